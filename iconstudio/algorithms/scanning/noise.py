"""What lossy files leave around the edges of a bitmap is taken back: noise, and colours."""

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.scanning.averaging import averaged
from iconstudio.algorithms.scanning.ground import ASTRAY, Ground, ground_of
from iconstudio.algorithms.scanning.palette import evenly_painted
from iconstudio.algorithms.scanning.resampling import premultiplied

LONGEST = 192
"""Pixels of the longer side of a bitmap in which such noise is as wide as what is drawn."""
_FRINGED = 512
"""Pixels of the longer side of a bitmap in which the colours at its edges are as wide."""
_REACH = 3
"""Pixels around that are averaged."""
_YCBCR = np.array([[0.299, 0.587, 0.114], [-0.169, -0.331, 0.5], [0.5, -0.419, -0.081]], np.float32)
"""Luminance and chrominance, by which pixels are compared."""
_LEVELS, _WIDTH, _ROUNDS = 15.0, 1.0, 2
"""Levels of those, and pixels, over which weights fall; and how often pixels are averaged."""
_FAR, _WIDER, _APART = 4, 2.0, (12.0, 40.0, 40.0)
"""The same where colours are made sharp: pixels around, pixels and levels over which weights fall.
"""
_FULL, _NONE = 0.8, 0.1
"""How much of a pixel has the one colour of a drawing at least if it has no other, and at most if
it has none."""
_FARTHEST = 90
"""Percent of the drawing that are nearer to the ground than its one colour."""
_FEW = 0.002
"""How much of a drawing may be evenly painted in other colours, at most, if these are noise."""


def without_noise(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return a bitmap (h, w, 3) from a lossy file without noise; a large one or any other as it is.

    A drawing in one colour has no others at its edges. In a small one, each pixel becomes the mean
    of those around that differ little.
    """
    if pixels.shape[2] == 4 or max(pixels.shape[:2]) > _FRINGED:
        return pixels
    levels = pixels.astype(np.float32)
    blended = premultiplied(levels)
    ground = ground_of(blended)
    if ground is None or ground.mask.all() or not ground.is_lossy(blended):
        return pixels
    if ground.is_clean(blended):
        levels = _without_fringes(levels, ground)
    if max(pixels.shape[:2]) <= LONGEST:
        levels = _smoothed(_with_sharp_colours(levels))
    clean: NDArray[np.uint8] = np.clip(np.rint(levels), 0, 255).astype(np.uint8)
    return clean


def _without_fringes(levels: NDArray[np.float32], ground: Ground) -> NDArray[np.float32]:
    """Return a picture as blends of its ground and one colour, if no other is evenly painted."""
    off = levels - ground.colour[:3]
    away = np.linalg.norm(off, axis=2)
    way = np.median(off[away >= np.percentile(away[~ground.mask], _FARTHEST)], axis=0)
    share = off @ way / max(float(way @ way), 1.0)
    stray = np.linalg.norm(off - share[..., None] * way, axis=2) > ASTRAY
    even = evenly_painted(premultiplied(levels), 3)
    full, part = (even & ~stray & (share > least) for least in (_FULL, _NONE))
    others = even & (stray | (part & ~full))
    if not full.any() or others.sum() > _FEW * (share > _NONE).sum():
        return levels
    share = np.where(full, 1, np.where(even & ~part, 0, share))
    blended: NDArray[np.float32] = ground.colour[:3] + share[..., None] * way
    return blended


def _with_sharp_colours(levels: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return a picture (h, w, 3) whose colours end where its luminance does.

    Lossy files keep colours at half the resolution, so that they bleed. Each pixel's chrominance
    becomes the median of that around where the luminance differs little (J. Kopf et al., *Joint
    bilateral upsampling*, 2007; a mean would carry the bleeding on).
    """
    split = levels @ _YCBCR.T
    y, x = np.mgrid[-_FAR : _FAR + 1, -_FAR : _FAR + 1]
    near = np.exp(-(x**2 + y**2) / (2 * _WIDER**2)).astype(np.float32)
    for _ in range(_ROUNDS):
        padded = np.pad(split, [(_FAR, _FAR), (_FAR, _FAR), (0, 0)], mode="edge")
        around = np.lib.stride_tricks.sliding_window_view(padded, near.shape, axis=(0, 1))
        around = around.reshape(*split.shape, -1)
        apart = sum(((around[..., n, :] - split[..., n, None]) / _APART[n]) ** 2 for n in range(3))
        weights = near.ravel() * np.exp(-apart / 2)
        for channel in (1, 2):
            split[..., channel] = _median(around[..., channel, :], weights)
    sharp: NDArray[np.float32] = split @ np.linalg.inv(_YCBCR).T
    return sharp


def _median(values: NDArray[np.float32], weights: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the weighted medians (h, w) of values (h, w, n)."""
    order = values.argsort(axis=-1)
    below = np.take_along_axis(weights, order, axis=-1).cumsum(axis=-1)
    middle = (below >= below[..., -1:] / 2).argmax(axis=-1)
    at = np.take_along_axis(order, middle[..., None], axis=-1)
    median: NDArray[np.float32] = np.take_along_axis(values, at, axis=-1)[..., 0]
    return median


def _smoothed(levels: NDArray[np.float32]) -> NDArray[np.float32]:
    for _ in range(_ROUNDS):
        levels = averaged(levels, levels @ _YCBCR.T, _LEVELS, _WIDTH, _REACH)
    return levels
