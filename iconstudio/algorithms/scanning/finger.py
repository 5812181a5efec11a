"""The finger that holds the paper is told, at the edge of a photo, from what is drawn on it."""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.scanning.ground import unevenness
from iconstudio.algorithms.scanning.margin import rim_of
from iconstudio.algorithms.tones.regions import Mask, cielab, hull

_LIGHTNESS, _CHROMA, _HUE = (6.0, 90.0), (9.0, 50.0), (25.0, 85.0)
"""Skin in CIELAB, of whatever complexion, with its shadows; its hue in degrees."""
_SURE = 14.0
"""Chroma that a good part of a finger has."""
_DARKER, _SURELY = 0.35, 0.45
"""As part of its lightness, if that is less: dark skin has less chroma, and black ink none."""
_THICK = 0.03
"""Half the width of a finger, as part of the shorter side of the photo, at least."""
_SMALLEST, _LARGEST = 0.004, 0.2
"""How much of a photo fingers at one place cover."""
_RIM = 0.3
"""How much of the edge of the photo looks like skin, at most: a wooden desk does, all around."""
_EVEN, _PAINTED = 1.0 / 255, 0.4
"""Within so many levels over five pixels what a computer painted is even, and how much of it is."""
_ROUND = 0.88
"""How much of its convex hull a finger fills."""
_LIGHT = 55.0
"""Lightness of the paper, at least."""
_AROUND = 0.012
"""How far around a finger its shadow and blur reach, as part of the longer side of the photo."""


def finger(picture: NDArray[np.float32]) -> Mask | None:
    """Return (h, w) where fingers are on a photo of paper, (h, w, 3) in sRGB from 0 to 1; or None.

    They are thick, and reach the edge of the photo; their colour is that of skin, and changes.
    """
    lab = cielab(np.rint(picture * 255).astype(np.uint8))
    chroma = np.hypot(lab[..., 1], lab[..., 2])
    hue = np.degrees(np.arctan2(lab[..., 2], lab[..., 1]))
    skin = np.ones(chroma.shape, bool)
    for values, (least, most) in ((lab[..., 0], _LIGHTNESS), (hue, _HUE)):
        skin &= (values > least) & (values < most)
    skin &= (chroma > np.minimum(_CHROMA[0], _DARKER * lab[..., 0])) & (chroma < _CHROMA[1])
    rim = rim_of(skin)
    if not rim.any() or rim.mean() > _RIM or np.median(rim_of(lab[..., 0])) < _LIGHT:
        return None
    radius = max(2, round(_THICK * min(skin.shape)))
    found = _opened(skin | scipy.ndimage.binary_closing(skin, iterations=2), radius)
    pieces, _ = scipy.ndimage.label(found)
    even = unevenness(picture, 5) < _EVEN
    fingers = np.zeros_like(skin)
    for number in set(rim_of(pieces)[rim_of(pieces) > 0]):
        one = pieces == number
        share = one.mean()
        sure = np.median(chroma[one] - np.minimum(_SURE, _SURELY * lab[one, 0])) > 0
        if _SMALLEST < share < _LARGEST and sure and even[one].mean() < _PAINTED and _is_round(one):
            fingers |= one
    if not fingers.any():
        return None
    return _grown(fingers, radius / 2 + _AROUND * max(skin.shape))


def _is_round(shape: Mask) -> bool:
    return bool(shape.sum() > _ROUND * hull(shape).sum())


def _opened(shape: Mask, radius: int) -> Mask:
    """Return a shape without what is narrower than a disc; it goes on past the edge."""
    framed = np.pad(shape, 2 * radius, mode="edge")
    inner = scipy.ndimage.distance_transform_edt(framed) > radius
    opened = scipy.ndimage.distance_transform_edt(~inner) <= radius
    cropped: Mask = (opened & framed)[2 * radius : -2 * radius, 2 * radius : -2 * radius]
    return cropped


def _grown(shape: Mask, reach: float) -> Mask:
    grown: Mask = scipy.ndimage.distance_transform_edt(~shape) <= reach
    return grown
