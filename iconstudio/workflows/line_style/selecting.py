"""Which lines are meant, by a point near them or a box around a part of them."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from iconstudio.model import Line, Point

_STEP = 2.0
"""Canvas units between the points of a line that a box may hold."""


def line_at(lines: Sequence[Line], point: Point, reach: float) -> int | None:
    """Return the number of the nearest line within ``reach`` canvas units of a point, or none.

    A stroke reaches as far as its ink.
    """
    gaps = [max(0.0, _distance(line, point) - line.width / 2) for line in lines]
    if not gaps or min(gaps) > reach:
        return None
    return min(range(len(gaps)), key=lambda n: (gaps[n], _distance(lines[n], point)))


def lines_in(lines: Sequence[Line], one: Point, other: Point) -> frozenset[int]:
    """Return the numbers of the lines that have a part in the box between two points."""
    low, high = np.minimum(one, other), np.maximum(one, other)
    return frozenset(
        number
        for number, line in enumerate(lines)
        if ((_dense(line) >= low) & (_dense(line) <= high)).all(axis=1).any()
    )


def _segments(line: Line) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return where the segments of a line begin, (n, 2), and how they go on from there."""
    points = np.array((*line.points, line.points[0]) if line.closed else line.points, dtype=float)
    return points[:-1], np.diff(points, axis=0)


def _distance(line: Line, point: Point) -> float:
    starts, ways = _segments(line)
    lengths = np.maximum((ways**2).sum(axis=1), 1e-12)
    along = np.clip(((point - starts) * ways).sum(axis=1) / lengths, 0, 1)
    gaps: NDArray[np.float64] = np.hypot(*(starts + along[:, None] * ways - point).T)
    return float(gaps.min(initial=np.inf))


def _dense(line: Line) -> NDArray[np.float64]:
    starts, ways = _segments(line)
    counts = np.ceil(np.hypot(*ways.T) / _STEP).astype(int) + 1
    each = np.repeat(np.arange(len(starts)), counts)
    along = np.concatenate([np.linspace(0, 1, count) for count in counts])
    dense: NDArray[np.float64] = starts[each] + along[:, None] * ways[each]
    return dense
