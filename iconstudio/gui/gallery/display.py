"""How results are shown: as icons, coded by source, or both; and the switch for it."""

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QButtonGroup, QFrame, QToolButton

from iconstudio.gui.pictures.picture import Display
from iconstudio.gui.preferences import prefer, preferred
from iconstudio.gui.theme.layout import segments

_NAME = "display"
"""Under which it is remembered."""

_WORDS = {
    Display.PLAIN: ("Icon", "The icons as they are"),
    Display.BOTH: ("Both", "The icons, each with its colour code beside it (Ctrl+Shift+K)"),
    Display.CODED: (
        "Colour code",
        "One hue for each source icon, one lightness for each of its placements (Ctrl+K)",
    ),
}


class DisplaySetting(QObject):
    """How all results are shown, in all workspaces; remembered.

    Signals
    -------
    changed()
    """

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.value = Display.BOTH

    def choose(self, display: Display) -> None:
        """Show results in another way from now on."""
        prefer(_NAME, display.value)
        self._show(display)

    def recall(self) -> None:
        """Show results as they were shown the last time."""
        known = {one.value: one for one in Display}
        self._show(known.get(preferred(_NAME, ""), Display.BOTH))

    def _show(self, display: Display) -> None:
        if display is not self.value:
            self.value = display
            self.changed.emit()


setting = DisplaySetting()


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
