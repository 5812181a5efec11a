"""The number that random choices depend on."""

import random

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QLineEdit, QWidget

from iconstudio.gui.document.document import new_gesture
from iconstudio.gui.theme.layout import label, row, tool_button
from iconstudio.gui.theme.theme import UNIT


class SeedField(QWidget):
    """The number that random choices depend on, and a dice that throws another.

    Parameters
    ----------
    largest
        The largest seed there is.
    results
        What the choices make, in a word: “hybrids”.

    Signals
    -------
    changed(object)
        The user wants this seed, a whole number. What is typed until Enter, or until the focus
        goes elsewhere, is one ``gesture``, and so is each throw.
    """

    changed = Signal(object)

    def __init__(self, largest: int, results: str) -> None:
        super().__init__()
        self._largest = largest
        self.field = QLineEdit()
        self.field.setFixedWidth(11 * UNIT)
        self.field.setMaxLength(len(str(largest)))
        self.field.setAccessibleName("Random seed")
        self.field.setToolTip(f"Random seed: the same number gives the same {results}")
        self.dice = tool_button("dice", "Another random seed", self._throw, side=20)
        self.dice.setToolTip(f"Draw other {results}: another random seed")
        self.words = label("Seed")
        self.words.setBuddy(self.field)
        row(self.words, self.field, self.dice, of=self, spacing=UNIT // 2)
        self.field.textEdited.connect(self._read)
        self.field.editingFinished.connect(self._end_entry)
        self.gesture = new_gesture()

    def set_seed(self, seed: int) -> None:
        """Show the seed."""
        typed = self.field.text()
        if (int(typed) if typed.isdigit() else None) != seed and (
            typed or not self.field.hasFocus()
        ):
            self.field.setText(str(seed))

    def _end_entry(self) -> None:
        self.gesture = new_gesture()

    def _throw(self) -> None:
        self._end_entry()
        self.changed.emit(random.randrange(10_000))

    def _read(self, text: str) -> None:
        digits = "".join(c for c in text if c in "0123456789")
        if digits != text:
            self.field.setText(digits)
        self.changed.emit(min(int(digits or 0), self._largest))
