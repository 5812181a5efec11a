"""Which paints of a drawing are ink, where its shapes can be kept as they are."""

from enum import Enum

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.tones import regions
from iconstudio.algorithms.tones.regions import Mask, cielab
from iconstudio.algorithms.tones.resolution import SMALLEST, averaged, body_alpha, reduced


class Paints(Enum):
    """Which paints of a drawing are ink, if its shapes can be kept as they are."""

    ALL = "all paints are ink"
    DARK = "near white is paper, all other paints are ink"
    LIGHT = "near white is ink, all other paints are paper"


def paints(rgba: NDArray[np.uint8], coverage: NDArray[np.uint8]) -> Paints | None:
    """Return which paints of a drawing are ink, given its pictogram; None if shapes must change.

    Painted so, and with the opacity of its body raised to 1, the drawing looks as the pictogram
    does but for specks; if there is no such way, the pictogram is to be traced.
    """
    rgb, alpha = reduced(rgba)
    visible, white = alpha > body_alpha(alpha) / 2, near_white(rgb)
    ink = averaged(coverage[..., None].astype(np.float32))[..., 0] > 127.5
    for choice, painted in (
        (Paints.ALL, visible),
        (Paints.DARK, visible & ~white),
        (Paints.LIGHT, visible & white),
    ):
        # Edges, where colours blend, do not count.
        amiss = scipy.ndimage.binary_opening(painted != ink, np.ones((3, 3)))
        if amiss.sum() < SMALLEST:
            return choice
    return None


def near_white(rgb: NDArray[np.uint8]) -> Mask:
    """Return which of the sRGB colours (..., 3) are near white."""
    return regions.near_white(cielab(rgb))
