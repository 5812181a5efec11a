"""Healed seams: where two sources meet, the contour is made anew from theirs.

A cross-fade of two sources leaves kinks and swellings that neither has. So the points of a seam,
what lies between two rows that follow known curves, are synthesised as *Curve Analogies* refines a
curve (3.1): every neighbourhood of them shall look like one of the sources' contours, after the
best rotation and translation, and what lies outside of the seam is a hard constraint (3.2). Or the
curves on both sides run on until they cross. What is most like the sources is kept; the cross-fade,
if nothing is more.
"""

from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.tracing.bezier import Points
from iconstudio.algorithms.tracing.exact import Followed, crossing
from iconstudio.algorithms.tracing.pieces import Outline, Run
from iconstudio.algorithms.tracing.source_curve import SourceCurve, points_on

_SPACING = 2.0
"""Canvas units between the samples of a neighbourhood."""
_REACH = 10
"""Samples of a neighbourhood to each side of its middle."""
_AROUND = np.arange(-_REACH, _REACH + 1)
_FEWEST = 12
"""Samples of the shortest contour that serves as an example."""
_LONGEST = 60.0
"""Canvas units of the longest seam that is healed."""
_PASSES = 3
_LIKELY = 24
"""Examples of each neighbourhood of a seam among which those of what replaces it are sought."""
_ALIKE = 0.22
"""A drawn seam that is so few canvas units from its nearest examples needs no healing."""
_CUTS = 3, 8
"""Canvas units by which the curves on both sides are cut back before a new one joins them."""
_TURNED = 2.0
"""Radians by which a curve's end may look away from where it is to go."""
_FAR = 2.5
"""Canvas units by which a healed contour may lie from the drawn one."""
_BETTER = 0.8
"""A healed seam is kept if it is at most so many times as unlike the sources as the drawn one."""


class Examples:
    """Neighbourhoods of the sources' contours (section 3.1 of *Curve Analogies*)."""

    def __init__(self, rows: NDArray[np.complex64]) -> None:
        """Take neighbourhoods (n, k) whose means are 0."""
        self._rows = rows
        self._factors = np.ascontiguousarray(rows.conj().T)
        self._energies = (abs(rows) ** 2).sum(axis=1)

    @classmethod
    def of(cls, curves: Sequence[tuple[SourceCurve, bool]], unit: float) -> "Examples":
        """Take all neighbourhoods of closed contours in pixels, of ``unit`` canvas units each.

        With each contour comes whether it is to be run backwards: all shall have the ink on the
        side on which outlines have it.
        """
        none = np.zeros((0, len(_AROUND)), np.complex64)
        return cls(np.concatenate([none, *(_neighbourhoods(*one, unit) for one in curves)]))

    def __bool__(self) -> bool:
        return len(self._rows) > 0

    def compared(self, rows: Points) -> "_Compared":
        """Compare neighbourhoods (n, k) with all of them, after the best rotation and move."""
        centred = (rows - rows.mean(axis=1, keepdims=True)).astype(np.complex64)
        products = centred @ self._factors
        return _Compared(self._rows, rows, self._energies - 2 * abs(products), products)


class _Compared(NamedTuple):
    """Examples (m, k), and neighbourhoods (n, k) that are compared with them."""

    examples: NDArray[np.complex64]
    rows: Points
    errors: NDArray[np.float32]
    """(n, m): sums of squares for each neighbourhood and example, but for the former's own part."""
    products: NDArray[np.complex64]
    """(n, m): how they turn is the best rotation."""

    def away(self) -> NDArray[np.float32]:
        """Return how far each is from the nearest example: root mean square, in canvas units."""
        means = self.rows.mean(axis=1, keepdims=True)
        squares = self.errors.min(axis=1) + (abs(self.rows - means) ** 2).sum(axis=1)
        found: NDArray[np.float32] = np.sqrt(np.maximum(squares, 0) / self.rows.shape[1])
        return found

    def unlike(self) -> float:
        """Return how far they are from their nearest examples, all together."""
        return float(np.sqrt((self.away() ** 2).mean()))

    def nearest(self) -> Points:
        """Return the nearest example to each, so turned and moved that it lies on it, (n, k)."""
        best = self.errors.argmin(axis=1)
        turns = self.products[np.arange(len(self.rows)), best]
        turns = turns / np.maximum(abs(turns), 1e-12)
        found: Points = self.examples[best] * turns[:, None] + self.rows.mean(axis=1, keepdims=True)
        return found

    def likely(self) -> Examples:
        """Return those examples that the neighbourhoods, or others like these, are near to."""
        few = len(self.examples) <= _LIKELY
        return Examples(self.examples if few else self.examples[_least(self.errors, _LIKELY)])


