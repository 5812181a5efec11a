"""A pictogram of a collection, and whom to thank for it."""

from dataclasses import dataclass

OWN = "own:"
"""How the identifiers of drawings of the user's own begin."""
UNCOLLECTED = ("made:", OWN)
"""Beginnings of the identifiers of icons that no collection has: results, and drawings."""

NAMELESS = frozenset({"drawing", "image", "icon", "montage"})
"""What such an icon is called if nobody named it: by this program, or by one that saved it."""


@dataclass(frozen=True, slots=True)
class Credit:
    """What an attribution names: title, author, licence and address."""

    title: str
    author: str
    license: str
    """SPDX identifier, for example ``CC-BY-4.0``."""
    license_url: str
    url: str
    """Address of the collection or of the pictogram itself."""


@dataclass(frozen=True, slots=True)
class Pictogram:
    """An icon as it stands in a collection, in a file of the user's, or as a result was drawn.

    ``svg`` is a complete SVG document with a ``viewBox``. It comes from outside,
    so it is hostile until ``svg.check`` has passed it.
    """

    id: str
    """``set:name``, unique in a collection."""
    svg: str
    credit: Credit
    made_of: tuple["Pictogram", ...] = ()
    """If it is itself a result: the icons that own its parts. Of those that were read back from a
    file's credits, ``svg`` is empty."""
    remarks: tuple[str, ...] = ()
    """What could not be read of its drawing, and what to do about it; a sentence for the user each.
    """

    @property
    def name(self) -> str:
        """What to call it: the title of what is the user's own, else its identifier."""
        own = self.made_of or self.id.startswith(OWN)
        return (self.credit.title if own else "") or self.id

    @property
    def origins(self) -> tuple["Pictogram", ...]:
        """The icons to thank: those that it was made of, or itself."""
        return self.made_of or (self,)
