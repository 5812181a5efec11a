"""How nearly a shape is a rectangle as photos show it: a quadrangle, perhaps cut by their edge."""

import numpy as np
import scipy
from numpy.typing import NDArray

_SIDES = 4
_SHARPEST = 50.0
"""Degrees of the sharpest corner that a rectangle seen askew has."""
_SHORTEST = 0.2
"""Its shortest side, as part of its longest one."""


def quadrangularity(shape: NDArray[np.bool_]) -> float:
    """Return how much of a small quadrangle around it a shape fills, from 0 to 1.

    ``shape`` is (h, w). Sides along the edge of the picture do not count: something reaches past
    it there. It is 0 if there is no quadrangle that may be a rectangle seen askew.
    """
    from skimage.draw import polygon2mask

    if not shape.any():
        return 0.0
    corners, own = quadrangle(shape)
    sides = np.roll(corners, -1, axis=0) - corners
    if len(sides) < _SIDES or own.sum() > _SIDES:
        return 0.0
    lengths = np.hypot(*sides.T)
    if own.all() and lengths.min() < _SHORTEST * lengths.max():
        return 0.0
    before = np.roll(own, 1) & own
    towards = sides / lengths[:, None]
    cosines = -(np.roll(towards, 1, axis=0) * towards).sum(axis=1)
    if (cosines[before] > np.cos(np.deg2rad(_SHARPEST))).any():
        return 0.0
    return float(shape.sum() / (shape | polygon2mask(shape.shape, corners)).sum())


def quadrangle(
    shape: NDArray[np.bool_], slack: float = 0.0
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Return (n, 2) corners around a shape, and which of the n sides lie within the picture.

    Of these there are four at most: from its convex hull, the side that adds least is left out,
    and those beside it are prolonged until they meet; so is what adds less than ``slack``, as part
    of the shape.
    """
    from scipy.spatial import ConvexHull

    points = np.argwhere(shape ^ scipy.ndimage.binary_erosion(shape)).astype(float)
    corners = points[ConvexHull(points).vertices]
    while True:
        own = ~_along_the_edge(corners, shape.shape)
        if own.sum() <= _SIDES and not slack:
            return corners, own
        added, meeting = _without_each(corners)
        side = int(np.argmin(np.where(own, added, np.inf)))
        few = own.sum() <= _SIDES and not added[side] < slack * shape.sum()
        if few or not np.isfinite(added[side]) or not own.any():
            return corners, own
        corners[side] = meeting[side]
        corners = np.delete(corners, (side + 1) % len(corners), axis=0)


def _along_the_edge(corners: NDArray[np.float64], shape: tuple[int, ...]) -> NDArray[np.bool_]:
    """Return (n,) which sides lie on the edge of the picture."""
    last = np.array(shape) - 1.0
    on = np.concatenate([corners <= 0, corners >= last], axis=1)
    along: NDArray[np.bool_] = (on & np.roll(on, -1, axis=0)).any(axis=1)
    return along


def _without_each(
    corners: NDArray[np.float64],
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return (n,) the area that is added if a side is left out, and (n, 2) where others meet then.

    Infinite where they do not meet.
    """
    sides = np.roll(corners, -1, axis=0) - corners
    before, after = np.roll(sides, 1, axis=0), np.roll(sides, -1, axis=0)
    turn = _cross(before, after)
    meet = turn > 1e-9
    reach = _cross(sides, after) / np.where(meet, turn, 1)
    meeting = corners + reach[:, None] * before
    return np.where(meet, abs(reach * _cross(sides, before)) / 2, np.inf), meeting


def _cross(first: NDArray[np.float64], second: NDArray[np.float64]) -> NDArray[np.float64]:
    product: NDArray[np.float64] = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    return product
