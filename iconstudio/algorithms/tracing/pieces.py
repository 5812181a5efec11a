"""An outline of points as lines and cubics, from corner to corner.

Points are complex numbers, x + iy, in pixels of the drawing; outlines are rows of points one
pixel apart.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from iconstudio.algorithms.tracing.bezier import Points, direction, fit, snapped

_FEWEST = 12
"""Points of the smallest outline, which are closer together."""
_TURN, _TURN_MORE = 3, 2
"""Points to each side between which a corner's turn shows, and how many more if it is blunted."""
_SHARP = np.radians(20)
_CORNER = np.radians(15)
"""By how much the sides of a corner differ in direction at least."""
_AT_ONCE = 0.6
"""How much of its turn a corner makes at once; a bend makes half as much."""
_REVERSED = np.radians(150)
"""More than that cannot show in so few points."""
_ROUNDED = 3
"""Points to each side of a corner that pixels (and the smoothing) may have displaced."""
_SIDE, _SIDE_MORE = 9, 4
"""Points to each side of a corner that tell where the side is going, and more if it is blunted."""
_LONG = 16
"""Points of each side of a corner that may be blunted more: between shorter ones is a bend."""
_CURVED = 0.15
"""How far, in pixels, those points stray from a line if the side is bent."""
_RUN = 48
"""Points that tell a straight side from a bow, unless it lies between two corners."""
_BOW = 0.1
"""How much, in pixels, so many points may bow and still be straight."""
_LEFT, _GONE = 0.3, 1.2
"""Distances in pixels from a line at which an outline is leaving it, and has left."""
_STRAY = 1.5
"""How many times the tolerance points may stray from a line found by its bow."""
_APART = 12
"""Straight sides with fewer points between them would make a kink of a gentle bend."""
_SMOOTH = np.array([1, 2, 3, 2, 1]) / 9
"""Takes off what the 256 shades of a pixel, and the cross-fade of a seam, add."""

_LOOSE = 2.0
"""How many times as far what joins two runs may stray: seams are not as exact as drawings."""
_SHORT, _NEXT = 4, 0.5
"""Points, and pixels between the ends, of a span that is nothing but a step back."""
_NOTHING = 1e-6
"""Points so few pixels apart are one."""

Piece = tuple[complex, ...]
"""First and last point of a line, or the four points of a cubic."""
NOBODY = -1
"""Owner of pieces that are of no source."""


@dataclass(frozen=True, slots=True, eq=False)
class Outline:
    """A row of points (n,) that closes, or else repeats itself, moved by ``step``, for ever."""

    points: Points
    step: complex = 0j

    def __len__(self) -> int:
        return len(self.points)

    def at(self, indices: "NDArray[np.int64] | range") -> Points:
        """Return the points with these indices, which may go round and round."""
        turns, inside = np.divmod(indices, len(self.points))
        found: Points = self.points[inside]
        return found + turns * self.step if self.step else found

    def even(self) -> "Outline":
        """Return it with points a pixel apart."""
        row = np.append(self.points, self.points[0] + self.step)
        along = np.concatenate([[0], np.cumsum(abs(np.diff(row)))])
        count = max(_FEWEST, round(along[-1]))
        places = np.arange(count) * along[-1] / count
        return Outline(np.interp(places, along, row), self.step)

    def smooth(self) -> "Outline":
        """Return it without what pixels add."""
        reach = len(_SMOOTH) // 2
        row = self.at(range(-reach, len(self) + reach))
        return Outline(ndimage.convolve1d(row, _SMOOTH)[reach:-reach], self.step)


class _Line(NamedTuple):
    """A straight side: the points ``first`` to ``last`` of a span are along it."""

    first: int
    last: int
    point: complex
    way: complex

    def nearest(self, point: complex) -> complex:
        return self.point + self.way * ((point - self.point) * self.way.conjugate()).real


class Run(NamedTuple):
    """The points ``first`` to ``last`` of an outline, whose pieces are known."""

    first: int
    """Less than the outline has points; ``last`` may be more."""
    last: int
    pieces: Sequence[Piece]
    whole: bool = False
    """Whether the pieces are all of the outline."""
    owner: int = NOBODY
    """Number of the source that they are of."""


