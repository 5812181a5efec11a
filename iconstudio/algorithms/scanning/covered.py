"""What lies on a sheet and is no drawing is covered with the paper around it."""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.tones.regions import Mask, nearest

_SOFT = 3.0
"""Pixels over which the paper that covers something is averaged."""


def covered(
    pixels: NDArray[np.uint8], picture: NDArray[np.float32], over: Mask
) -> NDArray[np.uint8]:
    """Return a picture (h, w, 3) with paper over a mask.

    The mask (m, n) is of the same picture (m, n, 3) with fewer pixels, in sRGB from 0 to 1.
    """
    paper = picture[nearest(~over)]
    soft = [scipy.ndimage.gaussian_filter(channel, _SOFT) for channel in np.moveaxis(paper, 2, 0)]
    levels = np.rint(np.stack(soft, axis=2) * 255).astype(np.uint8)
    rows, columns = (
        np.arange(side) * small // side
        for side, small in zip(pixels.shape[:2], over.shape, strict=True)
    )
    at = np.ix_(rows, columns)
    bare: NDArray[np.uint8] = np.where(over[at][..., None], levels[at], pixels)
    return bare
