"""Points in files: those of very many are simplified once read, and few digits are written."""

from iconstudio.algorithms.geometry import simplified, simplified_line
from iconstudio.model import CANVAS, MARGIN, Point, Polygon

STRAY = 0.2
"""How far, in canvas units, lines of more than ``MANY`` points may stray to have fewer."""
MANY = 500
"""Points that nobody draws by hand."""


def outline(points: tuple[Point, ...]) -> Polygon:
    """Return a polygon in any unit, simplified as for the canvas if it has many points."""
    polygon = Polygon.of(points)
    if len(polygon.vertices) <= MANY:
        return polygon
    left, top, right, bottom = polygon.bounds
    return simplified(polygon, STRAY * max(right - left, bottom - top) / (CANVAS - 2 * MARGIN))


def area(points: tuple[Point, ...]) -> Polygon:
    """Return a polygon in canvas units, simplified if it has many points."""
    polygon = Polygon.of(points)
    return simplified(polygon, STRAY) if len(polygon.vertices) > MANY else polygon


def line(points: tuple[Point, ...]) -> tuple[Point, ...]:
    """Return a line in canvas units, simplified if it has many points."""
    return simplified_line(points, STRAY) if len(points) > MANY else points


def rounded(points: tuple[Point, ...]) -> tuple[Point, ...]:
    """Return points as they are written: to a hundredth of a pixel."""
    return tuple((round(x, 2), round(y, 2)) for x, y in points)
