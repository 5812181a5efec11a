"""Cubics fitted to a row of points, which are straight between corners or smooth.

After Schneider, *An Algorithm for Automatically Fitting Digitized Curves* (Graphics Gems, 1990),
compiled. Points and directions are complex numbers, x + iy; directions have length 1.
"""

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.compiled import entry, part
from iconstudio.model import Point
from iconstudio.model.path import Contour, Segment

Row = NDArray[np.complex128]
Numbers = NDArray[np.float64]
Marks = NDArray[np.bool_]

TOLERANCE = 0.12
"""How far, in canvas units, a cubic may be off the points and what is straight between them."""
_SHARP = np.radians(55)
"""A turn that is a corner, however short its sides."""
_BLUNT = np.radians(15)
"""A turn that is a corner if its sides are long."""
_BULGE = 0.2
"""How far, in canvas units, an arc along a corner's shorter side would be off it."""
_REACH = 0.4
"""Canvas units along which a corner turns."""
_STRAIGHT = 8.0
"""Canvas units from which on what is straight between two points is meant to be."""
_STEP = 1.0
"""Canvas units between points at which errors are measured, at most."""
_ROUNDS = 4
_LONGEST = 1.5
"""A handle longer than this many times the row would loop."""


def fitted(points: Row, closed: bool, tolerance: float = TOLERANCE) -> Contour:
    """Return a contour of lines and cubics through points (n,), no two in a row the same.

    Corners stay corners; where cubics join elsewhere, the direction is continuous. The error is at
    most ``tolerance``. A single point is a line of no length.
    """
    if len(points) < 3:
        ends = [(complex(one), complex(one), complex(one), complex(one)) for one in points]
        return Contour(_pair(ends[0][0]), ((_pair(ends[-1][0]),),), False)
    pieces = fit(*_broken(points, closed), tolerance)
    return _contour(pieces, closed)


def _broken(points: Row, closed: bool) -> tuple[Row, Marks, Row, Row]:
    """Return a row, where it breaks, and the directions into and out of each point.

    A closed row begins at a break, if there is one, and its first point is its last again.
    """
    if closed:
        breaks, _, _ = _joints(np.append(points, points[0]), True)
        start = int(breaks[:-1].argmax())
        points = np.roll(points, -start)
        points = np.append(points, points[0])
    breaks, into, out = _joints(points, closed)
    breaks[0] = breaks[-1] = True
    return points, breaks, into, out


def _joints(points: Row, closed: bool) -> tuple[Marks, Row, Row]:
    """Return which points are breaks, and the directions into and out of each."""
    sides = np.diff(points)
    lengths: Numbers = np.abs(sides)
    ways = sides / lengths
    if closed:
        before, after = np.append(ways[-1], ways), np.append(ways, ways[0])
        one, other = np.append(lengths[-1], lengths), np.append(lengths, lengths[0])
    else:
        before, after = np.append(ways[0], ways), np.append(ways, ways[-1])
        one, other = np.append(lengths[0], lengths), np.append(lengths, lengths[-1])
    turn = np.angle(after * before.conj())
    corner = _corners(points, closed, turn, np.minimum(one, other))
    # A circle through three points turns along its chords in proportion to them.
    smooth = before * np.exp(1j * turn * one / (one + other))
    straight = lengths > _STRAIGHT
    ends = np.zeros(len(points), bool)
    ends[:-1] |= straight
    ends[1:] |= straight
    if closed:
        ends[0] = ends[-1] = ends[0] | ends[-1]
    line_in, line_out = one > _STRAIGHT, other > _STRAIGHT
    way = np.where(line_in & ~line_out, before, np.where(line_out & ~line_in, after, smooth))
    loose = corner.copy()
    if not closed:
        loose[0] = loose[-1] = True
    into, out = way.copy(), way.copy()
    at = np.flatnonzero(loose)
    into[at], out[at] = before[at], after[at]
    _bend_ends(at, into, out, ways, lengths, loose, closed)
    return corner | ends, into, out


