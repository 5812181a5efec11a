"""What an empty canvas offers to begin with."""

from PySide6.QtCore import QEvent, QObject
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QHBoxLayout, QMenu, QPushButton, QWidget

from iconstudio.gui.theme.theme import UNIT


class StartButtons(QWidget):
    """A button of these ``words`` and “Try an example” below the welcome on an empty canvas."""

    def __init__(self, canvas: QWidget, words: str, action: QAction, examples: QMenu) -> None:
        super().__init__(canvas)
        self._canvas = canvas
        begin = QPushButton(words)
        begin.clicked.connect(action.trigger)
        try_example = QPushButton("Try an example")
        try_example.setMenu(examples)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(UNIT)
        row.addWidget(begin)
        row.addWidget(try_example)
        canvas.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Stay below the middle of the canvas."""
        if event.type() == QEvent.Type.Resize:
            self.adjustSize()
            canvas = self._canvas
            self.move((canvas.width() - self.width()) // 2, canvas.height() // 2 + 2 * UNIT)
        return False
