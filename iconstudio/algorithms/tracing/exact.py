"""Exact curves: where a traced outline runs along a curve of its source, it is that curve.

A picture tells an outline to a few hundredths of a pixel. What its sources are drawn with tells it
exactly: lines are lines, circles are circles, and nodes are where their author set them. So the
outline's points are compared with the sources' curves, and rows of points that follow one are
replaced by that part of it; only what is between, where two sources meet, is fitted to points.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.nearby import Nearby
from iconstudio.algorithms.tracing.bezier import Points
from iconstudio.algorithms.tracing.pieces import Outline, Run
from iconstudio.algorithms.tracing.source_curve import STEP, SourceCurve
from iconstudio.model.path import Path

_NEAR = 0.4
"""How far, in pixels, the points of an outline may be from a curve that they follow."""
_SHORTEST = 8
"""Points in a row that must follow a curve."""
_BLUNTED = 10
"""Points in a row, at a corner, that need not be near: pixels round it."""
_SPIKE = 4.0
"""Pixels by which the curve may be longer than those points: how far a corner may point."""
_PACE = 0.3, 2.5
"""How far along the curve, in pixels, a step from point to point may lead."""
_ROOM = 12
"""Points between two rows from which what is between is fitted."""
_CROSSES = 0.05
"""Sine of the least angle at which curves cross."""


@dataclass(frozen=True, eq=False)
class Followed:
    """A row of an outline's points that follows a curve."""

    curve: SourceCurve
    first: int
    """Its first point; the last one's number may be more than the outline has."""
    along: NDArray[np.float64]
    """(p,): how far along the curve each point is; it only grows, or only falls."""
    source: int = 0
    """Number of the path that the curve is of."""
    whole: bool = False
    """Whether all of the outline follows all of the curve."""

    @property
    def count(self) -> int:
        """How many points it has."""
        return len(self.along)

    @property
    def last(self) -> int:
        """Its last point."""
        return self.first + self.count - 1

    @property
    def indices(self) -> NDArray[np.intp]:
        """All its points."""
        return np.arange(self.first, self.last + 1)

    def moved(self, by: complex) -> "Followed":
        """Return it with its curve moved by some pixels."""
        return replace(self, curve=self.curve.moved(by)) if by else self

    @property
    def points(self) -> Points:
        """Its points on the curve."""
        return self.curve.at(self.along)

    @property
    def way(self) -> float:
        """1 if it runs as the curve does, else -1."""
        return 1.0 if self.along[-1] > self.along[0] else -1.0

    def longest(self, free: NDArray[np.bool_]) -> "Followed":
        """Return the longest part of it, of those of its points (p,) that are ``free``."""
        if free.all():
            return self
        edges = np.flatnonzero(np.diff(free, prepend=False, append=False))
        starts, ends = edges[::2], edges[1::2]
        if not len(starts):
            return self.cut(0, 0)
        best = (ends - starts).argmax()
        return self.cut(int(starts[best]), int(ends[best]))

    def cut(self, start: int, end: int) -> "Followed":
        """Return its points from one number up to another."""
        return replace(self, first=self.first + start, along=self.along[start:end])

    def ending(self, along: float) -> "Followed":
        """Return it with its last point moved along the curve."""
        return replace(self, along=np.append(self.along[:-1], along))

    def beginning(self, along: float) -> "Followed":
        """Return it with its first point moved along the curve."""
        return replace(self, along=np.append(along, self.along[1:]))

    def run(self) -> Run:
        """Return it as a run of the outline."""
        start, end = float(self.along[0]), float(self.along[-1])
        if self.whole:
            start, end = (0.0, self.curve.length) if end > start else (self.curve.length, 0.0)
        pieces = self.curve.part(start, end)
        return Run(self.first, self.last, pieces, self.whole, self.source)


