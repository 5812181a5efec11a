"""The area that the tools work on, one among those of the page."""

from typing import Any, cast

from iconstudio.model import Point
from iconstudio.workflows.editing.page import Area, EditDocument, EditPage, Kind
from iconstudio.workflows.outline import Outline
from iconstudio.workflows.pages import Document


class AreaOutline(Outline):
    """The outline of the selected area; of none if nothing is selected.

    Which one is selected is no part of the page: to select is nothing that could be undone. An area
    that is still being traced is always the selected one.
    """

    document: Document[Any]

    def __init__(self, document: EditDocument) -> None:
        super().__init__(cast(Document[Any], document))
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

    def put(
        self, text: str, vertices: tuple[Point, ...], closed: bool, gesture: object = None
    ) -> None:
        """Replace the selected area; with too few vertices a finished one goes altogether."""
        index, area = self._index, self.area
        if index is None or area is None:
            return
        gone = not vertices or (area.closed and len(vertices) < 3)
        there = () if gone else (Area(area.kind, vertices, closed),)
        areas = self._page.areas
        page = self._page.with_areas((*areas[:index], *there, *areas[index + 1 :]))
        self.document.change(f"remove {_named(area)}" if gone else text, page, gesture)

    def begin(self, kind: Kind, point: Point) -> None:
        """Begin to trace an area."""
        self._append("add point", Area(kind, (point,), closed=False))

    def draw(self, kind: Kind, vertices: tuple[Point, ...]) -> None:
        """Add an area that was drawn in one go."""
        area = Area(kind, vertices)
        self._append(f"draw {_named(area)}", area)

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
            self.put("close outline", self.vertices if len(self.vertices) >= 3 else (), True)

    def follow_page(self) -> None:
        """The page has changed: what is traced on it is selected, and nothing that is gone."""
        page = self._page
        if page.open_area is not None:
            self._index = page.open_area
        elif len(page.areas) != self._count:
            self._index = None
        self._count = len(page.areas)

    @property
    def _page(self) -> EditPage:
        page: EditPage = self.document.page
        return page

    def _append(self, text: str, area: Area) -> None:
        page = self._page
        self.document.change(text, page.with_areas((*page.areas, area)))
        self._index = len(page.areas)


def _named(area: Area) -> str:
    return {Kind.REMOVE: "red area", Kind.ADD: "green area"}[area.kind]
