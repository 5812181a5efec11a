"""What is missing of an image whose file is cut short becomes paper, not a black or grey slab."""

import numpy as np
from numpy.typing import NDArray

_BLOCK = 16
"""Rows that JPEG decodes at a time: the last of them may be there in part."""
_FEW = 1 / 16
"""Part of the rows that may look as if they were missing, below the edges of a drawing."""
_NEAR = 1 / 8
"""Part of the height of an image that tells, above what is missing, how the paper looks there."""


def completed(pixels: NDArray[np.uint8], upwards: bool) -> NDArray[np.uint8]:
    """Return an image (h, w, c) with paper in place of the rows that were never read.

    Decoders leave them all in one colour. Paper is what most pixels beside them are like.
    ``upwards`` says that the file begins with the lowest row.
    """
    pixels = pixels.copy()
    rows = pixels[::-1] if upwards else pixels
    same = (rows == rows[-1, -1]).all(axis=2)
    read = np.flatnonzero(~same.all(axis=1))
    if not len(read) or read[-1] == len(rows) - 1:
        return pixels
    first = read[-1] + 1
    above = rows[max(0, first - _BLOCK - round(_NEAR * len(rows))) : max(1, first - _BLOCK)]
    paper = np.median(above.reshape(-1, above.shape[2]), axis=0).astype(np.uint8)
    # A row of blocks that ends in the middle.
    for row in range(max(0, first - _BLOCK), first):
        missing = same.shape[1] - 1 - np.max(np.flatnonzero(~same[row]), initial=-1)
        rows[row, same.shape[1] - missing :] = paper
    rows[max(0, first - 1) :] = paper  # one more: made smaller, it is a blend
    return pixels


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
