"""Where icons lie, as files say it."""

from iconstudio.inputs.fields import Fields
from iconstudio.model import Placement

_FAR = 1e6


def placement_in(entry: Fields) -> Placement:
    """Return where an icon lies."""
    return Placement(
        entry.number("scale", 1.0, 0.0, 1000.0, above=True),
        entry.flag("flip"),
        round(entry.number("dx", 0, -_FAR, _FAR)),
        round(entry.number("dy", 0, -_FAR, _FAR)),
    )
