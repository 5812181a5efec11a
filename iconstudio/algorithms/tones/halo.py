"""Halos: a glow drawn as several even shapes, one around the other, each paler than the one in it.

One such shape alone is the second tone of a drawing. Around nothing but a disc, they are the
drawing, such as the waves around a point.
"""

import itertools

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter
from iconstudio.algorithms.tones.regions import Mask

_STEP = 6
"""Grey levels of alpha by which a ring and what is around it differ at least."""
_SHARE = 0.02
"""Part of the drawing that a ring makes at least."""
_RING = 5
"""Pixels, of 1024, that a ring is wide at least."""
_DISC, _LEVELS = 0.02, 12
"""By how much a disc may miss one; by how many levels of sRGB its colours may differ."""


def without_halo(rgba: NDArray[np.uint8]) -> NDArray[np.uint8] | None:
    """Return a drawing (n, n, 4), straight alpha, without its halo; None if it has none."""
    alpha = rgba[..., 3]
    counts = np.bincount(alpha.ravel(), minlength=256)
    counts[:_STEP] = 0
    if not counts.any():
        return None
    body = int(np.flatnonzero(counts.cumsum() > 0.99 * counts.sum())[0])
    least = _SHARE * counts.sum()
    levels = [int(one) for one in np.flatnonzero(counts > least) if one <= body - _STEP]
    if len(levels) < 2 or min(np.diff([*levels, body])) < _STEP:  # as nearly always
        return None
    within = [scipy.ndimage.binary_fill_holes(alpha >= level) for level in (*levels, body)]
    wide = 2 * round(_RING * len(alpha) / 1024) + 1
    for outer, inner in itertools.pairwise(within):
        if (maximum_filter(inner, wide) & ~outer).any():
            return None
    if _is_disc(within[-1], rgba):
        return None
    rest = np.clip((alpha.astype(float) - levels[-1]) * (body / (body - levels[-1])), 0, 255)
    return np.dstack([rgba[..., :3], rest.astype(np.uint8)])


def _is_disc(mask: Mask, rgba: NDArray[np.uint8]) -> bool:
    """Whether a mask (n, n) is a disc of one colour, or several such discs."""
    pieces, _ = scipy.ndimage.label(mask)
    for number, (rows, columns) in enumerate(scipy.ndimage.find_objects(pieces), 1):
        piece = pieces[rows, columns] == number
        height, width = piece.shape
        if abs(height / width - 1) > _DISC or abs(piece.mean() / (np.pi / 4) - 1) > _DISC:
            return False
        solid = scipy.ndimage.binary_erosion(piece, iterations=2)
        colours = rgba[rows, columns, :3][solid]
        if colours.size and np.ptp(colours, axis=0).max() > _LEVELS:
            return False
    return True
