"""The ground of a bitmap that a computer drew: the even colour all around what is drawn.

It is told before any other colour, from the rim inwards, so that what is nearly as pale as the
ground, or fades into it, is not taken for it.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.scanning.margin import PAPER, rim_of

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

_EXACTLY = 0.3
"""How much of what has its colour has just that."""


class Ground(NamedTuple):
    """What is all around a drawing."""

    colour: NDArray[np.float32]
    """(4,): sRGB times alpha, and alpha, from 0 to 255."""
    mask: NDArray[np.bool_]
    """(h, w): where it is, but for what the drawing encloses."""
    around: float
    """How much of the rim has its colour."""


def ground_of(blended: NDArray[np.float32]) -> Ground | None:
    """Return the ground of a bitmap (h, w, 4), of colours times alpha; None if it has none.

    It is what is clear, else the colour of nearly all of the rim, of all corners, or of white paper
    along a part of the rim.
    """
    clear = blended[..., 3] < CLEAR
    if clear.any():
        return Ground(np.zeros(4, np.float32), clear, 1.0)
    rim = rim_of(blended)
    for colour, least in _candidates(blended, rim):
        alike = rim[np.linalg.norm(rim - colour, axis=1) < ASTRAY]
        around = len(alike) / len(rim)
        colour = np.median(alike, axis=0)
        noise = np.percentile(abs(alike - colour).max(axis=1), _USUAL)
        mask = _reached(blended, colour, float(np.clip(1.5 * noise, _LEAST, _MOST)))
        if around > least and rim_of(mask).mean() > _EXACTLY * around:
            return Ground(colour, mask, around)
    return None


def _candidates(
    blended: NDArray[np.float32], rim: NDArray[np.float32]
) -> Iterator[tuple[NDArray[np.float32], float]]:
    """Yield colours (4,) that may be the ground's, and how much of the rim each must have."""
    bins = (rim // _BIN).astype(np.intp) @ _BIN ** np.arange(4)
    usual = np.median(rim[bins == np.bincount(bins).argmax()], axis=0)
    yield usual, AROUND
    corners = blended[[0, 0, -1, -1], [0, -1, 0, -1]]
    if (np.linalg.norm(corners - np.median(corners, axis=0), axis=1) < ASTRAY).all():
        yield corners[0], 0.0
    white = rim.min(axis=1) > PAPER
    if white.any():
        yield np.median(rim[white], axis=0), _AT_RIM


def _reached(
    blended: NDArray[np.float32], colour: NDArray[np.float32], straying: float
) -> NDArray[np.bool_]:
    """Return where a colour is that reaches the rim, if its levels stray by so many."""
    pieces, count = scipy.ndimage.label(abs(blended - colour).max(axis=2) < straying)
    reaching = np.zeros(count + 1, bool)
    reaching[rim_of(pieces)] = True
    reaching[0] = False
    reached: NDArray[np.bool_] = reaching[pieces]
    return reached
