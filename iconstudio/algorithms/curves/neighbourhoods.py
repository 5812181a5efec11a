"""Neighbourhoods and how far they differ under rigid motions (section 3.1).

A neighbourhood is 2 reach + 1 samples of a curve, D apart by arc length, and the directions from
each to the next. All neighbourhoods of the example are compared with one of the result at once: in
the plane, with complex numbers, the best rotation of each comes of one sum of products,
``S = sum w conj(a) b``, and the distance is ``E_a + E_b - 2 |S|``.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.curves.curve import Curve, Numbers, Points
from iconstudio.algorithms.curves.parameters import Parameters

Samples = NDArray[np.complex128]
"""(K, n): a sample a row, a neighbourhood a column."""


@dataclass(frozen=True, eq=False)
class Neighbourhoods:
    """The neighbourhoods of n places of a curve, their samples relative to the middle one."""

    middles: Points
    """(n,)"""
    samples: Samples
    """(2 reach + 1, n)"""
    directions: Samples
    """(2 reach, n): from each sample to the next, of length 1 or 0."""

    @classmethod
    def of(cls, curve: Curve, along: Numbers, spacing: float, reach: int) -> "Neighbourhoods":
        """Return the neighbourhoods at these arc lengths."""
        offsets = spacing * np.arange(-reach, reach + 1)
        samples = curve.at_arc(along[None, :] + offsets[:, None])
        middles = samples[reach].copy()
        return cls(middles, samples - middles, directions(samples))

    @classmethod
    def joined(cls, several: Sequence["Neighbourhoods"]) -> "Neighbourhoods":
        """Return those of several curves one after the other."""
        return cls(
            np.concatenate([one.middles for one in several]),
            np.concatenate([one.samples for one in several], axis=1),
            np.concatenate([one.directions for one in several], axis=1),
        )


def directions(samples: Samples) -> Samples:
    """Return the directions from each sample to the next, of length 1, or 0 where they are one."""
    steps = np.diff(samples, axis=0)
    lengths = abs(steps)
    return np.divide(steps, lengths, out=np.zeros_like(steps), where=lengths > 0)


def weights(parameters: Parameters) -> Numbers:
    """Return w_k of the samples, (2 reach + 1,): 1 in the middle (section 3.6)."""
    k = np.arange(-parameters.reach, parameters.reach + 1)
    return np.exp(-0.5 * (k / parameters.sigma) ** 2)
