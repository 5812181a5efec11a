"""Colours that move along with a zero level set (section 2; Lee et al. 1995).

Near the contour a pixel moves as far as the contour did; farther away, the deformation is
interpolated, from coarse to fine, as by multilevel free-form deformation.
"""

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import map_coordinates, zoom

from iconstudio.algorithms.patterns.distance import bordered
from iconstudio.algorithms.patterns.exemplar import Colours

Field = NDArray[np.float32]

_NEAR = 1.5
"""Pixels from the contour within which its own motion is known."""


def warped(colours: Colours, before: Field, after: Field, tile: bool) -> Colours:
    """Return colours (h, w, 3) moved as the zero level set of a distance function did.

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
    return _interpolated(
        np.stack([far * down, far * right]).astype(np.float32), known.astype(np.float32)
    )


def _interpolated(values: NDArray[np.float32], weight: Field) -> NDArray[np.float32]:
    """Fill in values (2, h, w) where their weight (h, w) is 0, from ever coarser means."""
    height, width = weight.shape
    if weight.all() or max(height, width) < 2:
        return values
    sums, mass = _halved(values * weight), _halved(weight[None])
    coarse_weight = np.minimum(mass[0], 1)
    coarse = _interpolated((sums / np.maximum(mass, 1e-6)).astype(np.float32), coarse_weight)
    scale = (1, height / coarse.shape[1], width / coarse.shape[2])
    filled = zoom(coarse, scale, order=1, mode="nearest", grid_mode=True)
    return np.where(weight > 0, values, filled[:, :height, :width]).astype(np.float32)


def _halved(values: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the sums over squares of 2 x 2 (..., h, w)."""
    more = [(0, 0)] * (values.ndim - 2) + [(0, values.shape[-2] % 2), (0, values.shape[-1] % 2)]
    even = np.pad(values, more)
    return even[..., ::2, ::2] + even[..., 1::2, ::2] + even[..., ::2, 1::2] + even[..., 1::2, 1::2]
