"""Strokes of nearly one width: what is of a source with a somewhat other pen is drawn with one.

The pen of a source is as wide as its strokes are nearly everywhere; a solid shape has none.
"""

from collections.abc import Iterable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.tidying.sides import LIMIT, SEAM, Side, Sides
from iconstudio.algorithms.tracing.bezier import Points
from iconstudio.algorithms.tracing.source_curve import SourceCurve
from iconstudio.model.path import Path

_SPACING, _EVERY = 1.0, 8
"""Canvas units between points of contours, and how many points there are to one asked."""
_FEWEST = 12
"""Points that are asked at least."""
_SPREAD = 0.12
"""Quartiles of the widths along a pen's strokes differ by no more, in parts."""
_WIDEST = 40.0
"""Canvas units of the widest pen."""
_NEAR = 0.35
"""Widths that differ by no more, in parts, are meant to be one."""
_CORNER = 0.3
"""Sine of the angle from which on two sides meet in a corner."""
_ONWARD = 0.9
"""Cosine of the angle by which a contour turns at most where it goes on."""
_UPRIGHT = 1e-3
"""Sine of the angle by which a line that is upright or level is off it at most."""


def pen_of(path: Path) -> float | None:
    """Return the width of the pen that drew an outline, in its units; None if none did."""
    curves = [SourceCurve.of(one, _SPACING) for one in path.contours if one.segments]
    rows = [_even(one) for one in curves if one.length > _FEWEST]
    if not rows:
        return None
    points = np.concatenate(rows)
    ways = np.concatenate([np.roll(row, -1) - np.roll(row, 1) for row in rows])
    normals = 1j * ways / np.maximum(abs(ways), 1e-9)
    if path.area < 0:
        normals = -normals
    some = slice(None, None, max(1, min(_EVERY, len(points) // _FEWEST)))
    widths = _widths(points, points[some], normals[some])
    low, middle, high = np.percentile(widths, [25, 50, 75])
    if not 0 < middle < _WIDEST or high - low > _SPREAD * middle:
        return None
    return float(middle)


def _even(curve: SourceCurve) -> Points:
    count = int(curve.length / _SPACING)
    return curve.at(np.arange(count) * curve.length / count)


def _widths(points: Points, some: Points, normals: Points) -> NDArray[np.float64]:
    """Return the diameters of the largest discs within a shape that touch it at ``some`` points."""
    away = points - some[:, None]
    depth = (away * normals.conj()[:, None]).real
    with np.errstate(divide="ignore", invalid="ignore"):
        # What is next to a point, along a straight side, says nothing of its disc.
        found = np.where(depth > 0.3 * abs(away), abs(away) ** 2 / depth, np.inf)
    widths: NDArray[np.float64] = found.min(axis=1)
    return widths


def evened(contours: Sequence[Sides], pens: Mapping[int, float]) -> list[Sides]:
    """Return contours with strokes of one width where their sources' are nearly one.

    ``pens`` are the widths of those sources that have one. That of most of the contour wins.
    """
    lengths: dict[int, float] = {}
    for sides in contours:
        for side in sides:
            lengths[side.owner] = lengths.get(side.owner, 0.0) + side.length
    lengths.pop(SEAM, None)
    thicker: dict[int, float] = {}
    groups = _groups(contours, lengths)
    widths = {group: _width(group, pens, lengths) for group in groups}
    drawn = {group: width for group, width in widths.items() if width}
    if not drawn:
        return list(contours)
    sizes = {group: sum(lengths[owner] for owner in group) for group in drawn}
    # The largest group, of those that have the most beside them that is nearly as wide.
    near = {
        one: sum(sizes[group] for group in drawn if _nearly(drawn[group], drawn[one]))
        for one in drawn
    }
    most = max(drawn, key=lambda one: (near[one], sizes[one]))
    for group, width in drawn.items():
        if _nearly(width, drawn[most]):
            thicker.update(dict.fromkeys(group, (drawn[most] - width) / 2))
    if not any(thicker.values()):
        return list(contours)
    return [_thickened(sides, thicker) for sides in contours]


def _nearly(one: float, other: float) -> bool:
    return abs(one - other) <= _NEAR * max(one, other)


def _width(
    group: Sequence[int], pens: Mapping[int, float], lengths: Mapping[int, float]
) -> float | None:
    """Return the mean width of the strokes of some sources; None if one of them is no pen's."""
    if not all(owner in pens for owner in group):
        return None
    total = sum(lengths[owner] for owner in group)
    return sum(lengths[owner] * pens[owner] for owner in group) / max(total, 1e-9)


def _groups(contours: Sequence[Sides], owners: Iterable[int]) -> list[tuple[int, ...]]:
    """Return the sources that are moved together: a curve of one goes on as another's.

    What is moved on one side of a seam alone would have a dent there.
    """
    leaders = {owner: owner for owner in owners}
    for sides in contours:
        known = [side for side in sides if side.owner != SEAM]
        for one, other in zip(known, known[1:] + known[:1], strict=True):
            smooth = (one.ways[1] * other.ways[0].conjugate()).real > _ONWARD
            if smooth and not (one.is_line and other.is_line):
                leader, led = leaders[one.owner], leaders[other.owner]
                leaders = {k: leader if now == led else now for k, now in leaders.items()}
    return [
        tuple(sorted(k for k, now in leaders.items() if now == leader))
        for leader in sorted(set(leaders.values()))
    ]


def _thickened(sides: Sides, thicker: Mapping[int, float]) -> Sides:
    """Return a contour with the sides of each owner moved outwards by some canvas units."""
    by = _along([None if side.owner == SEAM else thicker.get(side.owner, 0.0) for side in sides])
    if not by.any():
        return sides
    nodes = [
        side.start + _moved(sides[k - 1], float(by[k - 1]), side, float(by[k]))
        for k, side in enumerate(sides)
    ]
    return [
        _stretched(side, start, end)
        for side, start, end in zip(sides, nodes, nodes[1:] + nodes[:1], strict=True)
    ]


def _along(offsets: Sequence[float | None]) -> NDArray[np.float64]:
    """Return an offset for each side; those of a seam go from one source's to the other's."""
    known = [number for number, one in enumerate(offsets) if one is not None]
    if not known:
        return np.zeros(len(offsets))
    values = [one for one in offsets if one is not None]
    return np.interp(np.arange(len(offsets)), known, values, period=len(offsets))


def _moved(before: Side, by: float, after: Side, more: float) -> complex:
    """Return how the node between two sides moves that are moved outwards.

    In a corner both stay parallel to themselves; where that would lead far, and where one goes on
    as the other, the one that matters more.
    """
    normal, other = -1j * before.ways[1], -1j * after.ways[0]
    sine = (normal.conjugate() * other).imag
    if abs(sine) >= _CORNER:
        moved = 1j * (by * other - more * normal) / -sine
        if abs(moved) <= LIMIT:
            return moved
    first = max((before, after), key=_firm) is before
    return by * normal if first else more * other


def _firm(side: Side) -> tuple[bool, bool, float]:
    """Return how much it matters that a side stays parallel to itself, to be compared."""
    x, y = side.ways[0].real, side.ways[0].imag
    return side.is_line, side.is_line and min(abs(x), abs(y)) < _UPRIGHT, side.length


def _stretched(side: Side, start: complex, end: complex) -> Side:
    """Return a side between two other ends, its handles as directed as they were."""
    if side.is_line:
        return Side((start, end), side.owner)
    a, b, c, d = side.piece
    scale = abs(end - start) / abs(d - a) if abs(d - a) > 1e-6 else 1.0
    return Side((start, start + (b - a) * scale, end + (c - d) * scale, end), side.owner)
