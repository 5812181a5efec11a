"""Styles ready to be applied: in the size that a line has room for."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d

from iconstudio.algorithms.curves.curve import Curve, Numbers
from iconstudio.algorithms.curves.example import Pair
from iconstudio.algorithms.curves.parameters import Parameters
from iconstudio.algorithms.curves.pyramid import Level, pyramid
from iconstudio.algorithms.curves.untangling import longest_loop
from iconstudio.model import LineStyle

_SPACINGS = (2.0, 1.6, 1.25, 1.0, 0.8)
_FAITHFUL = 0.12
"""A sampled example may be off by so much of what its style is off the plain line."""
_FINEST = 0.6
_SIZES = 12
_SMALLER = 0.7
_ROOM = 5.0
"""A closed line has room for a style if its radius is so many times the style's offset ..."""
_PERIODS = 5.0
"""... and it is so many times as long as the style's period."""
_COARSE, _SKIPPED = 2.0, 2
"""The least spacing of a coarse curve, and how many levels it does without at least."""
_SOFT = 2.0
"""Standard deviation, in points, of the blur of widths."""
_SWELL, _GRAIN = 0.7, 0.12
"""Logarithms of the factors by which a stroke swells at most, and by which it does abruptly."""
_GRADUAL = 0.8
"""Standard deviation of what is not abrupt, over the width of the stroke."""
_KEPT = 64
"""Sizes of styles that stay prepared."""


@dataclass(frozen=True, slots=True)
class Prepared:
    """A style in one size and strength."""

    style: LineStyle
    strength: float
    size: float
    offset: float
    """How far its lines are from the plain ones, as a root of the mean square."""
    period: float
    """After how much of the plain line a styled one has crossed it twice, on average."""
    loop: float
    """The length of the plain line that the longest loop of the style takes."""

    @property
    def whole(self) -> tuple[Parameters, Sequence[Level]]:
        """What has the size that is wanted, whatever it fits on."""
        return _sized(self.style, self.strength, self.size, 0)

    def room(self, line: Curve, coarse: bool = False) -> tuple[Parameters, Sequence[Level]]:
        """Return what fits on a line: smaller by and by where there is no room.

        If ``coarse``, without the finest levels: what is made of it is soon there, but blurred.
        """
        radius, length = _room(line)
        part = min(radius / (_ROOM * self.offset), length / (_PERIODS * self.period), 1.0)
        number = int(np.ceil(np.log(max(part, 1e-9)) / np.log(_SMALLER) - 1e-9))
        parameters, levels = _sized(self.style, self.strength, self.size, min(number, _SIZES - 1))
        if coarse:
            least = max(_COARSE, parameters.coarser**_SKIPPED * parameters.spacing) - 1e-9
            levels = [one for one in levels if one.spacing > least] or levels[:1]
        return parameters, levels

    def widths(self, levels: Sequence[Level], sources: NDArray[np.int64]) -> Numbers:
        """Return the width at the candidates of points (n,), over the mean of the example."""
        finest = levels[-1]
        found = np.zeros(len(sources))
        for number, pair in enumerate(self.style.pairs):
            here = finest.order.curve[sources] == number
            if pair.widths and here.any():
                width = np.array(pair.widths) / max(float(np.mean(pair.widths)), 1e-9)
                at, even = _knots(self.style, number)
                along = np.interp(finest.parameters[sources[here]], at, even)
                own = np.interp(along, np.linspace(0, 1, len(width)), width)
                found[here] = _bounded(self.strength * np.log(np.maximum(own, 1e-3)), _SWELL)
        return np.exp(found)


def smoothed(widths: Numbers, curve: Curve, width: float) -> Numbers:
    """Return widths at a curve's points, over ``width``, that do not jump where it does not.

    Candidates may. Along less than the width of the stroke, they hardly change: else a line would
    be a row of beads.
    """
    mode = "wrap" if curve.closed else "nearest"
    found = gaussian_filter1d(np.log(widths), _SOFT, mode=mode)
    points = width * _GRADUAL * len(widths) / max(curve.length, 1e-9)
    gradual = gaussian_filter1d(found, max(points, _SOFT), mode=mode)
    kept: Numbers = np.exp(gradual + _bounded(found - gradual, _GRAIN))
    return kept


