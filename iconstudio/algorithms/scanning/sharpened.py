"""What a picture was sharpened by, as editors and browsers do, is taken back.

An unsharp mask adds to a picture what a blurred copy lacks, and leaves bands along all edges: paler
on the pale side, darker on the dark one. They look like lines, and are of no even colour. As it
amplifies each frequency by a known and moderate factor, it can be undone. It is told by that then
more of what is beside edges is even; of a picture that was not sharpened, it is less.
"""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter, minimum_filter
from iconstudio.algorithms.scanning.ground import ground_of, sharpness, unevenness
from iconstudio.algorithms.scanning.resampling import premultiplied

_LONGEST = 320
"""Pixels of the longer side of the largest picture that is looked at."""
_RADII, _AMOUNTS = (1.0, 1.5, 2.0, 3.0), (0.75, 1.5, 2.0)
"""Standard deviations in pixels of the blurred copy, and how often what it lacks was added."""
_FIRST = 2.0, 0.75
"""What is tried first: it takes back some of any sharpening."""
_ROUNDS = 6
"""How often a picture is sharpened again to learn what was lost where it is black or white."""
_EVEN, _ACROSS = 12.0, 5
"""Levels by which what is even differs, at most, within so many pixels."""
_WIDE, _ADDED = 5, 40.0
"""Pixels across of what is white or black by itself, and by how many levels more than what is
beside it: not only by what was added."""
_EDGE, _NEAR = 40.0, 11
"""Levels by which an edge differs within three pixels, at least, and pixels across around it."""
_TELLS, _LEFT = 0.05, 0.84
"""How much of what is around edges becomes even, at least, where a picture was sharpened; and what
part of all unevenness is left, at most: lossy files that were not have some that goes, too."""
_STRONG, _USUAL, _SHARP = 0.6, 98, 0.75
"""What its strong edges differ by, as part of what so many per cent of a picture differ by less
than; and how sharp they are: those of a picture that was not sharpened are blurred by the attempt.
"""
_LUMINANCE = np.array([0.299, 0.587, 0.114], np.float32)
"""Lossy files keep colours at a lower resolution: these tell nothing."""


def unsharpened(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return a bitmap (h, w, 3) on a clean ground as it was before it was sharpened, if it was."""
    if pixels.shape[2] == 4 or not 16 <= min(pixels.shape[:2]) <= max(pixels.shape[:2]) <= _LONGEST:
        return pixels
    levels = pixels.astype(np.float32)
    light = (levels @ _LUMINANCE)[..., None]
    edges = unevenness(light, 3) > _EDGE
    near = scipy.ndimage.binary_dilation(edges, np.ones((_NEAR, _NEAR))).sum()
    least = _even(light) + _TELLS * near
    if not near or _even(_undone(light, *_FIRST)) < least:
        return pixels
    blended = premultiplied(levels)
    ground = ground_of(blended)
    if ground is None or not ground.is_clean(blended):
        return pixels
    ways = [(radius, amount) for radius in _RADII for amount in _AMOUNTS]
    best = min(ways, key=lambda way: _uneven(_undone(light, *way)))
    plain = _undone(light, *best)
    if _uneven(plain) > _LEFT * _uneven(light) or not _is_sharp(plain):
        return pixels
    undone: NDArray[np.uint8] = np.rint(_undone(levels, *best)).astype(np.uint8)
    return undone


def _even(light: NDArray[np.float32]) -> int:
    return int((unevenness(light, _ACROSS) < _EVEN).sum())


def _uneven(light: NDArray[np.float32]) -> float:
    return float(np.minimum(unevenness(light, _ACROSS), _EDGE).mean())


def _is_sharp(light: NDArray[np.float32]) -> bool:
    change = unevenness(light, 3)
    strong = change > _STRONG * np.percentile(change, _USUAL)
    return bool(sharpness(light)[strong].mean() > _SHARP)


def _undone(levels: NDArray[np.float32], radius: float, amount: float) -> NDArray[np.float32]:
    """Return what becomes the given picture (h, w, c) if it is sharpened, and then cut off."""
    black, white = levels <= 1, levels >= 254
    before = levels
    for _ in range(_ROUNDS):
        soft = scipy.ndimage.gaussian_filter(before, (radius, radius, 0), mode="nearest")
        again = before + amount * (before - soft)
        whole = np.where(white, np.maximum(again, levels), levels)
        whole = np.where(black, np.minimum(again, levels), whole)
        before = np.clip((whole + amount * soft) / (1 + amount), 0, 255)
    # How much was lost there cannot be known, but what is beside it can.
    size = (_WIDE + 2, _WIDE + 2, 1)
    beside = maximum_filter(np.where(white, 0, before), size)
    added = _is_slim(white) & (before - beside < _ADDED)
    before = np.where(added, np.minimum(before, beside), before)
    beside = minimum_filter(np.where(black, 255, before), size)
    added = _is_slim(black) & (beside - before < _ADDED)
    return np.where(added, np.maximum(before, beside), before)


def _is_slim(mask: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return what of a mask (h, w, c) is slim in its channel."""
    size = (_WIDE, _WIDE, 1)
    framed = np.pad(mask, [(_WIDE, _WIDE), (_WIDE, _WIDE), (0, 0)], mode="edge")
    opened = maximum_filter(minimum_filter(framed, size), size)
    slim: NDArray[np.bool_] = mask & ~opened[_WIDE:-_WIDE, _WIDE:-_WIDE]
    return slim
