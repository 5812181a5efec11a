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
import scipy
from numpy.typing import NDArray

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
_CELL = 4.0
"""Side in pixels of the cells by which it is told what is far from a curve."""
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

    def followed(self, outline: Outline) -> list[Followed]:
        """Return where a closed outline follows a curve, in order, and none over another."""
        count = len(outline)
        found = [
            replace(row, source=number)
            for number, source in self._sources.items()
            for row in source.followed(outline.points)
        ]
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
        pairs = np.column_stack([points.real, points.imag])
        self._near = _Cells(pairs)
        self._tree = scipy.spatial.KDTree(pairs, balanced_tree=False, compact_nodes=False)

    @cached_property
    def is_backwards(self) -> bool:
        """Whether what its curves enclose is on the other side of them than an outline's ink."""
        rows = [curve.points for curve in self.curves]
        return bool(sum((row[:-1].conj() * row[1:]).imag.sum() for row in rows) < 0)

    def followed(self, points: Points) -> Iterator[Followed]:
        """Yield the rows of a closed outline's points (n,) that follow one of its curves."""
        count = len(points)
        pairs = np.column_stack([points.real, points.imag])
        some = np.flatnonzero(self._near.hold(pairs))
        if len(some) < _SHORTEST:
            return
        away, nearest = self._tree.query(pairs[some], distance_upper_bound=_NEAR + STEP)
        near = away < np.inf
        some, nearest = some[near], nearest[near]
        if len(some) < _SHORTEST:
            return
        number, along = np.full(count, -1), np.zeros(count)
        away, place = self._projected(points[some], nearest)
        close = away < _NEAR
        number[some[close]] = self._number[nearest[close]]
        along[some[close]] = place[close]
        for curve_number in np.unique(number[number >= 0]):
            near = np.flatnonzero(number == curve_number)
            yield from _rows(self.curves[int(curve_number)], near, along[near], count)

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


class _Cells:
    """Where points are near to others, by cells: few are left to be looked for among them."""

    def __init__(self, points: NDArray[np.float64]) -> None:
        """Take rows of x and y."""
        cells = np.floor(points / _CELL).astype(int)
        self._corner = cells.min(axis=0) - 2
        places = cells - self._corner
        held = np.zeros(places.max(axis=0) + 3, dtype=bool)
        held[tuple(places.T)] = True
        self._held = scipy.ndimage.maximum_filter(held, 3)

    def hold(self, points: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Return which points (n, 2) may be less than a cell from any: all that are."""
        places = np.floor(points / _CELL).astype(int) - self._corner
        x, y = np.clip(places, 0, np.array(self._held.shape) - 1).T
        held: NDArray[np.bool_] = self._held[x, y]
        return held


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
