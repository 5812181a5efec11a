"""A contour of a path with points along it, of which any part can be told."""

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.tracing.bezier import Points
from iconstudio.algorithms.tracing.pieces import Piece
from iconstudio.model.path import Contour

STEP = 1.0
"""Pixels between the points that stand for a curve."""
_SNAP = 1.0
"""A part that ends so few pixels from a node of its curve ends there."""


@dataclass(frozen=True, eq=False)
class SourceCurve:
    """A closed contour in pixels, and points along it."""

    pieces: tuple[Piece, ...]
    points: Points
    """(p,): close to one another; the last is the first."""
    along: NDArray[np.float64]
    """(p,): how far along the contour each is, in pixels."""
    place: NDArray[np.float64]
    """(p,): number of the piece, plus how much of its parameter lies before the point."""

    @classmethod
    def of(cls, contour: Contour, unit: float) -> "SourceCurve":
        """Put points on a contour."""
        at = complex(*contour.start) / unit
        pieces: list[Piece] = []
        for segment in contour.segments:
            ends = tuple(complex(*point) / unit for point in segment)
            if len(ends) == 3 or ends[0] != at:
                pieces.append((at, *ends))
            at = ends[-1]
        start = complex(*contour.start) / unit
        if at != start:
            pieces.append((at, start))
        rows, places = [np.array([start])], [np.zeros(1)]
        for number, piece in enumerate(pieces):
            length = sum(abs(b - a) for a, b in pairwise(piece))
            t = np.arange(1, max(1, int(length / STEP)) + 1) / max(1, int(length / STEP))
            rows.append(points_on(piece, t))
            places.append(number + t)
        points = np.concatenate(rows)
        along = np.concatenate([[0], np.cumsum(abs(np.diff(points)))])
        return cls(tuple(pieces), points, along, np.concatenate(places))

    @property
    def length(self) -> float:
        """Pixels around it."""
        return float(self.along[-1])

    def moved(self, by: complex) -> "SourceCurve":
        """Return it moved by some pixels."""
        pieces = tuple(tuple(point + by for point in piece) for piece in self.pieces)
        return replace(self, pieces=pieces, points=self.points + by)

    def at(self, along: NDArray[np.float64]) -> Points:
        """Return the points that lie so far along; it goes round and round."""
        return np.interp(along % self.length, self.along, self.points)

    def part(self, start: float, end: float) -> list[Piece]:
        """Return the pieces between two places along it, backwards if the end is before the start.

        Places are in pixels, and go round and round.
        """
        if end < start:
            return [piece[::-1] for piece in reversed(self.part(end, start))]
        first, last = self._place(start), self._place(end)
        count = len(self.pieces)
        found = []
        for number in range(int(np.floor(first)), int(np.ceil(last))):
            since, until = max(first - number, 0.0), min(last - number, 1.0)
            piece = self.pieces[number % count]
            found.append(piece if (since, until) == (0, 1) else part_of(piece, since, until))
        return found

    def _place(self, at: float) -> float:
        """Return the piece and parameter of a place along, at a node if one is next to it."""
        turns, rest = divmod(at, self.length)
        place = float(np.interp(rest, self.along, self.place))
        node = round(place)
        if abs(np.interp(node, self.place, self.along) - rest) < _SNAP:
            place = node
        return place + turns * len(self.pieces)


def points_on(piece: Piece, t: NDArray[np.float64]) -> Points:
    """Return the points of a line or cubic at parameters (n,) from 0 to 1."""
    u = 1 - t
    powers = [u, t] if len(piece) == 2 else [u**3, 3 * u * u * t, 3 * u * t * t, t**3]
    found: Points = np.array(piece, dtype=np.complex128) @ np.array(powers)
    return found


def part_of(piece: Piece, since: float, until: float) -> Piece:
    """Return the part of a line or cubic between two of its parameters."""
    ends = points_on(piece, np.array([since, until]))
    start, end = (complex(one) for one in ends)
    if len(piece) == 2:
        return start, end
    third = (until - since) / 3
    first, last = (_speed(piece, t) * third for t in (since, until))
    return start, start + first, end - last, end


def _speed(piece: Piece, t: float) -> complex:
    a, b, c, d = piece
    return 3 * ((1 - t) ** 2 * (b - a) + 2 * (1 - t) * t * (c - b) + t * t * (d - c))
