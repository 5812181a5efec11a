"""Whether results are shown tidied, or as they were before; and the switch for it."""

from typing import TypeVar

from iconstudio.gui.gallery.setting import OnOffSwitch, on_or_off
from iconstudio.gui.pictures.picture import Picture

Entry = TypeVar("Entry")

setting = on_or_off("tidy")
"""Whether results are tidied."""


def shown(entry: Entry) -> Entry:
    """Return a result as it is to be shown; anything else as it is."""
    if not isinstance(entry, Picture):
        return entry
    return (entry.tidied if setting.value else entry.untidied) or entry


def tidy_switch() -> OnOffSwitch:
    """Return the switch for it."""
    tip = "Lines, circles, widths and symmetry put right where parts meet; off: as joined"
    return OnOffSwitch(setting, "Tidy", tip)
