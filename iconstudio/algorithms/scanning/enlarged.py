"""Small bitmaps that were enlarged softly tell more at the resolution that they had."""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.scanning.ground import unevenness
from iconstudio.algorithms.scanning.resampling import premultiplied, resized

_TIMES, _SMALL, _LEAST = range(16, 3, -1), 48, 12
"""How many times a bitmap may have been enlarged; pixels of the longer side that it had, at most,
and of the shorter one at least."""
_EDGE, _OFF, _USUAL, _NOISE = 20.0, 16.0, 95, 1.5
"""Levels by which pixels beside an edge differ; by which these are off, if it is enlarged anew, at
most, but for a few in a hundred; and by which any pixel is so in the median."""


def at_own_resolution(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return a bitmap (h, w, c) as it was before it was enlarged by a whole number; or as it is.

    Enlarged again, it is what is given: linearly, or by cubic curves.
    """
    height, width = pixels.shape[:2]
    possible = [
        times
        for times in _TIMES
        if (height % times, width % times) == (0, 0)
        and max(height, width) <= _SMALL * times
        and min(height, width) >= _LEAST * times
    ]
    if not possible:
        return pixels
    blended = premultiplied(pixels.astype(np.float32))
    edges: NDArray[np.bool_] = np.asarray(unevenness(blended, 3) > _EDGE)
    # What is too sharp to have been enlarged a little, was not enlarged much.
    if not edges.any() or not _gives(_centres(blended, possible[-1]), blended, edges):
        return pixels
    for times in possible:
        small = _centres(blended, times)
        if _gives(small, blended, edges):
            alpha = small[..., 3:]
            straight = small[..., :3] * (255 / np.maximum(alpha, 1))
            both = np.concatenate([straight, alpha], axis=2)[..., : pixels.shape[2]]
            own: NDArray[np.uint8] = np.clip(np.rint(both), 0, 255).astype(np.uint8)
            return own
    return pixels


def _centres(blended: NDArray[np.float32], times: int) -> NDArray[np.float32]:
    """Return the middle of every ``times`` x ``times`` pixels."""
    before, after = (times - 1) // 2, times // 2
    rows = blended[before::times] + blended[after::times]
    centres = rows[:, before::times] + rows[:, after::times]
    return (centres / 4).astype(np.float32)


def _gives(
    small: NDArray[np.float32], blended: NDArray[np.float32], edges: NDArray[np.bool_]
) -> bool:
    """Whether a picture is the small one, enlarged."""
    factors = (blended.shape[0] / small.shape[0], blended.shape[1] / small.shape[1], 1)
    linear = scipy.ndimage.zoom(small, factors, order=1, mode="nearest", grid_mode=True)
    for again in (linear, resized(small, blended.shape[:2])):
        off = abs(again - blended).max(axis=2)
        if np.percentile(off[edges], _USUAL) < _OFF and np.median(off) < _NOISE:
            return True
    return False
