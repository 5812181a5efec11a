"""A slider with a word before it and its value behind: one drag is one step."""

from collections.abc import Callable
from math import log2
from typing import ClassVar

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import QSlider, QWidget

from iconstudio.gui.document.document import new_gesture
from iconstudio.gui.theme.layout import label, row
from iconstudio.gui.theme.theme import UNIT

NAME = 7 * UNIT
"""Room for the word before a slider, in pixels."""


class ValueSlider(QWidget):
    """A value from ``least`` to ``most``; a subclass says how it reads, and where it stands.

    Parameters
    ----------
    title, tip
        What it is called, and what it does.
    change
        Called with the value and the mark of the drag.
    """

    step: ClassVar[int] = 5
    """Of the arrow keys, in positions of the slider."""

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
            minimum=self.position(least),
            maximum=self.position(most),
            singleStep=self.step,
            pageStep=5 * self.step,
        )
        self.slider.setMinimumHeight(3 * UNIT)  # else its round handle is cut off
        self.slider.setAccessibleName(title)
        self.setToolTip(tip)
        name, self._value = label(title), label()
        name.setFixedWidth(NAME)
        self._value.setFixedWidth(5 * UNIT)
        self._value.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        row(name, (self.slider, 1), self._value, of=self, spacing=UNIT // 2)
        self.slider.sliderPressed.connect(self._begin)
        self.slider.sliderReleased.connect(self._end)
        self.slider.valueChanged.connect(self._changed)

    def position(self, value: float) -> int:
        """Return where the slider stands for a value."""
        return round(value)

    def value(self, position: int) -> float:
        """Return the value for which the slider stands there."""
        return float(position)

    def words(self, value: float) -> str:
        """Return a value in words."""
        return f"{value:.0f}"

    def show_value(self, value: float) -> None:
        """Show the value that is in use."""
        if self.position(value) != self.slider.value():
            with QSignalBlocker(self.slider):
                self.slider.setValue(self.position(value))
        self._value.setText(self.words(value))

    def _begin(self) -> None:
        self._gesture = new_gesture()

    def _end(self) -> None:
        self._gesture = None

    def _changed(self, position: int) -> None:
        self._change(self.value(position), self._gesture)


class PercentSlider(ValueSlider):
    """A part of the usual value, in percent."""

    def position(self, value: float) -> int:
        """Return where the slider stands for a part."""
        return round(100 * value)

    def value(self, position: int) -> float:
        """Return the part for which the slider stands there."""
        return position / 100

    def words(self, value: float) -> str:
        """Return a part in words."""
        return f"{value:.0%}"


_TO_DOUBLE = 20
"""Steps of the slider that double a factor."""


class FactorSlider(PercentSlider):
    """A factor in percent: as far to the left for a half as to the right for twice as much."""

    step = 1

    def position(self, value: float) -> int:
        """Return where the slider stands for a factor."""
        return round(_TO_DOUBLE * log2(value))

    def value(self, position: int) -> float:
        """Return the factor for which the slider stands there."""
        return float(round(2 ** (position / _TO_DOUBLE), 3))
