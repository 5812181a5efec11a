"""How a style is used: its strength, its size, whether it turns with the line, and the seed."""

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QFrame, QSlider, QWidget

from iconstudio.gui.document.document import new_gesture
from iconstudio.gui.panels.seed import SeedField
from iconstudio.gui.theme.layout import card, column, label, row
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


class PercentSlider(QWidget):
    """A part of the usual value, in percent; one drag is one step.

    ``change`` is called with the part and the mark of the drag.
    """

    def __init__(
        self,
        title: str,
        tip: str,
        least: float,
        most: float,
        change: Callable[[float, object], None],
    ) -> None:
        super().__init__()
        self._change = change
        self._gesture: object = None
        self.slider = QSlider(
            Qt.Orientation.Horizontal,
            minimum=round(100 * least),
            maximum=round(100 * most),
            singleStep=5,
            pageStep=25,
        )
        self.slider.setMinimumHeight(3 * UNIT)  # else its round handle is cut off
        self.slider.setAccessibleName(title)
        self.setToolTip(tip)
        words = label(title)
        words.setFixedWidth(6 * UNIT)
        self._value = label()
        self._value.setFixedWidth(5 * UNIT)
        row(words, (self.slider, 1), self._value, of=self, spacing=UNIT)
        self.slider.sliderPressed.connect(self._begin)
        self.slider.sliderReleased.connect(self._end)
        self.slider.valueChanged.connect(self._changed)

    def show_part(self, part: float) -> None:
        """Show the value that is in use."""
        percent = round(100 * part)
        if percent != self.slider.value():
            blocked = self.slider.blockSignals(True)
            self.slider.setValue(percent)
            self.slider.blockSignals(blocked)
        self._value.setText(f"{percent} %")

    def _begin(self) -> None:
        self._gesture = new_gesture()

    def _end(self) -> None:
        self._gesture = None

    def _changed(self, percent: int) -> None:
        self._change(percent / 100, self._gesture)


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
        self.strength.show_part(work.strength)
        self.size.show_part(work.size)
        self.seed.set_seed(work.seed)
        style = work.style_of(0)
        self.turning.setEnabled(style is not None)
        self.turning.setChecked(style is not None and style.rotation)

    def _turn(self, on: bool) -> None:
        style = self._document.page.work.style
        own = style is not None and style.rotation == on
        edits.set_turning(self._document, None if own else on)
