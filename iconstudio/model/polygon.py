"""Polygons: the outlines that the user draws."""

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass

from iconstudio.model.canvas import CANVAS, MARGIN
from iconstudio.model.errors import IconstudioError

Point = tuple[float, float]


SLIMMEST = 0.04
"""Least width of a polygon that is remixed, as a part of its length: some 9 of 224 pixels.
Slimmer ones hold hardly a crumb of an icon."""


@dataclass(frozen=True, slots=True)
class Polygon:
    """A closed polygon, y down, in any unit; the last vertex joins the first."""

    vertices: tuple[Point, ...] = ()

    @classmethod
    def of(cls, points: Iterable[Iterable[float]]) -> "Polygon":
        """Return the polygon of ``points``; repeated neighbours are dropped.

        Raises
        ------
        IconstudioError
            If a coordinate is no finite number, or a point is no pair.

        Examples
        --------
        >>> Polygon.of([(0, 0), (0, 0), (4, 0), (4, 3), (0, 0)]).vertices
        ((0.0, 0.0), (4.0, 0.0), (4.0, 3.0))
        """
        vertices: list[Point] = []
        for number, point in enumerate(points, start=1):
            try:
                x, y = (float(value) for value in point)
            except (TypeError, ValueError):
                raise IconstudioError(
                    f"Point {number} of the polygon is not a pair of numbers: {point!r}."
                ) from None
            if not (math.isfinite(x) and math.isfinite(y)):
                raise IconstudioError(
                    f"Point {number} of the polygon is not finite: ({x}, {y}). Remove it."
                )
            if max(abs(x), abs(y)) > 1e9:
                raise IconstudioError(
                    f"Point {number} of the polygon, ({x:g}, {y:g}), is out of all scale. "
                    "Use coordinates below a thousand million."
                )
            if not vertices or (x, y) != vertices[-1]:
                vertices.append((x, y))
        if len(vertices) > 1 and vertices[0] == vertices[-1]:
            vertices.pop()
        return cls(tuple(vertices))

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Left, top, right, bottom."""
        xs, ys = zip(*self.vertices, strict=True)
        return min(xs), min(ys), max(xs), max(ys)

    def fitted(self) -> "Polygon":
        """Return the polygon scaled by its bounding box to the canvas, and centred.

        Raises
        ------
        IconstudioError
            If there are fewer than three vertices, they enclose no area, or it is too slim.

        Examples
        --------
        >>> Polygon(((0, 0), (2, 0), (2, 1))).fitted().bounds
        (16.0, 72.0, 240.0, 184.0)
        """
        return Polygon(tuple(map(self.fitting(), self.vertices)))

    def fitting(self) -> Callable[[Point], Point]:
        """Return what moves each point as ``fitted`` moves the polygon; errors as there."""
        self.check_area()
        left, top, right, bottom = self.bounds
        size = max(right - left, bottom - top)
        width, _ = self._spread()
        if min(width, right - left, bottom - top) <= SLIMMEST * size:
            raise IconstudioError(
                f"The polygon is too slim: it is not even {SLIMMEST:.0%} as wide as it is long, "
                "and parts of icons would not fit in. Draw it wider."
            )
        k = (CANVAS - 2 * MARGIN) / size
        cx, cy = (left + right) / 2, (top + bottom) / 2
        return lambda at: ((at[0] - cx) * k + CANVAS / 2, (at[1] - cy) * k + CANVAS / 2)

    def check_area(self) -> None:
        """Refuse what encloses nothing.

        Raises
        ------
        IconstudioError
            If there are fewer than three vertices, or all lie on a line.
        """
        if (count := len(self.vertices)) < 3:
            points = "point" if count == 1 else "different points"
            raise IconstudioError(f"The polygon has {count} {points}; draw at least 3.")
        width, length = self._spread()
        if width <= 1e-6 * length:
            raise IconstudioError(
                "The polygon encloses no area: its points lie on a line. Draw around the object."
            )

    def _spread(self) -> tuple[float, float]:
        """Return how wide the polygon is across the line along which it is longest, and how long.

        That line goes through the first vertex.
        """
        x0, y0 = self.vertices[0]
        x1, y1 = max(self.vertices, key=lambda p: math.dist(p, (x0, y0)))
        length = math.dist((x0, y0), (x1, y1)) or 1.0
        sides = [((x1 - x0) * (y - y0) - (y1 - y0) * (x - x0)) / length for x, y in self.vertices]
        return max(sides) - min(sides), length
