"""Drawings on paper that is lit unevenly: by a lamp that it mirrors, from one side, or in a shadow.

Paper that changes by degrees and has the grain of a photo is no painted shade. Where the light is
so clean that a computer might have painted it, it is told only if one pen drew lines, no more.
"""

from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import greatest_channel
from iconstudio.algorithms.scanning.paper import lighting
from iconstudio.algorithms.scanning.resampling import resized

_SHORTEST = 100
"""Pixels of the shorter side of a picture in which it is told."""
_LIGHT, _CLEAN, _GRAINY = 0.5, 0.85, 0.97
"""How bright paper is where it is lit best, at least; and how bright where least, as part of that,
at most: without grain, and with."""
_SHADOW = 0.6
"""The same of paper in the shadow, at most; the colours of what is drawn there cannot be told."""
_GRAIN = 0.4
"""By how many of 255 levels paper with grain strays from its light, in the median, at least; what
is painted by degrees strays by less, as it is rounded to whole levels."""
_TINGE, _ALIKE = 0.1, 0.98
"""By how much the channels of paper differ that is less lit, at most; of how much of it that is so.
"""
_PAPER, _INK, _BESIDE = 0.1, 0.25, 3
"""By how much paper strays from its light, at most; and ink differs, at least; within how many
pixels beside ink there are edges."""
_NOISE, _EDGE = 8, 2
"""Pixels beside ink in which lossy files leave noise; and of the edges of ink itself."""
_SLIM, _DRAWN = 0.02, 0.003
"""Half the width of lines, as part of the picture, at most; how much of it they cover, at least."""


class UnevenLight(NamedTuple):
    """How the paper of a picture is lit."""

    ground: NDArray[np.float32]
    """(h, w, 3): the colour of the paper, also below what is drawn, from 0 to 1."""
    one_pen: bool
    """Whether all that is drawn has one colour."""

    def divided_out(self, pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """Return the picture (h, w, 3) at any resolution, its paper as where it is lit best."""
        light = self.ground.mean(axis=2)
        best = self.ground[light >= np.percentile(light, 99.5)].mean(axis=0)
        ground = np.maximum(resized(self.ground, pixels.shape[:2]), _PAPER)
        even: NDArray[np.uint8] = np.clip(np.rint(pixels / ground * best), 0, 255).astype(np.uint8)
        return even


def uneven_light(picture: NDArray[np.float32]) -> UnevenLight | None:
    """Return the light on paper with a drawing, (h, w, 3), in sRGB from 0 to 1; None if even."""
    if min(picture.shape[:2]) < _SHORTEST:
        return None
    ground = lighting(picture, np.ones(picture.shape[:2], bool))
    light = ground.mean(axis=2)
    least, most = np.percentile(light, (2, 99.5))
    if most < _LIGHT or least > _GRAINY * most:
        return None
    # Of what is less lit, each channel is so by as much.
    shade = ground / np.maximum(ground[light >= most].mean(axis=0), _PAPER)
    alike = np.ptp(shade, axis=2) < _TINGE * shade.mean(axis=2)
    off = ((picture - ground) / np.maximum(ground, _PAPER)).astype(np.float32)
    away = greatest_channel(abs(off))
    ink = away > _INK
    rest = ~scipy.ndimage.binary_dilation(ink, iterations=_BESIDE)
    if not rest.any() or alike.mean() < _ALIKE or ink.mean() < _DRAWN:
        return None
    if (away[rest] < _PAPER).mean() <= _ALIKE:
        return None
    depth = float(scipy.ndimage.distance_transform_edt(ink).max())
    slim = depth < _SLIM * max(ink.shape)
    if _grain(picture - ground, ink) < _GRAIN:
        return UnevenLight(ground, True) if slim and least <= _CLEAN * most else None
    one_pen = slim or _is_of_one_colour(off, ink)
    return UnevenLight(ground, one_pen) if one_pen or least > _SHADOW * most else None


def _grain(stray: NDArray[np.float32], ink: NDArray[np.bool_]) -> float:
    """Return by how many of 255 levels the paper strays from its light, in the median."""
    paper = ~scipy.ndimage.binary_dilation(ink, iterations=_NOISE)
    return 255 * float(np.median(greatest_channel(abs(stray))[paper])) if paper.any() else 0.0


def _is_of_one_colour(off: NDArray[np.float32], ink: NDArray[np.bool_]) -> bool:
    """Whether ink differs from its paper alike, in (h, w, 3) by what part, but for its edges."""
    inner = off[scipy.ndimage.binary_erosion(ink, iterations=_EDGE)]
    away = greatest_channel(abs(inner - np.median(inner, axis=0))[None])
    return bool((away < _INK).mean() > _ALIKE)
