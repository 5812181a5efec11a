"""The resolution at which regions are found, and the ways there and back."""

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.tones.regions import Mask

SIDE = 512
"""Pixels to a side at which regions are found."""
SMALLEST = 60
"""Pixels of the smallest detail that reads."""


def reduced(rgba: NDArray[np.uint8]) -> tuple[NDArray[np.uint8], NDArray[np.float32]]:
    """Return the colours and the alpha, 0 to 255, of a drawing on SIDE by SIDE pixels."""
    premultiplied = rgba.astype(np.float32)
    premultiplied[..., :3] *= premultiplied[..., 3:] / 255
    small = averaged(premultiplied)
    alpha = small[..., 3]
    rgb = small[..., :3] * (255 / np.maximum(alpha, 1))[..., None]
    return np.clip(rgb + 0.5, 0, 255).astype(np.uint8), alpha


def averaged(values: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the means (SIDE, SIDE, c) of values (n, n, c)."""
    n = len(values)
    if n % SIDE:
        from skimage.transform import resize_local_mean

        means: NDArray[np.float32] = resize_local_mean(values, (SIDE, SIDE), channel_axis=2)
        return means
    step = n // SIDE
    shifts = [values[row::step, column::step] for row in range(step) for column in range(step)]
    return sum(shifts[1:], shifts[0]) / np.float32(step**2)


def body_alpha(alpha: NDArray[np.float32]) -> float:
    """Return the alpha of a drawing's body: all but its most opaque specks have no more."""
    visible = alpha[alpha > 4]
    return float(np.quantile(visible, 0.95)) if visible.size else 255.0


def repeated(mask: Mask, n: int) -> Mask:
    """Return a mask (SIDE, SIDE) on n by n pixels."""
    at = np.arange(n) * SIDE // n
    return mask[at][:, at]


def enlarged(soft: NDArray[np.float32], n: int) -> NDArray[np.float32]:
    """Return values (SIDE, SIDE) on n by n pixels."""
    from skimage.transform import resize

    return soft if n == len(soft) else resize(soft, (n, n), order=1)