def _bounded(values: Numbers, most: float) -> Numbers:
    bounded: Numbers = most * np.tanh(values / most)
    return bounded


@lru_cache(_KEPT)
def prepare(style: LineStyle, strength: float = 1.0, size: float = 1.0) -> Prepared:
    """Return a style ready to be applied.

    ``strength`` is how far the styled lines of the example are from the plain ones, and ``size``
    how large its texture is, both over what the example shows.
    """
    pairs = [one.scaled(size, strength) for one in pairs_of(style)]
    return Prepared(
        style,
        strength,
        size,
        max(_offset(pairs), 1e-6),
        max(_period(pairs), 1e-6),
        max(longest_loop(one) for one in pairs),
    )


@lru_cache(_KEPT)
def pairs_of(style: LineStyle) -> tuple[Pair, ...]:
    """Return the examples of a style as curves."""
    return tuple(
        Pair.of(
            np.array(one.plain) @ [1, 1j] if one.plain else None,
            np.array(one.styled) @ [1, 1j],
            one.closed,
        )
        for one in style.pairs
    )


@lru_cache(_KEPT)
def _sized(
    style: LineStyle, strength: float, size: float, number: int
) -> tuple[Parameters, Sequence[Level]]:
    # What is shown larger than it was drawn has the same detail: it needs no more points.
    larger = max(size, 1.0)
    whole = [one.scaled(size / larger, strength) for one in pairs_of(style)]
    spacing = max(_FINEST, _spacing(whole) * larger * _SMALLER**number)
    smaller = [one.scaled(larger * _SMALLER**number) for one in whole]
    parameters = Parameters(spacing=spacing)
    more = max(0.0, np.log(_SPACINGS[0] / spacing) / np.log(parameters.coarser))
    parameters = replace(parameters, levels=parameters.levels + round(more))
    return parameters, pyramid(smaller, parameters, style.shape)


@lru_cache(_KEPT)
def _knots(style: LineStyle, number: int) -> tuple[Numbers, Numbers]:
    """Return the parameters of the given points of a styled stroke, and 0 to 1 along them."""
    pair = style.pairs[number]
    curve = pairs_of(style)[number].styled
    points = np.array(pair.styled) @ [1, 1j]
    steps = abs(np.diff(points))
    arc = np.concatenate([[0.0], np.cumsum(steps)])
    at = curve.parameters_at(arc / max(arc[-1], 1e-9) * curve.length)
    return at, np.linspace(0, 1, len(points))


def _room(line: Curve) -> tuple[float, float]:
    """Return the radius of a circle as slim as a closed line, and its length.

    An open line has more room: nothing meets at its ends.
    """
    if not line.closed:
        return line.length / 4, 2 * line.length
    around = np.append(line.points, line.points[:1])
    area = abs((around[:-1].conj() * around[1:]).imag.sum()) / 2
    return float(2 * area / line.length), line.length


def _offset(pairs: Sequence[Pair]) -> float:
    off = [abs(one.styled.points - one.plain.at(one.styled.parameters)) ** 2 for one in pairs]
    return float(np.sqrt(np.mean(np.concatenate(off))))


def _period(pairs: Sequence[Pair]) -> float:
    """Return twice the length of the plain line between places where the styled one crosses it."""
    length, crossings = 0.0, 0
    for pair in pairs:
        even = np.arange(0, pair.plain.length, 1.0)
        at = pair.plain.parameters_at(even)
        way = pair.plain.at_arc(even + 1) - pair.plain.at_arc(even - 1)
        off = ((pair.styled.at(at) - pair.plain.at(at)) * way.conj()).imag
        length += pair.plain.length
        middle = np.percentile(off, [10, 90]).mean()
        crossings += int((np.diff(off > middle) != 0).sum())
    return 2 * length / max(crossings, 1)


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
