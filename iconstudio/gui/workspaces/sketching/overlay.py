"""What lies over the canvas, or beside its tools, only when a sketch is made."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QSlider, QWidget

from iconstudio.gui.theme import icons
from iconstudio.gui.theme.theme import UNIT


class DimSlider(QWidget):
    """Fades the photo under the sketch."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.slider = QSlider(Qt.Orientation.Horizontal, minimum=0, maximum=100, value=35)
        self.slider.setFixedWidth(7 * UNIT)
        self.slider.setAccessibleName("Dim the photo")
        self.setToolTip("Dim the photo")
        row = QHBoxLayout(self)
        row.setContentsMargins(UNIT, 0, 0, 0)
        row.setSpacing(2)
        row.addWidget(icons.Sign("dim"))
        row.addWidget(self.slider)
