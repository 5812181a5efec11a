"""Seams: hair gaps between shapes of different colours, which are to touch.

Programs that trace bitmaps cut shapes out of each other and draw each contour anew, so that
neighbours miss each other by a hair. What shows between them is nothing that anybody drew: each
side goes on to the middle. A slit in what has one colour is a part of the drawing.
"""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import greatest_channel, maximum_filter, minimum_filter
from iconstudio.algorithms.tones.regions import Mask

_WIDEST, _WIDE = 0.012, 0.008
"""Width of a seam at its widest, and on average, as part of the picture's."""
_LONG = 3.0
"""How much longer than wide a seam is; what is shorter is the end of a line beside another."""
_OPAQUE = 0.7
"""How opaque shapes are beside a seam, as part of the drawing's body; edges that abut are 0.75."""
_APART = 24
"""Levels of sRGB by which two shapes beside a seam differ, and more."""


def without_seams(rgba: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return a drawing (n, n, 4), straight alpha, whose seams are closed; itself if it has none."""
    alpha = rgba[..., 3]
    if not alpha.any():
        return rgba
    body = np.quantile(alpha[alpha > 0], 0.95)
    solid = alpha >= _OPAQUE * body
    if np.ptp(rgba[solid, :3], axis=0).max() <= _APART:
        return rgba
    reach = max(round(_WIDEST * len(rgba) / 2), 1)
    size = 2 * reach + 1
    narrow = minimum_filter(maximum_filter(solid, size), size) & ~solid
    pieces, _ = scipy.ndimage.label(narrow, np.ones((3, 3)))
    closed = rgba
    for number, piece in enumerate(scipy.ndimage.find_objects(pieces), 1):
        window = tuple(slice(max(one.start - size, 0), one.stop + size) for one in piece)
        here, colours = pieces[window] == number, rgba[window]
        if not _is_between(colours[..., :3], solid[window], here, size).any():  # as most corners
            continue
        seams, filled = _seams(colours, solid[window], here, reach)
        if seams.any():
            closed = rgba.copy() if closed is rgba else closed
            closed[window][seams] = filled[seams]
            closed[window][seams, 3] = body
    return closed


def _seams(
    rgba: NDArray[np.uint8], solid: Mask, narrow: Mask, reach: int
) -> tuple[Mask, NDArray[np.uint8]]:
    """Return the seams among what is narrow, and the colours (h, w, 4) of what is next."""
    away, at = scipy.ndimage.distance_transform_edt(~solid, return_indices=True)
    filled = rgba[tuple(at)]
    gap = narrow & (scipy.ndimage.distance_transform_edt(away <= reach) > reach)
    gap &= _is_between(rgba[..., :3], solid & maximum_filter(gap, 3), gap, 2 * reach + 1)
    parts, count = scipy.ndimage.label(gap, np.ones((3, 3)))
    # Across a gap of width w, the mean distance from its sides is w / 4.
    numbers = np.arange(1, count + 1)
    widths = np.maximum(4 * scipy.ndimage.mean(away - 0.5, parts, numbers), 1)
    areas = np.bincount(parts.ravel(), minlength=count + 1)[1:]
    thin = (widths < 2 * reach * _WIDE / _WIDEST) & (areas > _LONG * widths**2)
    return np.isin(parts, numbers[thin]), filled


def _is_between(rgb: NDArray[np.uint8], of: Mask, gap: Mask, size: int) -> Mask:
    """Return where in a gap colours that differ, of what is ``of`` interest, are near."""
    window = size, size, 1
    most = maximum_filter(np.where(of[..., None], rgb, 0), window)
    least = minimum_filter(np.where(of[..., None], rgb, 255), window)
    apart = np.where(most > least, most - least, 0)
    between: Mask = gap & (greatest_channel(apart) > _APART)
    return between
