"""The ground of a bitmap that a computer drew: the even colour all around what is drawn.

It is told before any other colour, from the rim inwards, so that what is nearly as pale as the
ground, or fades into it, is not taken for it.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import greatest_channel, maximum_filter, minimum_filter
from iconstudio.algorithms.scanning.margin import PAPER, corners_of, rim_of
from iconstudio.algorithms.tones.regions import GREY, cielab

CLEAR = 12.0
"""Levels of alpha of what is not there."""
AROUND = 0.97
"""How much of the rim of a bitmap has the colour of the ground, if not all corners have."""
ASTRAY = 28.0
"""Levels by which a pixel of the rim misses the colour of the ground if it is not of it."""
_AT_RIM = 0.3
"""How much of the rim the colour of white paper has, at least."""
_BIN = 16
"""Levels of a channel that are counted as one to find the colour that the rim has most."""
_LEAST, _MOST = 4.0, 12.0
"""Levels by which a channel of the ground strays from its colour: in files that lose nothing, and
at most."""
_USUAL = 95
"""Percent of the rim whose straying tells of the ground's."""
_EXACT, _SAME = 0.9, 2.0
"""How much of what is flat has the very same colour, but for so many levels, in files that lose
nothing."""
_EXACTLY = 0.3
"""How much of what has its colour has just that."""
_FAINT, _PLAIN, _LOSSY = 12.0, 128.0, 0.3
"""Levels by which noise differs from the ground at most, and edges do; how many pixels have noise
in lossy files, for each that has an edge, at least."""
_CLEAN = 5.0
"""Levels by which pixels of a ground that a computer painted stray in the median, at most."""
_TINY = 40
"""Pixels of the longer side of a bitmap in which noise cannot be told from what is drawn."""
_BROAD = 9
"""Pixels across, of what is near an edge."""
_GENTLE, _ALONG, _TINTED = 5.0, 0.9, 0.25
"""Levels by which a gradient changes within three pixels at most; how much of the rim does so, and
how much of it is coloured, at least."""


_GRAIN, _BLOCKS = 0.4, 16
"""Levels by which pixels of paper stray from those around in the median, as no painted ones do; and
pixels beside edges in which lossy files leave noise."""


class Ground(NamedTuple):
    """What is all around a drawing."""

    colour: NDArray[np.float32]
    """(4,): sRGB times alpha, and alpha, from 0 to 255."""
    mask: NDArray[np.bool_]
    """(h, w): where it is, but for what the drawing encloses."""
    around: float
    """How much of the rim has its colour."""

    def is_clean(self, blended: NDArray[np.float32]) -> bool:
        """Whether a computer painted it, and no camera or scanner saw it."""
        return bool(np.median(abs(blended[self.mask] - self.colour).max(axis=1)) < _CLEAN)

    def is_exact(self, blended: NDArray[np.float32]) -> bool:
        """Whether most of it has the very same colour, as lossy files do not keep it."""
        return are_alike(blended[self.mask], self.colour)

    def is_lossy(self, blended: NDArray[np.float32]) -> bool:
        """Whether much of a bitmap is nearly of its colour, as what lossy files leave at edges."""
        if max(blended.shape[:2]) < _TINY:
            return False
        away = greatest_channel(abs(blended - self.colour))
        faint = ((away > 0) & (away <= _FAINT) & (unevenness(blended, 2) > 1)).sum()
        return bool(faint > _LOSSY * ((away > _FAINT) & (away <= _PLAIN)).sum())


def unevenness(levels: NDArray[np.float32], size: int) -> NDArray[np.float32]:
    """Return (h, w) by how much a channel differs within a square of ``size`` pixels, at most."""
    high = maximum_filter(levels, (size, size, 1))
    low = minimum_filter(levels, (size, size, 1))
    most: NDArray[np.float32] = greatest_channel(high - low)
    return most


