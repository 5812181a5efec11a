"""No new crossings, and no new contacts: styled lines give way where the plain ones do not meet.

Beyond the paper. Where two styled lines, or two parts of one, cross or nearly touch and the plain
ones do not (the sides of an open line's tip excepted), both go back towards the plain ones, along
a short stretch: as little as is enough. In the end that always is, as the plain lines do not cross
there.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from iconstudio.algorithms.areas import meeting_boxes
from iconstudio.algorithms.curves.curve import Curve, Numbers, Points
from iconstudio.algorithms.curves.example import Pair

_CLEARANCE = 1.0
"""Canvas units between the edges of lines that did not touch ..."""
_KEPT = 0.6
"""... or so much of what was between them, if that is less."""
_BACK = 0.65
"""How much of the style is left at a conflict after each round."""
_ROUNDS = 14
_STRAIGHT = 0.85
"""What goes so much of the way as the crow flies goes straight."""
_SAME = 1e-6
"""Canvas units that are rounding."""
_SPACED = 0.25
"""Between points of a stroke that tell what it touches, over half its width."""
_STRETCH = 6.0
"""Canvas units: standard deviation of the stretch that gives way."""


@dataclass(frozen=True, eq=False)
class _Lines:
    """All points of all lines, one line after the other."""

    points: Points
    plain: Points
    line: NDArray[np.int64]
    following: NDArray[np.int64]
    """The index of the next point of the line; its own at an open end."""
    arc: Numbers
    """Along the plain line."""
    length: Numbers
    """Of the plain line, if it is closed; else infinite."""
    radius: Numbers
    """Half the width of the stroke."""


def untangled(
    plain: Sequence[Curve], styled: Sequence[Curve], widths: Sequence[float], loop: float = 0.0
) -> list[Curve]:
    """Return the styled curves without crossings and contacts that the plain ones have not.

    Crossings of a curve with itself are no conflict within ``loop`` canvas units along it: a style
    may have loops.
    """
    lines = _gathered(plain, styled, widths)
    kept = np.ones(len(lines.points))
    for number in range(_ROUNDS):
        moved = replace(lines, points=lines.plain + kept * (lines.points - lines.plain))
        conflicts = _conflicts(moved, lines.plain, loop)
        if not len(conflicts):
            break
        kept *= _giving_way(lines, conflicts, _BACK if number < _ROUNDS - 2 else 0.0)
    else:
        moved = replace(lines, points=lines.plain + kept * (lines.points - lines.plain))
    return [
        replace(curve, points=moved.points[lines.line == number])
        for number, curve in enumerate(styled)
    ]


def longest_loop(pair: Pair) -> float:
    """Return how much of the plain line the longest loop of an example's styled line takes."""
    lines = _gathered([pair.plain], [pair.styled], [0.0])
    first = np.flatnonzero(lines.following != np.arange(len(lines.points)))
    crossing = first[_crossing(lines.points, first, lines.following[first])]
    return float(_apart(lines, crossing[:, 0], crossing[:, 1]).max(initial=0))


def _gathered(plain: Sequence[Curve], styled: Sequence[Curve], widths: Sequence[float]) -> _Lines:
    before = [one.at(made.parameters) for one, made in zip(plain, styled, strict=True)]
    counts = [len(one.points) for one in styled]
    starts = np.cumsum([0, *counts[:-1]])
    following = [
        start + np.append(np.arange(1, count), 0 if one.closed else count - 1)
        for start, count, one in zip(starts, counts, styled, strict=True)
    ]
    return _Lines(
        np.concatenate([one.points for one in styled]),
        np.concatenate(before),
        np.repeat(np.arange(len(styled)), counts),
        np.concatenate(following),
        np.concatenate(
            [one.arc_at(made.parameters) for one, made in zip(plain, styled, strict=True)]
        ),
        np.repeat([one.length if one.closed else np.inf for one in plain], counts),
        np.repeat(np.array(widths) / 2, counts),
    )


def _conflicts(lines: _Lines, plain: Points, loop: float) -> NDArray[np.int64]:
    """Return the indices of all points at which lines cross or touch newly."""
    return np.unique(np.concatenate([_crossings(lines, loop), _contacts(lines, plain, loop)]))


def _crossings(lines: _Lines, loop: float) -> NDArray[np.int64]:
    first = np.flatnonzero(lines.following != np.arange(len(lines.points)))
    second = lines.following[first]
    crossing = _crossing(lines.points, first, second)
    before = _crossing(lines.plain, first, second)
    new = crossing[~_known(lines, first, crossing, before)]
    i, j = first[new[:, 0]], first[new[:, 1]]
    far = ~((lines.line[i] == lines.line[j]) & (_apart(lines, i, j) < loop))
    # Strokes that overlap anyway may cross, and so may the sides of a tip.
    far &= abs(lines.plain[i] - lines.plain[j]) > lines.radius[i] + lines.radius[j] + _SAME
    far &= ~_at_a_tip(lines, i, j)
    return np.concatenate([i[far], j[far]])


