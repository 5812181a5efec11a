"""Messages that stay until they are read, and block nothing, and move nothing."""

from collections.abc import Iterable

from PySide6.QtCore import QRect, Qt, Signal
from PySide6.QtWidgets import QFrame, QLabel, QWidget

from iconstudio.gui.theme import icons
from iconstudio.gui.theme.layout import (
    OnGeometry,
    row,
    scrolled,
    show_sentence,
    tool_button,
    turn_role,
    with_role,
)
from iconstudio.gui.theme.theme import UNIT

_WIDEST = 110 * UNIT
_LINES = 2
"""Of what there is to say: so much stands over the status line. The rest is scrolled to, or
read in the tool tip."""


class Notice(QFrame):
    """A bar with sentences that floats over what is below, hidden while there is nothing to say.

    Messages are about what has been tried; remarks about what lies on the page: they stay as long
    as it does, unless they are dismissed. Hints say what to do next: no mistake was made.

    Signals
    -------
    resized()
        It has more or less to say: it should be placed anew.
    """

    resized = Signal()

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        with_role(self, "notice")
        self._messages: dict[str, bool] = {}
        """Each with whether it is a hint."""
        self._remarks: dict[str, None] = {}
        self._dismissed: set[str] = set()
        self._signs = icons.Sign("warning", "danger", 20), icons.Sign("hint", "accent", 20)
        self.label = QLabel(wordWrap=True)
        self.label.setTextFormat(Qt.TextFormat.PlainText)
        self.label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._scroll = scrolled(self.label, frameShape=QFrame.Shape.NoFrame)
        OnGeometry(self._scroll.viewport(), self._fit)
        self._button = tool_button("close", "Dismiss this message", self._dismiss, token="muted")
        margins = UNIT * 3 // 2, UNIT // 2, UNIT // 2, UNIT // 2
        row(*self._signs, (self._scroll, 1), self._button, of=self, margins=margins)
        self.hide()

    def say(self, message: str, hint: bool = False) -> None:
        """Show a message, or a hint, below those that are there."""
        self._messages.pop(message, None)
        self._messages[message] = hint
        self._write()

    def hint(self, message: str) -> None:
        """Show a hint below the messages that are there."""
        self.say(message, hint=True)

    def place(self, room: QRect) -> None:
        """Float at the lower end of ``room``, on its left."""
        width = min(_WIDEST, room.width())
        self.resize(width, self.height())
        self._fit()
        height = self.sizeHint().height()
        self.setGeometry(room.left(), room.bottom() + 1 - height, width, height)
        self.raise_()

    def clear(self) -> None:
        """Take all messages away: they are dealt with."""
        self._messages.clear()
        self._write()

    def remark(self, remarks: Iterable[str]) -> None:
        """Show these remarks, and no others; but none that was dismissed since it came."""
        self._remarks = dict.fromkeys(remarks)
        self._dismissed &= self._remarks.keys()
        self._write()

    def _dismiss(self) -> None:
        self._dismissed |= self._remarks.keys()
        self.clear()

    def _write(self) -> None:
        remarks = [one for one in self._remarks if one not in self._dismissed]
        text = "\n".join((*self._messages, *remarks))
        hint = bool(self._messages) and all(self._messages.values()) and not remarks
        turn_role(self, "hint", hint)
        for sign, shown in zip(self._signs, (not hint, hint), strict=True):
            sign.setVisible(shown)
        self.setVisible(bool(text))
        if text and show_sentence(self.label, text):
            self.setAccessibleName(text)
            self._scroll.verticalScrollBar().setValue(0)
        self.resized.emit()

    def _fit(self) -> None:
        """Be as high as the sentences at this width, but cover no more than the status line."""
        line = self.label.fontMetrics().lineSpacing()
        height = self.label.heightForWidth(self._scroll.viewport().width())
        highest = _LINES * line
        self._scroll.setFixedHeight(min(max(height, 2 * UNIT), highest))
        self._scroll.verticalScrollBar().setSingleStep(line)
        self._scroll.setToolTip(self.label.text() if height > highest else "")
