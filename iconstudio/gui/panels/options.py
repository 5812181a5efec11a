"""How a sketch is matched: a button that shows what can be set, and whether something is."""

from collections.abc import Callable

from PySide6.QtCore import QSize
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QCheckBox, QMenu, QToolButton, QWidget, QWidgetAction

from iconstudio.gui.panels.value_slider import PercentSlider
from iconstudio.gui.theme import icons
from iconstudio.gui.theme.layout import column
from iconstudio.gui.theme.theme import UNIT


class OptionsButton(QToolButton):
    """A button with a slider for fine details, and a box for larger scales.

    Parameters
    ----------
    scales
        The action that switches larger scales on and off.
    weight
        Called with the weight of fine details, from 0 to 1, and the mark of the drag.
    """

    def __init__(self, scales: QAction, weight: Callable[[float, object], None]) -> None:
        super().__init__()
        self._scales = scales
        tip = (
            "Fine details: small parts of the outline at sharp turns, as a nose or an ear, count "
            "more. At 0% they count as all else does"
        )
        self.detail = PercentSlider("Details", tip, 0.0, 1.0, weight)
        self.larger = QCheckBox("Larger scales (0.8 to 1.25)")
        self.larger.setToolTip(scales.toolTip())
        self.larger.clicked.connect(scales.trigger)
        scales.toggled.connect(self._show)
        panel = QWidget()
        margins = UNIT, UNIT, UNIT, UNIT
        column(self.detail, self.larger, of=panel, margins=margins)
        menu = QMenu(self)
        action = QWidgetAction(menu)
        action.setDefaultWidget(panel)
        menu.addAction(action)
        self.setMenu(menu)
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.setIconSize(QSize(20, 20))
        self.show_detail(0.0)

    def show_detail(self, detail: float) -> None:
        """Show the weight in use."""
        self.detail.show_value(detail)
        self._show()

    def _show(self) -> None:
        """Show whether the scales are larger; tell by the icon whether anything is set."""
        larger, weight = self._scales.isChecked(), self.detail.slider.value()
        self.larger.setChecked(larger)
        self.setIcon(icons.icon("options", "accent" if larger or weight else "text"))
        told = f"fine details {weight}%, {'larger' if larger else 'usual'} scales"
        self.setToolTip(f"How the sketch is matched: {told}")
        self.setAccessibleName(f"Matching: {told}")
