"""Lines in the style of an example: what the program calls, and what the sections come to."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from iconstudio.algorithms.curves.curve import Curve
from iconstudio.algorithms.curves.example import Pair
from iconstudio.algorithms.curves.multiresolution import analogy
from iconstudio.algorithms.curves.parameters import Parameters
from iconstudio.algorithms.curves.pyramid import Level, pyramid
from iconstudio.model import Line, LineStyle

_SPACINGS = (2.0, 1.6, 1.25, 1.0, 0.8)
_FAITHFUL = 0.12
"""A sampled example may be off by so much of what its style is off the plain line."""


@dataclass(frozen=True, eq=False)
class Prepared:
    """A style ready to be applied, in one size and strength."""

    style: LineStyle
    parameters: Parameters
    levels: Sequence[Level]


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
    parameters = Parameters(spacing=_spacing(pairs))
    return Prepared(style, parameters, pyramid(pairs, parameters))


def restyled(lines: Iterable[tuple[Line, Prepared]], seed: int = 0) -> list[Line]:
    """Return lines, each in its style. The same seed gives the same lines."""
    return [
        restyled_line(line, style, seed * 1_000_003 + number)
        for number, (line, style) in enumerate(lines)
    ]


def restyled_line(line: Line, prepared: Prepared, seed: int) -> Line:
    """Return one line in a style."""
    curve = Curve.of(np.array(line.points) @ [1, 1j], line.closed)
    plain = replace(curve, parameters=curve.parameters / curve.end, end=1.0)
    style = prepared.style
    made = analogy(
        prepared.levels, plain, prepared.parameters, seed, style.rotation, style.shape
    ).curve
    points = tuple(zip(made.points.real.tolist(), made.points.imag.tolist(), strict=True))
    return replace(line, points=points)


def _spacing(pairs: Sequence[Pair]) -> float:
    """Return the largest spacing that shows the styled lines as they are."""
    offset = np.sqrt(
        np.mean(np.concatenate([abs(_against(one.styled, one)) ** 2 for one in pairs]))
    )
    for spacing in _SPACINGS:
        if all(_roughness(one.styled, spacing) <= _FAITHFUL * offset for one in pairs):
            return spacing
    return _SPACINGS[-1]


def _against(styled: Curve, pair: Pair) -> np.ndarray:
    return np.asarray(styled.points - pair.plain.at(styled.parameters))


def _roughness(curve: Curve, spacing: float) -> float:
    """Return how far a curve is from its samples' polyline, as a root of the mean square."""
    along = np.linspace(0, curve.length, max(2, int(4 * curve.length / spacing)))
    coarse = curve.resampled(spacing)
    off = curve.at_arc(along) - coarse.at(curve.parameters_at(along))
    return float(np.sqrt(np.mean(abs(off) ** 2)))
