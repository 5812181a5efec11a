"""The edits of what is wanted beside an outline: keyword, icons left out, symmetry."""

from dataclasses import replace
from typing import Any, Protocol, Self, TypeVar

from iconstudio.inputs.together import quoted_list
from iconstudio.model import Axis, Edit, IconstudioError, Sketch
from iconstudio.workflows.pages import Document, Page
from iconstudio.workflows.workflow import Find

_Request = TypeVar("_Request", Sketch, Edit)


class Criteria(Protocol):
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
    def include(self) -> frozenset[str]:
        """Identifiers of those that may be used though they are less alike."""
        ...

    @property
    def symmetry(self) -> Axis | None:
        """Which halves of the results must mirror each other."""
        ...


class CriteriaPage(Page, Protocol):
    """A page with criteria."""

    @property
    def criteria(self) -> Criteria:
        """The criteria."""
        ...

    def with_criteria(self, **values: Any) -> Self:
        """Return the page with some of the criteria changed."""
        ...


CriteriaDocument = Document[CriteriaPage]


def with_known_icons(request: _Request, find: Find) -> tuple[_Request, tuple[str, ...]]:
    """Return what a file asks for with the icons' identifiers, and remarks on what is not there.

    An icon that is not there stays among them: another version of the collection may have it.
    """
    known: dict[str, frozenset[str]] = {}
    remarks: list[str] = []
    for field, words in (("exclude", "leaves out"), ("include", "brings in")):
        found = set()
        for name in sorted(getattr(request, field)):
            try:
                found.add(find(name).id)
            except IconstudioError as error:
                found.add(name)
                remarks.append(f'"{field}" {words} nothing by “{name}”. {error}')
        known[field] = frozenset(found)
    request = replace(request, exclude=known["exclude"], include=known["include"])
    return request, tuple(remarks)


def contradiction(request: Criteria) -> str:
    """Return a sentence about icons that are both left out and brought in; empty if none are."""
    both = sorted(request.exclude & request.include)
    if not both:
        return ""
    are, they_are = ("is", "it is") if len(both) == 1 else ("are", "they are")
    return f'{quoted_list(both)} {are} in "exclude" and in "include": {they_are} left out.'


def set_keyword(document: CriteriaDocument, keyword: str, gesture: object = None) -> None:
    """Name the object. Letters that are typed in one ``gesture`` are undone together."""
    document.change("name the object", document.page.with_criteria(keyword=keyword), gesture)


def toggle_icon(document: CriteriaDocument, icon: str) -> None:
    """Leave an icon of the collection out, or take it in again."""
    exclude_icons(document, document.page.criteria.exclude ^ {icon})


def exclude_icons(document: CriteriaDocument, exclude: frozenset[str]) -> None:
    """Say which icons must not be used."""
    fewer = exclude < document.page.criteria.exclude
    text = "use icon again" if fewer else "leave icon out"
    document.change(text, document.page.with_criteria(exclude=exclude))


def toggle_stranger(document: CriteriaDocument, icon: str) -> None:
    """Bring in an icon that is less alike than the others, or leave it where it was."""
    before = document.page.criteria.include
    text = "leave icon out" if icon in before else "bring icon in"
    document.change(text, document.page.with_criteria(include=before ^ {icon}))


def set_symmetry(document: CriteriaDocument, axis: Axis | None) -> None:
    """Say which halves of the results must mirror each other."""
    text = "hold to symmetry" if axis else "drop symmetry"
    document.change(text, document.page.with_criteria(symmetry=axis))
