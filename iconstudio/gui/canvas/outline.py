"""The edits of an outline, on any page that has one."""

from typing import Protocol, Self

from iconstudio.gui.document import Document, Page
from iconstudio.model import Point


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


Outlined = Document[OutlinedPage]


def add_vertex(document: Outlined, point: Point) -> None:
    """Append a vertex to the open outline."""
    page = document.page
    document.change("add point", page.with_outline((*page.vertices, point), False))


def insert_vertex(document: Outlined, index: int, point: Point) -> None:
    """Put a vertex on the edge that starts at vertex ``index``."""
    page = document.page
    vertices = (*page.vertices[: index + 1], point, *page.vertices[index + 1 :])
    document.change("insert point", page.with_outline(vertices, page.closed))


def move_vertex(document: Outlined, index: int, point: Point, gesture: object) -> None:
    """Move vertex ``index``. Moves of one ``gesture`` are undone together."""
    page = document.page
    vertices = (*page.vertices[:index], point, *page.vertices[index + 1 :])
    document.change("move point", page.with_outline(vertices, page.closed), gesture)


def delete_vertex(document: Outlined, index: int) -> None:
    """Remove vertex ``index``; with fewer than three left, the outline is open again."""
    page = document.page
    vertices = page.vertices[:index] + page.vertices[index + 1 :]
    closed = page.closed and len(vertices) >= 3
    document.change("delete point", page.with_outline(vertices, closed))


def close_outline(document: Outlined) -> None:
    """Join the last vertex to the first."""
    page = document.page
    document.change("close outline", page.with_outline(page.vertices, True))


def clear_outline(document: Outlined) -> None:
    """Remove all vertices; whatever else is on the page stays."""
    document.change("clear outline", document.page.with_outline((), False))
