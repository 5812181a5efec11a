"""The soft shadow that the tile of an app icon casts on its ground, however wide and even."""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter
from iconstudio.algorithms.scanning.ground import ASTRAY, Ground, unevenness
from iconstudio.algorithms.scanning.margin import box_of
from iconstudio.algorithms.tones.regions import Mask

_GENTLE = 48.0
"""Levels by which a soft shadow differs within three pixels at most."""
_SEEN, _LEAST, _WIDE = 8.0, 0.02, 5
"""Levels from which a shadow is seen, how large what is seen of it is at least, and what else is
drawn at most, as part of the tile; how many pixels wide it is: noise of lossy files is slimmer."""
_FADES, _NEARLY = 0.9, 16.0
"""How much of where a shadow meets its ground is nearly of its colour, and by how many levels."""
_CUT, _CUT_SIDES = 3, 2
"""Pixels within a bounding box that are its sides; on how many of these a shadow is cut off."""
_SHAPE = (0.86, 1.01)
"""How much of its bounding box a rounded square fills; a disc fills less."""
_OBLONG = 1.25
"""How many times as long as wide a tile is at most."""
_LARGE = 0.12
"""How much of a picture a tile fills at least."""
_EDGED = 0.9
"""How much of the contour of a tile stands out from its shadow."""


def shadow_of_tile(
    levels: NDArray[np.float32], dark: Mask, away: NDArray[np.float32], ground: Ground
) -> Mask | None:
    """Return where a tile casts its shadow, of what is ``dark``, (h, w); None if there is no tile.

    ``levels`` are (h, w, 3), from 0 to 255, and ``away`` (h, w) from the colour of the ground.
    """
    change = unevenness(levels, 3)
    gentle = dark & (change < _GENTLE)
    outside = scipy.ndimage.binary_propagation(ground.mask, mask=ground.mask | gentle)
    shadow = outside & ~ground.mask
    body = scipy.ndimage.binary_opening(~outside, np.ones((3, 3)), iterations=2)
    pieces, count = scipy.ndimage.label(scipy.ndimage.binary_fill_holes(body))
    if not count:
        return None
    tile = pieces == 1 + int(np.argmax(np.bincount(pieces.ravel())[1:]))
    seen = scipy.ndimage.binary_opening(shadow & (away > _SEEN), np.ones((_WIDE, _WIDE)))
    least = _LEAST * tile.sum()
    if not _is_tile(tile) or seen.sum() < least or (body & ~tile).sum() > least:
        return None
    meets = scipy.ndimage.binary_dilation(ground.mask, np.ones((3, 3))) & shadow
    if not _fades(meets, away < _NEARLY, ~ground.mask):
        return None
    contour = tile & ~scipy.ndimage.binary_erosion(tile, np.ones((3, 3)), iterations=2)
    sharp = maximum_filter(change, 5)[contour] > ASTRAY
    return ~tile & ~ground.mask if sharp.mean() > _EDGED else None


def _fades(edge: Mask, near: Mask, drawn: Mask) -> bool:
    """Whether the edge of a shadow is ``near`` its ground, but for where filters cut it off.

    They do so on a side or two of the bounding box of all that is ``drawn``.
    """
    box = box_of(drawn)
    if box is None:
        return False
    rows, columns = box
    cut = 0
    rest = edge.copy()
    for side in (
        np.s_[rows.start : rows.start + _CUT, :],
        np.s_[rows.stop - _CUT : rows.stop, :],
        np.s_[:, columns.start : columns.start + _CUT],
        np.s_[:, columns.stop - _CUT : columns.stop],
    ):
        if edge[side].any() and near[side][edge[side]].mean() < _FADES:
            rest[side] = False
            cut += 1
    return bool(cut <= _CUT_SIDES and rest.any() and near[rest].mean() >= _FADES)


def _is_tile(shape: Mask) -> bool:
    """Whether a shape is a large rounded square, or nearly one."""
    box = box_of(shape)
    if box is None or shape.mean() < _LARGE:
        return False
    height, width = shape[box].shape
    fills = _SHAPE[0] < shape[box].mean() < _SHAPE[1]
    return bool(fills and max(height, width) < _OBLONG * min(height, width))
