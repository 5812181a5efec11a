"""A slider beside the small icon of what it sets."""

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QSlider, QWidget

from iconstudio.gui.theme import icons
from iconstudio.gui.theme.layout import row
from iconstudio.gui.theme.theme import UNIT


class IconSlider(QWidget):
    """Calls ``change`` with each value."""

    def __init__(
        self,
        icon: str,
        name: str,
        values: tuple[int, int],
        value: int,
        change: Callable[[int], None],
    ) -> None:
        """``values`` are the least and the greatest."""
        super().__init__()
        least, most = values
        self.slider = QSlider(Qt.Orientation.Horizontal, minimum=least, maximum=most, value=value)
        self.slider.setFixedWidth(9 * UNIT)
        self.slider.setMinimumHeight(3 * UNIT)  # else its round handle is cut off
        self.slider.setAccessibleName(name)
        self.slider.valueChanged.connect(change)
        self.setToolTip(name)
        row(icons.Sign(icon), self.slider, of=self, spacing=UNIT // 2, margins=(UNIT, 0, 0, 0))
