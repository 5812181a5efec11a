"""White on colour: paper, unless it is a shape of the drawing.

White that makes a large part of the silhouette is such a shape (a cloud before the sun, a sheep),
unless it is pure white, as pages are, and bites into a colour: what it hides of that is a good part
of it, as in a crescent made of a disc and a white one, or a bitten apple. What a colour is behind
the white is told by its convex hull.
"""

import numpy as np

from iconstudio.algorithms.tones.linework import THICK
from iconstudio.algorithms.tones.regions import ALIKE, Mask, Regions
from iconstudio.algorithms.tones.tiles import SHARP, rectangularity

_FREE = 0.9
"""How much of its contour a shape that stands by itself shares with the outside."""
_PURE = 99.0
"""Lightness from which white is that of a page."""
_STEP = 2
"""Of so many rows and columns of pixels one is looked at for hulls."""
_HIDING, _BITING = 0.3, 0.1
"""How much of a bite lies where the colour behind it was, at least; if it is convex, as knives and
discs are, and clouds are not."""
_CONVEX = 0.98
"""How much of its convex hull a convex shape fills."""
_WITHIN = 0.9
"""How much of its contour a shape that is drawn on the white shares with it."""
_WHOLE = 0.95
"""How much of its convex hull a shape fills that a band of white divides, with that band."""


def white_on_colour(found: Regions) -> Mask:
    """Return the white regions (k + 1,) that are paper, as they make no part of the silhouette."""
    white = found.white
    total = found.areas[1:].sum()
    if found.areas[1:][~white[1:]].sum() < 0.05 * total:
        return np.zeros_like(white)
    page = white & (found.lengths[0] > 0.75 * found.lengths[0].sum())
    if page.any() and rectangularity(found) > SHARP:
        return white
    outer = found.lengths[0]
    free = outer > _FREE * found.lengths.sum(axis=1)
    at_outside = outer > 0
    at_outside[0] = True
    # What is drawn on the white does not count. A narrow band sets other colours off.
    large = (found.areas > 0.05 * total) & (found.widths > THICK)
    part = large & (outer > 0.5 * found.lengths[:, at_outside].sum(axis=1))
    for number in np.flatnonzero(part & white & ~free):
        part[number] = not _is_bite(found, int(number))
    paper: Mask = white & ~free & ~part
    return paper


def _is_bite(found: Regions, number: int) -> bool:
    """Whether a white region takes a bite out of a colour, and nothing else is drawn on it."""
    if found.colours[number, 0] < _PURE:
        return False
    meeting = ~found.white & (found.lengths[number] > 0)
    meeting[0] = False
    on_it = meeting & (found.lengths[number] > _WITHIN * found.around)
    behind = np.flatnonzero(meeting & ~on_it)
    alike = np.linalg.norm(found.colours[:, None] - found.colours, axis=2) < ALIKE
    if not alike[on_it][:, behind].any(axis=1).all():
        return False
    labels = found.labels[::_STEP, ::_STEP]
    white = labels == number
    filled = white | on_it[labels]
    least = _BITING if filled.sum() > _CONVEX * _hull(filled).sum() else _HIDING
    for one in behind:
        if (_hull(labels == one) & white).sum() > least * white.sum():
            return True
        parts = behind[alike[one, behind]]
        if len(parts) > 1:
            hull = _hull(np.isin(labels, parts))
            whole = np.isin(labels[hull], [*parts, number]).mean() > _WHOLE
            if whole and (hull & white).sum() > _HIDING * white.sum():
                return True
    return False


def _hull(mask: Mask) -> Mask:
    from skimage.morphology import convex_hull_image

    hull: Mask = convex_hull_image(mask)
    return hull