@lru_cache(maxsize=256)
def _neighbourhoods(curve: SourceCurve, backwards: bool, unit: float) -> NDArray[np.complex64]:
    """Return the neighbourhoods of a closed contour, (n, k), their means 0.

    They are remembered, some 100 KiB each: the results of a row share most of their sources.
    """
    count = int(curve.length * unit / _SPACING)
    if count < _FEWEST:
        return np.zeros((0, len(_AROUND)), np.complex64)
    points = curve.at(np.arange(count) * curve.length / count) * unit
    points = points[::-1] if backwards else points
    found = points[(np.arange(count)[:, None] + _AROUND) % count]
    rows: NDArray[np.complex64] = (found - found.mean(axis=1, keepdims=True)).astype(np.complex64)
    return rows


def _least(errors: NDArray[np.float32], count: int) -> NDArray[np.intp]:
    """Return in which columns rows of errors (n, m) have one of their ``count`` least, or equal.

    The least of some stretches of a row tell how large those can be, so that few are left to sort.
    """
    stretch = max(1, errors.shape[1] // (8 * count))
    heads = errors[:, : errors.shape[1] // stretch * stretch]
    heads = heads.reshape(len(errors), -1, stretch).min(axis=2)
    bounds = np.partition(heads, count - 1, axis=1)[:, count - 1]
    found = np.zeros(errors.shape[1], dtype=bool)
    for row, bound in zip(errors, bounds, strict=True):
        few = np.flatnonzero(row <= bound)
        last = np.partition(row[few], count - 1)[count - 1]
        found[few[row[few] <= last]] = True
    return np.flatnonzero(found)


def healed(
    outline: Outline, followed: Sequence[Followed], examples: Examples, unit: float
) -> tuple[Outline, list[Run]]:
    """Return a closed outline with its seams made anew, and its runs of known curves.

    ``followed`` are in order, and none is over another; ``unit`` is in canvas units to a pixel.
    """
    if not followed or followed[0].whole or not examples:
        return outline, [one.run() for one in followed]
    rows = list(followed)
    count = len(outline)
    seams: list[Points] = []
    for here in range(len(rows)):
        there = (here + 1) % len(rows)
        end = rows[there].first + (count if there <= here else 0)
        seam = _Seam(outline, rows[here], rows[there], end, examples, unit)
        rows[here], rows[there] = seam.best()
        seams.append(seam.points)
    return _put_together(outline, rows, seams)


class _Seam:
    """What lies between two rows of points that follow known curves."""

    def __init__(
        self,
        outline: Outline,
        before: Followed,
        after: Followed,
        end: int,
        examples: Examples,
        unit: float,
    ) -> None:
        self._before, self._after, self._unit = before, after, unit
        self.points = outline.at(np.arange(before.last + 1, end))
        reach = np.arange(2 * _REACH * _SPACING / unit).astype(int)
        self._earlier = outline.at(before.first - 1 - reach[::-1])
        self._later = outline.at(after.last + 1 + reach)
        self._drawn = self._row(before, after, self.points)
        self._examples = examples

    def best(self) -> tuple[Followed, Followed]:
        """Return the two rows, joined by ``points`` as much like the sources as can be."""
        best = self._before, self._after
        if not 1 < len(self.points) * self._unit < _LONGEST:
            return best
        drawn = self._examples.compared(self._drawn.neighbourhoods)
        least = drawn.unlike() * _BETTER
        if least < _ALIKE * _BETTER:
            return best
        self._examples = drawn.likely()
        for before, after, points in self._candidates():
            row = self._row(before, after, points)
            if row.strays(self._drawn) > _FAR:
                continue
            unlike = self._examples.compared(row.neighbourhoods).unlike()
            if unlike < least:
                least, best, self.points = unlike, (before, after), points
        return best

    def _candidates(self) -> Iterator[tuple[Followed, Followed, Points]]:
        before, after = self._before, self._after
        at = crossing(before, after, len(self.points) + _FAR / self._unit)
        if at is not None:
            yield before.ending(at[0]), after.beginning(at[1]), np.zeros(0, np.complex128)
        for cut in _CUTS:
            pixels = round(cut / self._unit)
            if min(before.count, after.count) < 2 * pixels + 2:
                continue
            one = before.cut(0, before.count - pixels)
            other = after.cut(pixels, after.count)
            joined = _bridge(one, other)
            if joined is None:
                continue
            yield one, other, joined
            yield one, other, self._refined(self._row(one, other, joined))

    def _row(self, before: Followed, after: Followed, points: Points) -> "_Row":
        start = np.concatenate([self._earlier, before.points])
        end = np.concatenate([after.points, self._later])
        return _Row.of(start, points, end, self._unit)

    def _refined(self, row: "_Row") -> Points:
        """Return a seam's points after some passes of refinement (section 3.1)."""
        for _ in range(_PASSES):
            row = row.drawn_to(self._examples.compared(row.neighbourhoods).nearest())
        return row.seam(self._unit)


class _Row(NamedTuple):
    """A part of an outline around a seam, in canvas units, by its samples."""

    points: Points
    first: int
    """First and last number of the seam's points."""
    last: int

    @classmethod
    def of(cls, start: Points, points: Points, end: Points, unit: float) -> "_Row":
        row = np.concatenate([start, points, end]) * unit / _SPACING
        along = np.concatenate([[0], np.cumsum(abs(np.diff(row)))])
        since, until = along[len(start) - 1], along[len(start) + len(points)]
        reach = 2 * _REACH
        count = max(1, round(until - since))
        inner = since + np.arange(count + 1) * (until - since) / count
        before, after = since - np.arange(reach, 0, -1), until + np.arange(1, reach + 1)
        places = np.concatenate([before, inner, after])
        return cls(np.interp(places, along, row) * _SPACING, reach, reach + count)

    @property
    def middles(self) -> NDArray[np.intp]:
        return np.arange(self.first - _REACH, self.last + _REACH + 1, 2)

    @property
    def neighbourhoods(self) -> Points:
        found: Points = self.points[self.middles[:, None] + _AROUND]
        return found

    def drawn_to(self, found: Points) -> "_Row":
        """Return the row with each of the seam's points where the neighbourhoods want it."""
        weights = np.exp(-((_AROUND / (_REACH / 2)) ** 2))
        numbers = (self.middles[:, None] + _AROUND).ravel()
        total = np.bincount(numbers, np.tile(weights, len(found)), len(self.points))
        wanted = (found * weights).ravel()
        x, y = (np.bincount(numbers, part, len(self.points)) for part in (wanted.real, wanted.imag))
        moved = self.points.copy()
        inner = slice(self.first + 1, self.last)
        moved[inner] = (x + 1j * y)[inner] / total[inner]
        return _Row.of(moved[: self.first + 1], moved[inner], moved[self.last :], 1.0)

    def seam(self, unit: float) -> Points:
        """Return the seam's points in pixels, a pixel apart."""
        row = self.points[self.first : self.last + 1] / unit
        along = np.concatenate([[0], np.cumsum(abs(np.diff(row)))])
        count = max(2, round(along[-1]))
        found: Points = np.interp(np.arange(1, count) * along[-1] / count, along, row)
        return found

    def strays(self, other: "_Row") -> float:
        """Return how far the seam's points of one row are from the other row at most, or back."""
        pairs = (self, other), (other, self)
        return max(
            float(abs(one.points[one.first : one.last + 1, None] - two.points).min(axis=1).max())
            for one, two in pairs
        )


def _bridge(before: Followed, after: Followed) -> Points | None:
    """Return points of a smooth curve from one row to another (Hobby 1986, as in METAFONT).

    None: it would have to turn round.
    """
    a, b = before.points[-1], after.points[0]
    chord = b - a
    if abs(chord) < 2:
        return None
    into, out = (np.diff(row[:2])[0] for row in (before.points[-2:], after.points[:2]))
    theta, phi = np.angle(into / chord), np.angle(chord / out)
    if max(abs(theta), abs(phi)) > _TURNED:
        return None
    handles = _velocity(theta, phi), _velocity(phi, theta)
    first = a + chord * np.exp(1j * theta) * handles[0]
    last = b - chord * np.exp(-1j * phi) * handles[1]
    count = max(2, round(abs(chord)))
    return points_on((a, first, last, b), np.arange(1, count) / count)


def _velocity(theta: float, phi: float) -> float:
    """Return the length of a handle, as a part of the chord, for the angles at its two ends."""
    c = (3 - np.sqrt(5)) / 2
    alpha = np.sqrt(2) * (np.sin(theta) - np.sin(phi) / 16) * (np.sin(phi) - np.sin(theta) / 16)
    alpha *= np.cos(theta) - np.cos(phi)
    return float((2 + alpha) / (1 + (1 - c) * np.cos(theta) + c * np.cos(phi)) / 3)


def _put_together(
    outline: Outline, rows: Sequence[Followed], seams: Sequence[Points]
) -> tuple[Outline, list[Run]]:
    """Return the outline that begins with the first row, and the runs in it."""
    points, runs, at = [], [], 0
    for row, seam in zip(rows, seams, strict=True):
        runs.append(row.run()._replace(first=at, last=at + row.count - 1))
        points += [row.points, seam]
        at += row.count + len(seam)
    return Outline(np.concatenate(points)), runs
