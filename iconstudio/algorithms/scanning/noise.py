"""What lossy files leave around the edges of a small bitmap is smoothed away."""

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.scanning.ground import ground_of
from iconstudio.algorithms.scanning.resampling import premultiplied

LONGEST = 192
"""Pixels of the longer side of a bitmap in which such noise is as wide as what is drawn."""
_REACH = 3
"""Pixels around that are averaged."""
_YCBCR = np.array([[0.299, 0.587, 0.114], [-0.169, -0.331, 0.5], [0.5, -0.419, -0.081]], np.float32)
"""Luminance and chrominance, by which pixels are compared."""
_LEVELS, _WIDTH, _ROUNDS = 15.0, 1.0, 2
"""Levels of those, and pixels, over which weights fall; and how often pixels are averaged."""


def without_noise(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return a small bitmap (h, w, 3) from a lossy file without noise; any other as it is.

    Each pixel becomes the mean of those around that differ little (C. Tomasi, R. Manduchi, 1998).
    """
    if pixels.shape[2] == 4 or max(pixels.shape[:2]) > LONGEST:
        return pixels
    height, width = pixels.shape[:2]
    levels = pixels.astype(np.float32)
    ground = ground_of(premultiplied(levels))
    if ground is None or not ground.is_lossy(premultiplied(levels)):
        return pixels
    for _ in range(_ROUNDS):
        around = np.pad(levels, [(_REACH, _REACH), (_REACH, _REACH), (0, 0)], mode="edge")
        total, weights = np.zeros_like(levels), np.zeros_like(levels[..., :1])
        for y, x in np.ndindex(2 * _REACH + 1, 2 * _REACH + 1):
            other = around[y : y + height, x : x + width]
            apart = (((other - levels) @ _YCBCR.T) ** 2).sum(axis=2, keepdims=True)
            distance = (y - _REACH) ** 2 + (x - _REACH) ** 2
            weight = np.exp(-apart / (2 * _LEVELS**2) - distance / (2 * _WIDTH**2))
            total += weight * other
            weights += weight
        levels = total / weights
    smooth: NDArray[np.uint8] = np.clip(np.rint(levels), 0, 255).astype(np.uint8)
    return smooth
