"""How a style is used: its strength, its size, whether it turns with the line, and the seed."""

from PySide6.QtWidgets import QCheckBox, QFrame

from iconstudio.gui.panels.seed import SeedField
from iconstudio.gui.panels.value_slider import PercentSlider
from iconstudio.gui.theme.layout import card, column, row
from iconstudio.gui.theme.theme import UNIT
from iconstudio.workflows.line_style import page as edits
from iconstudio.workflows.line_style.page import RestyleDocument, RestylePage
from iconstudio.workflows.line_style.restyling import (
    LARGEST,
    LARGEST_SEED,
    SMALLEST,
    STRONGEST,
    WEAKEST,
)


class StyleControls(QFrame):
    """The few controls below the canvas: edit the page."""

    def __init__(self, document: RestyleDocument) -> None:
        super().__init__()
        self._document = document
        self.strength = PercentSlider(
            "Strength",
            "How far lines go from the plain ones",
            WEAKEST,
            STRONGEST,
            lambda part, gesture: edits.set_strength(document, part, gesture),
        )
        self.size = PercentSlider(
            "Size",
            "How large the texture of the style is",
            SMALLEST,
            LARGEST,
            lambda part, gesture: edits.set_size(document, part, gesture),
        )
        self.turning = QCheckBox("Turn with the line")
        self.turning.setToolTip(
            "On: the style looks the same whichever way a line goes. "
            "Off: it depends on the line's direction, as drips that always fall"
        )
        self.turning.clicked.connect(self._turn)
        self.seed = SeedField(LARGEST_SEED, "lines")
        self.seed.changed.connect(lambda seed: edits.set_seed(document, seed, self.seed.gesture))
        sliders = column(self.strength, self.size, spacing=UNIT // 2)
        others = column(self.seed, self.turning, spacing=UNIT // 2)
        row(card(row((sliders, 1), others, spacing=3 * UNIT)), of=self)

    def show_page(self, page: RestylePage) -> None:
        """Show what the page says."""
        work = page.work
        self.strength.show_value(work.strength)
        self.size.show_value(work.size)
        self.seed.set_seed(work.seed)
        style = work.style_of(0)
        self.turning.setEnabled(style is not None)
        self.turning.setChecked(style is not None and style.rotation)

    def _turn(self, on: bool) -> None:
        style = self._document.page.work.style
        own = style is not None and style.rotation == on
        edits.set_turning(self._document, None if own else on)