def _crossing(
    points: Points, first: NDArray[np.int64], second: NDArray[np.int64]
) -> NDArray[np.int64]:
    """Return the pairs of segments that cross, (n, 2)."""
    a, b = points[first], points[second]
    i, j = meeting_boxes(_plane(a), _plane(b)).T
    apart = (second[i] != first[j]) & (second[j] != first[i])
    i, j = i[apart], j[apart]
    cross = (_side(a[i], b[i], a[j]) * _side(a[i], b[i], b[j]) < 0) & (
        _side(a[j], b[j], a[i]) * _side(a[j], b[j], b[i]) < 0
    )
    return np.stack([i[cross], j[cross]], axis=1)


def _side(a: Points, b: Points, c: Points) -> Numbers:
    """Return on which side of the lines from a to b the points c lie: 0 on them, but for rounding.

    Along a straight line, rounding would tell crossings.
    """
    sides: Numbers = ((b - a).conj() * (c - a)).imag
    return np.where(abs(sides) < _SAME * abs(b - a), 0.0, sides)


def _known(
    lines: _Lines,
    first: NDArray[np.int64],
    crossing: NDArray[np.int64],
    before: NDArray[np.int64],
) -> NDArray[np.bool_]:
    """Return which crossings are those of the plain lines, moved a little."""
    known = np.zeros(len(crossing), bool)
    for i, j in first[before]:
        for a, b in ((i, j), (j, i)):
            same = (lines.line[first[crossing[:, 0]]] == lines.line[a]) & (
                lines.line[first[crossing[:, 1]]] == lines.line[b]
            )
            near = (_apart(lines, first[crossing[:, 0]], a) < 3 * _STRETCH) & (
                _apart(lines, first[crossing[:, 1]], b) < 3 * _STRETCH
            )
            known |= same & near
    return known


def _contacts(lines: _Lines, plain: Points, loop: float) -> NDArray[np.int64]:
    """Return the points whose edges are too near to those of others, and were not."""
    points, radius = lines.points, lines.radius
    some = _spaced(lines)
    tree = cKDTree(_plane(points[some]))
    pairs = tree.query_pairs(2 * radius.max() + _CLEARANCE, output_type="ndarray")
    i, j = some[pairs[:, 0]], some[pairs[:, 1]]
    touch = radius[i] + radius[j]
    apart, before = abs(points[i] - points[j]) - touch, abs(plain[i] - plain[j]) - touch
    tight = (before > _SAME) & (apart < np.minimum(_CLEARANCE, _KEPT * before))
    i, j = i[tight], j[tight]
    along = _apart(lines, i, j)
    same = lines.line[i] == lines.line[j]
    # Along one line, what is near is no contact; nor where the line itself turns back so tightly.
    near = same & (along < np.maximum(loop, 3 * (radius[i] + radius[j]) + 4 * _CLEARANCE))
    near |= _at_a_tip(lines, i, j)
    return np.concatenate([i[~near], j[~near]])


def _spaced(lines: _Lines) -> NDArray[np.int64]:
    """Return points that are enough to tell how near thick strokes come."""
    steps = abs(lines.points[lines.following] - lines.points)
    along = np.cumsum(steps)
    number = np.floor(along / np.maximum(_SPACED * lines.radius, _SAME))
    new = np.append(True, (np.diff(number) > 0) | (np.diff(lines.line) > 0))
    return np.flatnonzero(new | (lines.radius == 0))


def _at_a_tip(lines: _Lines, i: NDArray[np.int64], j: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Return which points of an open line lie on both sides of a tip: it goes there and back."""
    middle = (i + j) // 2
    straight = _STRAIGHT * _apart(lines, i, j) / 2
    tips: NDArray[np.bool_] = (
        (lines.line[i] == lines.line[j])
        & np.isinf(lines.length[i])
        & (abs(lines.plain[middle] - lines.plain[i]) > straight)
        & (abs(lines.plain[middle] - lines.plain[j]) > straight)
        & (abs(lines.plain[i] - lines.plain[j]) < straight)
    )
    return tips


def _apart(lines: _Lines, i: NDArray[np.int64], j: NDArray[np.int64]) -> Numbers:
    """Return how far points of one line are apart along it, where it is plain."""
    gap = abs(lines.arc[i] - lines.arc[j])
    apart: Numbers = np.minimum(gap, lines.length[i] - gap)
    return apart


def _nearest(lines: _Lines, here: NDArray[np.int64], there: NDArray[np.int64]) -> Numbers:
    """Return how far points of one line are from the nearest of others of it, along it."""
    places, length = np.sort(lines.arc[there]), lines.length[here[0]]
    around = np.concatenate([places[-1:] - length, places, places[:1] + length])
    after = np.clip(np.searchsorted(around, lines.arc[here]), 1, len(around) - 1)
    apart: Numbers = np.minimum(
        around[after] - lines.arc[here], lines.arc[here] - around[after - 1]
    )
    return apart


def _plane(points: Points) -> NDArray[np.float64]:
    return np.stack([points.real, points.imag], axis=1)


def _giving_way(lines: _Lines, conflicts: NDArray[np.int64], back: float) -> Numbers:
    """Return how much of the style stays at each point, from ``back`` at a conflict up to 1."""
    most = np.zeros(len(lines.points))
    for number in np.unique(lines.line[conflicts]):
        here = np.flatnonzero(lines.line == number)
        apart = _nearest(lines, here, conflicts[lines.line[conflicts] == number])
        most[here] = np.exp(-0.5 * (np.maximum(0, apart - _STRETCH / 2) / _STRETCH) ** 2)
    return 1 - (1 - back) * most
