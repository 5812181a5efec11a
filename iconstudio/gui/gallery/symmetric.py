"""Whether symmetric results stand in the places of others; and the switch for it."""

from iconstudio.gui.gallery.setting import OnOffSwitch, on_or_off

setting = on_or_off("symmetric")
"""Whether symmetric results are shown where there are any."""


def symmetric_switch() -> OnOffSwitch:
    """Return the switch for it."""
    tip = "The outline is nearly symmetric: show symmetric results where they look better"
    return OnOffSwitch(setting, "Symmetric", tip)
