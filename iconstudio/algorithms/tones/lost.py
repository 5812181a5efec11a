"""Edges of a drawing that a person sees, and that have no counterpart in its pictogram.

Neighbours that differ little are one shape in a pictogram, and so are two of paper that do not
differ strikingly. What is lost by that, as the folds of a map, the facets of a gem or a highlight,
is told: where even colours meet, sharply and along some way, and no ink ends near by; or where a
line lies on an even ground. Colours that
go over into each other by degrees make no edge, nor do the steps of a gradient of few pixels.
"""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter, minimum_filter
from iconstudio.algorithms.tones.alternation import Tones
from iconstudio.algorithms.tones.regions import Mask, Regions, even_pieces, nearest

_LEAP = 1.5
"""How much a channel of CIELAB differs within three pixels at an edge, at least."""
_SEEN = 3.0
"""Difference (CIEDE2000) of even colours that is seen where they meet."""
_SHARP = 6.0
"""Half the width, in pixels of 512 to a side, of a sharp edge at most."""
_NEAR = 6
"""Pixels on either side of where ink ends in which an edge is kept."""
_WIDE = 10
"""Pixels around the middle of what is wide; what is narrower belongs to what is beside it."""
_LONG = 0.15
"""How long a lost edge or line is that is told, as part of the size of the drawing."""
_BESIDE, _MOSTLY, _PARTLY = 9, 0.85, 0.2
"""Pixels beside a line that tell what it lies on; how much of them has one colour, if it is even;
and how much of a line that is lost may be near ink that ends."""
_PLAIN = 5.0
"""As ``_SEEN``, of a line; and by how much an even ground may differ, in CIELAB."""


def loses_edges(lab: NDArray[np.float32], found: Regions, tones: Tones, ink: Mask) -> bool:
    """Whether a pictogram lacks edges of a drawing (n, n, 3), in CIELAB, that are seen.

    ``ink`` (m, m) is what is ink of the regions found. What lies behind the drawing, and is told
    to be left out, has no edges that count.
    """
    from skimage.color import deltaE_ciede2000

    inside = found.labels > 0
    pieces = even_pieces(lab, inside, _LEAP)
    even = _wide(pieces)
    pure = even > 0
    if not pure.any():
        return False
    behind = ~tones.ink & ~tones.outlined & (found.lengths[0] > 0) & bool(tones.omissions)
    left_out = behind[found.labels]
    at = nearest(pure)
    labels = np.where(inside, even[at], 0)
    of_each = (np.arange(len(inside)) * len(ink) // len(inside)).astype(np.intp)
    shown = inside & ink[np.ix_(of_each, of_each)]
    kept = maximum_filter(shown, 2 * _NEAR + 1) & ~minimum_filter(shown, 2 * _NEAR + 1)
    if _loses_line(lab, np.where(pure, 0, pieces), even, left_out | kept):
        return True
    here = np.indices(labels.shape, np.float32)
    sharp = np.hypot(*(np.stack(at) - here)) <= _SHARP
    open_ = sharp & inside & ~left_out & ~kept
    lost = np.zeros_like(inside)
    for one, other in ((np.s_[1:], np.s_[:-1]), (np.s_[:, 1:], np.s_[:, :-1])):
        meet = (labels[one] != labels[other]) & open_[one] & open_[other]
        colours = (lab[at[0][side][meet], at[1][side][meet]] for side in (one, other))
        lost[one][meet] |= deltaE_ciede2000(*colours) > _SEEN
    if not lost.any():
        return False
    lines, _ = scipy.ndimage.label(maximum_filter(lost, 3), np.ones((3, 3)))
    longest = np.bincount(lines[lost]).max()
    return bool(longest > _LONG * np.sqrt(inside.sum()))


def _loses_line(
    lab: NDArray[np.float32], narrow: NDArray[np.intp], wide: NDArray[np.intp], shown: Mask
) -> bool:
    """Whether a line on an even ground, one of the ``narrow`` pieces, is not ``shown``."""
    from skimage.color import deltaE_ciede2000

    size = np.sqrt((narrow + wide > 0).sum())
    for number, window in enumerate(scipy.ndimage.find_objects(narrow), 1):
        if window is None:
            continue
        around = tuple(slice(max(one.start - _BESIDE, 0), one.stop + _BESIDE) for one in window)
        line = narrow[around] == number
        width = 2 * scipy.ndimage.distance_transform_edt(line).max()
        if line.sum() < _LONG * size * width or shown[around][line].mean() > _PARTLY:
            continue
        beside = maximum_filter(line, 2 * _BESIDE + 1) & ~maximum_filter(line, _BESIDE)
        ground = lab[around][beside & (wide[around] > 0)]
        if len(ground) < _MOSTLY * beside.sum():
            continue
        colour = np.median(ground, axis=0)
        one = np.linalg.norm(ground - colour, axis=1) < _PLAIN
        own = np.median(lab[around][line], axis=0)
        if one.mean() > _MOSTLY and deltaE_ciede2000(own, colour) > _PLAIN:
            return True
    return False


def _wide(pieces: NDArray[np.intp]) -> NDArray[np.intp]:
    """Return pieces without those that are narrow everywhere."""
    depth = scipy.ndimage.distance_transform_edt(minimum_filter(pieces, 3) > 0)
    widest = np.zeros(pieces.max() + 1)
    np.maximum.at(widest, pieces, depth)
    widest[0] = 0
    return np.where(widest[pieces] > _WIDE, pieces, 0)
