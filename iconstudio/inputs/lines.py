"""Points in files: those of very many are simplified once read, and few digits are written."""

from iconstudio.algorithms.geometry import simplified, simplified_line
from iconstudio.model import CANVAS, MARGIN, IconstudioError, Inner, Point, Polygon

Rows = tuple[tuple[Point, ...], ...]

STRAY = 0.2
"""How far, in canvas units, lines of more than ``MANY`` points may stray to have fewer."""
MANY = 500
"""Points that nobody draws by hand."""
MOST = 20_000
"""Points of an outline, once it is simplified: one with more fills the canvas with noise."""


def outline(points: tuple[Point, ...]) -> Polygon:
    """Return a polygon in any unit, simplified as for the canvas if it has many points.

    Raises
    ------
    IconstudioError
        If more than ``MOST`` are left.
    """
    polygon = Polygon.of(points)
    return _simpler(polygon, stray_of(polygon)) if len(polygon.vertices) > MANY else polygon


def stray_of(polygon: Polygon) -> float:
    """Return ``STRAY`` in the unit of a polygon that will be fitted to the canvas."""
    left, top, right, bottom = polygon.bounds
    return STRAY * max(right - left, bottom - top) / (CANVAS - 2 * MARGIN)


def area(points: tuple[Point, ...], stray: float = STRAY) -> Polygon:
    """Return a polygon, simplified within ``stray`` of its units if it has many points.

    Raises
    ------
    IconstudioError
        If more than ``MOST`` are left.
    """
    polygon = Polygon.of(points)
    return _simpler(polygon, stray) if len(polygon.vertices) > MANY else polygon


def inner(holes: Rows, lines: Rows, stray: float = STRAY) -> Inner:
    """Return inner outlines, simplified as areas and lines are; errors as for ``area``."""
    return Inner(
        tuple(area(hole, stray) for hole in holes), tuple(line(one, stray) for one in lines)
    )


def rows(drawn: Inner) -> tuple[Rows, Rows]:
    """Return holes and lines as they are written."""
    holes = tuple(rounded(hole.vertices) for hole in drawn.holes)
    return holes, tuple(map(rounded, drawn.lines))


def _simpler(polygon: Polygon, stray: float) -> Polygon:
    count = len(polygon.vertices)
    if count > MOST and (left := len(simplified_line(polygon.vertices, stray))) > MOST:
        raise IconstudioError(
            f"An outline of {count:,} points runs to and fro so much that {left:,} of them are "
            f"needed to draw it, and at most {MOST:,} can be. Trace it along the edge of the thing."
        )
    return simplified(polygon, stray)


def line(points: tuple[Point, ...], stray: float = STRAY) -> tuple[Point, ...]:
    """Return a line, simplified within ``stray`` of its units if it has many points."""
    return simplified_line(points, stray) if len(points) > MANY else points


def meets_canvas(points: tuple[Point, ...], width: float) -> bool:
    """Whether the box around a line of some width has a part of the canvas."""
    reach = width / 2
    xs, ys = ([point[axis] for point in points] for axis in (0, 1))
    return all(-reach < max(some) and min(some) < CANVAS + reach for some in (xs, ys))


def rounded(points: tuple[Point, ...]) -> tuple[Point, ...]:
    """Return points as they are written: to a hundredth of a pixel."""
    return tuple((round(x, 2), round(y, 2)) for x, y in points)