class _Knot(NamedTuple):
    """Where a span of an outline ends, and the next begins: a corner, or a run."""

    first: int
    last: int
    run: Run | None = None


def pieces_of(
    outline: Outline, tolerance: float, blur: int, runs: Sequence[Run] = ()
) -> list[Piece]:
    """Return the lines and cubics of an outline, each beginning where the one before ends.

    ``runs`` are in order, none over another.
    """
    return [piece for piece, _ in owned_pieces_of(outline, tolerance, blur, runs)]


def owned_pieces_of(
    outline: Outline, tolerance: float, blur: int, runs: Sequence[Run] = ()
) -> list[tuple[Piece, int]]:
    """Return the same, each with its owner: that of its run, or nobody."""
    runs = [one for one in runs if one.pieces]  # one that was cut back to a node is none
    if runs and runs[0].whole:
        return [(piece, runs[0].owner) for piece in runs[0].pieces]
    corners = _corners(outline, blur)
    smooth = outline.smooth()
    knots = [_Knot(one.first, one.last, one) for one in runs]
    knots += [_Knot(one, one) for one in corners if not _is_covered(one, runs, len(outline))]
    if not knots:
        return [(piece, NOBODY) for piece in _round(smooth, tolerance)]
    knots.sort()
    count = len(outline)
    ends = [*knots, _Knot(knots[0].first + count, knots[0].last + count)]
    spans = [smooth.at(range(a.last, b.first + 1)) for a, b in pairwise(ends)]
    lines = [_lines(span, tolerance) for span in spans]
    for here, knot in enumerate(knots):
        into, out = spans[here - 1], spans[here]
        if knot.run:
            into[-1], out[0] = knot.run.pieces[0][0], knot.run.pieces[-1][-1]
            continue
        turn = 0 if here else outline.step  # the last span ends where the first begins
        rooms = len(into), len(out)
        one = _side(outline, knot.first, -1, rooms[0], blur)
        other = _side(outline, knot.first, 1, rooms[1], blur)
        before, after = lines[here - 1], lines[here]
        if before and before[-1].last == rooms[0] - 1:
            one = before[-1].point - turn, before[-1].way
        if after and after[0].first == 0:
            other = after[0].point, after[0].way
        at = _meeting(*one, *other)
        near = outline.at(range(knot.first - 2, knot.first + 3))
        if at is None or abs(at - near).min() > _ROUNDED:
            at = outline.points[knot.first]
        out[0] = at
        into[-1] = at + turn
    pieces: list[tuple[Piece, int]] = []
    for knot, following, span, straight in zip(
        knots, [*knots[1:], knots[0]], spans, lines, strict=True
    ):
        if knot.run:
            pieces += [(piece, knot.run.owner) for piece in knot.run.pieces]
        start = _way(knot.run.pieces[-1][::-1]) if knot.run else None
        end = _way(following.run.pieces[0]) if following.run else None
        if len(span) > _SHORT or abs(span[-1] - span[0]) > _NEXT:
            allowed = tolerance * _LOOSE if knot.run and following.run else tolerance
            found = _along(span, straight, start and -start, end and -end, allowed)
            pieces += [(piece, NOBODY) for piece in found]
    return pieces


def _is_covered(corner: int, runs: Sequence[Run], count: int) -> bool:
    """Whether a point of an outline is on a run, or next to it."""
    return any(
        (corner - one.first + _ROUNDED) % count <= one.last - one.first + 2 * _ROUNDED
        for one in runs
    )


def _way(piece: Piece) -> complex:
    """Return the direction in which a piece leaves its start."""
    for point in piece[1:]:
        if abs(point - piece[0]) > _NOTHING:
            return (point - piece[0]) / abs(point - piece[0])
    return 1


