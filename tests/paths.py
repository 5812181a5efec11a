"""Paths of known shapes, and what tests compare of paths."""

from iconstudio.model import Path
from iconstudio.model.path import Contour

K = 0.5522847
"""Length of the handles of a quarter of a circle of radius 1."""


def circle(x: float, y: float, r: float) -> Path:
    h = K * r
    return Path(
        (
            Contour(
                (x + r, y),
                (
                    ((x + r, y + h), (x + h, y + r), (x, y + r)),
                    ((x - h, y + r), (x - r, y + h), (x - r, y)),
                    ((x - r, y - h), (x - h, y - r), (x, y - r)),
                    ((x + h, y - r), (x + r, y - h), (x + r, y)),
                ),
            ),
        )
    )


def rectangle(x: float, y: float, width: float, height: float) -> Path:
    corners = (x + width, y), (x + width, y + height), (x, y + height)
    return Path((Contour((x, y), tuple((one,) for one in corners)),))


def segments(path: Path) -> set:
    """Its lines and curves as sets of points, whichever way they run and wherever they begin."""
    found = set()
    for contour in path.contours:
        at = contour.start
        for segment in (*contour.segments, (contour.start,)):
            points = (at, *segment)
            row = tuple((round(x, 2), round(y, 2)) for x, y in points)
            if row[0] != row[-1]:
                found.add(min(row, row[::-1]))
            at = segment[-1]
    return found
