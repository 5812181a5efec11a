"""What is dark along an edge of a scan is no drawing: an open lid, or the gutter of a book.

It may be hard or soft, slanted or torn: all along much of a side it is darker than the paper
farther in, from the very edge of the picture on, and not far into it. A sheet on a desk is another
matter (``sheet``): there is more of that, and on more sides.
"""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.scanning.ground import unevenness
from iconstudio.algorithms.tones.regions import Mask

_FAR, _FARTHER = 0.16, 0.24
"""How far in it reaches at most, and how far the paper is that it is compared with, as part of the
picture's width or height."""
_DARK, _PAPER = 0.6, 0.92
"""How bright its outermost pixels are at most, and where it ends, as part of that paper."""
_ALONG = 0.35
"""How much of a side it takes at least."""
_SIDES = 2
"""On how many sides it lies, at most."""
_BRIGHT = 0.45
"""How bright paper is."""
_BLUR, _SMOOTH = 1.0, 12.0
"""Pixels over which grain is averaged, and, along a side, how bright the paper is."""
_EVEN, _PAINTED = 1.0 / 255, 0.4
"""Within so many levels over five pixels what a computer painted is even, and how much of it is."""
_FEWEST = 100
"""Pixels of the shorter side of a scan, at least."""
_BESIDE = 2
"""Pixels that it is grown by."""


def dark_edge(picture: NDArray[np.float32]) -> Mask | None:
    """Return (h, w) what is dark along edges of a scan, (h, w, 3) in sRGB from 0 to 1; or None."""
    if min(picture.shape[:2]) < _FEWEST:
        return None
    light = scipy.ndimage.gaussian_filter(picture.mean(axis=2), _BLUR, mode="nearest")
    found = np.zeros(light.shape, bool)
    sides = 0
    # Each side is looked at as the left one.
    for turned, seen in (
        (light, found),
        (light[:, ::-1], found[:, ::-1]),
        (light.T, found.T),
        (light.T[:, ::-1], found.T[:, ::-1]),
    ):
        dark = _on_the_left(turned)
        if dark is not None:
            seen[:, : dark.shape[1]] |= dark
            sides += 1
    if not 0 < sides <= _SIDES or (unevenness(picture, 5) < _EVEN).mean() > _PAINTED:
        return None
    # Where two of them meet, each goes far into the other.
    corners = np.zeros(light.shape, bool)
    high, wide = (round(_FAR * side) for side in light.shape)
    for rows in (slice(high), slice(-high, None)):
        for columns in (slice(wide), slice(-wide, None)):
            corners[rows, columns] = True
    corners &= light < _PAPER * np.median(light)
    found = scipy.ndimage.binary_propagation(found, mask=found | corners)
    grown: Mask = scipy.ndimage.binary_dilation(found, iterations=_BESIDE)
    return grown


def _on_the_left(light: NDArray[np.float32]) -> Mask | None:
    """Return (h, n) what is dark in the first columns of a picture (h, w); None if little is."""
    far, farther = (round(part * light.shape[1]) for part in (_FAR, _FARTHER))
    paper = scipy.ndimage.gaussian_filter1d(light[:, far:farther].max(axis=1), _SMOOTH)
    darker = light[:, : far + 1] < _PAPER * paper[:, None]
    run = np.logical_and.accumulate(darker, axis=1)
    edge = (light[:, 0] < _DARK * paper) & ~run[:, -1]
    if edge.mean() < _ALONG or np.median(paper) < _BRIGHT:
        return None
    dark: Mask = run & ~run[:, -1:]
    return dark
