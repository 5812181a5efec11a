"""Lines cut by arc length: dashed, as pens are lifted, or shortened at their ends."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.float64]
"""(n, 2), rows of (x, y)."""

_MOST = 2_000
"""Dashes of one line."""


def dashed(points: Points, closed: bool, pattern: Sequence[float], offset: float) -> list[Points]:
    """Return the dashes of a line: ``pattern`` is dash, gap, dash, gap, in turn (SVG 2, 13.5.6).

    A line without length, or with too many dashes to be seen, stays whole.
    """
    if closed:
        points = np.concatenate([points, points[:1]])
    whole = _along(points)[-1]
    period = float(sum(pattern))
    if not whole or not period or whole / period * len(pattern) > _MOST:
        return [points]
    edges = np.concatenate([[0.0], np.cumsum(pattern)])
    found = []
    turn = np.floor(offset / period) * period - offset
    while turn < whole:
        for start, end in zip(edges[:-1:2], edges[1::2], strict=True):
            first, last = max(turn + start, 0.0), min(turn + end, whole)
            if first < last or (first == last == turn + start):
                found.append(part(points, first, last))
        turn += period
    return found


def part(points: Points, first: float, last: float) -> Points:
    """Return an open line from one arc length to another; both lie on it."""
    along = _along(points)
    inside = points[(along > first) & (along < last)]
    ends = [[np.interp(at, along, points[:, axis]) for axis in (0, 1)] for at in (first, last)]
    return np.concatenate([ends[:1], inside, ends[1:]])


def length_of(points: Points) -> float:
    """Return the arc length of an open line."""
    return float(_along(points)[-1])


def _along(points: Points) -> NDArray[np.float64]:
    steps = np.diff(points, axis=0)
    return np.concatenate([[0.0], np.cumsum(np.hypot(steps[:, 0], steps[:, 1]))])
