"""Pictures in few colours, dithered to show more of these: what they show is taken back.

Ordered dithering (B. Bayer, 1973) and error diffusion (R. Floyd, L. Steinberg, 1976) strew pixels
of one colour among those of another. What one sees there is the mean.
"""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.scanning.averaging import averaged
from iconstudio.algorithms.scanning.resampling import shrunk
from iconstudio.algorithms.tones.regions import nearest

_MOST = 256
"""Colours of a dithered picture."""
_COARSE = 16
"""Every so many rows and columns are looked at first, as most pictures have more."""
_SMALLEST, _LONGEST, _LARGEST = 48, 512, 2048
"""Pixels of the shorter side of a dithered picture, at least: smaller ones may be codes of squares;
of the longer side of one of which more are not averaged, but shrunk; and of this, at most: of more,
each takes too much memory, and dithered ones are small."""
_WIDE = 8
"""Pixels across of an area that is dithered, at least: as many as ordered patterns repeat in."""
_GRAINS, _SHARE, _LEAST = 0.05, 0.03, 400
"""How many of its pixels are grains, at least; how much of a dithered picture, and how many pixels
of it, are such an area."""
_AGAIN, _AROUND = 4, 9
"""How often the colour of a grain is there, itself included, among so many pixels across."""
_OFF = 8.0
"""Levels of a channel by which grains differ from what is beside them, at least."""
_BLUR = 1.2
"""Pixels by which a picture is blurred to tell what is alike in it."""
_APART, _WIDTH, _REACH, _ROUNDS = 25.0, 2.5, 5, 2
"""Levels of what is alike; pixels over which it is averaged, and at most; how often."""


def without_dithering(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return a picture (h, w, 3 or 4) with the means of what is dithered; any other as it is.

    A large one is made smaller.
    """
    shorter, longer = sorted(pixels.shape[:2])
    if not _SMALLEST <= shorter <= longer <= _LARGEST or any(
        len(np.unique(_packed(pixels[::step, ::step]))) > _MOST for step in (_COARSE, 1)
    ):
        return pixels
    area = dithered(pixels)
    if area.sum() < max(_LEAST, _SHARE * area.size):
        return pixels
    step = -(-max(pixels.shape[:2]) // _LONGEST)
    if step > 1:
        pixels = np.rint(shrunk(pixels, step) * 255).astype(np.uint8)
    area = scipy.ndimage.binary_dilation(dithered(pixels), np.ones((3, 3)))
    means = pixels.copy()
    means[area, :3] = np.rint(np.clip(_means(pixels), 0, 255))[area]
    return means


def dithered(pixels: NDArray[np.uint8]) -> NDArray[np.bool_]:
    """Return where (h, w) grains of colours are strewn among others, on a picture (h, w, 3 or 4).

    A grain is lighter than all that is beside it, or darker: the greys of edges lie between. And
    there are more of just its colour near, as there are seldom in fine details.
    """
    levels = pixels[..., :3].astype(np.float32)
    if pixels.shape[2] == 4:
        levels[pixels[..., 3] == 0] = np.nan
    padded = np.pad(levels, [(1, 1), (1, 1), (0, 0)], mode="edge")
    beside = padded[:-2, 1:-1], padded[2:, 1:-1], padded[1:-1, :-2], padded[1:-1, 2:]
    off = np.stack([levels - one for one in beside])
    extreme = np.maximum(off.min(axis=0), -off.max(axis=0))
    grains = _repeated(pixels, (extreme > _OFF).any(axis=2))
    dense = scipy.ndimage.uniform_filter(grains.astype(np.float32), _WIDE) > _GRAINS
    area: NDArray[np.bool_] = scipy.ndimage.binary_opening(dense, np.ones((_WIDE, _WIDE)))
    return area


def _repeated(pixels: NDArray[np.uint8], grains: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return which grains (h, w) have others of the same colour near."""
    height, width = grains.shape
    colours = np.where(grains, _packed(pixels).astype(np.int64), -1)
    around = np.pad(colours, _AROUND // 2, mode="symmetric")
    count = np.zeros(grains.shape, np.uint8)
    for row, column in np.ndindex(_AROUND, _AROUND):
        count += around[row : row + height, column : column + width] == colours
    return grains & (count >= _AGAIN)


def _means(pixels: NDArray[np.uint8]) -> NDArray[np.float32]:
    """Return a picture (h, w, 3) with the mean of what is alike around each pixel.

    What is alike is told first by how the picture looks when it is blurred a little, then by this
    mean itself.
    """
    levels = pixels[..., :3].astype(np.float32)
    if pixels.shape[2] == 4:  # nothing has the colour of what lies nearest
        levels = levels[nearest(pixels[..., 3] > 0)]
    means: NDArray[np.float32] = scipy.ndimage.gaussian_filter(levels, (_BLUR, _BLUR, 0))
    for _ in range(_ROUNDS):
        means = averaged(levels, means, _APART, _WIDTH, _REACH)
    return means


def _packed(pixels: NDArray[np.uint8]) -> NDArray[np.uint32]:
    """Return the colours (h, w) of a picture (h, w, c), each as a number."""
    packed = np.zeros(pixels.shape[:2], np.uint32)
    for channel in range(pixels.shape[2]):  # of large pictures, no copy of all channels
        packed *= np.uint32(256)
        packed += pixels[..., channel]
    return packed
