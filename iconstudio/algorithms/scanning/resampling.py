"""Bitmaps at other resolutions."""

import numpy as np
import scipy
from numpy.typing import NDArray

_FINER = 8
"""Pixels to a side into which one is divided to reconstruct a shape."""
COARSE = 6
"""How many times a bitmap must be enlarged for that to be worth while."""
_ROUNDS, _STEEP, _SMOOTH = 3, 3.0, 0.2
"""How often it is corrected, how steep its edges are, per pixel of the bitmap, and how many of its
pixels contours are smoothed by."""
_JAGGED = 0.6
"""By how many pixels contours are smoothed where there are no greys; lines of one pixel stay."""
_GREY, _FEW = 0.4, 0.1
"""How far from half of 1 greys are at most, and what part of the pixels at edges is few."""


def shrunk(pixels: NDArray[np.uint8], step: int) -> NDArray[np.float32]:
    """Return means of ``step`` x ``step`` pixels, from 0 to 1; colours weighted by their alpha."""
    height, width, channels = pixels.shape
    pad = [(0, -height % step), (0, -width % step), (0, 0)]
    padded = np.pad(pixels, pad, mode="edge") if step > 1 else pixels
    rows, columns = padded.shape[0] // step, padded.shape[1] // step
    blocks = padded.reshape(rows, step, columns, step, channels)
    if channels == 3 or step == 1:
        means: NDArray[np.float32] = blocks.mean(axis=(1, 3), dtype=np.float32)
        return means / np.float32(255)
    alpha = blocks[..., 3:].astype(np.float32)
    total = alpha.sum(axis=(1, 3))
    colours = (blocks[..., :3] * alpha).sum(axis=(1, 3)) / np.maximum(total, 1)
    return np.concatenate([colours, total / step**2], axis=2, dtype=np.float32) / np.float32(255)


def reconstructed(coverage: NDArray[np.float32], shape: tuple[int, ...]) -> NDArray[np.float32]:
    """Return (h, w) how much of each pixel a shape covers, at a much higher resolution.

    At half of 1 runs a smooth contour whose shape covers as much of each of the given pixels as is
    given: what differs is added again and again (M. Irani, S. Peleg, Improving resolution by image
    registration, 1991: back-projection). So strokes of a pixel keep their width, and are whole.
    """
    height, width = coverage.shape
    if shape[0] < COARSE * height:
        return resized(coverage, shape)
    fine = height * _FINER, width * _FINER
    found = resized(coverage, fine)
    if _is_jagged(coverage):
        found = scipy.ndimage.gaussian_filter(found, _JAGGED * _FINER)
        return resized(np.clip(found, 0, 1), shape)
    for _ in range(_ROUNDS):
        sharp = np.clip(0.5 + (found - 0.5) * _STEEP, 0, 1)
        covered = sharp.reshape(height, _FINER, width, _FINER).mean(axis=(1, 3))
        found = found + resized(coverage - covered, fine)
        found = scipy.ndimage.gaussian_filter(found, _SMOOTH * _FINER)
    return resized(np.clip(found, 0, 1), shape)


def _is_jagged(coverage: NDArray[np.float32]) -> bool:
    """Whether the edges of a shape have no greys, which tell where within a pixel they run."""
    high = scipy.ndimage.maximum_filter(coverage, 3)
    low = scipy.ndimage.minimum_filter(coverage, 3)
    edge = high - low > 0.5
    grey = edge & (abs(coverage - 0.5) < _GREY)
    return bool(grey.sum() < _FEW * edge.sum())


def resized(values: NDArray[np.float32], shape: tuple[int, ...]) -> NDArray[np.float32]:
    """Return (h, w) or (h, w, c) values at another resolution: smooth, without overshooting."""
    from skimage.transform import resize

    if values.shape[:2] == tuple(shape):
        return values
    smaller = shape[0] < values.shape[0]
    resized: NDArray[np.float32] = resize(
        values, shape, order=1 if smaller else 3, mode="edge", anti_aliasing=smaller, clip=True
    ).astype(np.float32)
    return resized


def premultiplied(pixels: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return colours (h, w, 3 or 4), of levels up to 255, times alpha, and alpha: (h, w, 4)."""
    alpha = pixels[..., 3:] if pixels.shape[2] == 4 else np.full_like(pixels[..., :1], 255)
    return np.concatenate([pixels[..., :3] * (alpha / 255), alpha], axis=2)
