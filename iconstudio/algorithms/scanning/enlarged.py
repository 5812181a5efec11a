"""Small bitmaps that were enlarged softly tell more at the resolution that they had."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import greatest_channel
from iconstudio.algorithms.scanning.free import LARGE
from iconstudio.algorithms.scanning.ground import unevenness
from iconstudio.algorithms.scanning.resampling import premultiplied

_SMALLEST, _SMALL, _SMALLER, _LARGEST = 12, 72, 48, 768
"""Pixels of the shorter side of a bitmap before it was enlarged, at least, and of the longer one,
at most; at most, if it is ``LARGE`` now; and of this now."""
_LEAST = 1.4
"""How many times it was enlarged, at least."""
_LIKELY, _WHOLE = 6, 16
"""How many sizes are tried that it may have had: the likeliest ones, and those of whole factors."""
_PLAIN = 0.1
"""How much of all changes, down and across, has the period of the pixels that it had, at least."""
_LINES = 48
"""Rows and columns that tell which of them it was."""
_EDGE, _OFF, _USUAL, _NOISE = 20.0, 12.0, 95, 1.5
"""Levels by which pixels beside an edge differ; by which these are off, if it is enlarged anew, at
most, but for a few in a hundred; and by which any pixel is so in the median."""
_FOR_EACH, _ABOUT = 4.0, 2.0
"""Levels, for each time that it was enlarged, by which it is off at most: what is sharp is nearly
given by little less; and levels by which two of them differ that are about as near."""
_ROUNDS = 4
"""How often levels beyond black and white, which were cut off, are estimated."""


def at_own_resolution(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return a bitmap (h, w, c) as it was before it was enlarged by any factor; or as it is.

    It is the one that, enlarged again linearly, by cubic curves or by C. Lanczos' kernel, is
    nearest to what is given, and near enough.
    """
    height, width = pixels.shape[:2]
    if max(height, width) > _LARGEST or min(height, width) < _LEAST * _SMALLEST:
        return pixels
    blended = premultiplied(pixels.astype(np.float32))
    edges: NDArray[np.bool_] = np.asarray(unevenness(blended, 3) > _EDGE)
    if not edges.any():
        return pixels
    found = _likeliest(blended, edges)
    if found is None:
        return pixels
    small, off = _before(blended, *found)
    if _usual(off, edges) > _most(blended.shape, small.shape) or np.median(off) > _NOISE:
        return pixels
    alpha = small[..., 3:]
    straight = small[..., :3] * (255 / np.maximum(alpha, 1))
    both = np.concatenate([straight, alpha], axis=2)[..., : pixels.shape[2]]
    own: NDArray[np.uint8] = np.clip(np.rint(both), 0, 255).astype(np.uint8)
    return own


def _likeliest(
    blended: NDArray[np.float32], edges: NDArray[np.bool_]
) -> tuple[NDArray[np.float32], NDArray[np.float32]] | None:
    """Return the matrices that give most nearly the lines with the most edges; None if none do.

    Of those that are about as near, the ones for the smallest picture.
    """
    columns = np.argsort(-edges.sum(axis=0), kind="stable")[:_LINES]
    rows = np.argsort(-edges.sum(axis=1), kind="stable")[:_LINES]
    lines = (
        (blended[:, columns], edges[:, columns]),
        (blended[rows].swapaxes(0, 1), edges[rows].T),
    )
    nearest, best = _OFF, None
    for shape in _sizes(blended):
        for kernel in (_linear, _cubic, _lanczos):
            ways = [
                _enlarging(old, len(some), kernel)
                for old, (some, _) in zip(shape, lines, strict=True)
            ]
            most = min(nearest, _most(blended.shape, shape))
            off = 0.0
            for way, (some, there) in zip(ways, lines, strict=True):
                if off < most and there.any():
                    off = max(off, _usual(_before(some, way)[1], there))
            if off < min(most, nearest - _ABOUT):
                nearest, best = off, (ways[0], ways[1])
    return best


