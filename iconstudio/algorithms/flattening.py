"""Paths as rows of points, straight between them."""

import math

import numpy as np
from numpy.typing import NDArray

from iconstudio.model.path import Path

STRAY = 0.02
"""How far, in canvas units, the points' straight connection may be off the curve."""
_MOST = 500
"""Points of one curve."""


def flattened(path: Path, stray: float = STRAY) -> list[tuple[NDArray[np.float64], bool]]:
    """Return the points (n, 2) of each contour, none twice in a row, and whether it is closed.

    The last point of a closed one is not its first.
    """
    found = []
    for contour in path.contours:
        points = [np.array([contour.start], dtype=float)]
        at = contour.start
        for segment in contour.segments:
            points.append(np.array(segment) if len(segment) == 1 else _curve(at, segment, stray))
            at = segment[-1]
        row = np.concatenate(points)
        new = np.append(True, (row[1:] != row[:-1]).any(axis=1))
        row = row[new]
        if contour.closed and len(row) > 1 and (row[0] == row[-1]).all():
            row = row[:-1]
        found.append((row, contour.closed))
    return found


def _curve(
    start: tuple[float, float], segment: tuple[tuple[float, float], ...], stray: float
) -> NDArray[np.float64]:
    """Return points of a cubic after its start; how many, its second derivative tells."""
    p = np.array([start, *segment], dtype=float)
    bend = max(np.hypot(*(p[0] - 2 * p[1] + p[2])), np.hypot(*(p[1] - 2 * p[2] + p[3])))
    count = min(max(1, math.ceil(math.sqrt(6 * bend / 8 / stray))), _MOST)
    t = np.arange(1, count + 1)[:, None] / count
    u = 1 - t
    curve: NDArray[np.float64] = (
        u**3 * p[0] + 3 * u * u * t * p[1] + 3 * u * t * t * p[2] + t**3 * p[3]
    )
    curve[-1] = p[3]
    return curve
