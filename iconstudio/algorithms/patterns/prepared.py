"""What is known of an exemplar before anything is synthesised from it."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.patterns.distance import signed_distances
from iconstudio.algorithms.patterns.elements import Elements, elements_of, overlaps
from iconstudio.algorithms.patterns.energy import ALPHA, ALPHA_MONOCHROME, Channels, Weights
from iconstudio.algorithms.patterns.exemplar import Distances, Exemplar
from iconstudio.algorithms.patterns.layers import Paints, paints
from iconstudio.algorithms.patterns.loose_ends import loose_ends
from iconstudio.algorithms.raster import solid

_EVEN = 1e-3


@dataclass(frozen=True, slots=True, eq=False)
class Prepared:
    """An exemplar, ready to be synthesised from; it may be shared by threads."""

    exemplar: Exemplar
    distances: Distances
    paints: Paints
    elements: Sequence[Elements]
    """Of each layer."""
    overlaps: NDArray[np.float64]
    """(L, L): of an element of a layer, the most that lies over or below another layer."""
    endless: Sequence[bool]
    """Of each layer, whether it is of lines that go on beyond the exemplar, and end nowhere."""
    weights: Weights
    channels: Channels
    """(h, w, C)"""
    solidity: NDArray[np.float32]
    """(h, w), 1 where an element of any layer is, or a hole in it."""

    @classmethod
    def of(cls, exemplar: Exemplar, alpha: float | None = None) -> "Prepared":
        """Prepare an exemplar; ``alpha`` is the weight of appearance in equation 6."""
        if alpha is None:
            alpha = ALPHA_MONOCHROME if exemplar.monochrome else ALPHA
        weights = Weights(alpha, bool(np.ptp(exemplar.colours, axis=2).max() < _EVEN))
        distances = signed_distances(exemplar.masks)
        elements = tuple(elements_of(exemplar, m) for m in range(len(exemplar.masks)))
        inside = [
            solid((distance < 0) & ~one.running)
            for distance, one in zip(distances, elements, strict=True)
        ]
        return cls(
            exemplar, distances, paints(exemplar), elements, overlaps(exemplar, elements),
            tuple(_endless(exemplar, distances, elements, m) for m in range(len(elements))),
            weights, weights.channels(exemplar.colours, distances),
            np.any(inside, axis=0).astype(np.float32),
        )  # fmt: skip


def _endless(
    exemplar: Exemplar, distances: Distances, elements: Sequence[Elements], layer: int
) -> bool:
    """Return whether a layer is of lines that go on beyond the exemplar, and end nowhere."""
    if elements[layer].whole or not elements[layer].running.any():
        return False
    over = np.any(exemplar.masks[:layer] > 0.5, axis=0)
    return not loose_ends(distances[layer], over, False)