def _corners(points: Row, closed: bool, turn: Numbers, shorter: Numbers) -> Marks:
    """Return which points are corners."""
    along = np.append(0.0, np.cumsum(abs(np.diff(points))))
    places = along[:, None] + (-_REACH, _REACH)
    if closed:
        places = places % along[-1]
    near = np.interp(places, along, points)
    whole = abs(np.angle((near[:, 1] - points) * (points - near[:, 0]).conj()))
    if not closed:
        whole[0] = whole[-1] = 0.0
        turn = turn.copy()
        turn[0] = turn[-1] = 0.0
    sizes = abs(turn)
    found: Marks = (sizes > _BLUNT) & ((sizes * shorter / 8 > _BULGE) | (sizes > _SHARP))
    # Of a turn in several steps, the sharpest is the corner.
    for one in np.flatnonzero((whole > _SHARP) & ~found & (sizes > _BLUNT)):
        apart = abs(along - along[one])
        if closed:
            apart = np.minimum(apart, along[-1] - apart)
        around = apart <= _REACH
        if not found[around].any() and sizes[one] >= sizes[around].max():
            found[one] = True
    if closed:
        found[0] = found[-1] = found[0] | found[-1]
    return found


def _bend_ends(
    at: NDArray[np.intp], into: Row, out: Row, ways: Row, lengths: Numbers,
    loose: Marks, closed: bool,
) -> None:  # fmt: skip
    """Turn the directions at corners from the chords next to them to the arcs along these."""
    count = len(ways)
    for corner in at:
        for step, found in ((1, out), (-1, into)):
            first = corner if step == 1 else corner - 1
            second = first + step
            if closed:
                first, second = first % count, second % count
            elif not (0 <= first < count and 0 <= second < count):
                continue
            between = (max(first, second)) % (count if closed else count + 1)
            if loose[between] or max(lengths[first], lengths[second]) > _STRAIGHT:
                continue
            turned = np.angle(ways[second] * np.conj(ways[first]))
            if abs(turned) < _SHARP:
                share = lengths[first] / (lengths[first] + lengths[second])
                found[corner] = ways[first] * np.exp(-1j * turned * share)


@entry
def fit(points: Row, breaks: Marks, into: Row, out: Row, tolerance: float) -> Row:
    """Return pieces (m, 4): the points of cubics, or of lines, whose handles are their ends."""
    count = len(points)
    pieces = np.empty((count - 1, 4), np.complex128)
    ends = np.empty(count, np.int64)
    found = 0
    stack = np.empty((count + 2, 2), np.int64)
    first = 0
    while first < count - 1:
        last = first + 1
        while not breaks[last]:
            last += 1
        begin = found
        top = 0
        stack[0, 0], stack[0, 1] = first, last
        while top >= 0:
            a, b = stack[top]
            top -= 1
            cubic, error, worst = _cubic(points, a, b, out[a], into[b], tolerance)
            if error <= tolerance or b == a + 1:
                # What was divided may be joined with what came before.
                while found > begin:
                    before = ends[found - 1]
                    joined, off, _ = _cubic(points, before, b, out[before], into[b], tolerance)
                    if off > tolerance:
                        break
                    cubic = joined
                    a = before
                    found -= 1
                pieces[found] = cubic
                ends[found] = a
                found += 1
            else:
                stack[top + 1, 0], stack[top + 1, 1] = worst, b
                stack[top + 2, 0], stack[top + 2, 1] = a, worst
                top += 2
        first = last
    return pieces[:found].copy()


