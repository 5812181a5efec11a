"""Gaussian pyramids of the example's curves, ready to be searched (sections 3.4 and 3.5)."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.curves.comparison import Columns
from iconstudio.algorithms.curves.curve import Curve, Numbers
from iconstudio.algorithms.curves.example import Pair
from iconstudio.algorithms.curves.neighbourhoods import Neighbourhoods, Samples, directions, weights
from iconstudio.algorithms.curves.parameters import Parameters
from iconstudio.algorithms.curves.search import Order


@dataclass(frozen=True, eq=False)
class Level:
    """One level of an example's pyramid: the neighbourhoods of its candidates."""

    spacing: float
    """D"""
    styled: Columns
    """Of A'."""
    plain: Columns
    """Of A."""
    coarser: Columns | None
    """Of A' at the next coarser level; None at the coarsest."""
    order: Order
    parameters: Numbers
    """(n,) of the candidates, on their curves."""
    lengthening: float
    """The arc length of A' over that of A."""
    shortening: float
    """The arc length of A' at this level over that at the finest."""


def carried(sources: NDArray[np.int64], above: Level, level: Level) -> NDArray[np.int64]:
    """Return the candidates of a level that are nearest to those of the level above."""
    at = above.order.curve[sources] + above.parameters[sources] / 2  # parameters are at most 1
    here = level.order.curve + level.parameters / 2
    right = np.clip(np.searchsorted(here, at), 1, len(here) - 1)
    nearer = at - here[right - 1] < here[right] - at + 1e-9  # ties must not be told by rounding
    return np.where(nearer, right - 1, right)


def spacings(parameters: Parameters) -> list[float]:
    """Return D of each level, from the coarsest on.

    >>> spacings(Parameters(spacing=1.0, levels=2))
    [1.44, 1.2, 1.0]
    """
    return [parameters.spacing * parameters.coarser**n for n in range(parameters.levels, -1, -1)]


def blurred(curve: Curve, spacing: float, parameters: Parameters) -> Curve:
    """Return a curve as it is at the level of this spacing."""
    finest = parameters.spacing
    sigma = parameters.blur * np.sqrt(max(0.0, spacing**2 - finest**2))
    return curve.blurred(float(sigma), finest / 2)


def swept(curve: Curve, parameters: Parameters) -> Curve:
    """Return the sweep of a plain curve: what of its shape is no texture."""
    finest = parameters.spacing
    return curve.blurred(parameters.sweep * finest, finest / 2)


def pyramid(pairs: Sequence[Pair], parameters: Parameters, shape: bool = False) -> list[Level]:
    """Return the levels of the pairs of an example, from the coarsest on.

    If the ``shape`` of the plain curves counts, they are not unbent.
    """
    levels: list[Level] = []
    before: list[Curve] = []
    sweeps = [None if shape else swept(pair.plain, parameters) for pair in pairs]
    w = weights(parameters)
    for spacing in spacings(parameters):
        styled = [blurred(pair.styled, spacing, parameters) for pair in pairs]
        plain = [blurred(pair.plain, spacing, parameters) for pair in pairs]
        places = [_candidates(one, spacing, parameters.spacing) for one in styled]

        def columns(
            curves: list[Curve],
            hole: bool,
            spacing: float = spacing,
            places: list[Numbers] = places,
        ) -> Columns:
            found = [
                Neighbourhoods.of(curve, at, spacing, parameters.reach, sweep).samples
                for curve, at, sweep in zip(curves, places, sweeps, strict=True)
            ]
            return _columns(np.concatenate(found, axis=1), w, hole)

        order = _order(styled, places, parameters.reach * spacing)
        coarser = columns(before, False) if before else None
        lengthening = sum(one.length for one in styled) / sum(one.length for one in plain)
        shortening = sum(one.length for one in styled) / sum(one.styled.length for one in pairs)
        level = columns(styled, True), columns(plain, False), coarser
        at = np.concatenate(places)
        levels.append(Level(spacing, *level, order, at, lengthening, shortening))
        before = styled
    return levels


def _order(curves: Sequence[Curve], places: Sequence[Numbers], run: float) -> Order:
    """Return where candidates lie; jumps lead to those that go on for ``run``, if many do."""
    arcs = [curve.arc_at(at) for curve, at in zip(curves, places, strict=True)]
    counts = [len(at) for at in places]
    rest = [
        np.full(len(arc), np.inf) if one.closed else one.length - arc
        for one, arc in zip(curves, arcs, strict=True)
    ]
    runs = [min(run, one.length / 4) for one in curves]
    return Order(
        np.concatenate(arcs),
        np.repeat(np.arange(len(curves)), counts),
        np.repeat([one.length if one.closed else 0.0 for one in curves], counts),
        np.concatenate(
            [arc * (not one.closed) / one.length for one, arc in zip(curves, arcs, strict=True)]
        ),
        np.concatenate(rest) < np.repeat(runs, counts) + 1e-6,
    )


def _candidates(styled: Curve, spacing: float, finest: float) -> Numbers:
    """Return the parameters of candidates, about the finest spacing apart.

    A whole number of them makes a step of the level: else steps would be rounded, all alike, and
    textures stretched.
    """
    apart = spacing / np.ceil(spacing / finest - 1e-9)
    count = max(3, int(styled.length / apart + 1e-9))
    first = (styled.length - (count - 1) * apart) / 2
    return styled.parameters_at(np.maximum(first, 0) + apart * np.arange(count))


def _columns(samples: Samples, w: Numbers, hole: bool) -> Columns:
    w = w.copy()
    if hole:
        w[len(w) // 2] = 0
    middles = samples[len(w) // 2].copy()
    samples = samples - middles
    ways = directions(samples)
    centre = (w @ samples) / w.sum()
    energy = w @ abs(samples - centre) ** 2
    return Columns(
        np.concatenate([samples.real, ways.real]),
        np.concatenate([samples.imag, ways.imag]),
        middles,
        centre,
        energy,
    )
