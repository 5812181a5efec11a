"""Straight sides that go on across a seam are one, and corners that a seam blunted are corners."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from iconstudio.algorithms.tidying.sides import (
    LIMIT,
    SEAM,
    Side,
    Sides,
    angle,
    between,
    has_seam,
    turned,
)

_ALIKE = np.radians(3)
"""By how much the directions of two lines may differ that are one."""
_CORNER = np.radians(15)
"""By how much they differ at least where they meet in a corner."""
_POINTED = np.radians(150)
"""And at most: lines that meet so pointedly would meet far away."""
_LEAN = np.radians(2.5)
"""A line that a seam is part of, and that leans no more than this, does not lean."""
_EXACT = np.radians(0.05)
_LONG, _LEAST = 8.0, 2.0
"""Canvas units of the longer of two lines that are one, at least, and of the shorter."""
_GAP = 24.0
"""Canvas units between them at most."""
_BLUNT = 6.0
"""Canvas units of what is between the two sides of a blunted corner."""
_SMOOTH = np.radians(20)
"""A kink of no more, where a curve goes on across a seam, is none."""
_SHORT = 5.0
"""Canvas units of a side that goes on smoothly, at least."""
_MOST = 6
"""How many sides are looked over."""
_TIE = 0.02
_ASIDE = 0.05
"""Canvas units by which the end of a line is moved aside at most: lines do not turn."""
_CROSSES = 0.15
"""Sine of the least angle at which a line is followed to where it meets another."""


class Carrier(NamedTuple):
    """An endless line: a point, and its direction."""

    point: complex
    way: complex

    @classmethod
    def of(cls, side: Side) -> "Carrier":
        """Return the one that a line is part of."""
        return cls((side.start + side.end) / 2, side.ways[0])

    @property
    def lean(self) -> float:
        """By how many radians it is off the nearest axis."""
        return float(np.arcsin(min(abs(self.way.imag), abs(self.way.real), 1)))

    @property
    def upright(self) -> "Carrier":
        """The same along the nearest axis."""
        x, y = self.way.real, self.way.imag
        way = complex(np.sign(x), 0) if abs(x) > abs(y) else complex(0, np.sign(y))
        return Carrier(self.point, way)

    def nearest(self, point: complex) -> complex:
        """Return the point of it that is nearest to another."""
        return self.point + self.way * ((point - self.point) * self.way.conjugate()).real

    def crossing(self, other: "Carrier") -> complex | None:
        """Return where two of them cross; None if they hardly do."""
        sine = (self.way.conjugate() * other.way).imag
        if abs(sine) < _CROSSES:
            return None
        return (
            self.point + self.way * ((other.point - self.point).conjugate() * other.way).imag / sine
        )


def straightened(sides: Sides) -> Sides:
    """Return a contour whose lines and corners no seam interrupts."""
    if not has_seam(sides):
        return sides
    for _ in range(2 * len(sides)):
        changed = next(_changes(sides), None) if len(sides) > 2 else None
        if changed is None:
            break
        sides = changed
    return sides


def _changes(sides: Sides) -> Iterator[Sides]:
    """Yield the contour with one more thing put right, the longest lines first."""
    numbers = list(_before_seams(sides))
    lines = sorted((k for k in numbers if sides[k].is_line), key=lambda k: -sides[k].length)
    for first in lines:
        for last in _near(sides, first):
            changed = _joined(sides, first, last) or _cornered(sides, first, last)
            if changed:
                yield changed
    for first in numbers:
        for count in range(_MOST):
            changed = _smoothed(sides, first, count)
            if changed:
                yield changed
    for number in lines:
        changed = _set_upright(sides, number)
        if changed:
            yield changed


def _before_seams(sides: Sides) -> Iterator[int]:
    """Yield the numbers of the sides that have a seam soon after them."""
    owners = [side.owner for side in sides]
    wide = owners + owners[: _MOST + 1]
    for number, owner in enumerate(owners):
        if owner == SEAM or any(other != owner for other in wide[number : number + _MOST + 1]):
            yield number


def _near(sides: Sides, first: int) -> Iterator[int]:
    """Yield the numbers of lines that follow on a line after no more than a seam."""
    gone, count = 0.0, len(sides)
    for step in range(1, min(_MOST, count - 1) + 1):
        side = sides[(first + step) % count]
        if side.is_line:
            yield (first + step) % count
        gone += side.length
        if gone > _GAP:
            return


def _joined(sides: Sides, first: int, last: int) -> Sides | None:
    """Return the contour with two lines, and what is between them, as one line."""
    one, other = sides[first], sides[last]
    if abs(angle(one.ways[0], other.ways[0])) > _ALIKE:
        return None
    if max(one.length, other.length) < _LONG or min(one.length, other.length) < _LEAST:
        return None
    part = turned(sides, first)
    count = (last - first) % len(sides) + 1
    if not has_seam(part[:count]):
        return None
    longer, shorter = sorted((one, other), key=lambda side: -side.length)
    carriers = [Carrier.of(longer), Carrier.of(shorter)]
    if longer.length < (1 + _TIE) * shorter.length:
        middle = Carrier((one.start + one.end + other.start + other.end) / 4, carriers[0].way)
        carriers.insert(0, middle)
    carriers.sort(key=lambda carrier: carrier.lean > _EXACT)
    if carriers[0].lean < _LEAN:
        carriers.insert(0, carriers[0].upright)
    owner = longer.owner if longer.owner != SEAM else shorter.owner
    found = (_onto(part, count, carrier, owner) for carrier in carriers)
    return next((some for some in found if some), None)


def _cornered(sides: Sides, first: int, last: int) -> Sides | None:
    """Return the contour with a corner where two lines, drawn out, meet."""
    one, other = sides[first], sides[last]
    turn = abs(angle(one.ways[0], other.ways[0]))
    inner = [sides[k] for k in between(sides, first, last)]
    if not inner or not _CORNER < turn < _POINTED or sum(side.length for side in inner) > _BLUNT:
        return None
    if not has_seam([one, *inner, other]) or min(one.length, other.length) < _LEAST:
        return None
    at = Carrier.of(one).crossing(Carrier.of(other))
    if at is None or any(abs(point - at) > LIMIT for side in inner for point in side.piece):
        return None
    # It goes on beyond what it had, or is cut back by less than it has.
    if any(
        ((at - side.start) * way.conjugate()).real <= 0
        for side, way in ((one, one.ways[0]), (other.reversed(), -other.ways[0]))
    ):
        return None
    part = turned(sides, first)
    count = (last - first) % len(sides)
    return [one.ending(at), other.beginning(at), *part[count + 1 :]]


def _smoothed(sides: Sides, first: int, count: int) -> Sides | None:
    """Return the contour with two sides that nearly meet smoothly as they do so.

    ``count`` is how many sides there are between them, which go.
    """
    if count + 3 > len(sides):
        return None
    part = turned(sides, first)
    one, inner, other = part[0], part[1 : count + 1], part[count + 1]
    if (one.is_line and other.is_line) or not has_seam(part[: count + 2]):
        return None
    gone = sum(side.length for side in inner)
    if gone > _BLUNT:
        return None
    kink = abs(angle(one.ways[1], other.ways[0]))
    if kink > _SMOOTH or (not inner and kink < _EXACT):
        return None
    if min(one.length, other.length) < max(_SHORT, 1.5 * gone):
        return None
    at, way = (one.end + other.start) / 2, one.ways[1] + other.ways[0]
    if one.is_line:
        at, way = one.end, one.ways[1]
    elif other.is_line:
        at, way = other.start, other.ways[0]
    if any(abs(point - at) > LIMIT for side in inner for point in side.piece):
        return None
    way /= abs(way)
    one, other = one.ending(at, way), other.beginning(at, way)
    if abs(angle(one.ways[1], other.ways[0])) > _EXACT:  # a curve without a handle there
        return None
    return [one, other, *part[count + 2 :]]


def _set_upright(sides: Sides, number: int) -> Sides | None:
    """Return the contour with a line of a seam along the axis off which it leans."""
    side = sides[number]
    carrier = Carrier.of(side)
    if side.owner != SEAM or side.length < _LONG or not _EXACT < carrier.lean < _LEAN:
        return None
    return _onto(turned(sides, number), 1, carrier.upright, side.owner)


def _onto(sides: Sides, count: int, carrier: Carrier, owner: int) -> Sides | None:
    """Return a contour with its first ``count`` sides as one line on a carrier.

    None: something would move too far.
    """
    if len(sides) < count + 2:
        return None
    replaced, before, after = sides[:count], sides[-1], sides[count]
    for side in replaced:
        for point in side.points(5) if not side.is_line else side.piece:
            if abs(carrier.nearest(point) - point) > LIMIT:
                return None
    start, end = replaced[0].start, replaced[-1].end
    first, last = _meeting(before, carrier, start), _meeting(after.reversed(), carrier, end)
    if abs(first - start) > LIMIT or abs(last - end) > LIMIT:
        return None
    if tilts(before, first) or tilts(after, last):
        return None
    if ((last - first) * carrier.way.conjugate()).real <= 0:
        return None
    ways = before.ways[1], after.ways[0]
    smooth = [
        abs(angle(way, line.ways[end])) < _ALIKE
        for way, line, end in zip(ways, (replaced[0], replaced[-1]), (0, 1), strict=True)
    ]
    line = Side((first, last), owner)
    before = before.ending(first, carrier.way if smooth[0] else None)
    after = after.beginning(last, carrier.way if smooth[1] else None)
    return [line, after, *sides[count + 1 : -1], before]


def tilts(side: Side, end: complex) -> bool:
    """Whether a line of some length would turn if it ended elsewhere."""
    if not side.is_line or side.length < _LONG:
        return False
    return abs(Carrier.of(side).nearest(end) - end) > _ASIDE


def _meeting(side: Side, carrier: Carrier, end: complex) -> complex:
    """Return where a side that ended at ``end`` is to end on a carrier."""
    if side.is_line:
        at = carrier.crossing(Carrier.of(side))
        if at is not None and abs(at - end) < LIMIT:
            return at
    return carrier.nearest(end)
