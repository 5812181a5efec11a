"""Messages that stay until they are read, and block nothing."""

from collections.abc import Iterable

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QScrollArea, QToolButton, QWidget

from iconstudio.gui import icons
from iconstudio.gui.theme import UNIT

_HIGHEST = 9 * UNIT
"""Where there is more to say than fits into so many pixels, it scrolls."""


class Notice(QFrame):
    """A bar with sentences, hidden while there is nothing to say.

    Messages are about what has been tried; remarks about what lies on the page: they stay as long
    as it does, unless they are dismissed.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("notice", True)
        self._messages: dict[str, None] = {}
        self._remarks: dict[str, None] = {}
        self._dismissed: set[str] = set()
        self._sign = icons.Sign("warning", "danger", 20)
        self.label = QLabel(wordWrap=True)
        self.label.setTextFormat(Qt.TextFormat.PlainText)
        self.label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._scroll = QScrollArea(widgetResizable=True)
        self._scroll.setWidget(self.label)
        self._scroll.setFrameShape(QFrame.Shape.NoFrame)
        self._scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._scroll.viewport().setAutoFillBackground(False)
        self.label.setAutoFillBackground(False)
        self._scroll.viewport().installEventFilter(self)
        self._button = QToolButton(toolTip="Dismiss this message")
        self._button.setAccessibleName("Dismiss this message")
        self._button.setIcon(icons.icon("close", "muted"))
        self._button.clicked.connect(self._dismiss)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(UNIT * 3 // 2, UNIT // 2, UNIT // 2, UNIT // 2)
        layout.setSpacing(UNIT)
        layout.addWidget(self._sign)
        layout.addWidget(self._scroll, 1)
        layout.addWidget(self._button)
        self.hide()

    def say(self, message: str) -> None:
        """Show a message below those that are there."""
        self._messages.pop(message, None)
        self._messages[message] = None
        self._write()

    def clear(self) -> None:
        """Take all messages away: they are dealt with."""
        self._messages.clear()
        self._write()

    def remark(self, remarks: Iterable[str]) -> None:
        """Show these remarks, and no others; but none that was dismissed since it came."""
        self._remarks = dict.fromkeys(remarks)
        self._dismissed &= self._remarks.keys()
        self._write()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Be as high as the sentences at this width."""
        if event.type() == QEvent.Type.Resize:
            self._fit()
        return False

    def _dismiss(self) -> None:
        self._dismissed |= self._remarks.keys()
        self.clear()

    def _write(self) -> None:
        remarks = [one for one in self._remarks if one not in self._dismissed]
        text = "\n".join((*self._messages, *remarks))
        self.setVisible(bool(text))
        if text and text != self.label.text():
            self.label.setText(text)
            self.setAccessibleName(text)
            self._fit()
            self._scroll.verticalScrollBar().setValue(0)

    def _fit(self) -> None:
        height = self.label.heightForWidth(self._scroll.viewport().width())
        self._scroll.setFixedHeight(min(max(height, 2 * UNIT), _HIGHEST))
