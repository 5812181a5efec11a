"""Whether results are shown tidied, or as they were before; and the switch for it."""

from PySide6.QtWidgets import QFrame, QToolButton

from iconstudio.gui.gallery.setting import Setting
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.theme.layout import segments

setting = Setting("tidy", {on: on for on in (True, False)}, usual=True)
"""Whether results are tidied."""


def shown(picture: Picture) -> Picture:
    """Return a result as it is to be shown."""
    return (picture.tidied if setting.value else picture.untidied) or picture


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
