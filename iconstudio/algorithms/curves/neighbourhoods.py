"""Neighbourhoods and how far they differ under rigid motions (section 3.1).

A neighbourhood is 2 reach + 1 samples of a curve, D apart by arc length, and the directions from
each to the next. All neighbourhoods of the example are compared with one of the result at once: in
the plane, with complex numbers, the best rotation of each comes of one sum of products,
``S = sum w conj(a) b``, and the distance is ``E_a + E_b - 2 |S|``.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.curves.curve import Curve, Numbers
from iconstudio.algorithms.curves.parameters import Parameters

_STEP = 0.5
"""Canvas units to each side of a point that tell the direction of a sweep."""

Samples = NDArray[np.complex128]
"""(K, n): a sample a row, a neighbourhood a column."""


@dataclass(frozen=True, eq=False)
class Neighbourhoods:
    """The neighbourhoods of n places of a curve."""

    samples: Samples
    """(2 reach + 1, n)"""
    inside: NDArray[np.bool_]
    """(2 reach + 1, n): whether a sample lies on the curve; an open one goes straight on."""

    @classmethod
    def of(
        cls, curve: Curve, parameters: Numbers, spacing: float, reach: int, sweep: Curve | None
    ) -> "Neighbourhoods":
        """Return the neighbourhoods at these parameters, unbent along a sweep if there is one."""
        along = curve.arc_at(parameters) + spacing * np.arange(-reach, reach + 1)[:, None]
        samples = curve.at_arc(along)
        inside = np.ones(along.shape, bool)
        if not curve.closed:
            inside = (along > -1e-9) & (along < curve.length + 1e-9)
        if sweep is not None:
            middle = sweep.arc_at(parameters)
            off = _unrolled(curve, along, sweep) - middle
            samples = samples - bend(sweep, middle, off)
        return cls(samples, inside)


def bend(sweep: Curve, middle: Numbers, off: Numbers) -> Samples:
    """Return how far a sweep is off its tangent at ``middle``, ``off`` farther along it.

    Beyond the paper: without it, an example that is straight makes polygons of circles. The rigid
    alignment tells how neighbourhoods lie, but a bend in the sweep of B is no texture, so it is
    taken out of A and A', and of B and B'.
    """
    here = sweep.at_arc(middle)
    way = sweep.at_arc(middle + _STEP) - sweep.at_arc(middle - _STEP)
    way /= np.maximum(abs(way), 1e-12)
    bent: Samples = sweep.at_arc(middle + off) - here - way * off
    return bent


def _unrolled(curve: Curve, along: Numbers, sweep: Curve) -> Numbers:
    """Return the arc length along the sweep at arc lengths of a curve of the same parameters."""
    if not curve.closed:
        inside = np.clip(along, 0, curve.length)
        return sweep.arc_at(curve.parameters_at(inside)) + (along - inside)
    turns = np.floor_divide(along, curve.length)
    at = curve.parameters_at(along - turns * curve.length)
    return sweep.arc_at(at) + turns * sweep.length


def directions(samples: Samples) -> Samples:
    """Return the directions from each sample to the next, of length 1, or 0 where they are one."""
    steps = samples[1:] - samples[:-1]
    lengths = abs(steps)
    return np.divide(steps, lengths, out=np.zeros_like(steps), where=lengths > 0)


def weights(parameters: Parameters) -> Numbers:
    """Return w_k of the samples, (2 reach + 1,): 1 in the middle (section 3.6)."""
    k = np.arange(-parameters.reach, parameters.reach + 1)
    return np.exp(-0.5 * (k / parameters.sigma) ** 2)
