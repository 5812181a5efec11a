"""The user's input for editing: an icon, and what to change on it (section 4.2)."""

from dataclasses import dataclass, field

from iconstudio.model.inner import Inner
from iconstudio.model.pictogram import Pictogram
from iconstudio.model.polygon import Polygon
from iconstudio.model.symmetry import Axis


@dataclass(frozen=True, slots=True)
class Edit:
    """What to take off an icon, and what to put on, in canvas pixels of the normalised icon.

    The outline that is wanted is the icon's, less ``remove``, plus ``add``.
    """

    icon: Pictogram
    keyword: str = ""
    """What the parts that come in are looked for by."""
    remove: tuple[Polygon, ...] = ()
    add: tuple[Polygon, ...] = ()
    symmetry: Axis | None = None
    exclude: frozenset[str] = frozenset()
    """Identifiers of pictograms that must not be used."""
    include: frozenset[str] = frozenset()
    """Identifiers of those that may be used though they are less alike than others."""
    inner: Inner = field(default_factory=Inner)
    """What is drawn inside the outline that is wanted."""