def _sizes(blended: NDArray[np.float32]) -> list[tuple[int, int]]:
    """Return heights and widths that a picture may have had, the smallest first.

    How steep and curved it is changes with the period of the pixels that it had (A. Gallagher,
    *Detection of linear and cubic interpolation in JPEG compressed images*, 2005). What is merely
    blurred has no such period.
    """
    height, width = blended.shape[:2]
    down, across = _rhythm(blended), _rhythm(blended.swapaxes(0, 1))
    longest = max(height, width)
    possible: dict[tuple[int, int], float] = {}
    most = _SMALLER if longest >= LARGE else _SMALL
    for side in range(_SMALLEST, min(most, int(longest / _LEAST)) + 1):
        rows, columns = round(height * side / longest), round(width * side / longest)
        if min(rows, columns) >= _SMALLEST:
            possible[rows, columns] = float(down[rows] + across[columns])
    possible = {shape: plain for shape, plain in possible.items() if plain > _PLAIN}
    likely = sorted(possible, key=lambda shape: -possible[shape])[:_LIKELY]
    whole = [
        (height // times, width // times)
        for times in range(2, _WHOLE + 1)
        if height % times == width % times == 0
    ]
    return sorted({*likely, *possible.keys() & whole})


def _rhythm(blended: NDArray[np.float32]) -> NDArray[np.float64]:
    """Return how much (n,) of the changes from row to row repeats so many times in all."""
    height = len(blended)
    plainest = np.zeros(height)
    for change in (abs(np.diff(blended, 2, axis=0)), np.diff(blended, axis=0) ** 2):
        along = change.sum(axis=(1, 2))
        spectrum = np.abs(np.fft.fft(along * np.hanning(len(along)), height))
        plainest = np.maximum(plainest, spectrum / max(spectrum[0], 1e-6))
    return plainest


def _before(
    blended: NDArray[np.float32],
    down: NDArray[np.float32],
    across: NDArray[np.float32] | None = None,
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Return the picture (m, n, c) that is most nearly given (h, w, c) if it is enlarged.

    It is so by matrices (h, m) and, if its columns are fewer, too, (w, n). Also by how many levels
    each pixel (h, w) is off.
    """
    up = np.linalg.pinv(down)
    left = None if across is None else np.linalg.pinv(across)
    given = blended
    for _ in range(_ROUNDS):
        small = np.clip(_mixed(given, up, left), 0, 255)
        again = _mixed(small, down, across)
        off: NDArray[np.float32] = greatest_channel(abs(np.clip(again, 0, 255) - blended))
        cut = ((blended <= 0) & (again < 0)) | ((blended >= 255) & (again > 255))
        given = np.where(cut, again, blended)
    return small, off


def _most(shape: tuple[int, ...], small: tuple[int, ...]) -> float:
    """Return by how many levels an enlarged picture may be off at edges."""
    return min(_OFF, _FOR_EACH * max(shape) / max(small))


def _usual(off: NDArray[np.float32], edges: NDArray[np.bool_]) -> float:
    return float(np.percentile(off[edges], _USUAL))


def _mixed(
    picture: NDArray[np.float32],
    down: NDArray[np.float32],
    across: NDArray[np.float32] | None,
) -> NDArray[np.float32]:
    """Return a picture (h, w, c) with its columns, and its rows, mixed by matrices (new, old)."""
    mixed: NDArray[np.float32] = np.tensordot(down, picture, 1)
    if across is not None:
        mixed = np.tensordot(across, mixed, (1, 1)).swapaxes(0, 1)
    return mixed


def _enlarging(
    old: int, new: int, kernel: Callable[[NDArray[np.float64]], NDArray[np.float64]]
) -> NDArray[np.float32]:
    """Return the matrix (new, old) that enlarges a line of pixels."""
    at = (np.arange(new) + 0.5) * old / new - 0.5
    weights = kernel(abs(at[:, None] - np.arange(old)))
    matrix: NDArray[np.float32] = (weights / weights.sum(axis=1, keepdims=True)).astype(np.float32)
    return matrix


def _linear(away: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.clip(1 - away, 0, None)


def _cubic(away: NDArray[np.float64]) -> NDArray[np.float64]:
    """R. Keys, *Cubic convolution interpolation for digital image processing*, 1981."""
    near = 1.5 * away**3 - 2.5 * away**2 + 1
    far = -0.5 * away**3 + 2.5 * away**2 - 4 * away + 2
    return np.where(away < 1, near, np.where(away < 2, far, 0))


def _lanczos(away: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.where(away < 3, np.sinc(away) * np.sinc(away / 3), 0)
