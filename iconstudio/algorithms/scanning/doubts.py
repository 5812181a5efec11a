"""What makes one doubt a drawing: lines too faint to be ink, and shading as on photos."""

import math

import numpy as np
import scipy
from numpy.typing import NDArray

SPECK = 72
"""Most pixels of what is taken for dirt, on the paper or in the ink."""
_GRADUAL, _SOFT, _SOFTEST = 0.01, 6, 12
"""Shading changes by so much from pixel to pixel, at so many pixels from the edge of ink; at more
if that is out of focus, but no more than the last."""
_SLIM = 8
"""Half the width in pixels of a faint line: the rules of a notebook, or the rim of a stain."""
_BESIDE = 3
"""Pixels beside ink that its blurred edges reach."""
_SEEN, _FAINTER = 0.08, 0.02
"""How dark lines are that one can see, and how much of them beside the ink is told."""
_UNLIKE, _FEWEST = 0.82, 16
"""How much neighbours differ in noise, as part of any two pixels, at least; pixels to a side of the
coarsest picture that is asked."""
LEAST = 0.12
"""A drawing is darker than its paper by so much at least, of all the way to black: what is so much
darker is no noise."""


def has_fainter_lines(dark: NDArray[np.float32], threshold: float) -> bool:
    """Whether lines can be seen beside the ink that are too faint to be ink."""
    ink = without_specks(dark > threshold, SPECK)
    away = ~scipy.ndimage.binary_dilation(ink, iterations=_BESIDE)
    paper = dark[away]
    if not paper.size:
        return False
    grain = 1.48 * np.median(abs(paper - np.median(paper)))
    seen = without_specks((dark > np.median(paper) + max(_SEEN, 4 * grain)) & away, SPECK)
    return bool(seen.sum() > _FAINTER * ink.sum())


def is_noise(pixels: NDArray[np.uint8]) -> bool:
    """Whether each pixel (h, w, c) is as unlike its neighbours as any other, however coarsely seen.

    Of a drawing, however noisy, neighbours are alike at some resolution.
    """
    levels = pixels.astype(np.float32)
    spread = levels.var(axis=(0, 1)).sum()
    while spread > 1:
        apart = [(np.diff(levels, axis=axis) ** 2).mean(axis=(0, 1)).sum() / 2 for axis in (0, 1)]
        if min(apart) < _UNLIKE * spread:
            return False
        height, width = (side // 2 for side in levels.shape[:2])
        if min(height, width) < _FEWEST:
            return True
        levels = levels[: 2 * height, : 2 * width]
        levels = levels.reshape(height, 2, width, 2, -1).mean(axis=(1, 3))
        spread = levels.var(axis=(0, 1)).sum()
    return False


def shading(dark: NDArray[np.float32], threshold: float, scale: float) -> float:
    """Return how much of what is not paper is neither ink, its edge nor a line, from 0 to 1.

    What was enlarged much by ``scale``, or is out of focus, has wider edges.
    """
    ink = dark > threshold
    even = scipy.ndimage.gaussian_filter(dark, 2.0)  # without noise
    slope = np.hypot(*np.gradient(np.pad(even, 1, mode="edge")))[1:-1, 1:-1]
    enlarged = max(1.0, scale / 2)
    width = round(np.clip(_spread(ink, dark, slope), _SOFT * enlarged, _SOFTEST * enlarged))
    high, low = (  # beyond the picture is paper
        filtered(ink, 2 * width + 1, mode="constant", cval=0)
        for filtered in (scipy.ndimage.maximum_filter, scipy.ndimage.minimum_filter)
    )
    edge = high & ~low
    visible = even > LEAST
    around = 2 * round(_SLIM * enlarged) + 1
    wide = scipy.ndimage.grey_opening(even, around) > LEAST
    shaded = visible & ~edge & (slope > _GRADUAL) & scipy.ndimage.maximum_filter(wide, around)
    return float(shaded.sum() / max(1, visible.sum()))


def _spread(ink: NDArray[np.bool_], dark: NDArray[np.float32], slope: NDArray[np.float32]) -> float:
    """Return over how many pixels the sharpest edges of ink are spread: three of their sigmas.

    All edges of a drawing out of focus are alike; of other photos, some are sharp.
    """
    rim = ink & ~scipy.ndimage.binary_erosion(ink)
    if not rim.any():
        return 0.0
    steepest = max(float(np.percentile(slope[rim], 90)), 1e-6)
    return 3 * float(np.median(dark[ink])) / (math.sqrt(2 * math.pi) * steepest)


def without_specks(shape: NDArray[np.bool_], speck: int) -> NDArray[np.bool_]:
    """Return a shape without parts of at most ``speck`` pixels."""
    labels, _ = scipy.ndimage.label(shape)
    large = np.bincount(labels.ravel()) > speck
    large[0] = False
    cleaned: NDArray[np.bool_] = large[labels]
    return cleaned
