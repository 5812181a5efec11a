"""A text field for words, which leaves what is none to the workspace around it."""

from PySide6.QtCore import QEvent
from PySide6.QtGui import QKeyEvent, QKeySequence
from PySide6.QtWidgets import QApplication, QLineEdit

from iconstudio.gui.document.document import new_gesture
from iconstudio.gui.exchange.mime import holds_words

Key = QKeySequence.StandardKey


class WordField(QLineEdit):
    """Takes words that are pasted; drawings and files are pasted, and dropped, into the workspace.

    So are the shortcuts in ``others`` the workspace's. What is typed until Enter, or until the
    focus goes elsewhere, is one entry, and its changes one ``gesture``.
    """

    others: tuple[QKeySequence.StandardKey, ...] = ()

    def __init__(self, **properties: object) -> None:
        super().__init__(**properties)
        self.setMaxLength(100)
        self.setAcceptDrops(False)  # a file is for the workspace to open, its address is no word
        self.gesture = new_gesture()
        self.editingFinished.connect(self.end_entry)

    def end_entry(self) -> None:
        """What is typed from now on is another entry."""
        self.gesture = new_gesture()

    def event(self, event: QEvent) -> bool:
        """Do not claim shortcuts that are the workspace's."""
        if event.type() == QEvent.Type.ShortcutOverride and self._is_for_others(event):
            event.ignore()
            return False
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Let the workspace's shortcuts pass."""
        if self._is_for_others(event):
            event.ignore()
        else:
            super().keyPressEvent(event)

    def _is_for_others(self, event: QKeyEvent) -> bool:
        if event.matches(Key.Paste):
            return not holds_words(QApplication.clipboard().mimeData())
        return any(map(event.matches, self.others))
