"""Contours of areas and of paths, as lines."""

from iconstudio.algorithms import areas
from iconstudio.algorithms.areas import Area, Points
from iconstudio.algorithms.flattening import flattened
from iconstudio.model import Line, Point
from iconstudio.model.path import Path


def contours_of(area: Area) -> tuple[Line, ...]:
    """Return the contours of an area, holes the other way round than what is around them."""
    return tuple(Line(pairs(one), True) for one in areas.outlines(area))


def contours_of_path(path: Path) -> tuple[Line, ...]:
    """Return the contours of what a path fills by the nonzero rule, without overlaps."""
    return contours_of(areas.filled(row for row, _ in flattened(path)))


def pairs(points: Points) -> tuple[Point, ...]:
    """Return points (n, 2) as plain numbers."""
    return tuple((x, y) for x, y in points.tolist())
