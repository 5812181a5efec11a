"""Dots and filled shapes beside strokes, as a pen draws them: round a ring, and what is in it.

Beyond the paper. A dot has no length that could be styled, and the edge of a shape is no line that
a pen draws: with a texture there it is ragged, beside strokes whose edges are smooth.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from iconstudio.algorithms.areas import (
    Area,
    Points,
    filled,
    outlines,
    size_of,
    stroked,
    united,
    without,
)
from iconstudio.model import Line

LONGEST = 4.0
"""Canvas units: a stroke that is no longer than this is a dot."""
_LARGEST = 2.2
"""How large a filled dot is at most, over the width of the widest stroke."""
_ROUNDED = 0.1
"""Part of a shape that a pen may lose in its corners."""
_ROUND = 0.8
"""Part of what a circle of its length encloses that a filled dot does, at least."""


def with_rings(lines: Sequence[Line]) -> list[Line]:
    """Return lines of which dots, and shapes beside strokes, are closed strokes without a hole.

    What is filled is a dot if there are strokes, none of which is much thinner than it is large;
    and a shape is drawn by the pen of the widest one, if that can draw it.
    """
    pen = max((line.width for line in lines), default=0.0)
    return [_ring(line, lines, pen) for line in lines]


def length(line: Line) -> float:
    """Return the length of a line, without what closes it."""
    points = np.array(line.points) @ [1, 1j]
    return float(abs(np.diff(points)).sum())


def _ring(line: Line, lines: Sequence[Line], pen: float) -> Line:
    points = np.array(line.points, dtype=float)
    if line.width:
        if length(line) > LONGEST:
            return line
        return _ringed(stroked(points, line.closed, line.width / 2), line.width / 2) or line
    if not pen or _is_in_company(line, lines):
        return line
    width = _extent(points).min() / 2
    if 0 < 2 * width < _LARGEST * pen and _is_round(points):
        return _ringed(_inset(points, width), width) or line
    ring = _ringed(_inset(points, pen), pen)
    if ring is None:
        return line
    inner, whole = np.array(ring.points), filled([points])
    drawn = united([filled([inner]), stroked(inner, True, pen)])
    is_same = size_of(without(whole, drawn)) < _ROUNDED * size_of(whole)
    return replace(ring, filled=True) if is_same else line


def _ringed(inner: Area, width: float) -> Line | None:
    """Return a closed stroke along the outline of an area, if that is one piece without a hole."""
    rings = outlines(inner)
    if len(rings) != 1:
        return None
    return Line(tuple((x, y) for x, y in rings[0].tolist()), closed=True, width=width)


def _inset(points: Points, width: float) -> Area:
    """Return what is left of a contour's inside if a stroke along it is taken off."""
    return without(filled([points]), stroked(points, True, width))


def _extent(points: Points) -> Points:
    extent: Points = np.ptp(points, axis=0)
    return extent


def _is_round(points: Points) -> bool:
    """Whether a contour is convex and not much longer than wide, or nearly so."""
    around = np.append(points, points[:1], axis=0) @ [1, 1j]
    area = (around[:-1].conj() * around[1:]).imag.sum() / 2
    whole = abs(np.diff(around)).sum() ** 2 / (4 * np.pi)
    return bool(abs(area) > _ROUND * whole)


def _is_in_company(line: Line, lines: Sequence[Line]) -> bool:
    """Whether another contour comes near: it may be a hole in this one, or the other way round."""
    boxes = np.array([_box(one) for one in lines if not one.width and one is not line])
    if not len(boxes):
        return False
    left, top, right, bottom = _box(line)
    apart = (boxes[:, 0] > right) | (boxes[:, 2] < left) | (boxes[:, 1] > bottom)
    return bool((~(apart | (boxes[:, 3] < top))).any())


def _box(line: Line) -> Points:
    points = np.array(line.points, dtype=float)
    return np.concatenate([points.min(axis=0), points.max(axis=0)])
