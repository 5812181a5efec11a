"""Small bitmaps with the greys of edges that were enlarged sharply, each pixel to a square."""

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import greatest_channel
from iconstudio.algorithms.scanning.resampling import premultiplied

_SMALLEST = 8
"""Pixels of the shorter side of a bitmap before it was enlarged, at least."""
_EDGE, _OFF, _BETWEEN = 40.0, 10.0, 0.05
"""Levels by which pixels on both sides of an edge differ, at least; by which a grey between them
is off what they blend to, at most; and how much of each it has, at least."""
_OWN, _LEAST, _TWO = 0.75, 0.08, 2
"""How many of the pixels of a colour are greys, at least, if it is that of greys alone; and how
much of all edges has such greys, if there are more than so many other colours. In hard-edged pixel
art colours serve elsewhere, too."""


def unrepeated(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return a bitmap (h, w, c) with greys of edges as it was before its pixels became squares.

    Anything else is as it is: so are hard-edged pixel art and squares, whose corners are meant.
    """
    rows, columns = _changes(pixels), _changes(pixels.swapaxes(0, 1))
    times = int(np.gcd.reduce(np.concatenate([np.diff(rows), np.diff(columns)]), initial=0))
    if times < 2:
        return pixels
    down, across = (
        _firsts(changes, times, side)
        for changes, side in zip((rows, columns), pixels.shape[:2], strict=True)
    )
    small = pixels[down[:, None], across]
    return small if min(small.shape[:2]) >= _SMALLEST and _has_greys(small) else pixels


def _changes(pixels: NDArray[np.uint8]) -> NDArray[np.intp]:
    """Return the rows that are not as the ones above."""
    return np.flatnonzero((pixels[1:] != pixels[:-1]).any(axis=(1, 2))) + 1


def _firsts(changes: NDArray[np.intp], times: int, side: int) -> NDArray[np.intp]:
    """Return the first row of each square; where a picture was cropped, one is cut off."""
    start = int(changes[0]) % times if len(changes) else 0
    firsts = np.arange(start, side, times)
    return np.concatenate([[0], firsts]) if start else firsts


def _has_greys(pixels: NDArray[np.uint8]) -> bool:
    blended = premultiplied(pixels.astype(np.float32))
    grey = _between(blended) | _between(blended.swapaxes(0, 1)).T
    colours, colour, count = np.unique(
        pixels.reshape(-1, pixels.shape[2]), axis=0, return_inverse=True, return_counts=True
    )
    greys = np.bincount(colour.ravel(), grey.ravel(), len(colours))
    alone = greys >= _OWN * count
    own = grey & alone[colour.reshape(grey.shape)]
    if (~alone).sum() <= _TWO:
        return bool(own.any())
    hard = _hard_edges(blended, grey) + _hard_edges(blended.swapaxes(0, 1), grey.T)
    return bool(own.sum() > _LEAST * (own.sum() + hard))


def _between(blended: NDArray[np.float32]) -> NDArray[np.bool_]:
    """Return which pixels (h, w) are what those above and below blend to, across an edge."""
    above, here, below = blended[:-2], blended[1:-1], blended[2:]
    step = below - above
    part = ((here - above) * step).sum(axis=2) / np.maximum((step**2).sum(axis=2), 1)
    off = greatest_channel(abs(here - above - part[..., None] * step))
    blends = (part > _BETWEEN) & (part < 1 - _BETWEEN) & (off < _OFF)
    return np.pad(blends & (greatest_channel(abs(step)) > _EDGE), [(1, 1), (0, 0)])


def _hard_edges(blended: NDArray[np.float32], grey: NDArray[np.bool_]) -> int:
    """Return how often pixels one below the other differ, and neither is a grey."""
    differs = greatest_channel(abs(np.diff(blended, axis=0))) > _EDGE
    return int((differs & ~grey[1:] & ~grey[:-1]).sum())
