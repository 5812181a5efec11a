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
    """A real icon as it stands in a collection.

    ``svg`` is a complete SVG document with a ``viewBox``. It comes from outside,
    so it is hostile until ``library.svgcheck`` has passed it.
    """

    id: str
    """``set:name``, unique in a collection."""
    svg: str
    credit: Credit
