"""Asks for patience while something is being opened that takes long."""

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer

_DELAY = 300
"""Milliseconds after which it is told."""


class Patience(QObject):
    """Says that something is being opened, and takes that back when it is over."""

    def __init__(self, say: Callable[[str], object], parent: QObject) -> None:
        super().__init__(parent)
        self._say = say
        self._asked = False
        self._timer = QTimer(self, singleShot=True, interval=_DELAY)
        self._timer.timeout.connect(self._ask)

    def begin(self) -> None:
        """Ask for it if this takes long."""
        self._timer.start()

    def end(self, silently: bool = False) -> None:
        """It is over; ``silently`` if something else is said now."""
        self._timer.stop()
        if self._asked and not silently:
            self._say("")
        self._asked = False

    def _ask(self) -> None:
        self._asked = True
        self._say("Opening…")
