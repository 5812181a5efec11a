"""Outlines on a tile, drawn as often as they are seen in it, so that its opposite borders match.

What lies across a border is drawn at the opposite one as well, by the same curves. An outline that
does not close on the tile, such as a stripe's, goes on beyond its borders; what it bounds is closed
outside.
"""

import math
from collections.abc import Iterable, Sequence
from itertools import dropwhile, product
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.flattening import flattened
from iconstudio.model import Contour, Path, Transform
from iconstudio.model.path import Segment

Size = tuple[int, int]
"""Rows and columns of a tile."""
Points = NDArray[np.complex128]


def repeated(path: Path, size: Size) -> Path:
    """Return a shape with all its copies that are seen in a tile."""
    return Path(
        tuple(
            moved(contour, complex(right, down))
            for down, right in _moves(path.bounds, size)
            for contour in path.contours
        )
    )


def moved(contour: Contour, move: complex) -> Contour:
    """Return a contour moved by x + iy."""
    there = Transform().translate(float(move.real), float(move.imag))
    return Path((contour,)).transformed(there).contours[0]


def _moves(bounds: tuple[float, float, float, float], size: Size) -> Iterable[tuple[int, int]]:
    """Return how far down and right what has these bounds is moved to where a tile shows it."""
    left, top, right, bottom = bounds
    rows, columns = size
    return product(_along(top, bottom, rows), _along(left, right, columns))


def _along(low: float, high: float, side: int) -> list[int]:
    first, last = math.floor(-high / side) + 1, math.ceil(1 - low / side)
    return [side * count for count in range(first, last)]


class _Strip(NamedTuple):
    """A copy of an endless outline, and all that lies aside of it."""

    height: float
    """How far aside the outline comes."""
    begins: bool
    """Whether ink lies aside of the outline, or else ends there."""
    contour: Contour


def bounded(endless: Sequence[tuple[Contour, complex]], size: Size) -> Path:
    """Return what endless outlines bound, as far as a tile shows it.

    Parameters
    ----------
    endless
        Those of one component: one turn of each, and the step after which it goes on. Seen along
        it, with y down, ink is on the right.
    """
    step = endless[0][1]
    strips = [
        strip
        for contour, own in endless
        for strip in _strips(contour, step, (own * step.conjugate()).real > 0, size)
    ]
    inwards = dropwhile(lambda strip: not strip.begins, sorted(strips))
    return Path(tuple(strip.contour for strip in inwards))


def _strips(contour: Contour, step: complex, begins: bool, size: Size) -> Iterable[_Strip]:
    """Return the copies of an outline from some way before the tile to the end of it."""
    rows, columns = size
    row, _ = flattened(Path((contour,)))[0]
    length = abs(step)
    # Seen along the step: what is real is ahead, what is imaginary aside.
    turn = step.conjugate() / length
    points: Points = row @ np.array([1, 1j]) * turn
    corners = np.array([0, columns, 1j * rows, columns + 1j * rows]) * turn
    apart = rows * columns / length
    next_one = _next(step, size)
    low, high = points.imag.min(), points.imag.max()
    first = math.ceil((corners.imag.min() - high) / apart) - 1
    for count in range(first, math.floor((corners.imag.max() - low) / apart) + 1):
        move = count * next_one
        ahead = (move * turn).real
        before = math.floor((corners.real.min() - points.real.max() - ahead) / length) + 1
        after = math.ceil((corners.real.max() - points.real.min() - ahead) / length)
        turns = [moved(contour, move + k * step) for k in range(before, after)]
        far = (corners.imag.max() + length - low - count * apart) * 1j / turn
        closed = _closed(turns if begins else turns[::-1], far)
        yield _Strip(float(high + count * apart), begins, closed)


def _next(step: complex, size: Size) -> complex:
    """Return by how much an endless outline is moved to its next copy aside."""
    rows, columns = size
    right, down = round(step.real / columns), round(step.imag / rows)
    most = max(abs(right), abs(down))
    return next(
        complex(i * columns, j * rows)
        for i, j in product(range(-most, most + 1), repeat=2)
        if j * right - i * down == 1
    )


def _closed(turns: Sequence[Contour], far: complex) -> Contour:
    """Return turns, each of which begins where the one before ends, closed ``far`` aside."""
    segments: list[Segment] = [segment for one in turns for segment in one.segments]
    for x, y in (segments[-1][-1], turns[0].start):
        segments.append(((x + far.real, y + far.imag),))
    return Contour(turns[0].start, tuple(segments))
