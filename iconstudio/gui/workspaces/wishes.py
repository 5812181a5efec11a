"""The edits of what is wanted beside an outline: keyword, icons left out, symmetry."""

from typing import Protocol, Self

from iconstudio.gui.document import Document, Page
from iconstudio.model import Axis


class Wish(Protocol):
    """What the icons that lend parts must be, and the results."""

    @property
    def keyword(self) -> str:
        """What they are looked for by."""
        ...

    @property
    def exclude(self) -> frozenset[str]:
        """Identifiers of those that must not be used."""
        ...

    @property
    def symmetry(self) -> Axis | None:
        """Which halves of the results must mirror each other."""
        ...


class WishingPage(Page, Protocol):
    """A page with a wish."""

    @property
    def wish(self) -> Wish:
        """The wish."""
        ...

    def wishing(self, **values: object) -> Self:
        """Return the page with some values of the wish changed."""
        ...


WishingDocument = Document[WishingPage]


def set_keyword(document: WishingDocument, keyword: str) -> None:
    """Name the object. Letters typed one after the other are undone together."""
    document.change("name the object", document.page.wishing(keyword=keyword), "keyword")


def toggle_icon(document: WishingDocument, icon: str) -> None:
    """Leave an icon of the collection out, or take it in again."""
    exclude_icons(document, document.page.wish.exclude ^ {icon})


def exclude_icons(document: WishingDocument, exclude: frozenset[str]) -> None:
    """Say which icons must not be used."""
    fewer = exclude < document.page.wish.exclude
    text = "use icon again" if fewer else "leave icon out"
    document.change(text, document.page.wishing(exclude=exclude))


def set_symmetry(document: WishingDocument, axis: Axis | None) -> None:
    """Say which halves of the results must mirror each other."""
    text = "hold to symmetry" if axis else "drop symmetry"
    document.change(text, document.page.wishing(symmetry=axis))
