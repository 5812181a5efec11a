"""Where an edit begins: a sheet over the canvas on which the icon is chosen."""

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QMenu,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.panels.chooser import IconChooser
from iconstudio.gui.theme import icons
from iconstudio.gui.theme.theme import UNIT
from iconstudio.session import Session


class StartPanel(QFrame):
    """Covers a canvas while an icon is chosen; can be closed if there is one already.

    Signals
    -------
    closed()
        The user would rather go on with what is there.
    """

    closed = Signal()

    def __init__(self, canvas: QWidget, session: Session, worker: Worker, examples: QMenu) -> None:
        super().__init__(canvas)
        self.setProperty("sheet", True)
        self.setAutoFillBackground(True)
        heading = QLabel("Choose an icon to change")
        heading.setProperty("title", True)
        words = QLabel(
            "Then mark on it what should go and what should come: parts of other icons fill in.",
            wordWrap=True,
        )
        words.setProperty("muted", True)
        self.chooser = IconChooser(session, worker)
        self.close_button = QToolButton(toolTip="Go on with the icon that is there (Esc)")
        self.close_button.setAccessibleName("Close")
        self.close_button.setIcon(icons.icon("close"))
        self.close_button.clicked.connect(self.closed)
        top = QHBoxLayout()
        top.addWidget(heading, 1)
        try_example = QPushButton("Try an example")
        try_example.setMenu(examples)
        top.addWidget(try_example)
        top.addWidget(self.close_button)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(2 * UNIT, 2 * UNIT, 2 * UNIT, UNIT)
        layout.setSpacing(UNIT)
        layout.addLayout(top)
        layout.addWidget(words)
        layout.addWidget(self.chooser, 1)
        self.setFocusProxy(self.chooser)
        canvas.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Cover the whole canvas."""
        if event.type() == QEvent.Type.Resize:
            self.resize(watched.size())
        return False

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Close with Escape; keep other keys from the canvas below."""
        if event.key() == Qt.Key.Key_Escape and self.close_button.isVisible():
            self.closed.emit()
        event.accept()
