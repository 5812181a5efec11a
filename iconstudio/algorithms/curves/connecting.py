"""Lines through the middle of strokes, joined where the strokes meet.

A medial axis bends towards a line that branches off, and cuts corners. Where it is farther from the
outline than along the strokes, it is left out; what leads there is drawn straight on.
"""

from collections import Counter
from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from iconstudio.algorithms.areas import Points, simplified
from iconstudio.algorithms.curves.medial_axis import Axis, Numbers
from iconstudio.algorithms.dashing import length_of, part
from iconstudio.algorithms.geometry import merged_lines

Row = tuple[Points, bool]
"""Points of a line (n, 2), and whether it is closed."""
Place = tuple[float, ...]
End = tuple[int, int]
"""The number of a line, and 0 for its start or -1 for its end."""

_EVEN = 0.12
"""By what part of it the radius of a stroke may vary."""
_SPUR, _TIP = 0.5, 0.7
"""Over the radius: the length of the longest branch that is none, and of one that may lead from a
crossing into a corner."""
_NEAR = 0.6
"""Over the radius: how near to where two lines would meet such a one ends, and the axis runs."""
_BENT, _WAY = 0.4, 1.2
"""Over the radius: how much of a line's end crossings bend, and how much tells its direction."""
_STRAIGHT = np.radians(35)
"""Two lines that turn by less at a crossing are one that passes it."""
_FAR = 4.0
"""Over the radius: how far from a crossing two lines may meet."""
_STRAY = 0.05
"""Canvas units by which lines may be simplified."""


class Meeting(NamedTuple):
    """Where lines meet."""

    ends: Sequence[End]
    axis: Points
    """The points of the axis there, (n, 2)."""


@dataclass(frozen=True, eq=False)
class Centre:
    """Lines along strokes, without the places where they meet."""

    rows: Sequence[Row]
    meetings: Sequence[Meeting]
    radius: float
    """Half the width of the strokes."""
    share: float
    """The part of the axis that is along them."""

    @classmethod
    def of(cls, axis: Axis, radius: float | None = None) -> "Centre | None":
        """Return what an axis has of even width: of most of it, if no radius is given.

        None if there is nothing of it.
        """
        lengths = axis.lengths
        if not len(lengths):
            return None
        of_side = axis.radii[axis.sides]
        radius = _median(of_side.mean(axis=1), lengths) if radius is None else radius
        thick = of_side.max(axis=1) > (1 + _EVEN) * radius
        even = ~thick & (of_side.min(axis=1) > (1 - _EVEN) * radius)
        place = _places(len(axis.points), axis.sides[thick])
        crossings = {
            tuple(axis.points[at].tolist()): int(place[at]) for at in np.flatnonzero(place >= 0)
        }
        found = _without_spurs(axis.points[axis.sides[even]], crossings, _SPUR * radius)
        corners = _corners(*_meetings(found, crossings), radius)
        kept = [one for number, one in enumerate(found) if number not in corners]
        share = float(lengths[even].sum() / lengths.sum())
        return cls(*_meetings(kept, crossings), radius, share) if kept else None


def connected(centre: Centre) -> list[Row]:
    """Return lines that go on through the places where they meet, or end there on others."""
    rows = [
        _trimmed(points, closed, number, centre)
        for number, (points, closed) in enumerate(centre.rows)
    ]
    links: dict[End, tuple[End, Points | None]] = {}
    for meeting in centre.meetings:
        _connect(rows, meeting, centre.radius, links)
    return [
        (simplified(points, closed, _STRAY), closed)
        for points, closed in _walked(rows, [closed for _, closed in centre.rows], links)
    ]


def _median(values: Numbers, weights: Numbers) -> float:
    order = np.argsort(values)
    share = np.cumsum(weights[order])
    return float(values[order][np.searchsorted(share, share[-1] / 2)])


def _places(count: int, sides: NDArray[np.intp]) -> NDArray[np.intp]:
    """Return for each point the number of the crossing that it is part of; -1 for none."""
    joined = coo_array((np.ones(len(sides)), sides.T), (count, count))
    _, number = connected_components(joined, directed=False)
    some = np.full(count, -1)
    touched = np.unique(sides)
    some[touched] = number[touched]
    return some


