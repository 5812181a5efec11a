"""Lines by one pen on paper that is lit unevenly: by a lamp that it mirrors, or half in the shadow.

Where the light is that clean, a computer might have painted it; but no more than paper is there.
"""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import greatest_channel
from iconstudio.algorithms.scanning.paper import lighting

_SHORTEST = 100
"""Pixels of the shorter side of a picture in which it is told."""
_LIGHT, _UNEVEN = 0.5, 0.85
"""How bright paper is where it is lit best, at least; and how bright where least, as part of that,
at most."""
_TINGE, _ALIKE = 0.1, 0.98
"""By how much the channels of paper differ that is less lit, at most; of how much of it that is so.
"""
_PAPER, _INK, _BESIDE = 0.1, 0.25, 3
"""By how much paper strays from its light, at most; and ink differs, at least; within how many
pixels beside ink there are edges."""
_SLIM, _DRAWN = 0.02, 0.003
"""Half the width of lines, as part of the picture, at most; how much of it they cover, at least."""


def is_unevenly_lit(picture: NDArray[np.float32]) -> bool:
    """Whether (h, w, 3), in sRGB from 0 to 1, shows lines on paper in uneven light, and no more."""
    if min(picture.shape[:2]) < _SHORTEST:
        return False
    ground = lighting(picture, np.ones(picture.shape[:2], bool))
    light = ground.mean(axis=2)
    least, most = np.percentile(light, (2, 99.5))
    if most < _LIGHT or least > _UNEVEN * most:
        return False
    # Of what is less lit, each channel is so by as much.
    shade = ground / np.maximum(ground[light >= most].mean(axis=0), _PAPER)
    alike = np.ptp(shade, axis=2) < _TINGE * shade.mean(axis=2)
    off = abs(picture - ground) / np.maximum(ground, _PAPER)
    ink = greatest_channel(off) > _INK
    rest = ~scipy.ndimage.binary_dilation(ink, iterations=_BESIDE)
    if not rest.any() or alike.mean() < _ALIKE or ink.mean() < _DRAWN:
        return False
    depth = float(scipy.ndimage.distance_transform_edt(ink).max())
    is_paper = (off[rest].max(axis=1) < _PAPER).mean() > _ALIKE
    return bool(is_paper and depth < _SLIM * max(ink.shape))
