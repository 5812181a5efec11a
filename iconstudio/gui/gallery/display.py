"""Switch between icons as they are, coded by source, and both."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QButtonGroup, QFrame, QToolButton

from iconstudio.gui.gallery.pictures import Display
from iconstudio.gui.theme.layout import segments

_WORDS = {
    Display.PLAIN: ("Icon", "The icons as they are"),
    Display.BOTH: ("Both", "The icons, each with its colour code beside it (Ctrl+Shift+K)"),
    Display.CODED: (
        "Colour code",
        "One hue for each source icon, one lightness for each of its placements (Ctrl+K)",
    ),
}


class DisplaySwitch(QFrame):
    """Three segments: icon, both, and colour code.

    Signals
    -------
    chosen(Display)
        How the user wants the results to be shown.
    """

    chosen = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self.segments: dict[Display, QToolButton] = {}
        group = QButtonGroup(self)
        for display, (text, tip) in _WORDS.items():
            button = QToolButton(text=text, toolTip=tip, checkable=True)
            button.clicked.connect(lambda _, display=display: self.chosen.emit(display))
            group.addButton(button)
            self.segments[display] = button
        segments(self, *self.segments.values())
        self.show_display(Display.BOTH)

    def show_display(self, display: Display) -> None:
        """Show which is chosen."""
        self.segments[display].setChecked(True)
