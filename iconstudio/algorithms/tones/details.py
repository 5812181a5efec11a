"""Letters and thin lines: what is too fine for regions of even colour.

Where the even colour around is pale, all that is much darker is drawn on it, and as much of a pixel
is drawn as it is dark; what is black is drawn on darker grounds, too. Edges between even colours
are no darker than these are. On ink, the same is true of what is light, or white, on a dark ground.
"""

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter, minimum_filter
from iconstudio.algorithms.tones.regions import Mask

_PALE, _DARK = 190.0, 120.0
"""Grey levels of the darkest pale ground, and of the palest dark one."""
_BLACK = 40.0
"""Grey level of the palest black, which shows on any ground."""
_APART = 60.0
"""By how many grey levels that which is drawn on it differs at least."""


def with_details(
    soft: NDArray[np.float32],
    grey: NDArray[np.float32],
    inside: Mask,
    pure: Mask,
    ink: Mask,
    reach: int,
) -> NDArray[np.float32]:
    """Return how much of each pixel (n, n) is ink, given that without details as ``soft``.

    Parameters
    ----------
    grey:
        Grey levels, 0 to 255; 255 outside.
    pure, ink:
        The pixels of even colour, which stay as they are; which of them are ink.
    reach:
        Half the width in pixels of the thickest lines that are not of even colour.
    """
    solid, fine = pure & inside, inside & ~pure
    paper = solid & ~ink
    on_paper = _drawn_on(paper, grey, solid, reach)
    soft = np.where(fine & ~np.isnan(on_paper), on_paper, soft)
    # Lines along a contour are a part of the silhouette.
    within = minimum_filter(inside, 2 * reach + 1)
    within &= fine & ~maximum_filter(paper, 2 * reach + 1)
    if not within.any():  # as most often
        return soft
    for levels, darkest in ((grey, _PALE), (255 - grey, 255 - _DARK)):
        on_ink = _drawn_on(solid & ink, levels, solid, reach, darkest)
        soft = np.where(within & ~np.isnan(on_ink), 1 - on_ink, soft)
    return soft


def _drawn_on(
    ground: Mask,
    grey: NDArray[np.float32],
    solid: Mask,
    reach: int,
    darkest: float = _PALE,
) -> NDArray[np.float32]:
    """Return how much of each pixel is drawn on a pale ground; NaN where nothing is near."""
    size = 2 * reach + 1
    level = minimum_filter(np.where(ground, grey, np.inf), size)
    others = np.where(ground, np.inf, grey)
    darkest_other = minimum_filter(others, size)
    told = (level > darkest) | (darkest_other < _BLACK)
    near = np.isfinite(level) & told & (level - darkest_other > _APART) & ~solid
    # A line is as dark as it is, whatever is beside it.
    dark = minimum_filter(others, 5)[near]
    drawn = np.full(grey.shape, np.nan, np.float32)
    way = level[near] - grey[near]
    drawn[near] = np.clip(way / np.maximum(level[near] - dark, _APART), 0, 1)
    return drawn
