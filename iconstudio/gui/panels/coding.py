"""Switch between icons as they are and coded by source."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QButtonGroup, QFrame, QHBoxLayout, QToolButton, QWidget


class CodeSwitch(QFrame):
    """Two segments: icon, and colour code.

    Signals
    -------
    changed(bool)
        Whether results are to be colour-coded.
    """

    changed = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("segments", True)
        self.icon = QToolButton(text="Icon", checkable=True, checked=True)
        self.code = QToolButton(text="Colour code", checkable=True)
        self.code.setToolTip(
            "One hue for each source icon, one lightness for each of its placements (Ctrl+K)"
        )
        row = QHBoxLayout(self)
        row.setContentsMargins(2, 2, 2, 2)
        row.setSpacing(2)
        group = QButtonGroup(self)
        for button in (self.icon, self.code):
            button.setProperty("segment", True)
            group.addButton(button)
            row.addWidget(button)
        self.code.toggled.connect(self.changed)

    def set_coded(self, coded: bool) -> None:
        """Show which is chosen."""
        (self.code if coded else self.icon).setChecked(True)
