"""Lines as a drawing: one filled outline of few cubics, or strokes for who draws them."""

from collections.abc import Iterable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms import areas
from iconstudio.algorithms.areas import Area, Points
from iconstudio.algorithms.curves.brush import sides, turns
from iconstudio.algorithms.curves.fitting import fitted
from iconstudio.model import Line
from iconstudio.model.path import Contour, Path

_STRAY = 0.02
"""Canvas units by which points may be left out before curves are fitted."""
_SPECK = 2.0
"""Square canvas units: smaller pieces and holes, which nobody sees, are left out."""
_PINHOLE = 1 / 3
"""Side of a hole, over the width of the widest stroke, which looks like a fault if smaller."""


def path_of(lines: Iterable[Line]) -> Path:
    """Return what lines draw as one outline without overlaps, filled by the nonzero rule.

    Contours are filled together (``areas.inked``); strokes have round ends and joins.
    """
    contours: list[Points] = []
    strokes: list[Area] = []
    widest = 0.0
    for line in lines:
        widest = max(widest, line.width)
        points = _points(line)
        if line.widths:
            strokes.append(_brushed(points, line.closed, np.array(line.widths, dtype=float)))
        elif line.width > 0:
            strokes.append(areas.stroked(_without_repeats(points), line.closed, line.width))
        else:
            contours.append(_without_repeats(points))
        if line.filled:
            strokes.append(areas.filled([_without_repeats(points)]))
    whole = areas.united([areas.inked(contours), *strokes])
    hole = max(_SPECK, (_PINHOLE * widest) ** 2)
    rings = areas.outlines(areas.without_specks(whole, _SPECK, hole), _STRAY)
    return Path(tuple(_fitted(ring, True) for ring in rings))


def strokes_of(lines: Iterable[Line]) -> tuple[tuple[Path, float], ...]:
    """Return what lines draw as paths, each with the width of its stroke; 0 is filled instead.

    Strokes of one width are one path, with round ends and joins; those whose width is not the same
    all along are filled, as contours and the insides of filled strokes are.
    """
    lines = tuple(lines)
    inside = (replace(line, width=0.0, widths=(), filled=False) for line in lines if line.filled)
    filled = path_of((*(line for line in lines if line.widths or line.width <= 0), *inside))
    strokes: dict[float, list[Contour]] = {}
    for line in lines:
        if line.width > 0 and not line.widths:
            points = areas.simplified(_without_repeats(_points(line)), line.closed, _STRAY)
            strokes.setdefault(line.width, []).append(_fitted(points, line.closed))
    found = [(Path(tuple(contours)), width) for width, contours in strokes.items()]
    return tuple([(filled, 0.0)] * bool(filled) + found)


def _fitted(points: Points, closed: bool) -> Contour:
    return fitted(points[:, 0] + 1j * points[:, 1], closed)


def _brushed(points: Points, closed: bool, widths: NDArray[np.float64]) -> Area:
    """Return what a round brush covers along a line, with its width at each point."""
    new = _is_new(points)
    points, widths = points[new], np.maximum(widths[new], 0)
    row = points[:, 0] + 1j * points[:, 1]
    rings = sides(row, closed, widths / 2)
    discs = [areas.stroked(points[[at]], False, widths[at]) for at in turns(row, closed)]
    return areas.united(
        [areas.filled(np.column_stack([one.real, one.imag]) for one in rings), *discs]
    )


def _points(line: Line) -> Points:
    return np.array(line.points, dtype=float).reshape(-1, 2)


def _without_repeats(points: Points) -> Points:
    return points[_is_new(points)]


def _is_new(points: Points) -> NDArray[np.bool_]:
    """Return which points are not where the one before is."""
    new: NDArray[np.bool_] = np.append(True, (points[1:] != points[:-1]).any(axis=1))
    return new
