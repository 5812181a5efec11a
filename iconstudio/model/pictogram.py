"""A pictogram of a collection, and whom to thank for it."""

from dataclasses import dataclass


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
    so it is hostile until ``library.svgcheck`` has passed it.
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
    def origins(self) -> tuple["Pictogram", ...]:
        """The icons to thank: those that it was made of, or itself."""
        return self.made_of or (self,)
