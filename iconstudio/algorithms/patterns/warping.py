"""Colours that move along with a zero level set (section 2; Lee et al. 1995).

Near the contour a pixel moves as far as the contour did; farther away, the deformation is
interpolated by normalised convolution. (The paper takes multilevel free-form deformation, which
reaches farther; but colours are optimised afterwards, so that only those near the contour count.)
"""

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter, map_coordinates

from iconstudio.algorithms.patterns.distance import bordered

Field = NDArray[np.float32]

_NEAR = 1.5
"""Pixels from the contour within which its own motion is known."""
_SPREAD, _CUT, _LEAST = 3.0, 2.5, 0.02
"""Of the convolution: standard deviation in pixels, after how many of them it ends, and the weight
below which a mean fades to 0."""


def warped(colours: Field, before: Field, after: Field, tile: bool) -> Field:
    """Return colours (h, w, C) moved as the zero level set of a distance function did.

    Parameters
    ----------
    before, after
        (h, w), the distance function before and after.
    """
    moved = deformation(before, after, tile)
    if not moved.any():
        return colours
    at = np.indices(before.shape, np.float32) - moved
    mode = "grid-wrap" if tile else "nearest"
    channels = [
        map_coordinates(colours[..., k], at, order=1, mode=mode) for k in range(colours.shape[2])
    ]
    return np.stack(channels, axis=2)


def deformation(before: Field, after: Field, tile: bool) -> NDArray[np.float32]:
    """Return how far each pixel moves, down and to the right (2, h, w)."""
    padded = bordered(before, 1, tile)
    down = (padded[2:, 1:-1] - padded[:-2, 1:-1]) / 2
    right = (padded[1:-1, 2:] - padded[1:-1, :-2]) / 2
    slope = down**2 + right**2
    known = (np.abs(before) < _NEAR) & (slope > 0.1)
    far = np.where(known, (before - after) / np.where(known, slope, 1), 0)
    far = np.clip(far, -_NEAR, _NEAR).astype(np.float32)
    moved = np.stack([far * down, far * right]).astype(np.float32)
    return _interpolated(moved, known.astype(np.float32), tile)


def _interpolated(values: NDArray[np.float32], known: Field, tile: bool) -> NDArray[np.float32]:
    """Return values (2, h, w) that are right where ``known`` (h, w) is 1, as means elsewhere."""
    mode = "wrap" if tile else "nearest"
    mass = gaussian_filter(known, _SPREAD, mode=mode, truncate=_CUT)
    means = [
        gaussian_filter(one * known, _SPREAD, mode=mode, truncate=_CUT) / np.maximum(mass, _LEAST)
        for one in values
    ]
    filled: NDArray[np.float32] = np.where(known > 0, values, np.stack(means))
    return filled
