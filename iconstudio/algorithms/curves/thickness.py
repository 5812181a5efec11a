"""Thin shapes and near neighbours: styled lines go no farther than there is room beside plain ones.

Beyond the paper. Half of what lies between a line and the one that it faces, inside of a shape or
outside, is its own; of that, texture takes a part. Where it would take more it becomes flatter,
gradually, so that it stays of one hand.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy.ndimage import gaussian_filter1d, maximum_filter1d, minimum_filter1d
from scipy.spatial import cKDTree

from iconstudio.algorithms.curves.curve import Curve, Numbers, Points

_PART = 0.5
"""How much of its half a line may take."""
_STEP, _STEPS = 1.5, 40
"""Least canvas units between samples of plain lines, and how many at least lead to neighbours."""
_FACING, _ASIDE = np.cos(np.radians([30, 45]))
"""Cosine of the angle to the normal at which a neighbour faces a line, and at which it does not:
the sides of a corner meet, and leave room enough."""
_AROUND = 12.0
"""Canvas units to each side along which the largest offset counts."""
_GRADUAL = 6.0
"""Canvas units along which texture becomes flatter."""
_SAME = 1e-6
"""Canvas units that are rounding."""
_LEFT, _RIGHT = 0, 1


def held_back(
    plain: Sequence[Curve], styled: Sequence[Curve], widths: Sequence[float]
) -> list[Curve]:
    """Return the styled curves, nearer to the plain ones where there is little room.

    ``widths`` are those of strokes, 0 of contours. Strokes give way to other lines alone, unless
    they overlap when plain.
    """
    reach = 2 / _PART * max(_farthest(*both) for both in zip(plain, styled, strict=True))
    step = max(_STEP, reach / _STEPS)
    sampled = [one.resampled(step) for one in plain]
    rooms = _rooms(sampled, widths, step, reach)
    return [
        _flattened(one, made, _needed(one, made, some, step), room, step)
        for one, made, some, room in zip(plain, styled, sampled, rooms, strict=True)
    ]


def _farthest(plain: Curve, styled: Curve) -> float:
    return float(abs(styled.points - plain.at(styled.parameters)).max())


def _needed(plain: Curve, styled: Curve, sampled: Curve, step: float) -> Numbers:
    """Return how far a styled curve goes to the left and right of samples, nearby, (2, n)."""
    at = styled.parameters
    along = plain.arc_at(at)
    off = (_ways(plain, along, step).conj() * (styled.points - plain.at(at))).imag
    places = plain.arc_at(sampled.parameters)
    here = np.interp(places, along, off, period=plain.length if plain.closed else None)
    widest: Numbers = maximum_filter1d(
        np.maximum(0.0, [here, -here]), 2 * round(_AROUND / step) + 1, mode=_mode(plain)
    )
    return widest


def _rooms(
    curves: Sequence[Curve], widths: Sequence[float], step: float, reach: float
) -> list[Numbers]:
    """Return half of what is free to the left and right of samples, (2, n); infinite if much is."""
    counts = [len(one.points) for one in curves]
    points = np.concatenate([one.points for one in curves])
    ways = np.concatenate([_ways(one, one.arc_at(one.parameters), step) for one in curves])
    radius, line = (np.repeat(one, counts) for one in (np.array(widths) / 2, range(len(curves))))
    found = np.full((2, len(points)), np.inf)
    tree = cKDTree(np.stack([points.real, points.imag], axis=1))
    pairs = tree.query_pairs(reach + 2 * radius.max(), output_type="ndarray")
    for i, j in (pairs.T, pairs.T[::-1]):
        way = points[j] - points[i]
        apart = np.maximum(abs(way), _SAME)
        here, there = (ways[i].conj() * way).imag / apart, (ways[j].conj() * way).imag / apart
        facing = np.minimum(abs(here), abs(there))
        share = np.clip((facing - _ASIDE) / (_FACING - _ASIDE), 0, 1)
        free = apart - radius[i] - radius[j]
        # A stroke may come near itself, as handwriting does.
        some = (share > 0) & (free > _SAME) & ((line[i] != line[j]) | (radius[i] == 0))
        side = np.where(here > 0, _LEFT, _RIGHT)
        np.minimum.at(found, (side[some], i[some]), free[some] / (2 * share[some]))
    return np.split(found, np.cumsum(counts)[:-1], axis=1)


def _ways(curve: Curve, along: Numbers, step: float) -> Points:
    """Return the directions of a curve after so much arc length."""
    ways = curve.at_arc(along + step / 2) - curve.at_arc(along - step / 2)
    return ways / np.maximum(abs(ways), _SAME)


def _flattened(plain: Curve, styled: Curve, needed: Numbers, room: Numbers, step: float) -> Curve:
    """Return a styled curve with no more of its offsets at each sample than there is room for."""
    part = np.minimum(1.0, _PART * room / np.maximum(needed, _SAME)).min(axis=0)
    if part.min() == 1.0:
        return styled
    reach = max(1, round(_GRADUAL / step))
    least = minimum_filter1d(part, 2 * reach + 1, mode=_mode(plain))
    gradual = gaussian_filter1d(least, reach / 2, mode=_mode(plain), radius=reach)
    if plain.closed:
        gradual = np.append(gradual, gradual[0])
    places = np.linspace(0, plain.length, len(gradual))
    kept = np.interp(plain.arc_at(styled.parameters), places, gradual)
    before = plain.at(styled.parameters)
    return replace(styled, points=before + kept * (styled.points - before))


def _mode(curve: Curve) -> str:
    return "wrap" if curve.closed else "nearest"
