"""What the program is doing, how far it is, and a button to stop it."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QProgressBar, QPushButton, QWidget

from iconstudio.gui.theme import UNIT
from iconstudio.workflows.events import Progress


class ProgressStrip(QWidget):
    """One line at the bottom of the window.

    Signals
    -------
    cancelled()
        The user pressed Cancel.
    """

    cancelled = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFixedHeight(4 * UNIT + 4)
        self.label = QLabel()
        self.label.setProperty("muted", True)
        self.bar = QProgressBar(textVisible=False, maximum=1000)
        self.bar.setFixedWidth(25 * UNIT)
        self.bar.setAccessibleName("Progress")
        self.button = QPushButton("Cancel")
        self.button.setToolTip("Stop; finished results stay (Ctrl+.)")
        self.button.clicked.connect(self.cancelled)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(UNIT, 0, 0, 4)
        layout.setSpacing(UNIT * 3 // 2)
        layout.addWidget(self.label, 1)
        layout.addWidget(self.bar)
        layout.addWidget(self.button)
        self.rest("")

    def show_progress(self, progress: Progress, count: str = "") -> None:
        """Show a stage, how far it is, and how many icons are finished."""
        self.label.setText(" · ".join(text for text in (progress.message, count) if text))
        self.bar.setValue(round(1000 * min(1.0, max(0.0, progress.done))))
        self.bar.show()
        self.button.show()

    def rest(self, message: str) -> None:
        """Nothing is under way; ``message`` says what came out."""
        self.label.setText(message)
        self.bar.hide()
        self.bar.setValue(0)
        self.button.hide()
