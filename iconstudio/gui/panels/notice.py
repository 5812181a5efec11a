"""A message that stays until it is read, and blocks nothing."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QToolButton, QWidget

from iconstudio.gui import icons, theme
from iconstudio.gui.theme import UNIT


class Notice(QFrame):
    """A bar with a sentence, hidden while there is nothing to say."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("notice", True)
        self._sign = QLabel()
        self.label = QLabel(wordWrap=True)
        self.label.setTextFormat(Qt.TextFormat.PlainText)
        self.label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._button = QToolButton(toolTip="Dismiss this message")
        self._button.setAccessibleName("Dismiss this message")
        self._button.clicked.connect(self.hide)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(UNIT * 3 // 2, UNIT // 2, UNIT // 2, UNIT // 2)
        layout.setSpacing(UNIT)
        layout.addWidget(self._sign)
        layout.addWidget(self.label, 1)
        layout.addWidget(self._button)
        self.hide()

    def say(self, message: str) -> None:
        """Show a message."""
        self.label.setText(message)
        self.setAccessibleName(message)
        self.show()

    def refresh_icons(self, look: theme.Theme) -> None:
        """Draw the icons in the colours of ``look``."""
        self._sign.setPixmap(icons.pixmap("warning", look.color("danger"), ratio=2))
        self._button.setIcon(icons.icon("close", look, "muted"))
