"""Cubics fitted to a row of points, which are straight between corners or smooth.

After Schneider, *An Algorithm for Automatically Fitting Digitized Curves* (Graphics Gems, 1990),
compiled. Points and directions are complex numbers, x + iy; directions have length 1.
"""

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.compiled import entry, part
from iconstudio.algorithms.curves.joints import STRAIGHT, Marks, Numbers, Row, joints
from iconstudio.model import Point
from iconstudio.model.path import Contour, Segment

Indices = NDArray[np.int64]

TOLERANCE = 0.12
"""How far, in canvas units, a cubic may be off the points and what is straight between them."""
_DOT = 0.01
"""Canvas units that a dot measures: of a line of no length, some programs draw no round ends."""
_LINE, _LEVEL = 3.0, 0.03
"""Canvas units that a row of points measures at least, and is off a line at most, to be one."""
_STEP = 0.5
"""Canvas units between points at which errors are measured, at most."""
_ROUNDS = 4
_HOPELESS = 8
"""A fit so many times further off than is allowed will not come near."""
_SHORTEST, _LONGEST = 1e-3, 0.8
"""Lengths of handles, as parts of the row, beyond which they are of no use."""


def fitted(points: Row, closed: bool, tolerance: float = TOLERANCE) -> Contour:
    """Return a contour of lines and cubics through points (n,), no two in a row the same.

    Corners stay corners; where cubics join elsewhere, the direction is continuous. The error is at
    most ``tolerance``. Fewer than three points are a line.

    >>> circle = 50 * np.exp(2j * np.pi * np.arange(100) / 100)
    >>> len(fitted(circle, closed=True).segments)
    4
    """
    if len(points) < 3:
        end = points[-1] + (_DOT if len(points) == 1 else 0)
        return Contour(_pair(points[0]), ((_pair(end),),), False)
    breaks, into, out = joints(points, closed)
    if not breaks.any():  # curves then join where they are level or upright
        for heights in (points.real, points.imag):
            breaks[[heights.argmin(), heights.argmax()]] = True
    if closed:
        row = (int(breaks.argmax()) + np.arange(len(points) + 1)) % len(points)
        points, breaks, into, out = points[row], breaks[row], into[row], out[row]
    breaks[0] = breaks[-1] = True
    return _contour(fit(points, breaks, into, out, tolerance), closed)


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
    """Return the piece from one point to another, its error, and the point that is furthest off.

    It leaves the one in the direction ``start``, and comes to the other in the direction ``end``.
    """
    best = np.empty(4, np.complex128)
    best[0], best[1], best[2], best[3] = points[a], points[a], points[b], points[b]
    middle = max(a + 1, (a + b) // 2)
    away = _off_chord(points, a, b)
    length = abs(points[b] - points[a])
    if b == a + 1:
        chord = points[b] - points[a]
        bend = max(abs(chord - length * start), abs(chord - length * end))
        straight = length > STRAIGHT or bend < _LEVEL
    else:
        straight = length > _LINE and away < _LEVEL
    if straight:
        return best, away, middle
    row, owner = _sampled(points, a, b)
    u = np.empty(len(row))
    u[0] = 0.0
    for k in range(1, len(row)):
        u[k] = u[k - 1] + abs(row[k] - row[k - 1])
    whole = u[-1]
    u /= whole
    cubic = best.copy()
    least, furthest = np.inf, middle
    for _ in range(_ROUNDS):
        first, second = _handles(row, u, cubic, start, end, whole)
        cubic[1], cubic[2] = cubic[0] + first * start, cubic[3] - second * end
        worst, where = _step(row, u, cubic)
        if worst < least:
            best[:] = cubic
            least, furthest = worst, owner[where]
        if worst < tolerance or worst > _HOPELESS * tolerance:
            break
    if b == a + 1 and least > tolerance:  # a side between two corners missed
        best[1], best[2] = best[0], best[3]
        return best, 0.0, middle
    return best, least, furthest if a < furthest < b else middle


@part
def _off_chord(points: Row, a: int, b: int) -> float:
    """Return how far points are from what is straight between the first and the last."""
    way = points[b] - points[a]
    length = abs(way)
    if length == 0:
        return np.inf
    way /= length
    most = 0.0
    for k in range(a + 1, b):
        ahead = (points[k] - points[a]) * way.conjugate()
        if not 0 <= ahead.real <= length:
            return np.inf
        most = max(most, abs(ahead.imag))
    return most


@part
def _sampled(points: Row, a: int, b: int) -> tuple[Row, Indices]:
    """Return points along a row no more than a step apart, and which of its own is nearest."""
    many = 1
    for k in range(a, b):
        many += max(1, int(np.ceil(abs(points[k + 1] - points[k]) / _STEP)))
    row, owner = np.empty(many, np.complex128), np.empty(many, np.int64)
    at = 0
    for k in range(a, b):
        steps = max(1, int(np.ceil(abs(points[k + 1] - points[k]) / _STEP)))
        for i in range(steps):
            row[at] = points[k] + (points[k + 1] - points[k]) * (i / steps)
            owner[at] = k if 2 * i < steps else k + 1
            at += 1
    row[at], owner[at] = points[b], b
    return row, owner


@part
def _handles(
    row: Row, u: Numbers, cubic: Row, start: complex, end: complex, whole: float
) -> tuple[float, float]:
    """Return the lengths of the handles by least squares; a third of the row if they are odd."""
    c00, c01, c11, x0, x1 = 0.0, 0.0, 0.0, 0.0, 0.0
    for k in range(1, len(row) - 1):
        t, v = u[k], 1 - u[k]
        b1, b2 = 3 * v * v * t, 3 * v * t * t
        one, other = start * b1, -end * b2
        rest = row[k] - cubic[0] * (v * v * v + b1) - cubic[3] * (b2 + t * t * t)
        c00 += b1 * b1
        c01 += (one * other.conjugate()).real
        c11 += b2 * b2
        x0 += (one.conjugate() * rest).real
        x1 += (other.conjugate() * rest).real
    determinant = c00 * c11 - c01 * c01
    first = second = 0.0
    if determinant > 1e-9 * c00 * c11:
        first = (x0 * c11 - x1 * c01) / determinant
        second = (c00 * x1 - c01 * x0) / determinant
    if not _SHORTEST * whole < first < _LONGEST * whole:
        first = whole / 3
    if not _SHORTEST * whole < second < _LONGEST * whole:
        second = whole / 3
    return first, second


@part
def _step(row: Row, u: Numbers, cubic: Row) -> tuple[float, int]:
    """Return the largest error and where it is, and move each parameter to the foot of its point.

    That is a step of Newton's method, in place.
    """
    worst, where = 0.0, 0
    p0, p1, p2, p3 = cubic[0], cubic[1], cubic[2], cubic[3]
    for k in range(1, len(row) - 1):
        t, v = u[k], 1 - u[k]
        spot = v * v * v * p0 + 3 * v * v * t * p1 + 3 * v * t * t * p2 + t * t * t * p3
        gap = spot - row[k]
        if abs(gap) > worst:
            worst, where = abs(gap), k
        speed = 3 * (v * v * (p1 - p0) + 2 * v * t * (p2 - p1) + t * t * (p3 - p2))
        bend = 6 * (v * (p2 - 2 * p1 + p0) + t * (p3 - 2 * p2 + p1))
        slope = abs(speed) ** 2 + (gap.conjugate() * bend).real
        if slope > 1e-9:
            u[k] = min(max(t - (gap.conjugate() * speed).real / slope, 0.0), 1.0)
    return worst, where


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
