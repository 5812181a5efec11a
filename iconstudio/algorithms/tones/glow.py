"""Glows: what shines around a drawing, and fades into nothing all around it.

A glow is a region whose contour is soft nearly all along, and around all of the rest, which has
edges and another colour. What is soft by itself, as a cloud of steam, is none, nor is a drawing
that fades at one end.
"""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter, minimum_filter
from iconstudio.algorithms.tones.regions import Mask, cielab, hull, near_white, regions
from iconstudio.algorithms.tones.separation import blend

_SOFT = 0.4
"""By how much of the body's opacity alpha differs within five pixels of a soft contour, at most."""
_LEAST, _NEARLY = 0.3, 0.85
"""How much of a contour is soft if there may be a glow, and how much of that of a glow is."""
_CONTRAST, _SMALLEST = 8.0, 60
"""How much a glow and what shines differ (CIEDE2000), and pixels of the smallest part of that."""
_VISIBLE = 0.1
"""Opacity, as part of the body's, from which a glow is to be seen."""
_SHARE, _WITHIN = 0.03, 0.8
"""How much of the drawing shines, at least, and how much of that the glow is around."""
_WHITE = 0.5
"""How much of what shines is white, at most: white needs its ground to be seen."""
_EDGE = 3
"""Pixels on either side of an edge that may blend."""


def without_glow(
    rgb: NDArray[np.uint8], alpha: NDArray[np.float32], body: float
) -> tuple[NDArray[np.float32], Mask] | None:
    """Return how much of each pixel (n, n), from 0 to 1, is no glow; None if there is none.

    With it comes which of them have nothing of its colour. ``rgb`` (n, n, 3) are the colours of
    the drawing, ``alpha`` is from 0 to 255, and ``body`` where it is opaque.
    """
    inside = alpha > body / 2
    rim = inside & ~scipy.ndimage.binary_erosion(inside)
    # What ends at the edge of the picture has an edge there.
    framed = np.pad(alpha, 1)
    steep = maximum_filter(framed, 5) - minimum_filter(framed, 5)
    soft = (steep < _SOFT * body)[1:-1, 1:-1]
    if (soft & rim).sum() <= _LEAST * rim.sum():  # as nearly always
        return None
    lab = cielab(rgb)
    found = regions(lab, inside, _CONTRAST, _SMALLEST)
    count = len(found.areas)
    whole = np.bincount(found.labels[rim], minlength=count)
    fading = (whole > 0) & (
        np.bincount(found.labels[rim & soft], minlength=count) > _NEARLY * whole
    )
    rest = inside & ~fading[found.labels]
    seen = (alpha > _VISIBLE * body) & fading[found.extended]
    if rest.sum() < _SHARE * inside.sum() or (hull(seen) & rest).sum() < _WITHIN * rest.sum():
        return None
    if (rest & near_white(lab)).sum() > _WHITE * rest.sum():
        return None
    # Beyond its own edges, what is there is the end of the glow.
    left = scipy.ndimage.binary_dilation(rest, iterations=_EDGE) & ~fading[found.extended]
    share = left.astype(np.float32)
    pure = found.pure & inside
    mixed, of_rest, _ = blend(rgb, pure & rest, pure & ~rest, pure | ~inside)
    share[mixed] = of_rest
    return share, pure & rest