def _without_spurs(sides: Points, crossings: Container[Place], longest: float) -> list[Points]:
    """Return sides (n, 2, 2) joined to lines, without short branches."""
    while len(sides):
        rows = merged_lines(sides)
        met = Counter(tuple(one[at]) for one in rows for at in (0, -1))
        spurs = [
            number
            for number, one in enumerate(rows)
            if length_of(one) < longest
            and sum(met[tuple(one[at])] > 1 for at in (0, -1)) == 1
            and not any(tuple(one[at]) in crossings for at in (0, -1))
        ]
        if not spurs:
            return rows
        shortest = min(spurs, key=lambda number: length_of(rows[number]))
        kept = [one for number, one in enumerate(rows) if number != shortest]
        sides = np.concatenate([np.empty((0, 2, 2)), *(_sides(one) for one in kept)])
    return []


def _sides(row: Points) -> Points:
    return np.stack([row[:-1], row[1:]], axis=1)


def _meetings(
    lines: Sequence[Points], crossings: Mapping[Place, int]
) -> tuple[list[Row], list[Meeting]]:
    """Return lines, closed if they end where they begin and nothing else does; where ends meet."""
    met = Counter(tuple(one[at]) for one in lines for at in (0, -1))
    points: dict[int | Place, list[Place]] = {}
    for point, number in crossings.items():
        points.setdefault(number, []).append(point)
    rows: list[Row] = []
    ends: dict[int | Place, list[End]] = {}
    for number, line in enumerate(lines):
        first, last = tuple(line[0]), tuple(line[-1])
        closed = first == last and met[first] == 2 and first not in crossings
        rows.append((line[:-1], True) if closed else (line, False))
        if not closed:
            for which, at in ((0, first), (-1, last)):
                place = crossings.get(at, at)
                points.setdefault(place, [at])
                ends.setdefault(place, []).append((number, which))
    return rows, [
        Meeting(some, np.array(points[place])) for place, some in ends.items() if len(some) > 1
    ]


def _corners(rows: Sequence[Row], meetings: Sequence[Meeting], radius: float) -> set[int]:
    """Return the numbers of those lines that lead from a crossing into a corner of the outline.

    They are short, and end where two others would meet.
    """
    met = {end for ends, _ in meetings for end in ends}
    found = set()
    for ends, _ in meetings:
        short = [
            (number, at)
            for number, at in ends
            if length_of(rows[number][0]) < _TIP * radius and (number, -1 - at) not in met
        ]
        others = [
            (rows[number][0][at], way_out(rows[number][0], at, radius))
            for number, at in ends
            if (number, at) not in short
        ]
        corners = [
            corner
            for one, other in combinations(others, 2)
            if (corner := _crossing(*one, *other)) is not None
        ]
        for number, at in short:
            tip = rows[number][0][-1 - at]
            if any(np.hypot(*(tip - corner)) < _NEAR * radius for corner in corners):
                found.add(number)
    return found


def _trimmed(points: Points, closed: bool, number: int, centre: Centre) -> Points:
    """Return a line without what crossings bend of it."""
    if closed:
        return points
    met = {end for ends, _ in centre.meetings for end in ends}
    whole = length_of(points)
    off = [min(_BENT * centre.radius, whole / 4) * ((number, at) in met) for at in (0, -1)]
    return part(points, off[0], whole - off[1])


