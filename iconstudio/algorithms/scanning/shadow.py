"""The shadow that a drawing from a computer casts on its ground, soft or hard, is left out."""

import math

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import greatest_channel
from iconstudio.algorithms.scanning.cutting import cut_out
from iconstudio.algorithms.scanning.ground import AROUND, ASTRAY, Ground, ground_of, has_grain
from iconstudio.algorithms.scanning.resampling import premultiplied
from iconstudio.algorithms.scanning.soft_shadow import TINGE, soft_shadow
from iconstudio.algorithms.scanning.tile_shadow import shadow_of_tile
from iconstudio.algorithms.tones.regions import Mask, nearest

_LONGEST = 1024
"""Pixels of the longer side of the largest picture that is looked at."""
_AROUND = 0.7
"""How much of the rim has the colour of the ground, if the shadow of a tile reaches it."""
_DEEPEST, _FAINTEST = 0.35, 0.96
"""How bright a shadow is at least and at most, as part of its ground."""
_SEEN = 0.04
"""Size of what can be seen of a shadow, as part of that of the drawing, at least."""
_LEAST = 0.25
"""Size of the drawing, as part of that of its shadow, at least."""
_SHIFTED = 0.85
"""How much of a hard shadow is what the drawing covers, shifted, and the other way round."""
_FAR = 0.12
"""How far below the drawing a hard shadow lies at most, as part of the drawing's size."""
_EVEN = 8.0
"""Levels by which a hard shadow strays from its colour."""


def without_shadow(pixels: NDArray[np.uint8]) -> NDArray[np.uint8] | None:
    """Return a picture (h, w, 3) whose drawing casts no shadow; None if it casts none as it is.

    A shadow is the even ground, darker: soft, and fading into it all around; or hard, and of the
    shape of the drawing, shifted. What is on nothing, (h, w, 4), is told to cast one, on white, if
    it is a tile.
    """
    free = pixels.shape[2] == 4
    if free:
        pixels = _on_white(pixels)
    if not 16 <= min(pixels.shape[:2]) <= max(pixels.shape[:2]) <= _LONGEST:
        return None
    levels = pixels.astype(np.float32)
    ground = ground_of(premultiplied(levels))
    if ground is None or ground.around < _AROUND or ground.colour[:3].max() < 2 * ASTRAY:
        return None
    if has_grain(pixels):
        return None  # the soft edges of ink on paper are none
    bright = (levels @ ground.colour[:3]) / (ground.colour[:3] @ ground.colour[:3])
    tinge = greatest_channel(abs(levels - bright[..., None] * ground.colour[:3]))
    grey = (tinge < TINGE) & ~ground.mask
    dark = grey & (bright > _DEEPEST)
    away = greatest_channel(abs(levels - ground.colour[:3]))
    # A shadow may be black; so may a tile, which is none then.
    shadow = shadow_of_tile(levels, grey, away, ground)
    if shadow is None:
        shadow = shadow_of_tile(levels, dark, away, ground)
    told = not free and ground.around > AROUND
    if shadow is None and told:
        shadow = soft_shadow(levels, tinge, bright, ground)
    if shadow is None and told:
        shadow = _hard(dark & (bright < _FAINTEST), bright, away, ground)
    if shadow is None:
        return None
    behind = ground.mask | shadow
    cut = cut_out(pixels, levels[nearest(behind)], behind).astype(np.float32)
    alpha = cut[..., 3:] / 255
    free = cut[..., :3] * alpha + ground.colour[:3] * (1 - alpha)
    free[behind] = ground.colour[:3]
    without: NDArray[np.uint8] = np.rint(free).astype(np.uint8)
    return without


def _on_white(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    both = premultiplied(pixels.astype(np.float32))
    page: NDArray[np.uint8] = np.rint(both[..., :3] + 255 - both[..., 3:]).astype(np.uint8)
    return page


def _hard(
    dark: Mask, bright: NDArray[np.float32], away: NDArray[np.float32], ground: Ground
) -> Mask | None:
    """Return where a hard shadow lies, of what is ``dark``, or None."""
    if not dark.any():
        return None
    counts = np.bincount(np.rint(bright[dark] * 255).astype(np.intp))
    level = float(counts.argmax())
    shadow = dark & (abs(bright * 255 - level) < _EVEN)
    drawn = away > ASTRAY
    drawn &= ~dark | scipy.ndimage.binary_opening(dark & ~shadow, np.ones((3, 3)))
    if not _is_shadow(scipy.ndimage.binary_opening(shadow, np.ones((2, 2))), drawn):
        return None
    # Where the drawing must be shifted to for most of it to fall on shadow and least on ground.
    fits = scipy.signal.fftconvolve(
        shadow.astype(np.float32) - ground.mask, drawn[::-1, ::-1].astype(np.float32)
    )
    y, x = np.unravel_index(int(fits.argmax()), fits.shape)
    down, across = y - len(drawn) + 1, x - drawn.shape[1] + 1
    if down < 0 or math.hypot(down, across) > _FAR * math.sqrt(drawn.sum()):
        return None
    cast = scipy.ndimage.shift(drawn, (down, across), order=0)
    cast &= ground.mask | shadow
    wide_cast, wide = (
        scipy.ndimage.binary_dilation(one, np.ones((3, 3))) for one in (cast, shadow)
    )
    hits = (wide_cast & shadow).sum(), (wide & cast).sum()
    if hits[0] < _SHIFTED * shadow.sum() or hits[1] < _SHIFTED * cast.sum():
        return None
    edge: Mask = wide & dark
    return edge


def _is_shadow(seen: Mask, drawn: Mask) -> bool:
    """Whether what is seen of a shadow is neither noise nor all that there is."""
    return bool(_SEEN * drawn.sum() < seen.sum() < drawn.sum() / _LEAST)
