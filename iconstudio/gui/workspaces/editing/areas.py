"""The area that the tools work on, one among those of the page."""

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QPolygonF

from iconstudio.model import Point
from iconstudio.workflows.editing.page import Area, EditDocument, Kind
from iconstudio.workflows.outline import Outline

TOKENS = {Kind.REMOVE: "danger", Kind.ADD: "added"}
"""The colours of areas in the theme."""


class AreaOutline(Outline):
    """The outline of the selected area; of none if nothing is selected.

    Which one is selected is no part of the page: to select is nothing that could be undone. An area
    that is still being traced is always the selected one.
    """

    def __init__(self, document: EditDocument) -> None:
        super().__init__(document)
        self._index: int | None = None
        self._count = 0
        document.page_changed.connect(self._page_changed)

    @property
    def index(self) -> int | None:
        """Number of the selected area."""
        return self._index

    @property
    def area(self) -> Area | None:
        """The selected area."""
        return None if self._index is None else self.document.page.areas[self._index]

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
        if area is None:
            return
        gone = not vertices or (area.closed and len(vertices) < 3)
        there = () if gone else (Area(area.kind, vertices, closed),)
        areas = self.document.page.areas
        page = self.document.page.with_areas((*areas[:index], *there, *areas[index + 1 :]))
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

    def at(self, point: Point) -> int | None:
        """Return the area that is seen at a point: what is added lies above what is removed."""
        areas = self.document.page.areas
        order = sorted(range(len(areas)), key=lambda i: (areas[i].kind is Kind.ADD, i))
        for index in reversed(order):
            shape = QPolygonF([QPointF(*vertex) for vertex in areas[index].vertices])
            if shape.containsPoint(QPointF(*point), Qt.FillRule.WindingFill):
                return index
        return None

    def _append(self, text: str, area: Area) -> None:
        page = self.document.page
        self.document.change(text, page.with_areas((*page.areas, area)))
        self._index = len(page.areas)

    def _page_changed(self) -> None:
        page = self.document.page
        if page.open_area is not None:
            self._index = page.open_area
        elif len(page.areas) != self._count:
            self._index = None
        self._count = len(page.areas)


def _named(area: Area) -> str:
    return {Kind.REMOVE: "red area", Kind.ADD: "green area"}[area.kind]
