"""Pixels become the mean of those around that are like them (bilateral filtering)."""

import numpy as np
from numpy.typing import NDArray


def averaged(
    levels: NDArray[np.float32],
    guide: NDArray[np.float32],
    apart: float,
    width: float,
    reach: int,
) -> NDArray[np.float32]:
    """Return a picture (h, w, c) of which each pixel is the mean of those up to ``reach`` away.

    They count less the farther they are, over ``width`` pixels, and the more the ``guide``
    (h, w, d) differs there, over ``apart`` levels (C. Tomasi, R. Manduchi, 1998; G. Petschnigg et
    al., *Digital Photography with Flash and No-Flash Image Pairs*, 2004).
    """
    rows, columns = levels.shape[:2]
    pad = [(reach, reach), (reach, reach), (0, 0)]
    around, guides = np.pad(levels, pad, mode="edge"), np.pad(guide, pad, mode="edge")
    total, weights = np.zeros_like(levels), np.zeros_like(levels[..., :1])
    for y, x in np.ndindex(2 * reach + 1, 2 * reach + 1):
        here = np.s_[y : y + rows, x : x + columns]
        differ = ((guides[here] - guide) ** 2).sum(axis=2, keepdims=True)
        distance = (y - reach) ** 2 + (x - reach) ** 2
        weight = np.exp(-differ / (2 * apart**2) - distance / (2 * width**2))
        total += weight * around[here]
        weights += weight
    mean: NDArray[np.float32] = total / weights
    return mean
