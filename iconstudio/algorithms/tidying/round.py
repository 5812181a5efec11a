"""Arcs that go on across a seam are of one circle, and rings of two circles round one centre."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.tidying.sides import (
    LIMIT,
    Side,
    Sides,
    angle,
    has_seam,
    points_of,
    turned,
)
from iconstudio.algorithms.tidying.straight import Carrier, tilts
from iconstudio.algorithms.tracing.bezier import Points

_ROUND = 0.012
"""How far a cubic may stray from a circle to be an arc of it, in parts of the radius."""
_STRAY = 0.05, 2.0
"""How far what a seam is part of may stray: in parts of the radius, and in canvas units."""
_TURN = np.radians(35)
"""Radians that an arc turns at least, together with what goes on from it."""
_SPAN = np.radians(8)
"""And by itself, for its circle to be told."""
_SMALLEST, _LARGEST = 4.0, 200.0
"""Radii, in canvas units."""
_LIKE = 0.12
"""By how much radii of arcs of one circle differ at most, in parts."""
_SAME = 2.5
"""Canvas units by which centres of arcs differ that are round one centre."""
_NEXT = 2.0
"""And their radii, if these are one."""
_SMOOTH = np.radians(12)
"""A side that goes on from an arc with no more of a turn goes on from it smoothly."""
_BACK = 0.02
_FLAT = 1e-7
"""Points are on a line if their spread across it is less, in parts."""
_SAMPLES = 5


@dataclass(frozen=True)
class _Circle:
    centre: complex
    radius: float

    @classmethod
    def through(cls, points: Points) -> "_Circle | None":
        """Return the circle of least squares; None for a line."""
        middle = points.mean()
        z = points - middle
        squares = z.real**2 + z.imag**2
        # The least squares of |z|^2 = 2 x re z + 2 y im z + rest, whose means are 0.
        a, b, c = z.real @ z.real, z.real @ z.imag, z.imag @ z.imag
        determinant = a * c - b * b
        if determinant < _FLAT * (a + c) ** 2:
            return None
        p, q = z.real @ squares / 2, z.imag @ squares / 2
        x, y = (p * c - q * b) / determinant, (q * a - p * b) / determinant
        radius = float(np.sqrt(squares.mean() + x * x + y * y))
        if not _SMALLEST < radius < _LARGEST:
            return None
        return cls(complex(middle + x + 1j * y), radius)

    def stray(self, points: Points) -> float:
        """Return how far points are from it at most."""
        return float(abs(abs(points - self.centre) - self.radius).max())

    def nearest(self, point: complex) -> complex:
        """Return the point of it that is nearest to another."""
        way = point - self.centre
        return self.centre + way / max(abs(way), 1e-9) * self.radius

    def meeting(self, side: Side, end: complex) -> complex:
        """Return where a side that ended at ``end`` ends on it."""
        if side.is_line:
            carrier = Carrier.of(side)
            foot = carrier.nearest(self.centre)
            room = self.radius**2 - abs(foot - self.centre) ** 2
            if room > (0.1 * self.radius) ** 2:
                ends = (foot + sign * np.sqrt(room) * carrier.way for sign in (-1, 1))
                at = min(ends, key=lambda one: abs(one - end))
                if abs(at - end) < LIMIT:
                    return complex(at)
        return self.nearest(end)

    def arc(self, start: complex, turn: float, owner: int) -> Iterator[Side]:
        """Yield cubics from a point of it on, by some radians, of a quarter turn at most each."""
        count = max(1, int(np.ceil(abs(turn) / (np.pi / 2) - 1e-6)))
        step = turn / count
        handle = 4 / 3 * np.tan(step / 4)
        spokes = [(start - self.centre) * np.exp(1j * step * k) for k in range(count + 1)]
        for a, b in pairwise(spokes):
            piece = (a, a + 1j * handle * a, b - 1j * handle * b, b)
            yield Side(tuple(complex(self.centre + one) for one in piece), owner)


@dataclass(frozen=True, eq=False)
class _Arc:
    """A part of a contour that is to lie on a circle."""

    contour: int
    first: int
    count: int
    circle: _Circle
    turn: float
    """Radians; positive if it runs from x to y."""
    mended: bool
    """Whether a seam is part of it."""

    @property
    def weight(self) -> float:
        return abs(self.turn) * self.circle.radius


def rounded(contours: Sequence[Sides]) -> list[Sides]:
    """Return contours whose arcs no seam interrupts."""
    found = [arc for number, sides in enumerate(contours) for arc in _arcs(number, sides)]
    changed = list(contours)
    # From the end of a contour on, so that the numbers of its sides stay.
    for arc in sorted(_gathered(found), key=lambda arc: -arc.first):
        if arc.mended:
            changed[arc.contour] = _onto(changed[arc.contour], arc) or changed[arc.contour]
    return changed


def _arcs(number: int, sides: Sides) -> Iterator[_Arc]:
    """Yield the arcs of a contour that are whole, or that seams are part of."""
    circles = [_circle_of(side) for side in sides]
    if not any(circles):
        return
    count = len(sides)
    taken: set[int] = set()
    longest = sorted((k for k in range(count) if circles[k]), key=lambda k: -sides[k].length)
    for seed in longest:
        if seed in taken:
            continue
        first, last, circle = _grown(sides, circles, seed, taken)
        numbers = [k % count for k in range(first, last + 1)]
        part = [sides[k] for k in numbers]
        points = np.concatenate([side.points(_SAMPLES) for side in part])
        turn = float(_turns(points, circle).sum())
        taken.update(numbers)
        mended = len(part) > 1 and has_seam(part)
        yield _Arc(number, first % count, len(part), circle, turn, mended)


def _grown(
    sides: Sides, circles: "Sequence[_Circle | None]", seed: int, taken: set[int]
) -> tuple[int, int, _Circle]:
    """Return the first and last number of the sides around one that are about on one circle."""
    count = len(sides)
    first = last = seed
    circle = circles[seed]
    assert circle is not None
    rows = {seed: sides[seed].points(_SAMPLES)}
    growing = True
    while growing and last - first < count - 1:
        growing = False
        for step in (-1, 1):
            # What is between two arcs may be short, and no arc by itself.
            for reach in (1, 2, 3, 4):
                more = [first - k if step < 0 else last + k for k in range(1, reach + 1)]
                if last - first + 1 + reach > count or any(k % count in taken for k in more):
                    break
                other = circles[more[-1] % count]
                if other is None or not _alike(circle, other):
                    continue
                for k in more:
                    rows.setdefault(k % count, sides[k % count].points(_SAMPLES))
                wide = range(min(first, *more), max(last, *more) + 1)
                part = [sides[k % count] for k in wide]
                points = np.concatenate([rows[k % count] for k in wide])
                wider = _Circle.through(points)
                if wider is None or wider.stray(points) > _allowed(wider, has_seam(part)):
                    continue
                if not _one_way(points, wider):
                    continue
                circle, growing = wider, True
                first, last = wide[0], wide[-1]
                break
    return first, last, circle


def _alike(one: _Circle, other: _Circle) -> bool:
    return abs(one.radius - other.radius) < _LIKE * max(one.radius, other.radius)


def _allowed(circle: _Circle, mended: bool) -> float:
    if not mended:
        return _ROUND * circle.radius
    return min(_STRAY[0] * circle.radius, _STRAY[1])


def _circle_of(side: Side) -> _Circle | None:
    """Return the circle that a cubic is an arc of."""
    if side.is_line or abs(angle(*side.ways)) < _SPAN:
        return None
    points = side.points(_SAMPLES)
    circle = _Circle.through(points)
    if circle is None or circle.stray(points) > _ROUND * circle.radius:
        return None
    return circle


def _turns(points: Points, circle: _Circle) -> NDArray[np.float64]:
    """Return by how many radians a row of points goes round a centre, from point to point."""
    spokes = points - circle.centre
    return np.angle(spokes[1:] * spokes[:-1].conj())


def _one_way(points: Points, circle: _Circle) -> bool:
    """Whether a row of points goes round a centre without turning back, and no more than once."""
    steps = _turns(points, circle)
    total = steps.sum()
    return bool((steps * np.sign(total) > -_BACK).all() and abs(total) < 2 * np.pi + _BACK)


def _gathered(arcs: Sequence[_Arc]) -> list[_Arc]:
    """Return arcs with centres and radii in common where they nearly are.

    What no seam is part of stays as it is, and says where the others are to be.
    """
    settled: list[_Arc] = []
    for arc in sorted(arcs, key=lambda arc: (arc.mended, -arc.weight)):
        near = [one for one in settled if abs(one.circle.centre - arc.circle.centre) < _SAME]
        if arc.mended and near:
            arc = replace(arc, circle=_shared(arc.circle, near))
        if abs(arc.turn) > _TURN or (near and arc.circle in [one.circle for one in near]):
            settled.append(arc)
    return settled


def _shared(circle: _Circle, near: Sequence[_Arc]) -> _Circle:
    """Return a circle round the centre of the longest of some arcs, with the radius of one."""
    centre = max(near, key=lambda one: one.weight).circle.centre
    radii = [one.circle.radius for one in near]
    radius = min(radii, key=lambda one: abs(one - circle.radius))
    same = abs(radius - circle.radius) < _NEXT
    return _Circle(centre, radius if same else circle.radius)


def _onto(sides: Sides, arc: _Arc) -> Sides | None:
    """Return a contour with some of its sides as an arc; None if they would move too far."""
    part = turned(sides, arc.first)
    replaced, rest = part[: arc.count], part[arc.count :]
    circle = arc.circle
    if circle.stray(points_of(replaced, 2.0)) > LIMIT:
        return None
    owner = max(replaced, key=lambda side: side.length).owner
    if not rest:
        return list(circle.arc(circle.centre + circle.radius, np.sign(arc.turn) * 2 * np.pi, owner))
    before, after = rest[-1], rest[0]
    start, end = replaced[0].start, replaced[-1].end
    first = circle.meeting(before, start)
    last = circle.meeting(after.reversed(), end)
    if abs(first - start) > LIMIT or abs(last - end) > LIMIT:
        return None
    if tilts(before, first) or tilts(after, last):
        return None
    turn = np.angle((last - circle.centre) * np.conj(first - circle.centre))
    turn += 2 * np.pi * round((arc.turn - turn) / (2 * np.pi))
    if abs(turn - arc.turn) > 0.5 or len(rest) == 1:
        return None
    made = list(circle.arc(first, float(turn), owner))
    made[-1] = made[-1].ending(last)
    before = before.ending(first, _smooth(before.ways[1], replaced[0].ways[0], made[0].ways[0]))
    after = after.beginning(last, _smooth(after.ways[0], replaced[-1].ways[1], made[-1].ways[1]))
    return [*made, after, *rest[1:-1], before]


def _smooth(way: complex, was: complex, now: complex) -> complex | None:
    """Return the way a neighbour is to have; None if it met in a corner."""
    return now if abs(angle(way, was)) < _SMOOTH else None