def sharpness(levels: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return (h, w) how much of what a picture (h, w, c) differs by near by it does at once.

    From 0 to 1: within three pixels, as part of within nine.
    """
    within, near = (unevenness(levels, size) for size in (3, _BROAD))
    sharp = np.divide(within, np.maximum(near, 1e-6), dtype=np.float32)
    return sharp


def has_grain(pixels: NDArray[np.uint8]) -> bool:
    """Whether a camera or a scanner saw a picture (h, w, 3): what has no edges is not even."""
    levels = pixels.astype(np.float32)
    steep = unevenness(levels, 3) > ASTRAY
    plain = ~maximum_filter(steep, 2 * _BLOCKS + 1)
    around = scipy.ndimage.uniform_filter(levels, (3, 3, 1))
    stray = greatest_channel(abs(levels - around))[plain]
    return bool(stray.size and np.median(stray) > _GRAIN)


def is_gradient(pixels: NDArray[np.uint8]) -> bool:
    """Whether what is all around (h, w, 3) is coloured by degrees: no paper, nor a photo."""
    turned = pixels.swapaxes(0, 1)
    bands = (pixels[:3], pixels[-3:], turned[:3], turned[-3:])
    rims = np.concatenate([unevenness(band.astype(np.float32), 3)[1] for band in bands])
    lab = cielab(rim_of(pixels))
    coloured = np.hypot(lab[:, 1], lab[:, 2]) > GREY
    return bool((rims < _GENTLE).mean() > _ALONG and coloured.mean() > _TINTED)


def are_alike(pixels: NDArray[np.float32], colours: NDArray[np.float32]) -> bool:
    """Whether most pixels (n, 4) have the very same colours (n, 4) or (4,), and there are some."""
    return bool(len(pixels) and (abs(pixels - colours).max(axis=1) < _SAME).mean() > _EXACT)


def ground_of(blended: NDArray[np.float32]) -> Ground | None:
    """Return the ground of a bitmap (h, w, 4), of colours times alpha; None if it has none.

    It is what is clear, else the colour of nearly all of the rim, of all corners, or of white paper
    along a part of the rim.
    """
    clear = blended[..., 3] < CLEAR
    if clear.any():
        return Ground(np.zeros(4, np.float32), clear, 1.0)
    rim = rim_of(blended)
    corner = _in_corners(blended)
    for colour, least in _candidates(rim, corner):
        alike = rim[np.linalg.norm(rim - colour, axis=1) < ASTRAY]
        around = len(alike) / len(rim)
        colour = np.median(alike, axis=0)
        noise = np.percentile(abs(alike - colour).max(axis=1), _USUAL)
        # Behind a tile that is nearly as pale, there is more of it.
        behind = [] if corner is None or _differ(corner, colour) else [corner]
        straying = float(np.clip(1.5 * noise, _LEAST, _MOST))
        mask = _reached(blended, np.stack([colour, *behind]), straying)
        if around > least and rim_of(mask).mean() > _EXACTLY * around:
            return Ground(colour, mask, around)
    return None


def _candidates(
    rim: NDArray[np.float32], corner: NDArray[np.float32] | None
) -> Iterator[tuple[NDArray[np.float32], float]]:
    """Yield colours (4,) that may be the ground's, and how much of the rim each must have."""
    bins = (rim // _BIN).astype(np.intp) @ _BIN ** np.arange(4)
    usual = np.median(rim[bins == np.bincount(bins).argmax()], axis=0)
    yield usual, AROUND
    if corner is not None:
        yield corner, 0.0
    white = rim.min(axis=1) > PAPER
    if white.any():
        yield np.median(rim[white], axis=0), _AT_RIM


def _differ(one: NDArray[np.float32], other: NDArray[np.float32]) -> bool:
    return bool(np.linalg.norm(one - other) >= ASTRAY)


def _in_corners(blended: NDArray[np.float32]) -> NDArray[np.float32] | None:
    """Return the colour (4,) of all corners, or None."""
    corners = corners_of(blended)
    colour: NDArray[np.float32] = np.median(corners, axis=0)
    alike = np.linalg.norm(corners - colour, axis=1) < ASTRAY
    return colour if alike.all() else None


def _reached(
    blended: NDArray[np.float32], colours: NDArray[np.float32], straying: float
) -> NDArray[np.bool_]:
    """Return where colours between some (k, 4) are that reach the rim, but for so many levels."""
    low, high = colours.min(axis=0) - straying, colours.max(axis=0) + straying
    pieces, count = scipy.ndimage.label(((blended > low) & (blended < high)).all(axis=2))
    reaching = np.zeros(count + 1, bool)
    reaching[rim_of(pieces)] = True
    reaching[0] = False
    reached: NDArray[np.bool_] = reaching[pieces]
    return reached