def joined(found: Sequence[Followed], outline: Outline) -> list[Followed]:
    """Return rows that are next to one another so that they meet, or leave room between them.

    Two curves that cross meet there. Where they run on side by side, a step would show: what is
    between them is then left to be fitted.
    """
    rows = list(found)
    if len(rows) == 1 and rows[0].whole:
        return rows
    for here in range(len(rows)):
        there = (here + 1) % len(rows)
        one, other = rows[here], rows[there]
        turn = len(outline) if there <= here else 0
        gap = other.first + turn - one.last
        if gap > _ROOM:
            continue
        at = crossing(one, other, _ROOM)
        if at is None:
            back = (_ROOM - gap) // 2 + 1
            rows[here] = one.cut(0, max(one.count - back, one.count // 2))
            other = rows[there]
            rows[there] = other.cut(min(back, other.count // 2), other.count)
        else:
            rows[here] = rows[here].ending(at[0])
            rows[there] = rows[there].beginning(at[1])
    return rows


def crossing(one: Followed, other: Followed, room: float) -> tuple[float, float] | None:
    """Return how far along two curves they cross, where one row ends and the other begins.

    They are drawn out, and cut back, by ``room`` pixels at most. None: they do not cross.
    """
    steps = np.arange(-room, room + STEP, STEP)
    first = one.along[-1] + one.way * steps
    second = other.along[0] + other.way * steps
    p, q = one.curve.at(first), other.curve.at(second)
    a, b = p[:-1, None], q[None, :-1]
    da, db = np.diff(p)[:, None], np.diff(q)[None, :]
    sine = (da.conj() * db).imag
    with np.errstate(divide="ignore", invalid="ignore"):
        t = ((b - a).conj() * db).imag / sine
        u = ((b - a).conj() * da).imag / sine
    meets = (t >= 0) & (t < 1) & (u >= 0) & (u < 1)
    ways = abs(sine) > _CROSSES * abs(da) * abs(db)
    row, column = np.nonzero(meets & ways)
    if not len(row):
        return None
    # Where one ends and where the other begins should be as near as can be.
    best = (abs(steps[row]) + abs(steps[column])).argmin()
    i, j = row[best], column[best]
    return (
        float(first[i] + one.way * STEP * t[i, j]),
        float(second[j] + other.way * STEP * u[i, j]),
    )


class SourceCurves:
    """The curves of some paths, to be found again along an outline.

    Parameters
    ----------
    paths
        In canvas units; each overlaps itself nowhere.
    unit
        Canvas units to a pixel.
    """

    def __init__(self, paths: Sequence[Path], unit: float) -> None:
        self._sources = {number: _source(path, unit) for number, path in enumerate(paths) if path}

    def oriented(self) -> list[tuple[SourceCurve, bool]]:
        """Return all curves, and whether each runs against the outlines of what they enclose."""
        return [
            (curve, source.is_backwards)
            for source in self._sources.values()
            for curve in source.curves
        ]

    def followed(self, outlines: Sequence[Outline]) -> list[list[Followed]]:
        """Return where closed outlines follow a curve: for each in order, and none over another."""
        if not outlines:
            return []
        points = np.concatenate([one.points for one in outlines])
        ends = np.cumsum([len(one) for one in outlines])[:-1]
        found: list[list[Followed]] = [[] for _ in outlines]
        for number, source in self._sources.items():
            for rows, *places in zip(
                found, *(np.split(some, ends) for some in source.places(points)), strict=True
            ):
                rows += (replace(row, source=number) for row in source.rows(*places))
        return [_chosen(rows, len(outline)) for rows, outline in zip(found, outlines, strict=True)]


def _chosen(found: list[Followed], count: int) -> list[Followed]:
    """Return the longest rows of an outline's ``count`` points, none over another, in order."""
    taken = np.zeros(count, dtype=bool)
    chosen: list[Followed] = []
    while found:
        best = max(found, key=lambda one: one.count)
        found.remove(best)
        free = best.longest(~taken[best.indices % count])
        if free.count < _SHORTEST:
            continue
        if free.count < best.count:
            found.append(free)
            continue
        taken[best.indices % count] = True
        chosen.append(best)
    chosen.sort(key=lambda one: one.first)
    return chosen


class _Source:
    def __init__(self, curves: Sequence[SourceCurve]) -> None:
        self.curves = curves
        points = np.concatenate([curve.points for curve in curves])
        self._points = points
        self._along = np.concatenate([curve.along for curve in curves])
        self._number = np.repeat(np.arange(len(curves)), [len(one.points) for one in curves])
        self._nearby = Nearby(_pairs(points))

    @cached_property
    def is_backwards(self) -> bool:
        """Whether what its curves enclose is on the other side of them than an outline's ink."""
        rows = [curve.points for curve in self.curves]
        return bool(sum((row[:-1].conj() * row[1:]).imag.sum() for row in rows) < 0)

    def places(self, points: Points) -> tuple[NDArray[np.intp], NDArray[np.float64]]:
        """Return which of its curves is next to each of some points (n,), and where on it.

        Where none is so near that it may be followed, its number is -1.
        """
        number, along = np.full(len(points), -1), np.zeros(len(points))
        _, nearest = self._nearby.nearest(_pairs(points), _NEAR + STEP)
        some = np.flatnonzero(nearest >= 0)
        away, place = self._projected(points[some], nearest[some])
        close = some[away < _NEAR]
        number[close] = self._number[nearest[close]]
        along[close] = place[away < _NEAR]
        return number, along

    def rows(self, number: NDArray[np.intp], along: NDArray[np.float64]) -> Iterator[Followed]:
        """Yield the rows of a closed outline's points, of these ``places``, that follow a curve."""
        close = np.flatnonzero(number >= 0)
        if len(close) < _SHORTEST:
            return
        for curve in np.unique(number[close]):
            near = close[number[close] == curve]
            yield from _rows(self.curves[int(curve)], near, along[near], len(number))

    def _projected(
        self, points: Points, nearest: NDArray[np.intp]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return how far points are from the curve next to its nearest point, and where on it."""
        on = self._points[nearest]
        after = np.minimum(nearest + 1, len(self._points) - 1)
        before = np.maximum(nearest - 1, 0)
        after = np.where(self._number[after] == self._number[nearest], after, nearest)
        before = np.where(self._number[before] == self._number[nearest], before, nearest)
        way = self._points[after] - self._points[before]
        way = way / np.maximum(abs(way), 1e-9)
        offset = (points - on) * way.conj()
        return abs(offset.imag), self._along[nearest] + np.clip(offset.real, -STEP, STEP)


def _pairs(points: Points) -> NDArray[np.float64]:
    return np.column_stack([points.real, points.imag])


@lru_cache(maxsize=64)
def _source(path: Path, unit: float) -> _Source:
    """Remember sources, some 200 KiB each: the results of a row share most of theirs."""
    return _Source([SourceCurve.of(contour, unit) for contour in path.contours])


def _rows(
    curve: SourceCurve, near: NDArray[np.intp], along: NDArray[np.float64], count: int
) -> Iterator[Followed]:
    """Yield the rows of points of an outline that follow a curve, one after another.

    ``near`` are the indices of those that are close to it, and ``along`` says where on it.
    """
    if len(near) < _SHORTEST:
        return
    gap = np.diff(near, append=near[0] + count)
    step = np.diff(along, append=along[0])
    half = curve.length / 2
    step = (step + half) % curve.length - half
    way = np.sign(np.median(step)) or 1.0
    forward = step * way
    follows = np.where(
        gap == 1,
        (forward > _PACE[0]) & (forward < _PACE[1]),
        (gap <= _BLUNTED) & (forward > 0.5 * gap) & (forward < gap + _SPIKE),
    )
    if follows.all() and abs(step.sum()) > half:
        yield Followed(curve, 0, way * np.linspace(0, curve.length, count), whole=True)
        return
    breaks = np.flatnonzero(~follows)
    if not len(breaks):
        breaks = np.array([len(near) - 1])
    starts = (breaks + 1) % len(near)
    for start, end in zip(starts, np.roll(breaks, -1), strict=True):
        turn = np.arange(start, end + 1 if end >= start else end + 1 + len(near)) % len(near)
        if len(turn) < _SHORTEST:
            continue
        indices = np.concatenate([[0], np.cumsum(gap[turn[:-1]])])
        places = along[turn[0]] + np.concatenate([[0], np.cumsum(step[turn[:-1]])])
        yield Followed(
            curve, int(near[turn[0]]), np.interp(np.arange(indices[-1] + 1), indices, places)
        )
