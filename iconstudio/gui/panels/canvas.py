"""The canvas with its tool bar."""

from PySide6.QtCore import QEvent, QObject, QSize, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QMenu,
    QPushButton,
    QSlider,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from iconstudio.gui import icons, theme
from iconstudio.gui.canvas.view import CanvasView
from iconstudio.gui.document import Page
from iconstudio.gui.theme import UNIT


class CanvasPanel(QFrame):
    """Tool bar above, canvas below, and two ways to begin on an empty canvas."""

    def __init__(self, view: CanvasView, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("card", True)
        self.view = view
        self._bar = QHBoxLayout()
        self._bar.setContentsMargins(UNIT // 2, UNIT // 2, UNIT, UNIT // 2)
        self._bar.setSpacing(2)
        self.dim = QSlider(Qt.Orientation.Horizontal, minimum=0, maximum=100, value=35)
        self.dim.setFixedWidth(8 * UNIT)
        self.dim.setToolTip("Dim the photo")
        self.dim.setAccessibleName("Dim the photo")
        self.dim.valueChanged.connect(view.set_dim)
        self._dim_sign = QLabel()
        self._dim_sign.setToolTip("Dim the photo")
        self._start = _StartButtons(view)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(1, 1, 1, 1)
        layout.setSpacing(0)
        layout.addLayout(self._bar)
        layout.addWidget(view, 1)

    def fill_bar(self, groups: list[list[QAction]], examples: QMenu) -> None:
        """Put the actions on the tool bar; the examples' menu goes with the first group."""
        for number, actions in enumerate(groups):
            if number:
                self._bar.addSpacing(UNIT)
            for action in actions:
                button = QToolButton()
                button.setDefaultAction(action)
                button.setIconSize(QSize(20, 20))
                button.setAccessibleName(action.iconText())
                if action.menu() is not None:
                    button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
                self._bar.addWidget(button)
        self._bar.addStretch()
        self._bar.addWidget(self._dim_sign)
        self._bar.addWidget(self.dim)
        self._start.set_actions(groups[0][0], examples)

    def show_page(self, page: Page) -> None:
        """Offer what makes sense for the page."""
        self._start.setVisible(page.empty)
        for widget in (self.dim, self._dim_sign):
            widget.setVisible(page.photo is not None)

    def refresh_icons(self, look: theme.Theme) -> None:
        """Draw the icons in the colours of ``look``."""
        self._dim_sign.setPixmap(icons.pixmap("dim", look.color("muted"), 18, 2))


class _StartButtons(QWidget):
    """“Open photo” and “Try an example” below the welcome on an empty canvas."""

    def __init__(self, view: CanvasView) -> None:
        super().__init__(view)
        self._view = view
        self._photo = QPushButton("Open photo…")
        self._examples = QPushButton("Try an example")
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(UNIT)
        row.addWidget(self._photo)
        row.addWidget(self._examples)
        view.installEventFilter(self)

    def set_actions(self, photo: QAction, examples: QMenu) -> None:
        """Say what the buttons do."""
        self._photo.clicked.connect(photo.trigger)
        self._examples.setMenu(examples)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Stay below the middle of the canvas."""
        if event.type() == QEvent.Type.Resize:
            self.adjustSize()
            self.move((self._view.width() - self.width()) // 2, self._view.height() // 2 + 2 * UNIT)
        return False
