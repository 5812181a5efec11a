"""Where a row of points has corners and straight sides, and its directions at each point.

Points and directions are complex numbers, x + iy; directions have length 1.
"""

import numpy as np
from numpy.typing import NDArray

Row = NDArray[np.complex128]
Numbers = NDArray[np.float64]
Marks = NDArray[np.bool_]

STRAIGHT = 8.0
"""Canvas units from which on what is straight between two points is meant to be."""
_SHARP = np.radians(55)
"""A turn that is a corner, however short its sides."""
_BLUNT = np.radians(15)
"""A turn that is a corner if its sides are long."""
_BULGE = 0.2
"""How far, in canvas units, an arc along a corner's shorter side would be off it."""
_REACH = 0.4
"""Canvas units along which a corner turns."""


def joints(points: Row, closed: bool) -> tuple[Marks, Row, Row]:
    """Return which points curves begin and end at, and the directions into and out of each.

    ``points`` (n,) are three or more, no two in a row the same. Curves break at corners, and where
    a straight side begins or ends; there the direction is that of the side. Elsewhere it is that of
    a circle through the point and its neighbours.
    """
    sides = np.roll(points, -1) - points  # the last is none if the row is open
    lengths: Numbers = np.maximum(abs(sides), 1e-12)
    after = sides / lengths
    before, shorter = np.roll(after, 1), np.minimum(lengths, np.roll(lengths, 1))
    turn = np.angle(after * before.conj())
    if not closed:
        turn[[0, -1]] = 0.0
    corner = _corners(points, closed, turn, shorter)
    loose = corner.copy()
    if not closed:
        loose[[0, -1]] = True
    straight = lengths > STRAIGHT
    line_in, line_out = np.roll(straight, 1), straight
    # A circle through three points turns along its chords in proportion to them.
    share = np.roll(lengths, 1) / (np.roll(lengths, 1) + lengths)
    way = before * np.exp(1j * turn * share)
    way = np.where(line_in & ~line_out, before, np.where(line_out & ~line_in, after, way))
    # At a corner it is known from the next circle alone.
    round_ = ~loose & ~line_in & ~line_out & (abs(turn) < _SHARP)
    bend = np.where(round_, turn, 0.0)
    leaving = after * np.exp(-1j * np.roll(bend * share, -1))
    coming = before * np.exp(1j * np.roll(bend * (1 - share), 1))
    return corner | line_in | line_out, np.where(loose, coming, way), np.where(loose, leaving, way)


def _corners(points: Row, closed: bool, turn: Numbers, shorter: Numbers) -> Marks:
    """Return which points are corners: they turn more than a curve through their sides would."""
    size = abs(turn)
    found: Marks = (size > _BLUNT) & ((size * shorter / 8 > _BULGE) | (size > _SHARP))
    along = np.append(0.0, np.cumsum(abs(np.diff(points, append=points[:1]))))
    places = along[:-1, None] + (-_REACH, _REACH)
    if closed:
        places = places % along[-1]
    near = np.interp(places, along, np.append(points, points[0]))
    if not closed:
        near[[0, -1]] = points[[0, -1], None]
    whole = abs(np.angle((near[:, 1] - points) * (points - near[:, 0]).conj()))
    # Of a turn in several steps, the sharpest is the corner.
    for one in np.flatnonzero((whole > _SHARP) & ~found & (size > _BLUNT)):
        apart = abs(along[:-1] - along[one])
        if closed:
            apart = np.minimum(apart, along[-1] - apart)
        around = apart <= _REACH
        if not found[around].any() and size[one] >= size[around].max():
            found[one] = True
    return found
