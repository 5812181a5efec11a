"""Closed contours as sides that know which source they are of, and how one of them is changed.

Points are complex numbers, x + iy, in canvas units; ink is to the right of the way that a contour
runs, as y grows downwards.
"""

import cmath
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from iconstudio.algorithms.tracing.bezier import Points
from iconstudio.algorithms.tracing.pieces import NOBODY, Piece
from iconstudio.algorithms.tracing.source_curve import points_on
from iconstudio.model import CANVAS

LIMIT = 0.015 * CANVAS
"""Canvas units by which no contour is moved more."""
SEAM = NOBODY
"""Owner of what was made anew between two sources."""
_NOTHING = 1e-6


class Side(NamedTuple):
    """A line or a cubic, and the number of the source that it is of."""

    piece: Piece
    owner: int

    @classmethod
    def of(cls, piece: Piece, owner: int, unit: float) -> "Side":
        """Take a piece in pixels, each of ``unit`` canvas units."""
        return cls(tuple(complex(point) * unit for point in piece), owner)

    @property
    def start(self) -> complex:
        """Its first point."""
        return self.piece[0]

    @property
    def end(self) -> complex:
        """Its last point."""
        return self.piece[-1]

    @property
    def is_line(self) -> bool:
        """Whether it is straight."""
        return len(self.piece) == 2

    @property
    def length(self) -> float:
        """Its length, for a curve between that of its chord and that of its handles."""
        if self.is_line:
            return abs(self.end - self.start)
        a, b, c, d = self.piece
        return (abs(d - a) + abs(b - a) + abs(c - b) + abs(d - c)) / 2

    @property
    def ways(self) -> tuple[complex, complex]:
        """The directions in which it begins and ends."""
        return _way(self.piece), -_way(self.piece[::-1])

    @property
    def turning(self) -> float:
        """By how many radians it turns, to whichever side."""
        if self.is_line:
            return 0.0
        a, b, c, d = self.piece
        steps = [step for step in (b - a, c - b, d - c) if abs(step) > _NOTHING]
        return sum(abs(angle(one, other)) for one, other in pairwise(steps))

    def points(self, count: int) -> Points:
        """Return so many points along it, both ends among them."""
        return points_on(self.piece, np.linspace(0, 1, count))

    def beginning(self, at: complex, way: complex | None = None) -> "Side":
        """Return it from another first point on; its handle goes along, or points in a ``way``."""
        return self.reversed().ending(at, None if way is None else -way).reversed()

    def ending(self, at: complex, way: complex | None = None) -> "Side":
        """Return it up to another last point, to which it comes in its own way or in this one."""
        if self.is_line:
            return Side((self.start, at), self.owner)
        a, b, c, d = self.piece
        handle = c - d
        if way is not None:
            handle = -way * abs(handle)
        return Side((a, b, at + handle, at), self.owner)

    def reversed(self) -> "Side":
        """Return it backwards."""
        return Side(self.piece[::-1], self.owner)


Sides = list[Side]
"""A closed contour: each side begins where the one before ends."""


def has_seam(sides: Sequence[Side]) -> bool:
    """Whether not all sides are of one and the same source."""
    owners = {side.owner for side in sides}
    return len(owners) > 1 or SEAM in owners


def turned(sides: Sequence[Side], first: int) -> Sides:
    """Return a contour that begins with another side."""
    return [*sides[first:], *sides[:first]]


def points_of(sides: Sequence[Side], spacing: float) -> Points:
    """Return points along a contour, no farther apart than ``spacing`` canvas units."""
    rows = [side.points(max(2, int(side.length / spacing) + 2))[:-1] for side in sides]
    return np.concatenate(rows)


def area(sides: Sequence[Side]) -> float:
    """Return about what a contour encloses; negative if it is a hole."""
    row = points_of(sides, 8.0)
    return float((row.conj() * np.roll(row, -1)).imag.sum()) / 2


def angle(way: complex, other: complex) -> float:
    """Return by how many radians one direction is turned to become another, -pi to pi."""
    return cmath.phase(other * way.conjugate())


def turning(sides: Sequence[Side]) -> float:
    """Return by how many radians a contour turns in all: the more, the more bumps it has."""
    joints = (
        abs(angle(one.ways[1], other.ways[0])) for one, other in pairwise([sides[-1], *sides])
    )
    return sum(joints) + sum(side.turning for side in sides)


def between(sides: Sequence[Side], first: int, last: int) -> Iterator[int]:
    """Yield the numbers of the sides after one and before another, round and round."""
    count = len(sides)
    at = (first + 1) % count
    while at != last:
        yield at
        at = (at + 1) % count


def _way(piece: Piece) -> complex:
    for point in piece[1:]:
        if abs(point - piece[0]) > _NOTHING:
            return (point - piece[0]) / abs(point - piece[0])
    return 1
