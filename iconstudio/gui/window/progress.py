"""What the program is doing, how far it is, and a button to stop it."""

from PySide6.QtCore import QTimer, Signal
from PySide6.QtWidgets import QProgressBar, QWidget

from iconstudio.gui.theme.layout import label, push_button, row, show_sentence
from iconstudio.gui.theme.theme import UNIT
from iconstudio.workflows.estimating import spoken
from iconstudio.workflows.events import Progress

REMARK = 6000
"""Milliseconds for which a remark stays."""

_WHOLE = 1000
_BAR = 25 * UNIT
_RIGHT = _BAR + 14 * UNIT
"""Room for the progress and the button, in pixels."""


class StatusStrip(QWidget):
    """One line at the bottom of the window.

    Signals
    -------
    cancelled()
        The user pressed Cancel.
    """

    cancelled = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._message = ""
        self._finished = 0
        self._remark = ""
        self._timer = QTimer(self, singleShot=True, interval=REMARK)
        self._timer.timeout.connect(self._forget)
        self.setFixedHeight(4 * UNIT + 4)
        self.label = label()
        self.bar = QProgressBar(textVisible=False, maximum=_WHOLE)
        self.bar.setFixedWidth(_BAR)
        self.bar.setAccessibleName("Progress")
        tip = "Stop; finished results stay (Ctrl+.)"
        self.button = push_button("Cancel", tip, self.cancelled.emit)
        parts = (self.label, 1), self.bar, self.button
        row(*parts, of=self, spacing=UNIT * 3 // 2, margins=(UNIT, 0, 0, 4))
        self.rest("")

    @property
    def words_end(self) -> int:
        """How far the words may reach from the left, in pixels, whatever is under way."""
        return self.width() - _RIGHT

    def show_progress(self, progress: Progress) -> None:
        """Show a stage, and how far it is."""
        left = "" if progress.remaining is None else spoken(progress.remaining)
        self._message = " · ".join(text for text in (progress.message, left) if text)
        self._write()
        # As long as it is not known how far it is, the bar only moves.
        self.bar.setMaximum(_WHOLE if progress.done > 0 else 0)
        self.bar.setValue(round(_WHOLE * min(1.0, max(0.0, progress.done))))
        self.bar.show()
        self.button.show()

    def set_finished(self, count: int) -> None:
        """Say how many icons are finished."""
        self._finished = count
        self._write()

    def say(self, message: str) -> None:
        """Say something for a while, whatever is under way."""
        self._remark = message
        self._write()
        self._timer.start()

    def rest(self, message: str) -> None:
        """Nothing is under way; ``message`` says what came out."""
        self._message, self._finished = message, 0
        self._write()
        self.bar.hide()
        self.bar.setMaximum(_WHOLE)
        self.bar.setValue(0)
        self.button.hide()

    def _forget(self) -> None:
        self._remark = ""
        self._write()

    def _write(self) -> None:
        finished = f"{self._finished} finished" if self._finished else ""
        state = " · ".join(text for text in (self._message, finished) if text)
        show_sentence(self.label, self._remark or state)
