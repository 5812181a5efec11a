"""Which lines are meant, by a point near them or a box around a part of them."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from iconstudio.model import Line, Point

_Numbers = NDArray[np.float64]


def line_at(lines: Sequence[Line], point: Point, reach: float) -> int | None:
    """Return the number of the nearest line within ``reach`` canvas units of a point, or none.

    A stroke reaches as far as its ink; of several inks at the point, the nearest centre counts.
    """
    if not lines:
        return None
    starts, ways, owners = _segments(lines)
    lengths = np.maximum((ways**2).sum(axis=1), 1e-12)
    along = np.clip(((point - starts) * ways).sum(axis=1) / lengths, 0, 1)
    distances = np.hypot(*(starts + along[:, None] * ways - point).T)
    nearest = np.full(len(lines), np.inf)
    np.minimum.at(nearest, owners, distances)
    gaps = np.maximum(nearest - [line.width / 2 for line in lines], 0)
    best = int(np.lexsort((nearest, gaps))[0])
    return best if gaps[best] <= reach else None


def lines_in(lines: Sequence[Line], one: Point, other: Point) -> frozenset[int]:
    """Return the numbers of the lines that have a part in the box between two points.

    Segments are clipped by the box (Liang and Barsky).
    """
    if not lines:
        return frozenset()
    starts, ways, owners = _segments(lines)
    low, high = np.minimum(one, other), np.maximum(one, other)
    level = np.abs(ways) < 1e-12
    within = (starts >= low) & (starts <= high)
    safe = np.where(level, 1.0, ways)
    ends = np.sort(np.stack([(low - starts) / safe, (high - starts) / safe]), axis=0)
    enter = np.where(level, np.where(within, -np.inf, np.inf), ends[0]).max(axis=1)
    leave = np.where(level, np.where(within, np.inf, -np.inf), ends[1]).min(axis=1)
    hit = np.maximum(enter, 0) <= np.minimum(leave, 1)
    return frozenset(np.unique(owners[hit]).tolist())


def _segments(lines: Sequence[Line]) -> tuple[_Numbers, _Numbers, NDArray[np.intp]]:
    """Return where all segments begin, (n, 2), how they go on, and whose they are."""
    starts, ways, owners = [], [], []
    for number, line in enumerate(lines):
        points = np.array((*line.points, line.points[0]) if line.closed else line.points, float)
        starts.append(points[:-1])
        ways.append(np.diff(points, axis=0))
        owners.append(np.full(len(points) - 1, number))
    return np.concatenate(starts), np.concatenate(ways), np.concatenate(owners)
