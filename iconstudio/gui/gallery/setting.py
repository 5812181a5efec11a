"""How results are shown, in all workspaces, remembered from one time to the next."""

from typing import Generic, TypeVar

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QFrame, QToolButton

from iconstudio.gui.preferences import prefer, preferred
from iconstudio.gui.theme.layout import segments

T = TypeVar("T")


class Setting(QObject, Generic[T]):
    """One value of several, which have different words to be remembered by.

    Parameters
    ----------
    name
        Under which it is remembered.
    words
        What is remembered of each value: a truth value, or a text.
    usual
        The value until another one is chosen.

    Signals
    -------
    changed()
    """

    changed = Signal()

    def __init__(self, name: str, words: dict[T, bool | str], usual: T) -> None:
        super().__init__()
        self.value = usual
        self._name, self._words, self._usual = name, words, usual

    def choose(self, value: T) -> None:
        """Show results in another way from now on."""
        prefer(self._name, self._words[value])
        self._show(value)

    def recall(self) -> None:
        """Show results as they were shown the last time."""
        known = {word: value for value, word in self._words.items()}
        self._show(known.get(preferred(self._name, self._words[self._usual]), self._usual))

    def _show(self, value: T) -> None:
        if value != self.value:
            self.value = value
            self.changed.emit()


def on_or_off(name: str) -> Setting[bool]:
    """Return a setting that is on until it is switched off."""
    return Setting(name, {on: on for on in (True, False)}, usual=True)


class OnOffSwitch(QFrame):
    """One segment: on, or off."""

    def __init__(self, setting: Setting[bool], text: str, tip: str) -> None:
        super().__init__()
        self._setting = setting
        self.button = QToolButton(text=text, toolTip=tip, checkable=True)
        self.button.clicked.connect(setting.choose)
        segments(self, self.button)
        setting.changed.connect(self._show)
        self._show()

    def _show(self) -> None:
        self.button.setChecked(self._setting.value)
