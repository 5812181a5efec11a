"""Lines that are too thin for the pixels in which a layer is synthesised, made thick enough."""

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage
from skimage.morphology import skeletonize

from iconstudio.algorithms.patterns.elements import EIGHT

Mask = NDArray[np.float32]

_LONG = 3.0
"""How many times as long as wide a line is: corners and dots are no lines."""


def thickened(mask: Mask, width: float) -> Mask:
    """Return a mask (h, w) whose lines are so many pixels wide, at least; nothing else changes."""
    ink = mask > 0.5
    if width < 2 or not ink.any():
        return mask
    depth = ndimage.distance_transform_edt(np.pad(ink, 1, mode="edge"))[1:-1, 1:-1]
    wide = ndimage.distance_transform_edt(depth < width / 2) <= width / 2
    lines, count = ndimage.label(skeletonize(ink) & ~wide, EIGHT)
    long = np.bincount(lines.ravel(), minlength=count + 1) >= _LONG * width
    long[0] = False
    if not long.any():
        return mask
    thick = ndimage.distance_transform_edt(~long[lines]) <= (width - 1) / 2
    return np.where(thick, np.float32(1), mask)
