"""Lines in the style of an example: what the program calls, and what the sections come to."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from iconstudio.algorithms.curves.constraints import Constraint
from iconstudio.algorithms.curves.curve import Curve
from iconstudio.algorithms.curves.example import Pair
from iconstudio.algorithms.curves.junctions import junctions
from iconstudio.algorithms.curves.multiresolution import analogy
from iconstudio.algorithms.curves.parameters import Parameters
from iconstudio.algorithms.curves.pyramid import Level, pyramid
from iconstudio.algorithms.curves.untangling import longest_loop, untangled
from iconstudio.model import Line, LineStyle

_SPACINGS = (2.0, 1.6, 1.25, 1.0, 0.8)
_FAITHFUL = 0.12
"""A sampled example may be off by so much of what its style is off the plain line."""
_FINEST = 0.8
_SIZES = 4
_SMALLER = 0.7
_ROOM = 5.0
"""A line has room for a style if its radius is so many times the style's offset."""


@dataclass(frozen=True, eq=False)
class Prepared:
    """A style ready to be applied, in one size and strength."""

    style: LineStyle
    sizes: Sequence[tuple[Parameters, Sequence[Level]]]
    """As large as it is wanted, and smaller by and by, for lines on which it has no room."""
    offset: float
    """How far its lines are from the plain ones, as a root of the mean square."""
    loop: float
    """The arc length of the longest loop of the style, along the plain line."""

    def for_line(self, line: Curve) -> tuple[Parameters, Sequence[Level]]:
        """Return what fits on a line."""
        room = _room(line) / (_ROOM * self.offset) if self.offset else 1.0
        number = int(np.ceil(-np.log(max(room, 1e-9)) / -np.log(_SMALLER) - 1e-9))
        return self.sizes[min(max(0, number), len(self.sizes) - 1)]


def prepare(style: LineStyle, strength: float = 1.0, size: float = 1.0) -> Prepared:
    """Return a style ready to be applied.

    ``strength`` is how far the styled lines of the example are from the plain ones, and ``size``
    how large its texture is, both over what the example shows.
    """
    pairs = [
        Pair.of(
            np.array(one.plain) @ [1, 1j] if one.plain else None,
            np.array(one.styled) @ [1, 1j],
            one.closed,
        ).scaled(size, strength)
        for one in style.pairs
    ]
    finest = _spacing(pairs)
    sizes = []
    for number in range(_SIZES):
        smaller = [one.scaled(_SMALLER**number) for one in pairs]
        parameters = Parameters(spacing=max(_FINEST, finest * _SMALLER**number))
        sizes.append((parameters, pyramid(smaller, parameters, style.shape)))
    return Prepared(style, sizes, _offset(pairs), max(longest_loop(one) for one in pairs))


def restyled(lines: Iterable[tuple[Line, Prepared]], seed: int = 0) -> list[Line]:
    """Return lines, each in its style. The same seed gives the same lines.

    Lines that met still meet, and none cross or touch that did not.
    """
    lines = list(lines)
    plain = [_curve(line) for line, _ in lines]
    widths = [line.width for line, _ in lines]
    met = junctions(plain, widths)
    styled = [
        _one(curve, prepared, seed * 1_000_003 + number, constraints)
        for number, (curve, (_, prepared), constraints) in enumerate(
            zip(plain, lines, met, strict=True)
        )
    ]
    if styled:
        loop = max(prepared.loop for _, prepared in lines)
        styled = untangled(plain, styled, widths, loop)
    return [
        replace(line, points=tuple((point.real, point.imag) for point in made.points.tolist()))
        for (line, _), made in zip(lines, styled, strict=True)
    ]


def _one(plain: Curve, prepared: Prepared, seed: int, constraints: Sequence[Constraint]) -> Curve:
    parameters, levels = prepared.for_line(plain)
    style = prepared.style
    return analogy(levels, plain, parameters, seed, style.rotation, style.shape, constraints).curve


def _curve(line: Line) -> Curve:
    curve = Curve.of(np.array(line.points) @ [1, 1j], line.closed)
    return replace(curve, parameters=curve.parameters / curve.end, end=1.0)


def _room(line: Curve) -> float:
    """Return the radius of a circle as slim as a closed line; of an open one a quarter."""
    if not line.closed:
        return line.length / 4
    around = np.append(line.points, line.points[:1])
    area = abs((around[:-1].conj() * around[1:]).imag.sum()) / 2
    return float(2 * area / line.length)


def _offset(pairs: Sequence[Pair]) -> float:
    off = [abs(one.styled.points - one.plain.at(one.styled.parameters)) ** 2 for one in pairs]
    return float(np.sqrt(np.mean(np.concatenate(off))))


def _spacing(pairs: Sequence[Pair]) -> float:
    """Return the largest spacing that shows the styled lines as they are."""
    tolerance = _FAITHFUL * _offset(pairs)
    for spacing in _SPACINGS:
        if all(_roughness(one.styled, spacing) <= tolerance for one in pairs):
            return spacing
    return _SPACINGS[-1]


def _roughness(curve: Curve, spacing: float) -> float:
    """Return how far a curve is from its samples' polyline, as a root of the mean square."""
    along = np.linspace(0, curve.length, max(2, int(4 * curve.length / spacing)))
    coarse = curve.resampled(spacing)
    off = curve.at_arc(along) - coarse.at(curve.parameters_at(along))
    return float(np.sqrt(np.mean(abs(off) ** 2)))
