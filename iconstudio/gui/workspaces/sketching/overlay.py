"""What lies over the canvas, or beside its tools, only when a sketch is made."""

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QHBoxLayout, QLabel, QMenu, QPushButton, QSlider, QWidget

from iconstudio.gui import icons, theme
from iconstudio.gui.theme import UNIT


class DimSlider(QWidget):
    """Fades the photo under the sketch."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.slider = QSlider(Qt.Orientation.Horizontal, minimum=0, maximum=100, value=35)
        self.slider.setFixedWidth(8 * UNIT)
        self.slider.setAccessibleName("Dim the photo")
        self._sign = QLabel()
        self.setToolTip("Dim the photo")
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(2)
        row.addWidget(self._sign)
        row.addWidget(self.slider)

    def refresh_icons(self, look: theme.Theme) -> None:
        """Draw the sign in the colours of ``look``."""
        self._sign.setPixmap(icons.pixmap("dim", look.color("muted"), 18, 2))


class StartButtons(QWidget):
    """“Open photo” and “Try an example” below the welcome on an empty canvas."""

    def __init__(self, canvas: QWidget, photo: QAction, examples: QMenu) -> None:
        super().__init__(canvas)
        self._canvas = canvas
        open_photo = QPushButton("Open photo…")
        open_photo.clicked.connect(photo.trigger)
        try_example = QPushButton("Try an example")
        try_example.setMenu(examples)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(UNIT)
        row.addWidget(open_photo)
        row.addWidget(try_example)
        canvas.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Stay below the middle of the canvas."""
        if event.type() == QEvent.Type.Resize:
            self.adjustSize()
            canvas = self._canvas
            self.move((canvas.width() - self.width()) // 2, canvas.height() // 2 + 2 * UNIT)
        return False
