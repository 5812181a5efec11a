"""The edits of an outline, on any page that has one, and what of it lies at a point."""

from dataclasses import dataclass
from typing import Literal, Protocol, Self

import numpy as np
from numpy.typing import NDArray

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


@dataclass(frozen=True, slots=True)
class Hit:
    """What lies at a place: vertex ``index``, or the edge from there, and its nearest ``point``."""

    kind: Literal["vertex", "edge"]
    index: int
    point: Point


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

    @property
    def ring(self) -> bool:
        """Whether an edge leads from the last vertex to the first."""
        return self.closed

    @property
    def least(self) -> int:
        """How many vertices there must be to finish it."""
        return 3

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
        """Remove vertex ``index``; with too few left, the outline is open again."""
        vertices = self.vertices[:index] + self.vertices[index + 1 :]
        self.put("delete point", vertices, self.closed and len(vertices) >= self.least)

    def close(self) -> None:
        """Finish the outline: join the last vertex to the first."""
        self.put("close outline", self.vertices, True)

    def clear(self) -> None:
        """Remove all vertices; whatever else is on the page stays."""
        self.put("clear outline", (), False)

    def hit(self, place: Point, vertex_grip: float, edge_grip: float) -> Hit | None:
        """Return the vertex or edge within reach of a place, in page units; vertices come first."""
        if not self.vertices:
            return None
        points, spot = np.array(self.vertices, np.float64), np.array(place)
        gaps = np.hypot(*(points - spot).T)
        nearest = int(gaps.argmin())
        if gaps[nearest] <= vertex_grip:
            return Hit("vertex", nearest, self.vertices[nearest])
        feet = _feet(points, np.roll(points, -1, axis=0), spot)
        gaps = np.hypot(*(feet - spot).T)
        if not self.ring:
            gaps[-1] = np.inf  # the edge that would close it is not there
        nearest = int(gaps.argmin())
        if gaps[nearest] > edge_grip:
            return None
        x, y = feet[nearest].tolist()
        return Hit("edge", nearest, (x, y))


def _feet(
    starts: NDArray[np.float64], ends: NDArray[np.float64], spot: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return the point of each segment that is nearest to ``spot``, (n, 2)."""
    along = ends - starts
    length = (along**2).sum(axis=1)
    part = ((spot - starts) * along).sum(axis=1) / np.where(length > 0, length, 1)
    feet: NDArray[np.float64] = starts + along * part.clip(0, 1)[:, None]
    return feet
