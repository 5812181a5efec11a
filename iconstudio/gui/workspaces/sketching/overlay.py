"""What lies over the canvas, or beside its tools, only when a sketch is made."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QSlider, QWidget

from iconstudio.gui.theme import icons
from iconstudio.gui.theme.layout import row
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.workspaces.sketching.scene import SketchScene


class DimSlider(QWidget):
    """Fades the photo under the sketch."""

    def __init__(self, scene: SketchScene) -> None:
        super().__init__()
        self.slider = QSlider(Qt.Orientation.Horizontal, minimum=0, maximum=100, value=35)
        self.slider.setFixedWidth(7 * UNIT)
        self.slider.setAccessibleName("Dim the photo")
        self.slider.valueChanged.connect(scene.set_dim)
        self.setToolTip("Dim the photo")
        row(icons.Sign("dim"), self.slider, of=self, spacing=2, margins=(UNIT, 0, 0, 0))
