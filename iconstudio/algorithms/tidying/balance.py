"""What is nearly its own mirror image, but for a seam, becomes it."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.tidying.sides import LIMIT, Side, Sides, has_seam, turned
from iconstudio.algorithms.tracing.bezier import Points
from iconstudio.algorithms.tracing.source_curve import part_of

_SPACING = 1.0
"""Canvas units between the points by which contours are compared."""
_SAME = 0.2
"""Canvas units by which the halves of what is symmetric may differ."""
_OWN = 0.1
"""Part of the length of the differences that sources may have by themselves, at most."""


def balanced(contours: Sequence[Sides]) -> list[Sides]:
    """Return contours that are the same left and right, if they nearly are and seams are why not.

    The half that seams changed less stays.
    """
    if not has_seam([side for sides in contours for side in sides]):
        return list(contours)
    rows = [_points(sides) for sides in contours]
    points = np.concatenate([row for row, _ in rows])
    owners = np.concatenate([owners for _, owners in rows])
    numbers = np.repeat(np.arange(len(rows)), [len(row) for row, _ in rows])
    axis = (points.real.min() + points.real.max()) / 2
    for _ in range(3):
        image = _mirrored(points, axis)
        away, nearest = _nearest(points, image)
        if away.max() > 2 * LIMIT:
            return list(contours)
        axis += float(np.median((points[nearest] - image).real)) / 2
    image = _mirrored(points, axis)
    away, nearest = _nearest(points, image)
    off = away > max(_SAME, _SPACING / 2)
    if away.max() > LIMIT or not off.any():
        return list(contours)
    # Where a source is unlike its own mirror image, its author meant it.
    if (off & (owners == owners[nearest]) & (owners >= 0)).sum() > _OWN * off.sum():
        return list(contours)
    partners = [_partner(numbers[nearest[numbers == k]]) for k in range(len(rows))]
    if any(partners[one] != k for k, one in enumerate(partners)):
        return list(contours)
    left = [side for sides in contours for side in sides if _middle(side) < axis]
    right = [side for sides in contours for side in sides if _middle(side) > axis]
    keep = 1.0 if len(left) <= len(right) else -1.0
    found: list[Sides] = []
    for k, partner in enumerate(partners):
        whole = _whole(contours[k], contours[partner], partner == k, axis, keep)
        if whole is None:
            return list(contours)
        found.append(whole)
    return found


def _points(sides: Sides) -> tuple[Points, NDArray[np.intp]]:
    rows = [side.points(max(2, int(side.length / _SPACING) + 2))[:-1] for side in sides]
    owners = np.repeat([side.owner for side in sides], [len(row) for row in rows])
    return np.concatenate(rows), owners


def _nearest(points: Points, others: Points) -> tuple[NDArray[np.float64], NDArray[np.intp]]:
    """Return how far ``others`` are from the nearest of the points, and which these are."""
    pairs, wanted = (np.column_stack([row.real, row.imag]) for row in (points, others))
    tree = scipy.spatial.KDTree(pairs, balanced_tree=False, compact_nodes=False)
    away, nearest = tree.query(wanted)
    return away, nearest


def _partner(numbers: NDArray[np.intp]) -> int:
    """Return which contour most of these numbers name."""
    return int(np.bincount(numbers).argmax())


def _middle(side: Side) -> float:
    return (side.start.real + side.end.real) / 2


def _mirrored(points: Points, axis: float) -> Points:
    found: Points = 2 * axis - points.conj()
    return found


def _mirror(sides: Sides, axis: float) -> Sides:
    """Return the mirror image of sides, run the same way round."""
    return [
        Side(tuple(2 * axis - point.conjugate() for point in reversed(side.piece)), side.owner)
        for side in reversed(sides)
    ]


def _whole(sides: Sides, partner: Sides, crosses: bool, axis: float, keep: float) -> Sides | None:
    """Return a contour made of one half of it, or of its partner; ``keep`` is 1 for the left."""
    if not crosses:
        middle = np.mean([_middle(side) for side in sides])
        return sides if (axis - middle) * keep > 0 else _mirror(partner, axis)
    cut = [part for side in sides for part in _cut(side, axis)]
    kept = [(axis - side.points(3)[1].real) * keep > 0 for side in cut]
    starts = [k for k in range(len(cut)) if kept[k] and not kept[k - 1]]
    if len(starts) != 1:
        return None
    half = [side for side in turned(cut, starts[0])][: sum(kept)]
    first, last = (complex(axis, end.imag) for end in (half[0].start, half[-1].end))
    half[0] = half[0].beginning(first)
    half[-1] = half[-1].ending(last)
    return _merged([*half, *_mirror(half, axis)], (0, len(half)))


def _cut(side: Side, axis: float) -> list[Side]:
    """Return a side in parts that do not cross the axis."""
    heights = np.array([point.real - axis for point in side.piece])
    if side.is_line:
        powers = [heights[1] - heights[0], heights[0]]
    else:
        a, b, c, d = heights
        powers = [d - a + 3 * (b - c), 3 * (a - 2 * b + c), 3 * (b - a), a]
    if heights.min() >= 0 or heights.max() <= 0:
        return [side]
    roots = [root.real for root in np.roots(powers) if abs(root.imag) < 1e-9]
    ends = [0.0, *sorted(root for root in roots if 1e-6 < root < 1 - 1e-6), 1.0]
    return [Side(part_of(side.piece, one, other), side.owner) for one, other in pairwise(ends)]


def _merged(sides: Sides, joints: Sequence[int]) -> Sides:
    """Return a contour without nodes in the middle of lines that cross the axis."""
    gone = {
        joint
        for joint in joints
        if sides[joint].is_line
        and sides[joint - 1].is_line
        and abs(sides[joint].ways[0] - sides[joint - 1].ways[0]) < 1e-3
    }
    found: Sides = []
    for number in range(len(sides)):
        side = sides[number]
        if (number + 1) % len(sides) in gone:
            following = sides[(number + 1) % len(sides)]
            side = side.ending(following.end)
        if number not in gone:
            found.append(side)
    return found