def _round(outline: Outline, tolerance: float) -> list[Piece]:
    """Return the pieces of an outline without corners."""
    count = len(outline)
    bend = int(_turns(outline, 8).argmax())  # which is in no straight side
    span = outline.at(range(bend, bend + count + 1))
    lines = _lines(span, tolerance, closed=True)
    if lines:
        first = lines[0].first
        span = Outline(span[:-1], outline.step).at(range(first, first + count + 1))
        lines = [one._replace(first=one.first - first, last=one.last - first) for one in lines]
        span[0] = lines[0].nearest(span[0])
        span[-1] = span[0] + outline.step
        return _along(span, lines, lines[0].way, -lines[0].way, tolerance)
    across = (1j * outline.step,) if outline.step else (1, 1j)
    heights = [(outline.points * axis.conjugate()).real / abs(axis) for axis in across]
    ends = sorted({_extreme(sign * height) for height in heights for sign in (-1, 1)})
    reach = min(16, count // 12)
    pieces: list[Piece] = []
    for a, b in pairwise([*ends, ends[0] + count]):
        way, back = (direction(outline.at(range(k - reach, k + reach + 1))) for k in (a, b))
        pieces += fit(outline.at(range(a, b + 1)), way, -back, tolerance)
    return pieces


def _extreme(heights: NDArray[np.float64]) -> int:
    """Return the index of the middle of the top of a closed row, within half a pixel."""
    top = int(heights.argmax())
    centred = np.roll(heights, len(heights) // 2 - top) > heights[top] - 0.5
    labels, _ = ndimage.label(centred)
    plateau = np.flatnonzero(labels == labels[len(heights) // 2])
    return int(plateau.mean().round() - len(heights) // 2 + top) % len(heights)


def _along(
    span: Points,
    lines: list[_Line],
    start: complex | None,
    end: complex | None,
    tolerance: float,
) -> list[Piece]:
    """Return the pieces of a span: its lines, and the curves before, between and after them.

    ``start`` and ``end`` are the directions at its ends, inwards; None at a corner.
    """
    pieces: list[Piece] = []
    done, at = 0, span[0]
    for line in lines:
        first = span[0] if line.first == 0 else line.nearest(span[line.first])
        last = span[-1] if line.last == len(span) - 1 else line.nearest(span[line.last])
        if line.first > done:
            curve = np.concatenate([[at], span[done + 1 : line.first], [first]])
            pieces += fit(curve, start, -line.way, tolerance)
        pieces.append((first, last))
        done, at, start = line.last, last, line.way
    if done < len(span) - 1:
        pieces += fit(np.concatenate([[at], span[done + 1 :]]), start, end, tolerance)
    return pieces


def _corners(outline: Outline, blur: int) -> list[int]:
    """Return the indices of the points where sides that run straight to each other's would meet.

    A narrow bend is no corner: its sides, drawn out, meet too far from it.
    """
    reach = _TURN + _TURN_MORE * (blur - 1)
    turn = _turns(outline, reach)
    peaks = (turn == ndimage.maximum_filter1d(turn, 2 * reach + 1, mode="wrap")) & (turn > _SHARP)
    found = np.flatnonzero(peaks)
    rooms = np.diff(found, append=found[:1] + len(outline))
    corners = []
    for corner, before, after in zip(
        map(int, found), map(int, np.roll(rooms, 1)), map(int, rooms), strict=True
    ):
        p, way = _side(outline, corner, -1, before, blur)
        q, back = _side(outline, corner, 1, after, blur)
        at = _meeting(p, way, q, back)
        if at is None:
            continue
        whole = abs(np.angle(-back / way))
        near = outline.at(range(corner - 2, corner + 3))
        # Pixels blunt a corner the more, the more pointed it is.
        blunted = blur if min(before, after) >= _LONG else 1
        meets = abs(at - near).min() < blunted * (0.5 + 0.6 * np.tan(whole / 2))
        if whole > _CORNER and meets and turn[corner] > _AT_ONCE * min(whole, _REVERSED):
            corners.append(corner)
    return corners


def _turns(outline: Outline, reach: int) -> NDArray[np.float64]:
    """Return by how many radians an outline turns, at each point, between its neighbours."""
    here, count = outline.points, len(outline)
    before = here - outline.at(range(-reach, count - reach))
    after = outline.at(range(reach, count + reach)) - here
    return abs(np.angle(after * before.conj()))


def _side(
    outline: Outline, corner: int, step: int, room: int, blur: int
) -> tuple[complex, complex]:
    """Return where a side would reach its corner, and its direction there, away from it."""
    most = _SIDE + _SIDE_MORE * (blur - 1)
    s = np.arange(2, max(4, min(most, room // 2 + 1)))
    points = outline.at(corner + step * s)
    for degree in (1, 2):
        powers = np.vander(s, degree + 1).astype(float)
        found = np.linalg.lstsq(powers, points, rcond=None)[0]
        # A parabola, drawn out, swings with every flaw: only where a line will not do.
        if len(s) <= 5 or abs(powers @ found - points).max() < _CURVED:
            break
    return found[-1], snapped(found[-2], 0)


def _meeting(p: complex, way: complex, q: complex, other: complex) -> complex | None:
    """Return where two lines meet, each a point and a direction; None if they hardly do."""
    sine = (way.conjugate() * other).imag
    if abs(sine) < 0.1:
        return None
    return p + way * ((q - p).conjugate() * other).imag / sine


def _lines(span: Points, tolerance: float, *, closed: bool = False) -> list[_Line]:
    """Return the straight sides of a span between two corners, or of a closed one, in order."""
    end = len(span) - 1
    rounded = 0 if closed else min(_ROUNDED, max(0, (end - 2) // 2))
    if not closed:
        whole, stray = _line(span, rounded, end - rounded)
        if stray < tolerance:
            return [whole._replace(first=0, last=end)]
    if end < _RUN + 2 * rounded:
        return []
    # The bow of each window of points: the square term of the parabola through it.
    u = np.linspace(-1, 1, _RUN + 1)
    square = u**2 - (u**2).mean()
    bow = abs(np.convolve(span, square / (square @ square), "valid"))
    bow[:rounded] = bow[len(bow) - rounded :] = np.inf
    found: list[_Line] = []
    for (run,) in ndimage.find_objects(ndimage.label(bow < _BOW)[0]):
        first, last = run.start, run.stop - 1 + _RUN
        quarter = (last - first) // 4
        core, _ = _line(span, first + quarter, last - quarter)
        first = core.first - _leaving(span[core.first :: -1], core, closed)
        last = core.last + _leaving(span[core.last :], core, closed)
        line, stray = _line(span, first + rounded * (first == 0), last - rounded * (last == end))
        if stray > _STRAY * tolerance or last - first < _RUN / 2:
            continue
        found.append(line._replace(first=first, last=last))
        if len(found) > 1 and first - found[-2].last < _APART:
            found.remove(min(found[-2:], key=lambda side: side.last - side.first))
    return found


def _leaving(points: Points, line: _Line, closed: bool) -> int:
    """Return how many points further a row that begins along a line leaves it.

    It leaves along a circle, so that its distance grows by the square: where it is four times as
    far, it has come twice as far. Near a corner, the line goes on to the corner.
    """
    end = len(points) - 1
    away = abs(((points - line.point) * line.way.conjugate()).imag)
    left = int((away > _LEFT).argmax())
    if away[left] <= _LEFT or (not closed and left >= end - _ROUNDED):
        return end
    gone = left + int((away[left:] > _GONE).argmax())
    if away[gone] <= _GONE:
        return max(0, left - _ROUNDED)
    return max(0, 2 * left - gone)


def _line(span: Points, first: int, last: int) -> tuple[_Line, float]:
    """Return the line through some points by least squares, and how far they stray."""
    points = span[first : last + 1]
    middle = points.mean()
    spread = points - middle
    way = np.sqrt((spread * spread).sum())
    length = abs(points[-1] - points[0])
    if (way.conjugate() * (points[-1] - points[0])).real < 0:
        way = -way
    way = snapped(complex(way), 0.2 / max(length, 1))
    return _Line(first, last, middle, way), abs((spread * way.conjugate()).imag).max()
