"""Signed distances from a drawing's contour, where they are asked for."""

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.compiled import entry
from iconstudio.algorithms.nearby import Nearby

_SQUARE = 8
"""Side in pixels of the squares by which it is told where contours matter."""


class SignedDistance:
    """The distances in pixels from a drawing's contour, negative inside, at most ``far``.

    The contour is where the coverage, interpolated, is one half.

    Parameters
    ----------
    coverage
        (n, n) uint8, 255 = ink: the canvas.
    corners
        (p, 2): rows of (y, x). Distances can be asked for at all pixels between these.
    within
        Pixels by which these may lie below or to the right of the corners.
    far
        Contours further away, in pixels, are as good as so far.
    """

    def __init__(
        self, coverage: NDArray[np.uint8], corners: NDArray[np.intp], within: int, far: float
    ) -> None:
        self._coverage = coverage
        self._far = far
        reach = int(np.ceil(far)) + 1 + within
        self._contour = Nearby(_contour(coverage, corners, reach))

    def at(self, points: NDArray[np.intp]) -> NDArray[np.float64]:
        """Return the distances at ``points`` (p, 2), rows of (y, x)."""
        away, _ = self._contour.nearest(points.astype(np.float64), self._far)
        away = np.minimum(away, self._far)
        inside = self._coverage[points[:, 0], points[:, 1]] > 127
        return np.where(inside, -away, away)


@entry
def _contour(coverage, corners, reach):  # type: ignore[no-untyped-def]
    """Return points (p, 2) where the coverage crosses one half between neighbouring pixels.

    None is missing that is within ``reach`` pixels of a corner.
    """
    n = len(coverage)
    side, around = n // _SQUARE + 1, reach // _SQUARE + 1
    held = np.zeros((side, side), np.bool_)
    near = np.zeros((side, side), np.bool_)
    for k in range(len(corners)):
        row, column = corners[k, 0] // _SQUARE, corners[k, 1] // _SQUARE
        if not held[row, column]:
            held[row, column] = True
            top, left = max(0, row - around), max(0, column - around)
            near[top : row + around + 1, left : column + around + 1] = True
    found = np.empty((2 * _SQUARE**2 * near.sum(), 2))
    count = 0
    for row, column in np.argwhere(near):
        for y in range(row * _SQUARE, min(n, (row + 1) * _SQUARE)):
            for x in range(column * _SQUARE, min(n, (column + 1) * _SQUARE)):
                here = coverage[y, x]
                for down, right in ((1, 0), (0, 1)):
                    if y + down < n and x + right < n:
                        there = coverage[y + down, x + right]
                        if (here > 127) != (there > 127):
                            part = (127.5 - here) / (float(there) - float(here))
                            found[count, 0], found[count, 1] = y + down * part, x + right * part
                            count += 1
    return found[:count].copy()
