"""How results are shown: as icons, coded by source, or both; and the switch for it."""

from PySide6.QtWidgets import QButtonGroup, QFrame, QToolButton

from iconstudio.gui.gallery.setting import Setting
from iconstudio.gui.pictures.picture import Display
from iconstudio.gui.theme.layout import segments

_WORDS = {
    Display.PLAIN: ("Icon", "The icons as they are"),
    Display.BOTH: ("Both", "The icons, each with its colour code beside it (Ctrl+Shift+K)"),
    Display.CODED: (
        "Colour code",
        "One hue for each source icon, one lightness for each of its placements (Ctrl+K)",
    ),
}


setting = Setting("display", {one: one.value for one in Display}, Display.BOTH)
"""How all results are shown."""


class DisplaySwitch(QFrame):
    """Three segments: icon, both, and colour code."""

    def __init__(self) -> None:
        super().__init__()
        self.segments: dict[Display, QToolButton] = {}
        group = QButtonGroup(self)
        for display, (text, tip) in _WORDS.items():
            button = QToolButton(text=text, toolTip=tip, checkable=True)
            button.clicked.connect(lambda _, display=display: setting.choose(display))
            group.addButton(button)
            self.segments[display] = button
        segments(self, *self.segments.values())
        setting.changed.connect(self._show)
        self._show()

    def _show(self) -> None:
        self.segments[setting.value].setChecked(True)
