"""Whether results are shown tidied, or as they were before; and the switch for it."""

from iconstudio.gui.gallery.setting import OnOffSwitch, on_or_off
from iconstudio.gui.pictures.picture import Picture

setting = on_or_off("tidy")
"""Whether results are tidied."""


def shown(picture: Picture) -> Picture:
    """Return a result as it is to be shown."""
    return (picture.tidied if setting.value else picture.untidied) or picture


def tidy_switch() -> OnOffSwitch:
    """Return the switch for it."""
    tip = "Lines, circles, widths and symmetry put right where parts meet; off: as joined"
    return OnOffSwitch(setting, "Tidy", tip)
