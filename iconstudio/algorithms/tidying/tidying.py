"""Care for the whole: what seams brought about is put right, within a narrow limit.

Where sources meet, lines lean a little or go on beside themselves, circles are none, one stroke is
wider than the next, and what is alike left and right nearly is. All this is put right as long as no
contour is moved by more than 1.5% of the canvas. What one source drew is left as its author meant.
"""

from collections.abc import Mapping, Sequence

import numpy as np
import scipy

from iconstudio.algorithms.tidying.balance import balanced
from iconstudio.algorithms.tidying.pens import evened
from iconstudio.algorithms.tidying.round import rounded
from iconstudio.algorithms.tidying.sides import (
    LIMIT,
    SEAM,
    Sides,
    area,
    has_seam,
    points_of,
    turning,
)
from iconstudio.algorithms.tidying.straight import straightened

_CRUMB = 24.0
"""Square canvas units of the largest piece or hole that is a crumb."""
_ROUGHER = 0.35
"""Radians by which a contour may turn more than before in all: with more, it has bumps."""
_BUMPIER = 1.03
"""How many times as much all may turn with strokes of another width."""
_SPACING = 2.0
"""Canvas units between the points by which it is told how far a contour was moved."""


def tidied(contours: Sequence[Sides], pens: Mapping[int, float]) -> list[Sides]:
    """Return contours with what seams brought about put right.

    ``pens`` are the widths of the strokes of those sources that are drawn with one pen.
    """
    owners = {side.owner for sides in contours for side in sides}
    if len(owners - {SEAM}) < 2:
        return list(contours)
    kept = [sides for sides in contours if not _is_crumb(sides)] or list(contours)
    straight = [_better(straightened(sides), sides) for sides in kept]
    found = list(map(_better, rounded(straight), straight))
    even = evened(found, pens)
    if _turning(even) <= _turning(found) * _BUMPIER:
        found = even
    found = [one if is_near(one, sides) else sides for one, sides in zip(found, kept, strict=True)]
    whole = balanced(found)
    return whole if whole != found and all(map(is_near, whole, kept)) else found


def _better(sides: Sides, others: Sides) -> Sides:
    """Return a contour if it is no rougher than another one, and else that."""
    return sides if turning(sides) <= turning(others) + _ROUGHER else others


def _turning(contours: Sequence[Sides]) -> float:
    return sum(map(turning, contours))


def _is_crumb(sides: Sides) -> bool:
    """Whether a contour is a scrap that a seam left over: no source drew it so."""
    return has_seam(sides) and abs(area(sides)) < _CRUMB


def is_near(sides: Sides, others: Sides) -> bool:
    """Whether a contour is nowhere farther from another than the limit, nor that from it."""
    return sides is others or distance(sides, others) <= LIMIT


def distance(sides: Sides, others: Sides) -> float:
    """Return the Hausdorff distance of two contours, about."""
    rows = [
        np.column_stack([row.real, row.imag])
        for row in (points_of(sides, _SPACING), points_of(others, _SPACING))
    ]
    trees = [scipy.spatial.KDTree(row, balanced_tree=False, compact_nodes=False) for row in rows]
    return float(max(trees[0].query(rows[1])[0].max(), trees[1].query(rows[0])[0].max()))
