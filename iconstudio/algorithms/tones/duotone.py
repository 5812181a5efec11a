"""Drawings in two tones, such as black on a white page: each pixel blends the two, and no more.

In such a drawing there is nothing to guess but which tone is ink: what is drawn is as fine as its
pixels are, whereas regions (``regions``) take no notice of small and thin ones.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter, minimum_filter
from iconstudio.algorithms.tones import regions
from iconstudio.algorithms.tones.regions import Mask, Regions, cielab, pieces

_DARKER = 35.0
"""How much darker than the pale tone, in lightness, the other one is."""
_ASTRAY = 12.0
"""Levels of sRGB by which a blend may miss the line between the two."""
_BETWEEN = 0.15
"""How far from both tones, as part of the way, a third one is."""
_FEW = 30
"""Pixels, of 512 by 512, that may be of other colours."""
_MOSTLY = 0.98
"""How much of a tone is ink, or paper, if the tone is."""


class TwoTones(NamedTuple):
    """The colours (3,) of a drawing in two tones, in sRGB."""

    pale: NDArray[np.float32]
    dark: NDArray[np.float32]

    def darkness(self, rgb: NDArray[np.uint8] | NDArray[np.float32]) -> NDArray[np.float32]:
        """Return how far each colour (..., 3) is on the way from pale to dark, 0 to 1."""
        way = self.dark - self.pale
        return np.clip((rgb - self.pale) @ (way / (way @ way)), 0, 1)


def two_tones(rgb: NDArray[np.uint8], inside: Mask) -> TwoTones | None:
    """Return the tones of a drawing (n, n, 3) if it has a pale and a dark one, and no others."""
    packed = rgb[inside].astype(np.uint32) @ np.array([1 << 16, 1 << 8, 1], np.uint32)
    found, counts = np.unique(packed, return_counts=True)
    colours = np.stack([found >> 16, found >> 8 & 255, found & 255], axis=1).astype(np.float32)
    one = colours[counts.argmax()]
    other = colours[np.linalg.norm(colours - one, axis=1).argmax()]
    pale, dark = (one, other) if one.sum() > other.sum() else (other, one)
    lab = cielab(np.stack([pale, dark]).astype(np.uint8))
    if not regions.pale(lab[0]) or lab[1, 0] > lab[0, 0] - _DARKER:
        return None
    tones = TwoTones(pale, dark)
    on_line = pale + tones.darkness(colours)[:, None] * (dark - pale)
    if counts[np.linalg.norm(colours - on_line, axis=1) > _ASTRAY].sum() > _FEW:
        return None
    return None if _third_tone(tones.darkness(rgb), inside) else tones


def _third_tone(darkness: NDArray[np.float32], inside: Mask) -> bool:
    """Whether something is evenly of a colour between the two."""
    high = maximum_filter(np.where(inside, darkness, 1), 3)
    low = minimum_filter(np.where(inside, darkness, 0), 3)
    between = (low > _BETWEEN) & (high < 1 - _BETWEEN) & (high - low < _BETWEEN)
    return bool(between.sum() > _FEW)


def separated(tones: TwoTones, rgb: NDArray[np.uint8], inside: Mask) -> Regions:
    """Return the pieces of a drawing in two tones."""
    colours = cielab(np.stack(tones).astype(np.uint8))
    return pieces(colours, inside, tones.darkness(rgb) > 0.5)


def dark_is_ink(found: Regions, ink: Mask) -> bool | None:
    """Return whether the dark tone is ink, and the pale one paper; None if it is not so simple."""
    lightness = found.colours[1:, 0]
    dark = lightness < (lightness.min() + lightness.max()) / 2
    areas = found.areas[1:]
    shares = [areas[tone & ink[1:]].sum() / areas[tone].sum() for tone in (dark, ~dark)]
    if shares[1] < 1 - _MOSTLY and shares[0] > 0.5:
        return True
    return False if shares[0] < 1 - _MOSTLY and shares[1] > _MOSTLY else None
