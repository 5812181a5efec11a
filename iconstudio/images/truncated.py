"""What is missing of an image whose file is cut short is not there: no black or grey slab."""

import numpy as np
from numpy.typing import NDArray

_FEW = 1 / 16
"""Part of the rows that may look as if they were missing, below the edges of a drawing."""
_BLENDS = 2
"""Rows that may blend what was read with what was not, where a format or we make them smaller."""


def without_missing(pixels: NDArray[np.uint8], block: int, upwards: bool) -> NDArray[np.uint8]:
    """Return an image (h, w, 3 or 4) as (h, w, 4), transparent where its rows were never read.

    Decoders leave all of those in one colour. It is as it is if there are none.

    Parameters
    ----------
    block
        Rows that are decoded at a time: the last of them may be there in part, and are not shown.
    upwards
        Whether the file begins with the lowest row.
    """
    rows = pixels[::-1] if upwards else pixels
    same = (rows == rows[-1, -1]).all(axis=2)
    read = np.flatnonzero(~same.all(axis=1))
    if not len(read) or read[-1] == len(rows) - 1:
        return pixels
    end = int(read[-1]) + 1
    for _ in range(block):
        end -= bool(end and same[end - 1, -1])
    alpha = np.full_like(rows[..., :1], 255)
    shown = np.concatenate([rows, alpha], axis=2)[..., :4]
    shown[max(0, end - _BLENDS) :] = 0
    return shown[::-1] if upwards else shown


def what_was_read(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return the part of an image that ``without_missing`` left, without transparency if it can."""
    if pixels.shape[2] == 3 or not pixels[..., 3].any():
        return pixels
    there = pixels[..., 3] > 0
    rows, columns = np.flatnonzero(there.any(axis=1)), np.flatnonzero(there.any(axis=0))
    part = pixels[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    return part[..., :3] if (part[..., 3] == 255).all() else part


def coarser(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return every 1st, 2nd, 4th or 8th pixel of an image (h, w) or (h, w, c), each way.

    So many as were read to the end, of a file that gives them in passes, ever finer.
    """
    channels = 1 if pixels.ndim == 2 else pixels.shape[2]
    step = 1
    while step < 8:
        rows = pixels[::step].reshape(-1, pixels.shape[1], channels)
        added, before = rows[1::2], rows[::2][: len(rows) // 2]
        # A row in one colour, other than the one above it, was not read.
        missing = (added == added[:, :1]).all(axis=(1, 2)) & (added != before).any(axis=(1, 2))
        if len(missing) and not missing[-1] and missing.mean() < _FEW:
            break
        step *= 2
    return np.ascontiguousarray(pixels[::step, ::step])
