"""Truncated signed distance fields of an exterior contour (section 3.3)."""

import numpy as np
from numpy.typing import NDArray

from iconstudio.model import CANVAS

D_MAX = 6
"""Distances are clamped to [-D_MAX, D_MAX] pixels of the canvas."""


def tsdf(
    filled: NDArray[np.bool_], d_max: int = D_MAX, outside_only: bool = False
) -> NDArray[np.float32]:
    """Return the normalised truncated signed distance field of a filled shape.

    Positive outside, negative inside: the Euclidean distance in pixels to the nearest pixel of the
    other side, clamped to ``d_max`` and divided by m = CANVAS.

    Parameters
    ----------
    filled
        (..., h, w) bool, the solid shape; beyond its borders nothing is known, so a contour lies
        only between pixels of the picture.
    """
    return distances(squared_distances(filled, d_max, outside_only))


def distances(squared: NDArray[np.signedinteger]) -> NDArray[np.float32]:
    """Return the TSDF of which ``squared`` are the signed squares, in pixels (any shape)."""
    signed = squared.astype(np.float32)
    pixels: NDArray[np.float32] = np.copysign(np.sqrt(np.abs(signed)), signed)
    return pixels / np.float32(CANVAS)


def squared_distances(
    filled: NDArray[np.bool_], d_max: int = D_MAX, outside_only: bool = False
) -> NDArray[np.int8 | np.int16]:
    """Return the TSDF of ``filled`` (..., h, w) in a quarter of the room, or half of it.

    Each value is the square of the distance in pixels, negative inside: int8 up to a ``d_max`` of
    11, else int16, up to 15.

    Notes
    -----
    Only distances up to ``d_max`` are wanted, so a full distance transform would be waste: a row
    pass and a column pass over 2 d_max + 1 offsets in small integers are exact.

    Examples
    --------
    >>> squared_distances(np.array([[False, False, False, True, True]]))
    array([[ 9,  4,  1, -1, -4]], dtype=int8)
    """
    small = np.int8 if d_max <= 11 else np.int16
    outside = _squared_distance(filled, d_max)
    if outside_only:
        return outside.astype(small)
    inside = _squared_distance(~filled, d_max)
    # One of the two is 0 everywhere.
    signed: NDArray[np.int8 | np.int16] = outside.astype(small) - inside.astype(small)
    return signed


def _squared_distance(target: NDArray[np.bool_], reach: int) -> NDArray[np.uint8]:
    """Squared distance from every pixel to the nearest True one, at most ``reach ** 2``."""
    limit = reach * reach
    across = np.where(target, np.uint8(0), np.uint8(limit))
    row = across.copy()
    for k in range(1, reach):
        square = np.uint8(k * k)
        near = np.where(target, square, np.uint8(limit))
        np.minimum(row[..., k:], near[..., :-k], out=row[..., k:])
        np.minimum(row[..., :-k], near[..., k:], out=row[..., :-k])
    out = row.copy()
    for k in range(1, reach):
        near = np.minimum(row, limit - k * k) + np.uint8(k * k)
        np.minimum(out[..., k:, :], near[..., :-k, :], out=out[..., k:, :])
        np.minimum(out[..., :-k, :], near[..., k:, :], out=out[..., :-k, :])
    return out
