"""What is drawn on a known ground is cut out: its edges become transparent by degrees."""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter
from iconstudio.algorithms.scanning.pieces import pieces_alike

_BLENDS = 2
"""Pixels beside the ground that may blend it, in most files."""
_ALIKE = 6.0
"""Levels by which colours differ that are one."""
_NEAR = 5
"""Pixels across, of where the colour is that they blend with it."""


def cut_out(
    pixels: NDArray[np.uint8],
    ground: NDArray[np.floating],
    mask: NDArray[np.bool_],
    blends: int = _BLENDS,
) -> NDArray[np.uint8]:
    """Return a picture (h, w, 3) with transparency, (h, w, 4), where it shows its ground.

    ``ground`` is (h, w) of greys or (h, w, 3), or a colour (3,); ``mask`` is where it shows. Beside
    it, a pixel blends the ground with what differs from that most near by; as far as ``blends``.
    """
    levels = pixels.astype(np.float32)
    ground = ground[..., None] if ground.ndim == 2 else ground
    ground = np.broadcast_to(ground, levels.shape).astype(np.float32)
    away = np.linalg.norm(levels - ground, axis=2)
    away[mask] = 0
    edge = scipy.ndimage.binary_dilation(mask, np.ones((3, 3)), iterations=blends) & ~mask
    # What goes on beyond is of its own colour.
    number = pieces_alike(levels, ~mask, _ALIKE)
    goes_on = np.zeros(mask.size, bool)
    goes_on[number[~mask & ~edge]] = True
    pure = ~mask & goes_on[number]
    farthest = maximum_filter(np.where(pure, away, 0), 3)
    farthest = np.where(farthest > 0, farthest, maximum_filter(away, _NEAR))
    share = np.where(pure | mask, pure, np.minimum(away / np.maximum(farthest, 1), 1))
    colours = np.where(
        edge[..., None], ground + (levels - ground) / np.maximum(share, 0.1)[..., None], levels
    )
    both = np.concatenate([colours, 255 * share[..., None]], axis=2)
    cut: NDArray[np.uint8] = np.clip(np.rint(both), 0, 255).astype(np.uint8)
    return cut
