"""Colours that are alike, told apart: those of an image are few."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.tones.regions import sums

Pixels = NDArray[np.uint8]
"""(h, w, 3), red, green and blue."""
Numbers = NDArray[np.int16]
"""(h, w), the number of a colour; -1 for none."""
Lab = NDArray[np.float32]
"""(..., 3), CIELAB."""
MOST = 32
"""Colours."""
LEAST, FEWEST = 0.0015, 12
"""A colour has so much of the image at least, and so many pixels."""


class Limits(NamedTuple):
    """By how much the pixels of one colour differ."""

    even: float
    """In areas of even colour, the channels of CIELAB differ by less within three pixels."""
    alike: float
    """Colours that differ by less, by their distance in CIELAB, are one."""
    stray: float
    """Levels by which a pixel of a soft edge strays from the blend of two colours, at most."""


EXACT = Limits(5.0, 7.0, 24.0)
LOSSY = Limits(10.0, 14.0, 72.0)


def clustered(
    lab: NDArray[np.floating],
    weights: NDArray[np.floating] | NDArray[np.integer],
    least: float,
    alike: float,
    count: int | None,
) -> Numbers:
    """Return which colour each of some (n, 3) belongs to, from the commonest, 0, down.

    One that is far from all that are common enough has -1, unless there may be only ``count``.
    """
    bins = np.rint(lab / (alike / 4)).astype(np.int32)
    bins -= bins.min(axis=0)
    code = np.ravel_multi_index(tuple(bins.T), tuple(bins.max(axis=0) + 1))
    there = np.bincount(code) > 0
    which = (np.cumsum(there) - 1)[code]
    sizes = np.bincount(which, weights)
    means = sums_of(which, (lab.T * weights).T) / np.maximum(sizes, 1e-9)[:, None]
    found = np.full(len(sizes), -1, np.int16)
    palette: list[NDArray[np.float64]] = []
    left = sizes.copy()
    while left.max() > 0 and len(palette) < (count or MOST):
        middle = means[left.argmax()]
        for _ in range(2):
            near = (left > 0) & (np.linalg.norm(means - middle, axis=1) < alike)
            if near.any():
                middle = np.average(means[near], axis=0, weights=sizes[near])
        near[left.argmax()] = True
        if sizes[near].sum() >= least:
            found[near] = len(palette)
            palette.append(middle)
        left[near] = 0
    if palette:
        away = np.linalg.norm(means[:, None] - np.array(palette), axis=2)
        near = away.min(axis=1) < (2 * alike if count is None else np.inf)
        found[near] = away.argmin(axis=1)[near]
    numbers: Numbers = found[which]
    return numbers


def sums_of(number: NDArray[np.integer], values: NDArray[np.floating]) -> NDArray[np.float64]:
    """Return the sums (m, c) of the values (n, c) of each number (n,)."""
    return np.stack([sums(number.astype(np.intp), one) for one in values.T], axis=1)
