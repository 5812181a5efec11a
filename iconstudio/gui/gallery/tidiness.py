"""Whether results are shown tidied, or as they were before; and the switch for it."""

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QFrame, QToolButton

from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.preferences import prefer, preferred
from iconstudio.gui.theme.layout import segments

_NAME = "tidy"
"""Under which it is remembered."""


class TidySetting(QObject):
    """Whether results are tidied; remembered.

    Signals
    -------
    changed()
    """

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.value = True

    def choose(self, on: bool) -> None:
        """Show results tidied from now on, or not."""
        prefer(_NAME, on)
        self._show(on)

    def recall(self) -> None:
        """Show results as they were shown the last time."""
        self._show(preferred(_NAME, True))

    def shown(self, picture: Picture) -> Picture:
        """Return a result as it is to be shown."""
        return (picture.tidied if self.value else picture.untidied) or picture

    def _show(self, on: bool) -> None:
        if on != self.value:
            self.value = on
            self.changed.emit()


setting = TidySetting()


class TidySwitch(QFrame):
    """One segment: on, or off."""

    def __init__(self) -> None:
        super().__init__()
        tip = "Lines, circles, widths and symmetry put right where parts meet; off: as joined"
        self.button = QToolButton(text="Tidy", toolTip=tip, checkable=True)
        self.button.clicked.connect(setting.choose)
        segments(self, self.button)
        setting.changed.connect(self._show)
        self._show()

    def _show(self) -> None:
        self.button.setChecked(setting.value)
