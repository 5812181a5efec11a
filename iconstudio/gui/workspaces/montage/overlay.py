"""What lies beside the tools, or over the canvas, only when a montage is made."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QSlider, QWidget

from iconstudio.gui.theme import icons
from iconstudio.gui.theme.layout import row
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.workspaces.montage.tools.scribble import THINNEST, WIDEST, Brush


class BrushSlider(QWidget):
    """The width of brush and eraser."""

    def __init__(self, brush: Brush) -> None:
        super().__init__()
        self.slider = QSlider(
            Qt.Orientation.Horizontal, minimum=THINNEST, maximum=WIDEST, value=brush.width
        )
        self.slider.setFixedWidth(10 * UNIT)
        self.slider.setAccessibleName("Brush size")
        self.slider.valueChanged.connect(brush.set_width)
        brush.changed.connect(self.slider.setValue)
        self.setToolTip("Brush size ([ and ])")
        row(icons.Sign("brush"), self.slider, of=self, spacing=UNIT // 2)
