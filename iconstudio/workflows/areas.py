"""Areas and lines on a page, and the edits of the one that the tools work on."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from enum import Enum
from typing import Any, Protocol, Self, cast

from iconstudio.algorithms.geometry import crosses_itself
from iconstudio.grammar import joined
from iconstudio.inputs.formats import Points, Record
from iconstudio.model import Inner, Point, Polygon
from iconstudio.workflows.outline import Outline
from iconstudio.workflows.pages import Document, Page


class Kind(Enum):
    """What an area is for."""

    REMOVE = "remove"
    ADD = "add"
    HOLE = "hole"
    LINE = "line"
    """It encloses nothing."""

    @property
    def noun(self) -> str:
        """What it is called."""
        return _NOUNS[self]


_NOUNS = {
    Kind.REMOVE: "red area",
    Kind.ADD: "green area",
    Kind.HOLE: "hole",
    Kind.LINE: "line",
}


@dataclass(frozen=True, slots=True)
class Area:
    """A part of the canvas, in units of the page; it is finished once it is ``closed``."""

    kind: Kind
    vertices: tuple[Point, ...]
    closed: bool = True

    @property
    def least(self) -> int:
        """How many vertices it needs."""
        return 2 if self.kind is Kind.LINE else 3

    @property
    def ring(self) -> bool:
        """Whether an edge leads from the last vertex to the first."""
        return self.closed and self.kind is not Kind.LINE


class StoredArea(Record, frozen=True):
    """An area in a project file, finished or not."""

    kind: Kind
    points: Points
    closed: bool = False

    @classmethod
    def of(cls, area: Area) -> Self:
        """Return an area as it is stored."""
        return cls(area.kind, area.vertices, area.closed)

    @property
    def area(self) -> Area:
        """The value."""
        return Area(self.kind, self.points, self.closed)


def inner_of(areas: Iterable[Area]) -> Inner:
    """Return the holes and lines among areas that are finished."""
    done = [area for area in areas if area.closed]
    holes = tuple(Polygon(area.vertices) for area in done if area.kind is Kind.HOLE)
    return Inner(holes, tuple(area.vertices for area in done if area.kind is Kind.LINE))


def areas_of(inner: Inner) -> tuple[Area, ...]:
    """Return holes and lines as areas."""
    holes = (Area(Kind.HOLE, hole.vertices) for hole in inner.holes)
    return *holes, *(Area(Kind.LINE, line) for line in inner.lines)


def crossings(inner: Inner, others: Mapping[str, Polygon]) -> str:
    """Return the sentence that says which holes, and which others by name, cross themselves.

    If none does, nothing.
    """
    holes = {f"hole {number}": hole for number, hole in enumerate(inner.holes, start=1)}
    found = [name for name, outline in {**others, **holes}.items() if crosses_itself(outline)]
    if not found:
        return ""
    names = joined(found).capitalize()
    if len(found) == 1:
        return f"{names} crosses itself: all that it encloses counts as inside."
    return f"{names} cross themselves: all that they enclose counts as inside."


class AreasPage(Page, Protocol):
    """A page with areas, at most one of which, the last one, is not finished."""

    @property
    def areas(self) -> tuple[Area, ...]:
        """All areas."""
        ...

    def with_areas(self, areas: tuple[Area, ...]) -> Self:
        """Return the page with other areas; it may put them in another order."""
        ...


class AreaOutline(Outline):
    """The outline of the selected area; of none if nothing is selected.

    Which one is selected is no part of the page: to select is nothing that could be undone. An area
    that is still being traced is always the selected one.
    """

    document: Document[Any]

    def __init__(self, document: Document[Any]) -> None:
        super().__init__(document)
        self._index: int | None = None
        self._count = 0

    @property
    def index(self) -> int | None:
        """Number of the selected area."""
        return self._index

    @property
    def area(self) -> Area | None:
        """The selected area."""
        return None if self._index is None else self._page.areas[self._index]

    @property
    def vertices(self) -> tuple[Point, ...]:
        """The vertices of the selected area."""
        return () if self.area is None else self.area.vertices

    @property
    def closed(self) -> bool:
        """Whether nothing is being traced."""
        return self.area is None or self.area.closed

    @property
    def ring(self) -> bool:
        """Whether an edge leads from the last vertex of the selected area to the first."""
        return self.area is None or self.area.ring

    @property
    def least(self) -> int:
        """How many vertices the selected area needs."""
        return 3 if self.area is None else self.area.least

    def put(
        self, text: str, vertices: tuple[Point, ...], closed: bool, gesture: object = None
    ) -> None:
        """Replace the selected area; with too few vertices a finished one goes altogether."""
        index, area = self._index, self.area
        if index is None or area is None:
            return
        gone = not vertices or (area.closed and len(vertices) < area.least)
        areas = list(self._page.areas)
        areas[index : index + 1] = [] if gone else [Area(area.kind, vertices, closed)]
        text = f"remove {area.kind.noun}" if gone else text
        self._change(text, tuple(areas), None if gone else index, gesture)

    def begin(self, kind: Kind, point: Point) -> None:
        """Begin to trace an area."""
        self._append("add point", Area(kind, (point,), closed=False))

    def draw(self, kind: Kind, vertices: tuple[Point, ...]) -> None:
        """Add an area that was drawn in one go."""
        area = Area(kind, vertices)
        self._append(f"draw {kind.noun}", area)

    def remove(self) -> None:
        """Remove the selected area."""
        self.put("", (), True)

    def shift(self, dx: float, dy: float, gesture: object) -> None:
        """Move the selected area. Moves of one ``gesture`` are undone together."""
        vertices = tuple((x + dx, y + dy) for x, y in self.vertices)
        self.put("move area", vertices, self.closed, gesture)

    def select(self, index: int | None) -> None:
        """Select an area, or none, unless one is still being traced."""
        if self.closed:
            self._index = index

    def finish(self) -> None:
        """Close an area that is still being traced; what encloses nothing goes."""
        if not self.closed:
            done = self.vertices if len(self.vertices) >= self.least else ()
            self.put("close outline", done, True)

    def turn_to(self, kind: Kind | None) -> None:
        """Be ready for another area of a kind, or for correcting: finish what is none of it."""
        if kind is None or self.area is None or self.area.kind is not kind:
            self.finish()
        if kind is not None:
            self.select(None)

    def follow_page(self) -> None:
        """The page has changed: what is traced on it is selected, and nothing that is gone."""
        page = self._page
        if page.areas and not page.areas[-1].closed:
            self._index = len(page.areas) - 1
        elif len(page.areas) != self._count:
            self._index = None
        self._count = len(page.areas)

    @property
    def _page(self) -> AreasPage:
        return cast(AreasPage, self.document.page)

    def _append(self, text: str, area: Area) -> None:
        areas = self._page.areas
        self._change(text, (*areas, area), len(areas))

    def _change(
        self, text: str, areas: tuple[Area, ...], selected: int | None, gesture: object = None
    ) -> None:
        """Put other areas on the page, and select one, which may be at another place there."""
        area = None if selected is None else areas[selected]
        page = self._page.with_areas(areas)
        places = [at for at, one in enumerate(page.areas) if one is area or one == area]
        self._index = min(places, key=lambda at: abs(at - (selected or 0)), default=None)
        self._count = len(page.areas)
        self.document.change(text, page, gesture)
