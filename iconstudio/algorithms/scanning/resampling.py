"""Bitmaps at other resolutions."""

import numpy as np
from numpy.typing import NDArray


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
