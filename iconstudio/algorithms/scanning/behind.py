"""What lies behind the drawing on a bitmap, and is left out with its ground: a tile, or a page.

It is told as of the same drawing with a rectangle or a tile behind it: white goes without saying
behind black and grey alone. Only what a computer painted is told, not the paper of a scan.
"""

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import greatest_channel
from iconstudio.algorithms.scanning.ground import ASTRAY, ground_of, has_grain, is_gradient
from iconstudio.algorithms.scanning.margin import corners_of, rim_of
from iconstudio.algorithms.scanning.palette import evenly_painted
from iconstudio.algorithms.scanning.resampling import premultiplied, shrunk
from iconstudio.algorithms.tones.alternation import Omission
from iconstudio.algorithms.tones.regions import GREY, TINT, cielab, near_white

_LONGEST = 384
"""Pixels of the longer side of the bitmap that is looked at."""
_FEWEST, _COLOURED = 9, 0.03
"""Pixels of even colour from which colours are told; how much of a drawing has some, at least."""
_OTHER, _PLATE = 8.0, 0.1
"""Levels by which a white tile differs from the white around it, and how much of all that is white
it has, at least."""

_LIT, _AS_LIT = 60.0, 0.98
"""Lightness of paper where it is lit best, at least; how much of it has the same colour, but for
the light."""


def left_behind(
    pixels: NDArray[np.uint8], drawing: NDArray[np.uint8] | None = None, least: float = 0.0
) -> frozenset[Omission]:
    """Return what is left out with the ground of a bitmap (h, w, 3), or (h, w, 4) without one.

    What is white is no part of the drawing, either, if it is less dark than ``least``, from 0 to 1;
    nothing is left out that the coloured ``drawing`` (n, n, 4) shows.
    """
    if pixels.shape[2] == 4 or has_grain(pixels):
        return frozenset()
    small = shrunk(pixels, -(-max(pixels.shape[:2]) // _LONGEST)) * np.float32(255)
    blended = premultiplied(small)
    ground = ground_of(blended)
    if ground is None or not ground.is_clean(blended):
        told = is_gradient(pixels) and not _is_lit_paper(small)
        return frozenset({Omission.TILE} if told else ())
    if not near_white(cielab(np.rint(ground.colour[None, :3]).astype(np.uint8)))[0]:
        shown = drawing is not None and _has_colour(drawing, ground.colour[:3])
        return frozenset() if shown else frozenset({Omission.TILE})
    lab = cielab(np.rint(small).astype(np.uint8))
    even = evenly_painted(blended, 3)
    white = near_white(lab)
    drawn = even & ~white
    chroma = np.hypot(lab[..., 1], lab[..., 2])
    coloured = chroma[drawn if drawn.sum() > _FEWEST else ~white] > GREY
    paper = even & white & (1 - small.min(axis=2) / 255 < least)
    corner = np.median(corners_of(small), axis=0)
    plate = paper & (greatest_channel(abs(small - corner)) > _OTHER)
    told = coloured.sum() > _COLOURED * len(coloured) or plate.sum() > _PLATE * paper.sum()
    return frozenset({Omission.PAGE} if told else ())


def _is_lit_paper(picture: NDArray[np.float32]) -> bool:
    """Whether what is all around (h, w, 3) may be paper: of a mere tint, and only more or less lit.

    A camera that sees no grain, or a file that keeps none, leaves nothing else to tell it by.
    """
    rim = rim_of(picture)
    brightest = rim[rim.sum(axis=1).argmax()]
    lightness, *tint = cielab(np.rint(brightest[None]).astype(np.uint8))[0]
    # Of what is darker, by how much is told by each channel alike.
    lit = rim.mean(axis=1, keepdims=True) / brightest.mean() * brightest
    alike = (abs(rim - lit).max(axis=1) < _OTHER).mean()
    return bool(lightness > _LIT and np.hypot(*tint) < TINT and alike > _AS_LIT)


def _has_colour(drawing: NDArray[np.uint8], colour: NDArray[np.float32]) -> bool:
    """Whether some of a drawing (n, n, 4) has a colour (3,)."""
    seen = drawing[drawing[..., 3] > 0][:, :3]
    return bool((np.linalg.norm(seen - colour, axis=1) < ASTRAY).mean() > _COLOURED)
