"""The soft shadow that a drawing casts: its own shape, shifted and blurred, on an even ground.

What may be shadow is darker ground without sharp edges. It is one if the shape of the rest, shifted
and blurred, tells how dark it is everywhere.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import greatest_channel
from iconstudio.algorithms.scanning.ground import Ground, sharpness, unevenness
from iconstudio.algorithms.scanning.resampling import resized
from iconstudio.algorithms.tones.regions import Mask

TINGE = 14.0
"""Levels by which a shadow misses the colour of its ground, made darker."""
_LONGEST = 128
"""Pixels of the longer side at which a shadow is compared with what casts it."""
_GENTLE = (36.0, 80.0, np.inf)
"""Levels by which a soft shadow differs within three pixels at most; small ones do by more."""
_BLURS = tuple(0.006 * 2 ** (n / 2) for n in range(9))
"""By how much shadows are blurred, as part of the longer side: standard deviations."""
_TOLD, _SURE, _BETTER = 0.75, 0.97, 0.7
"""How much of the darkness of a shadow its drawing tells of, at least (the coefficient of
determination), and where no other way to divide them is tried; what part of what one leaves
untold another leaves that is better."""
_SEEN, _LEAST = 0.03, 0.03
"""How dark a shadow is where it is seen, as part of its ground, and how large what is seen is."""
_FADED = 0.5
"""How dark it is where it meets the ground at most, as part of how dark it is elsewhere."""
_STEEP = 0.7
"""How sharp the edge of a shadow is at most."""
_DEEPEST, _AMISS = 0.65, 0.1
"""How dark a shadow is at most; how much darker or brighter than is told of it."""
_SHARP, _SOMEWHERE = 0.6, 80
"""How sharp the contour of a drawing is: in so many per cent of one that is blurred itself it is
less so."""
_FAR = 0.3
"""How far a shadow is shifted at most, as part of the longer side."""
_DENSE = 0.12, 1.0
"""How dense a shadow is at least, and at most."""
_FLAT, _ACROSS = 4.0, 5
"""Levels by which an area differs that is as many pixels wide, if it is evenly painted."""
_NOISE, _REACH = 10.0, 12
"""Levels by which noise differs from an even area, at most, and within how many pixels of it."""
_BESIDE = 2
"""Pixels beside a shadow whose colour lossy files mix with that of the drawing."""
_SPECK = 12
"""Pixels of the largest piece that lossy files leave within a shadow."""


class _Cast(NamedTuple):
    """A shadow as its drawing tells of it."""

    told: float
    """How much of what is there it tells of."""
    darkness: NDArray[np.float32]
    """(h, w), from 0, ground, to 1, black."""


def soft_shadow(
    levels: NDArray[np.float32],
    tinge: NDArray[np.floating],
    bright: NDArray[np.float32],
    ground: Ground,
) -> Mask | None:
    """Return where a soft shadow lies, (h, w), or None.

    ``levels`` are (h, w, 3), from 0 to 255; ``bright`` (h, w) is how bright they are, as part of
    the ground, and ``tinge`` by how many they have another colour than the ground made darker.
    """
    depth = np.where(ground.mask, 0, 1 - bright).astype(np.float32)
    dark = (tinge < TINGE) & (depth > 0) & (depth < _DEEPEST)
    best: tuple[_Cast, Mask] | None = None
    for lying in _ways(levels, dark & ~ground.mask, depth):
        outside = scipy.ndimage.binary_propagation(ground.mask, mask=ground.mask | lying)
        cast = _lying(depth, outside) if _fades(depth, outside, ground.mask) else None
        if cast is None or (best and 1 - cast.told > _BETTER * (1 - best[0].told)):
            continue
        best = cast, outside
        if cast.told > _SURE:
            break
    if best is None or not _is_sharp(levels, ~best[1]):
        return None
    cast, outside = best
    # One sees it through holes, too.
    holes = outside | (tinge < TINGE) & (depth < cast.darkness + _AMISS)
    through = _lying(depth, holes)
    if through is not None and through.told > cast.told:
        cast = through
    fits = (abs(depth - cast.darkness) < _AMISS) & (cast.darkness > _SEEN)
    shadow = outside | (fits & (tinge < TINGE))
    beside = scipy.ndimage.binary_dilation(shadow, np.ones((3, 3)), iterations=_BESIDE)
    shadow = (shadow | (fits & beside & (tinge < 2 * TINGE))) & ~ground.mask
    pieces, _ = scipy.ndimage.label(~shadow & ~ground.mask)
    specks = (np.bincount(pieces.ravel()) <= _SPECK)[pieces] & (cast.darkness > _SEEN)
    found: Mask = shadow | specks
    return found


def _is_sharp(levels: NDArray[np.float32], drawn: Mask) -> bool:
    """Whether a drawing has a sharp contour, here and there at least."""
    contour = drawn & ~scipy.ndimage.binary_erosion(drawn, np.ones((3, 3)), border_value=1)
    if not contour.any():
        return False
    return bool(np.percentile(sharpness(levels)[contour], _SOMEWHERE) > _SHARP)


def _ways(levels: NDArray[np.float32], dark: Mask, depth: NDArray[np.float32]) -> Iterator[Mask]:
    """Yield what may be shadow, (h, w), by how it may be told from what is painted as dark."""
    change = unevenness(levels, 3)
    even = (unevenness(levels, _ACROSS) < _FLAT) & (depth > _SEEN)
    painted = scipy.ndimage.binary_dilation(_alike(levels, even), np.ones((3, 3)))
    for most in _GENTLE:
        gentle = dark & (change < most)
        yield gentle
        if (gentle & painted).any():
            yield gentle & ~painted


def _fades(depth: NDArray[np.float32], outside: Mask, ground: Mask) -> bool:
    """Whether what is outside is much paler where it meets the ground than elsewhere."""
    meets = scipy.ndimage.binary_dilation(ground, np.ones((3, 3))) & outside & ~ground
    seen = outside & (depth > _SEEN)
    if not seen.any() or not meets.any():
        return False
    deepest = np.percentile(depth[seen], 90)
    if np.median(depth[meets]) >= _FADED * deepest:
        return False
    # Beside a pale drawing, files leave noise that fades as well.
    half = outside & (depth > _FADED * deepest)
    edge = half & ~scipy.ndimage.binary_erosion(half | ~outside, border_value=1)
    return bool(not edge.any() or np.median(sharpness(depth[..., None])[edge]) < _STEEP)


def _alike(levels: NDArray[np.float32], even: Mask) -> Mask:
    """Return what is as the even area beside it, but for the noise that files leave at edges."""
    if not even.any():
        return even
    distance, (rows, columns) = scipy.ndimage.distance_transform_edt(~even, return_indices=True)
    alike = greatest_channel(abs(levels - levels[rows, columns])) < _NOISE
    like: Mask = even | (alike & (distance < _REACH))
    return like


def _lying(depth: NDArray[np.float32], outside: Mask) -> _Cast | None:
    """Return the shadow if all that is outside is ground or shadow; None if it is not told."""
    drawn = ~outside
    seen = scipy.ndimage.binary_opening(outside & (depth > _SEEN), np.ones((3, 3)))
    if not seen.sum() > _LEAST * drawn.sum() > 0:
        return None
    cast = _cast(depth, drawn)
    return None if cast is None or cast.told < _TOLD else cast


def _cast(depth: NDArray[np.float32], drawn: Mask) -> _Cast | None:
    """Return the shadow that comes nearest to how dark it is where nothing is ``drawn``."""
    longest = max(depth.shape)
    shape = tuple(max(1, round(side * min(1, _LONGEST / longest))) for side in depth.shape)
    body = resized(drawn.astype(np.float32), shape)
    free = np.where(resized((~drawn).astype(np.float32), shape) > 0.99, np.float32(1), 0)
    there = free * resized(np.where(drawn, 0, depth), shape)
    power = float((there**2).sum())
    if not power:
        return None
    far = round(_FAR * max(shape))
    best, found = 0.0, None
    for blur in _BLURS:
        soft = scipy.ndimage.gaussian_filter(np.pad(body, far), blur * max(shape))
        like, own = (
            scipy.signal.fftconvolve(one, other[::-1, ::-1], mode="valid")
            for one, other in ((soft, there), (soft**2, free))
        )
        told = np.where(own > 1e-3, np.maximum(like, 0) ** 2 / np.maximum(own, 1e-3), 0)
        at = np.unravel_index(int(told.argmax()), told.shape)
        dense = float(like[at] / max(own[at], 1e-3))
        if told[at] > best and _DENSE[0] < dense <= _DENSE[1]:
            y, x = int(at[0]), int(at[1])
            best, found = float(told[at]), dense * soft[y : y + shape[0], x : x + shape[1]]
    return None if found is None else _Cast(best / power, resized(found, depth.shape))
