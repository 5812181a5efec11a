"""A few small words below a field: what it is for, what it found, or what is wrong."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel

from iconstudio.gui.theme.layout import show_sentence, turn_role


class Caption(QLabel):
    """A muted text, or an error in its colour."""

    def __init__(self) -> None:
        super().__init__()
        self.setWordWrap(True)

    def say(self, text: str, error: bool = False, links: bool = False) -> None:
        """Show ``text``; only with ``links``, it is HTML."""
        self.setTextFormat(Qt.TextFormat.RichText if links else Qt.TextFormat.PlainText)
        show_sentence(self, text)
        turn_role(self, "muted", not error)
        turn_role(self, "error", error)
