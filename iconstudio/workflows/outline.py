"""The edits of an outline, on any page that has one."""

from typing import Protocol, Self

from iconstudio.model import Point
from iconstudio.workflows.pages import Document, Page


class OutlinedPage(Page, Protocol):
    """A page with an outline, which is finished once it is ``closed``."""

    @property
    def vertices(self) -> tuple[Point, ...]:
        """The outline's vertices, finished or not."""
        ...

    @property
    def closed(self) -> bool:
        """Whether the last vertex is joined to the first."""
        ...

    def with_outline(self, vertices: tuple[Point, ...], closed: bool) -> Self:
        """Return the page with another outline."""
        ...


class Outline:
    """The outline of a document's page; every edit is one step that can be undone.

    A page of several outlines needs a subclass, which says which one is meant.
    """

    def __init__(self, document: Document[OutlinedPage]) -> None:
        self.document = document

    @property
    def vertices(self) -> tuple[Point, ...]:
        """The vertices, finished or not."""
        return self.document.page.vertices

    @property
    def closed(self) -> bool:
        """Whether the last vertex is joined to the first."""
        return self.document.page.closed

    def put(
        self, text: str, vertices: tuple[Point, ...], closed: bool, gesture: object = None
    ) -> None:
        """Replace the outline; ``text`` names the step."""
        page = self.document.page.with_outline(vertices, closed)
        self.document.change(text, page, gesture)

    def add(self, point: Point) -> None:
        """Append a vertex to the open outline."""
        self.put("add point", (*self.vertices, point), False)

    def insert(self, index: int, point: Point) -> None:
        """Put a vertex on the edge that starts at vertex ``index``."""
        vertices = (*self.vertices[: index + 1], point, *self.vertices[index + 1 :])
        self.put("insert point", vertices, self.closed)

    def move(self, index: int, point: Point, gesture: object) -> None:
        """Move vertex ``index``. Moves of one ``gesture`` are undone together."""
        vertices = (*self.vertices[:index], point, *self.vertices[index + 1 :])
        self.put("move point", vertices, self.closed, gesture)

    def delete(self, index: int) -> None:
        """Remove vertex ``index``; with fewer than three left, the outline is open again."""
        vertices = self.vertices[:index] + self.vertices[index + 1 :]
        self.put("delete point", vertices, self.closed and len(vertices) >= 3)

    def close(self) -> None:
        """Join the last vertex to the first."""
        self.put("close outline", self.vertices, True)

    def clear(self) -> None:
        """Remove all vertices; whatever else is on the page stays."""
        self.put("clear outline", (), False)
