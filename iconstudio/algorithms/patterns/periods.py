"""Sizes that fit the exemplar's period (beyond the paper).

A tile whose side is no multiple of the period must be torn somewhere: no arrangement of the
exemplar's neighbourhoods closes it.
"""

import numpy as np
from numpy.typing import NDArray
from scipy import fft

from iconstudio.algorithms.patterns.distance import signed_distance

Field = NDArray[np.float32]

_ALIKE = 0.9
"""How well an exemplar correlates with itself, moved by a period, at least."""
_SHORTEST = 4


def period(mask: Field) -> tuple[int | None, int | None]:
    """Return after how many pixels a layer's mask (h, w) repeats, down and to the right.

    None where it does not, at least twice, or where it does not change at all.
    """
    distance = signed_distance(mask - np.float32(0.5))
    return _along(distance), _along(distance.T)


def _along(field: Field) -> int | None:
    """Return the period of a field (h, w) from row to row."""
    height = len(field)
    rows = field - field.mean()
    spectrum = np.abs(fft.rfft(rows, 2 * height, axis=0)) ** 2
    products = fft.irfft(spectrum, axis=0).sum(axis=1)[:height]
    squares = np.append(0, np.cumsum((rows**2).sum(axis=1)))
    shifts = np.arange(height // 2 + 2)
    ends, starts = squares[height - shifts], squares[height] - squares[shifts]
    alike = products[shifts] / np.sqrt(np.maximum(ends * starts, 1e-9))
    for k in range(_SHORTEST, len(shifts) - 1):
        before, here, after = alike[k - 1 : k + 2]
        if here > _ALIKE and here >= before and here > after and alike[1:k].min() < here - 0.05:
            return k
    return None


def fitting_size(size: tuple[int, int], masks: NDArray[np.float32]) -> tuple[int, int]:
    """Return the size of a tile nearest to a wanted one that fits the first layer's period.

    Parameters
    ----------
    size
        Rows and columns.
    masks
        (L, h, w), of the exemplar.
    """
    rows, columns = (
        wanted if found is None else max(1, round(wanted / found)) * found
        for wanted, found in zip(size, period(masks[0]), strict=True)
    )
    return rows, columns
