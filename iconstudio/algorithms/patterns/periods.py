"""Sizes that fit the exemplar's period (beyond the paper).

A tile whose side is no multiple of the period must be torn somewhere: no arrangement of the
exemplar's neighbourhoods closes it. Elements in rows leave an uneven last row.
"""

from itertools import product

import numpy as np
from numpy.typing import NDArray
from scipy import fft

from iconstudio.algorithms.patterns.distance import signed_distance

Field = NDArray[np.float32]
Period = tuple[float | None, float | None]
"""Pixels down and to the right; None where there is none."""

_ALIKE = 0.9
"""How well an exemplar correlates with itself, moved by a period, at least."""
_SHORTEST = 4
_FEWEST, _IN_ROWS = 6, 0.8
"""Elements that may lie in rows, and how near to these: the mean of their phases, 1 if exactly."""
_SCALED, _STRETCHED = 1.12, 1.03
"""By how much a tile is larger or smaller than wanted at most, and a side beside the other."""


def period(mask: Field) -> Period:
    """Return after how many pixels a layer's mask (h, w) repeats, at least twice."""
    distance = signed_distance(mask - np.float32(0.5))
    return _along(distance), _along(distance.T)


def _along(field: Field) -> float | None:
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
            return float(k)
    return None


def rows_apart(places: NDArray[np.floating], side: float) -> float | None:
    """Return how far rows are apart if elements at these places (n,) lie in rows that fill a side.

    None if they do not.
    """
    if len(places) < _FEWEST:
        return None
    for count in range(2, len(places) // 2 + 1):
        if abs(np.exp(2j * np.pi * count * places / side).mean()) > _IN_ROWS:
            return side / count
    return None


def fitting_size(size: tuple[int, int], period: Period) -> tuple[int, int]:
    """Return the size of a tile near a wanted one that fits a period.

    Its sides keep their ratio, as nearly as both periods let them. The wanted size, if none near
    fits.

    Parameters
    ----------
    size
        Rows and columns.
    period
        In the same pixels.
    """
    fits = [_near(side, found) for side, found in zip(size, period, strict=True)]
    if not any(fits):
        return size
    down, across = fits
    pairs = [
        (a, b)
        for a, b in product(down or across, across or down)
        if max(a, b) <= _STRETCHED * min(a, b) and ((down and across) or a == b)
    ]
    if not pairs:
        return size
    factors = min(pairs, key=lambda pair: sum(abs(np.log(one)) for one in pair))
    rows, columns = (round(side * one) for side, one in zip(size, factors, strict=True))
    return rows, columns


def _near(side: int, found: float | None) -> list[float]:
    """Return by how many times as long a side is that fits a period, if that is hardly another."""
    if found is None:
        return []
    count = round(side / found)
    factors = [k * found / side for k in (count - 1, count, count + 1) if k > 0]
    return [one for one in factors if 1 / _SCALED <= one <= _SCALED]
