"""What is out of date turns pale."""

from PySide6.QtCore import QObject, QTimer, Signal

PALING = 700
"""Milliseconds after which a result that is out of date turns pale: not at once, so that one that
is soon replaced does not flicker."""

PALE = 0.35
"""How opaque it is then."""


class Paling(QObject):
    """How pale a result is that follows what it is made of.

    Signals
    -------
    changed()
        It is to be painted anew.
    """

    changed = Signal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._stale = self._pale = False
        self.timer = QTimer(self, singleShot=True, interval=PALING)
        self.timer.timeout.connect(lambda: self._turn(True))

    @property
    def opacity(self) -> float:
        """How opaque the result is."""
        return PALE if self._pale else 1.0

    def set_stale(self, stale: bool) -> None:
        """Say whether the result is of something else than what is there now."""
        if stale == self._stale:
            return
        self._stale = stale
        if stale:
            self.timer.start()
        else:
            self.timer.stop()
            self._turn(False)

    def match(self, other: "Paling") -> None:
        """Be as pale as another one is now."""
        self._turn(other._pale)

    def renew(self) -> None:
        """Another result is there: if it is out of date, too, it stands for as long."""
        self._turn(False)
        if self._stale:
            self.timer.start()

    def _turn(self, pale: bool) -> None:
        if pale != self._pale:
            self._pale = pale
            self.changed.emit()
