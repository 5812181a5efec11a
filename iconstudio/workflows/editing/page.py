"""What lies on the canvas of an edit: an icon, areas to remove and to add, and the criteria."""

from dataclasses import dataclass, replace
from typing import Any

from iconstudio.model import Axis, Edit, Exemplar, IconstudioError, Polygon
from iconstudio.workflows.areas import Area, Kind, areas_of, crossings, inner_of
from iconstudio.workflows.pages import Document


@dataclass(frozen=True, slots=True)
class EditPage:
    """An icon and what to change on it. At most one area, the last one, is not finished."""

    icon: Exemplar | None = None
    keyword: str = ""
    areas: tuple[Area, ...] = ()
    symmetry: Axis | None = None
    exclude: frozenset[str] = frozenset()
    include: frozenset[str] = frozenset()

    @property
    def empty(self) -> bool:
        """Whether there is no icon yet."""
        return self.icon is None

    @property
    def open_area(self) -> int | None:
        """Number of the area that is still being traced."""
        return len(self.areas) - 1 if self.areas and not self.areas[-1].closed else None

    @property
    def criteria(self) -> "EditPage":
        """The page itself says what is wanted."""
        return self

    def with_criteria(self, **values: Any) -> "EditPage":
        """Return the page with another keyword, symmetry, or icons left out."""
        return replace(self, **values)

    def with_areas(self, areas: tuple[Area, ...]) -> "EditPage":
        """Return the page with other areas."""
        return replace(self, areas=areas)

    def edit(self) -> Edit | None:
        """Return the edit as far as it is finished; None without an icon."""
        if self.icon is None:
            return None
        remove, add = (
            tuple(Polygon(area.vertices) for area in self.areas if area.closed and area.kind is k)
            for k in (Kind.REMOVE, Kind.ADD)
        )
        criteria = self.symmetry, self.exclude, self.include
        inner = inner_of(self.areas)
        return Edit(self.icon.pictogram, self.keyword, remove, add, *criteria, inner)

    def elsewhere(self, before: "EditPage") -> bool:
        """Whether it is another icon."""
        return self.icon is not before.icon


EditDocument = Document[EditPage]


def problem(page: EditPage) -> str:
    """Return what is missing before an icon can be remixed, as a sentence; else nothing."""
    from iconstudio.workflows.editing.placing import place_edit

    edit = page.edit()
    if page.icon is None or edit is None:
        return "There is no icon yet. Look one up on the left, or open a drawing of your own."
    try:
        place_edit(edit, page.icon)
    except IconstudioError as error:
        return str(error)
    if not page.keyword.strip():
        return "The icon has no name. Type what it is below the canvas, for example “camera”."
    return ""


def begin(document: EditDocument, icon: Exemplar, keyword: str) -> None:
    """Start from an icon, on a new page; undo brings the old one back."""
    document.change("choose icon", EditPage(icon, keyword))


def load(document: EditDocument, edit: Edit, icon: Exemplar) -> None:
    """Put an edit on the page that was read from a file."""
    areas = tuple(
        Area(kind, polygon.vertices)
        for kind, polygons in ((Kind.REMOVE, edit.remove), (Kind.ADD, edit.add))
        for polygon in polygons
    )
    areas += areas_of(edit.inner)
    page = EditPage(icon, edit.keyword, areas, edit.symmetry, edit.exclude, edit.include)
    document.change("open edit", page)


def clear(document: EditDocument) -> None:
    """Remove all areas; the icon stays."""
    document.change("clear areas", document.page.with_areas(()))


def doubts(edit: Edit) -> str:
    """Return what the user should know of how an edit is read, as a sentence, or nothing."""
    kinds = {"removed area": edit.remove, "added area": edit.add}
    outlines = {
        f"{noun} {number}": outline
        for noun, some in kinds.items()
        for number, outline in enumerate(some, start=1)
    }
    return crossings(edit.inner, outlines)
