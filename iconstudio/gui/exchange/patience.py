"""Asks for patience while something is being opened that takes long."""

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer

from iconstudio.workflows.events import Progress

OPENING = "Opening…"
_DELAY = 300
"""Milliseconds after which it is told."""


class Patience(QObject):
    """Says that something is being opened, and when it is over."""

    def __init__(
        self, say: Callable[[Progress], object], over: Callable[[], object], parent: QObject
    ) -> None:
        super().__init__(parent)
        self._say, self._over = say, over
        self.asked = False
        """Whether it is said now."""
        self._timer = QTimer(self, singleShot=True, interval=_DELAY)
        self._timer.timeout.connect(self.ask)

    def begin(self) -> None:
        """Ask for it if this takes long."""
        self._timer.start()

    def end(self) -> None:
        """It is over."""
        self._timer.stop()
        if self.asked:
            self.asked = False
            self._over()

    def ask(self) -> None:
        """Ask for it, once more if need be."""
        self.asked = True
        self._say(Progress("open", 0.0, OPENING))