def _connect(
    rows: list[Points],
    meeting: Meeting,
    radius: float,
    links: dict[End, tuple[End, Points | None]],
) -> None:
    """Link the ends that go on in each other, and let the others end where those pass."""
    ends, axis = meeting
    at = {end: rows[end[0]][end[1]] for end in ends}
    ways = {end: way_out(rows[end[0]], end[1], radius) for end in ends}
    left = list(ends)
    passing: list[tuple[Points, Points]] = []
    turns = sorted(
        (_turn(ways[one], at[other] - at[one], -ways[other]), one, other)
        for i, one in enumerate(ends)
        for other in ends[:i]
        if one != other
    )
    for turn, one, other in turns:
        if turn < _STRAIGHT and one in left and other in left:
            links[one], links[other] = (other, None), (one, None)
            passing.append((at[one], at[other]))
            left = [end for end in left if end not in (one, other)]
    if len(left) == 2 and not passing:
        one, other = left
        corner = _crossing(at[one], ways[one], at[other], ways[other])
        corner = _on_axis(corner, axis, [at[one], at[other]], radius)
        links[one], links[other] = (other, corner), (one, corner)
        return
    middle = np.mean([at[end] for end in ends], axis=0)
    if not passing:
        middle = _nearest_to_all([at[end] for end in left], [ways[end] for end in left], middle)
        middle = _on_axis(middle, axis, [at[end] for end in left], radius)
    for end in left:
        onto = middle
        for first, last in passing:
            met = _crossing(at[end], ways[end], first, last - first)
            if met is not None and np.hypot(*(met - at[end])) < _FAR * radius:
                onto = met
                break
        row = rows[end[0]]
        rows[end[0]] = np.concatenate([[onto], row] if end[1] == 0 else [row, [onto]])


def way_out(row: Points, which: int, radius: float) -> Points:
    """Return the direction in which a line leaves at an end."""
    length = length_of(row)
    back = min(_WAY * radius, length)
    some = part(row, 0.0, back) if which == 0 else part(row, length - back, length)[::-1]
    way = some[0] - some[-1]
    found: Points = way / max(float(np.hypot(*way)), 1e-9)
    return found


def _turn(*ways: Points) -> float:
    """Return by how much a line turns, at most, from any of some directions to the next."""
    return max(
        abs(float(np.arctan2(a[0] * b[1] - a[1] * b[0], a @ b)))
        for a, b in pairwise(way for way in ways if way.any())
    )


def _crossing(a: Points, way: Points, b: Points, other: Points) -> Points | None:
    """Return where two straight lines cross, if it lies ahead on the first."""
    cross = way[0] * other[1] - way[1] * other[0]
    if abs(cross) < 0.1 * np.hypot(*way) * np.hypot(*other):
        return None
    along = ((b - a)[0] * other[1] - (b - a)[1] * other[0]) / cross
    return a + along * way if along > -1e-9 else None


def _on_axis(found: Points | None, axis: Points, ends: Sequence[Points], radius: float) -> Points:
    """Return a place where lines meet; if it is off the axis, or none, a place on that."""
    if found is None:
        away = np.min([np.hypot(*(axis - end).T) for end in ends], axis=0)
        farthest: Points = axis[away.argmax()]
        return farthest
    off = np.hypot(*(axis - found).T)
    return found if off.min() < _NEAR * radius else axis[off.argmin()]


def _nearest_to_all(ends: Sequence[Points], ways: Sequence[Points], otherwise: Points) -> Points:
    """Return the point whose squared distances to some straight lines have the least sum."""
    across = np.array([(-way[1], way[0]) for way in ways])
    found, _, rank, _ = np.linalg.lstsq(across, (across * np.array(ends)).sum(axis=1), rcond=0.1)
    return found if rank == 2 else otherwise


def _walked(
    rows: Sequence[Points], closed: Sequence[bool], links: dict[End, tuple[End, Points | None]]
) -> Iterator[Row]:
    """Yield the lines that linked ones make together."""
    left = {number for number in range(len(rows)) if not closed[number]}
    yield from ((rows[number], True) for number in range(len(rows)) if closed[number])
    starts = [(n, at) for n in left for at in (0, -1) if (n, at) not in links]
    for start in [*starts, *((n, 0) for n in sorted(left))]:
        if start[0] not in left:
            continue
        points: list[Points] = []
        end = start
        while end[0] in left:
            left.discard(end[0])
            points.append(rows[end[0]][:: 1 if end[1] == 0 else -1])
            out = (end[0], -1 - end[1])
            if out not in links:
                yield np.concatenate(points), False
                break
            end, corner = links[out]
            if corner is not None:
                points.append(corner[None])
        else:
            yield np.concatenate(points), True
