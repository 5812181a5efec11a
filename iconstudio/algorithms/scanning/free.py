"""Coloured bitmaps on nothing: the transparent pixels tell what belongs to the drawing."""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import greatest_channel, maximum_filter, minimum_filter
from iconstudio.algorithms.scanning.cutting import cut_out
from iconstudio.algorithms.scanning.ground import CLEAR, ground_of
from iconstudio.algorithms.scanning.margin import PAPER, TINGE, box_of, has_stripes, rim_of
from iconstudio.algorithms.scanning.palette import SMALL, evenly_painted, is_in_one_colour
from iconstudio.algorithms.scanning.resampling import (
    premultiplied,
    reconstructed,
    resized,
    shrunk,
)
from iconstudio.algorithms.tones.layers import flattened

SIDE = 512
"""Pixels to a side of the drawing."""
LARGE = 192
"""Pixels of the longer side of a drawing that is as good as one of any size."""
FILLED = 0.94
"""How much of the longer side of the drawing is not air."""
_SMALL, _PAINTED = 64, 0.5
"""Of a drawing that is longer than the one, so much is evenly painted at least; photos are not."""
_OPAQUE = 243.0
"""Levels of alpha of what is opaque."""
_INK = 0.95
"""Opacity of ink, as part of the most that there is."""
SPARSE = 0.6
"""How much of its bounding box a drawing in lines fills at most."""
_CLEAN = 0.9
"""How much of what has the colour of a ground has just that, if no camera saw it."""
_APART, _PART = 15.0, 0.015
"""Levels by which two colours of a drawing differ, and the least part that the second one has."""


def free_drawing(pixels: NDArray[np.uint8]) -> NDArray[np.uint8] | None:
    """Return a coloured drawing (SIDE, SIDE, 4), fitted to the square; None if there is none.

    ``pixels`` are (h, w, 4) RGBA, in sRGB. None are photos, pictures without transparency
    (h, w, 3), and drawings in one colour and opacity.
    """
    if pixels.shape[2] == 3 or not (pixels[..., 3] < CLEAR).any():
        return None
    box = box_of(pixels[..., 3] >= CLEAR)
    if box is None:
        return None
    crop = pixels[box]
    longest = max(crop.shape[:2])
    blended = premultiplied(shrunk(crop, max(1, longest // SIDE)) * np.float32(255))
    blended = np.pad(blended, [(1, 1), (1, 1), (0, 0)])
    shown = blended[..., 3] >= CLEAR
    even = evenly_painted(blended, 3) & shown
    if longest <= _SMALL and not even.any():
        even = blended[..., 3] >= _OPAQUE  # of a few pixels, each may be of its own shade
    if not even.any() or (longest > _SMALL and even.sum() < _PAINTED * shown.sum()):
        return None
    if not has_colours(blended[even]):
        return None
    larger = resized(blended, scaled(blended.shape[:2], FILLED / max(blended.shape[:2])))
    layered = blended[..., 3][even & shown].min() < _OPAQUE
    return on_square(larger if layered else _with_edges(larger, blended[..., 3] / np.float32(255)))


def _with_edges(larger: NDArray[np.float32], alpha: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return an enlarged drawing whose edges are as sharp as those of a large one.

    What its ``alpha`` (h, w) tells of are edges, and no layers that are hardly opaque.
    """
    inside = reconstructed(np.stack([alpha, 1 - alpha]), larger.shape[:2])[0] > 0.5
    straight = larger * (np.float32(255) / np.maximum(larger[..., 3:], 1))
    sharp: NDArray[np.float32] = np.where(inside[..., None], straight, np.float32(0))
    return sharp


def on_nothing(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return lines in one colour on white, on a small bitmap (h, w, 3), as the same on nothing.

    What is given is (h, w, 4); any other bitmap is as it is.
    """
    if pixels.shape[2] == 4 or not 8 <= min(pixels.shape[:2]) <= max(pixels.shape[:2]) <= SMALL:
        return pixels
    blended = premultiplied(pixels.astype(np.float32))
    if not _is_sparse(blended) or not is_in_one_colour(blended):
        return pixels
    coloured = (np.ptp(pixels, axis=2) > TINGE).any()
    if coloured and has_stripes(blended.min(axis=2) > PAPER):
        return pixels  # a flag
    away = greatest_channel(255 - blended[..., :3])
    alpha = np.rint(np.clip((away - away.min()) / np.ptp(away), 0, 1) * 255).astype(np.uint8)
    return np.dstack([np.zeros_like(pixels), alpha])


def _is_sparse(blended: NDArray[np.float32]) -> bool:
    """Whether what is on white paper fills so little of its bounding box as lines do."""
    ink = blended.min(axis=2) <= PAPER
    box = box_of(ink)
    return box is not None and bool(ink[box].mean() < SPARSE)


def veil(alpha: NDArray[np.float32]) -> NDArray[np.bool_]:
    """Return which pixels are paper as one sees through them, whatever colour they hide.

    An edge between ink and nothing is no such area: its opacity is uneven.
    """
    most = np.quantile(alpha, 0.99)
    clear = (alpha > 0.05) & (alpha < _INK * most)
    high, low = maximum_filter(alpha, 3), minimum_filter(alpha, 3)
    even = clear & (high - low < 0.05)
    seen_through: NDArray[np.bool_] = clear & scipy.ndimage.binary_dilation(even, np.ones((3, 3)))
    return seen_through


def cut_drawing(pixels: NDArray[np.uint8]) -> NDArray[np.uint8] | None:
    """Return the drawing (SIDE, SIDE, 4) in many colours on an even ground (h, w, 3), or None."""
    if pixels.shape[2] == 4:
        return None
    ground = ground_of(premultiplied(pixels.astype(np.float32)))
    if ground is None or rim_of(ground.mask).mean() < _CLEAN * ground.around:
        return None
    return free_drawing(cut_out(pixels, ground.colour[:3], ground.mask))


def scaled(shape: tuple[int, ...], scale: float) -> tuple[int, ...]:
    """Return (h, w) of something on a square of which a pixel takes the part ``scale``."""
    return tuple(max(1, round(side * scale * SIDE)) for side in shape)


def has_colours(blended: NDArray[np.float32]) -> bool:
    """Whether some of the colours (n, 4), times alpha, are far from the usual one."""
    if not len(blended):
        return False
    apart = np.linalg.norm(blended - np.median(blended, axis=0), axis=1) > _APART
    return bool(apart.sum() >= max(1, _PART * len(blended)))


def on_square(blended: NDArray[np.float32]) -> NDArray[np.uint8]:
    """Return a drawing (h, w, 4), of colours times alpha, in the middle of (SIDE, SIDE, 4)."""
    alpha = blended[..., 3:]
    straight = np.concatenate([blended[..., :3] * (255 / np.maximum(alpha, 1)), alpha], axis=2)
    square = np.zeros((SIDE, SIDE, 4), np.uint8)
    height, width = blended.shape[:2]
    y, x = (SIDE - height) // 2, (SIDE - width) // 2
    square[y : y + height, x : x + width] = np.clip(np.rint(straight), 0, 255)
    return flattened(square)
