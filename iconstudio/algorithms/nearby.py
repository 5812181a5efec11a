"""The nearest of many points along curves, if it is not far: faster than a tree.

The points are sorted by square cells, so that few are compared with what is asked about.
"""

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.compiled import entry

_CELL = 8.0
"""Side of a cell, for points about 1 apart."""


class Nearby:
    """Points (p, 2) among which the nearest ones are sought; memory grows with their bounds."""

    def __init__(self, points: NDArray[np.float64]) -> None:
        self._order, self._starts, self._corner, self._shape = _by_cell(points)
        self._points = points[self._order]

    def nearest(
        self, asked: NDArray[np.float64], within: float
    ) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
        """Return how far the nearest is from each of some points (q, 2), and its number.

        If none is nearer than ``within``, that is infinity, and -1. It is fastest if points come
        after others near to them.
        """
        cells = self._starts, self._corner, self._shape
        found: tuple[NDArray[np.float64], NDArray[np.int64]] = _nearest(
            self._points, self._order, *cells, asked, float(within)
        )
        return found


@entry
def _by_cell(points):  # type: ignore[no-untyped-def]
    """Sort points (p, 2) by cells.

    Returns their numbers in order, where those of each cell begin, and what the cells cover: their
    corner, and how many there are along each axis.
    """
    corner, shape = np.zeros(2), np.ones(2, np.int64)
    for axis in range(2 if len(points) else 0):
        corner[axis] = points[:, axis].min()
        shape[axis] = int((points[:, axis].max() - corner[axis]) / _CELL) + 1
    cells = np.empty(len(points), np.int64)
    starts = np.zeros(shape[0] * shape[1] + 1, np.int64)
    for k in range(len(points)):
        row, column = (points[k, 0] - corner[0]) / _CELL, (points[k, 1] - corner[1]) / _CELL
        cells[k] = int(row) * shape[1] + int(column)
        starts[cells[k] + 1] += 1
    starts = np.cumsum(starts)
    free = starts.copy()
    order = np.empty(len(points), np.int64)
    for k in range(len(points)):
        order[free[cells[k]]] = k
        free[cells[k]] += 1
    return order, starts, corner, shape


@entry
def _nearest(  # type: ignore[no-untyped-def]
    points, order, starts, corner, shape, asked, within
):
    """Return distances (q,) and numbers (q,); ``points`` are in ``order``."""
    away = np.full(len(asked), np.inf)
    found = np.full(len(asked), -1, np.int64)
    last = -1
    for k in range(len(asked)):
        y, x = asked[k, 0], asked[k, 1]
        best, one, reach = within * within, -1, within
        if last >= 0:  # the nearest one of the point before is mostly near to this one, too
            square = (y - points[last, 0]) ** 2 + (x - points[last, 1]) ** 2
            if square < best:
                best, one, reach = square, last, np.sqrt(square)
        top = max(0, int(np.floor((y - reach - corner[0]) / _CELL)))
        bottom = min(shape[0] - 1, int(np.floor((y + reach - corner[0]) / _CELL)))
        left = min(shape[1], max(0, int(np.floor((x - reach - corner[1]) / _CELL))))
        right = max(-1, min(shape[1] - 1, int(np.floor((x + reach - corner[1]) / _CELL))))
        for row in range(top, bottom + 1):
            first, end = starts[row * shape[1] + left], starts[row * shape[1] + right + 1]
            for n in range(first, end):
                dy, dx = y - points[n, 0], x - points[n, 1]
                if dy * dy + dx * dx < best:
                    best, one = dy * dy + dx * dx, n
        if one >= 0:
            away[k], found[k], last = np.sqrt(best), order[one], one
    return away, found