@part
def _cubic(
    points: Row, a: int, b: int, start: complex, end: complex, tolerance: float
) -> tuple[Row, float, int]:
    """Return the cubic from one point to another, its error, and the point that is furthest off."""
    cubic = np.empty(4, np.complex128)
    cubic[0], cubic[3] = points[a], points[b]
    chord = points[b] - points[a]
    middle = (a + b) // 2
    if middle == a:
        middle = a + 1
    straight = 0.0
    size = abs(chord)
    if size > 0:
        way = chord / size
        for k in range(a + 1, b):
            away = points[k] - points[a]
            ahead = (away * way.conjugate()).real
            off = abs((away * way.conjugate()).imag)
            if ahead < 0 or ahead > size:
                off = tolerance
            straight = max(straight, off)
    if size > 0 and (
        (b == a + 1 and size > 8.0) or (b > a + 1 and size > 3.0 and straight < tolerance / 4)
    ):
        cubic[1], cubic[2] = cubic[0], cubic[3]
        return cubic, straight, middle
    # Points no more than a step apart.
    many = 0
    for k in range(a, b):
        many += max(1, int(np.ceil(abs(points[k + 1] - points[k]) / 1.0)))
    row = np.empty(many + 1, np.complex128)
    owner = np.empty(many + 1, np.int64)
    at = 0
    for k in range(a, b):
        steps = max(1, int(np.ceil(abs(points[k + 1] - points[k]) / 1.0)))
        for i in range(steps):
            row[at] = points[k] + (points[k + 1] - points[k]) * (i / steps)
            owner[at] = k if 2 * i < steps else k + 1
            at += 1
    row[at] = points[b]
    owner[at] = b
    u = np.empty(many + 1)
    u[0] = 0.0
    for k in range(many):
        u[k + 1] = u[k] + abs(row[k + 1] - row[k])
    whole = u[many]
    u /= whole
    best = cubic.copy()
    least = np.inf
    furthest = middle
    for _ in range(4):
        c00, c01, c11, x0, x1 = 0.0, 0.0, 0.0, 0.0, 0.0
        for k in range(1, many):
            t = u[k]
            v = 1 - t
            b0, b1, b2, b3 = v * v * v, 3 * v * v * t, 3 * v * t * t, t * t * t
            one, other = start * b1, -end * b2
            rest = row[k] - cubic[0] * (b0 + b1) - cubic[3] * (b2 + b3)
            c00 += b1 * b1
            c01 += (one * other.conjugate()).real
            c11 += b2 * b2
            x0 += (one.conjugate() * rest).real
            x1 += (other.conjugate() * rest).real
        det = c00 * c11 - c01 * c01
        if det > 1e-9 * c00 * c11:
            first, second = (x0 * c11 - x1 * c01) / det, (c00 * x1 - c01 * x0) / det
        else:
            first = second = whole / 3
        if first < 1e-3 * whole or first > 1.5 * whole:
            first = whole / 3
            det = 0.0
        if second < 1e-3 * whole or second > 1.5 * whole:
            second = whole / 3
            det = 0.0
        cubic[1], cubic[2] = cubic[0] + start * first, cubic[3] - end * second
        worst, where = 0.0, middle
        for k in range(1, many):
            t = u[k]
            v = 1 - t
            spot = (
                v * v * v * cubic[0]
                + 3 * v * v * t * cubic[1]
                + 3 * v * t * t * cubic[2]
                + t * t * t * cubic[3]
            )
            gap = spot - row[k]
            if abs(gap) > worst:
                worst, where = abs(gap), owner[k]
            # A Newton step moves each parameter to the foot of its point.
            speed = 3 * (
                v * v * (cubic[1] - cubic[0])
                + 2 * v * t * (cubic[2] - cubic[1])
                + t * t * (cubic[3] - cubic[2])
            )
            bend = 6 * (
                v * (cubic[2] - 2 * cubic[1] + cubic[0]) + t * (cubic[3] - 2 * cubic[2] + cubic[1])
            )
            slope = abs(speed) ** 2 + (gap.conjugate() * bend).real
            if slope > 1e-9:
                u[k] = min(max(t - (gap.conjugate() * speed).real / slope, 0.0), 1.0)
        if worst < least:
            best[:] = cubic
            least = worst
            furthest = where
        if worst < tolerance or worst > 8 * tolerance:
            break
    if furthest <= a or furthest >= b:
        furthest = middle
    if b == a + 1 and least > tolerance:
        best[1], best[2] = best[0], best[3]
        least = 0.0
    return best, least, furthest


def _contour(pieces: Row, closed: bool) -> Contour:
    start = _pair(pieces[0, 0])
    segments: list[Segment] = []
    for piece in pieces.tolist():
        if piece[0] == piece[1]:
            segments.append((_pair(piece[3]),))
        else:
            segments.append((_pair(piece[1]), _pair(piece[2]), _pair(piece[3])))
    if closed and len(segments) > 2 and len(segments[-1]) == 1:
        del segments[-1]
    return Contour(start, tuple(segments), closed)


def _pair(point: complex) -> Point:
    return float(point.real), float(point.imag)
