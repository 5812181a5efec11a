"""Bitmaps that a computer drew in colours, as emoji and app icons are: told, and made crisp.

A palette (``palette``) are the colours that areas are evenly painted with; at an edge, and in a
thin line, a pixel blends two of them. What part of a pixel each colour takes is enlarged, not the
pixels: so the edges of small bitmaps are as sharp as those of large ones, and no third colour
appears between two. What is lit unevenly, shaded or drawn with a pencil has no such palette, or no
even ground.
"""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.scanning.free import SIDE, has_colours, on_square
from iconstudio.algorithms.scanning.palette import CLEAR, Palette, palette_of
from iconstudio.algorithms.scanning.resampling import (
    premultiplied,
    reconstructed,
    resized,
    shrunk,
)
from iconstudio.algorithms.scanning.sheet import sheet_on_desk
from iconstudio.algorithms.tones.alternation import Omission
from iconstudio.algorithms.tones.tone import pictogram

_LONGEST = 384
"""Pixels of the longer side of the bitmap that is looked at."""
_FILLED = 0.94
"""How much of the longer side of the crisp drawing is not air."""
_MISSED, _LOSSY = 0.04, 0.15
"""Part of the drawing that may be of other colours than those of the palette and their blends; in
lossy files, edges are."""
_ASTRAY = 28.0
"""Levels by which a pixel misses its blend if it is no such blend."""
_LACKING = 4
"""Colours of lines and dots that are added to a palette, at most."""
_ABSENT = 14.0
"""Levels that it costs to blend a colour that no even area near has."""
_NEAR = 7
"""Pixels across, of what is near."""
_AROUND = 0.97
"""How much of the rim of a bitmap has the colour of the ground, if not all corners have."""
_PAPER, _AT_RIM = 225.0, 0.3
"""Levels from which a colour is that of white paper, and how much of the rim that has at least."""
_DESK = 0.75
"""How much of the rim a desk has at least around a sheet of paper, whose corners are sharp."""
_TINGE = 70.0
"""Levels by which the channels of paper differ, at most."""
_CLEAN = 3.0
"""Levels by which the ground of a drawing with shades strays at most; that of a photo does."""
_FULL = 0.7
"""How much of its bounding box a tile or a badge fills, and a little air."""


def flat_drawing(pixels: NDArray[np.uint8]) -> NDArray[np.uint8] | None:
    """Return a coloured drawing (SIDE, SIDE, 4), free and crisp; None if the bitmap shows none.

    ``pixels`` are (h, w, 3) RGB or (h, w, 4) RGBA, in sRGB. The drawing is fitted to the square and
    has two colours or more; its ground, which is what is all around, is transparent. A drawing in
    one colour is none of these: its darkness tells more.
    """
    if min(pixels.shape[:2]) < 8:
        return None
    small = shrunk(pixels, -(-max(pixels.shape[:2]) // _LONGEST)) * np.float32(255)
    blended = premultiplied(small)
    palette = palette_of(blended)
    if palette is None:
        return None
    ground, around = _ground(palette, blended)
    if ground is None or (around > _DESK and _lies_on_a_desk(small, palette.colours[ground])):
        return None
    if small.shape[2] == 3 and palette.shades:
        if palette.noise(ground, blended) > _CLEAN:
            return None
        palette = _without_fading(palette, ground)
    most = _MISSED if palette.is_exact(blended) else _LOSSY
    parts, amiss = _parts(blended, palette, most)
    for _ in range(_LACKING):
        if amiss is None:
            break
        palette = palette.with_colour(amiss)
        parts, amiss = _parts(blended, palette, most)
    if amiss is not None:
        return None
    return _painted(parts, palette, ground, around < _AROUND)


def _ground(palette: Palette, blended: NDArray[np.float32]) -> tuple[int | None, float]:
    """Return the number of the colour all around, or in all corners, and its share of the rim.

    The number is None if there is no such colour.
    """
    if (palette.colours[:, 3] < CLEAR).any():
        return int(palette.colours[:, 3].argmin()), 1.0
    away = np.linalg.norm(palette.colours[:, None, None] - blended, axis=3)
    on_rim = np.concatenate([away[:, 0], away[:, -1], away[:, :, 0], away[:, :, -1]], axis=1)
    shares = (on_rim < _ASTRAY).mean(axis=1)
    shares[list(palette.shades)] = 0
    paper = (palette.colours.min(axis=1) > _PAPER) & (shares > _AT_RIM)
    cornered = (away[:, [0, 0, -1, -1], [0, -1, 0, -1]] < _ASTRAY).all(axis=1)
    # Paper of which a part lies in the shadow, or beside a desk, has shades.
    grounds = [shares > _AROUND, cornered] + ([] if palette.shades else [paper])
    for some in grounds:
        candidates = np.where(some, shares, 0)
        if candidates.any():
            return int(candidates.argmax()), float(candidates.max())
    return None, 0.0


def _lies_on_a_desk(small: NDArray[np.float32], ground: NDArray[np.float32]) -> bool:
    """Whether it is a sheet of paper; a ground as white as that is no desk."""
    if small.shape[2] == 4 or ground.min() > _PAPER:
        return False
    sheet = sheet_on_desk(small / np.float32(255))
    return sheet is not None and bool(np.ptp(np.median(small[sheet], axis=0)) < _TINGE)


def _without_fading(palette: Palette, ground: int) -> Palette:
    """Return a palette without shades that fade into the ground, as soft shadows do."""
    for one, shade in palette.shades.items():
        away = np.linalg.norm(shade[palette.number == one] - palette.colours[ground], axis=1)
        if (away < _ASTRAY).any():
            palette = palette.without(one, ground)
    return palette


def _parts(
    blended: NDArray[np.float32], palette: Palette, most: float
) -> tuple[NDArray[np.float32], NDArray[np.float32] | None]:
    """Return how much of each pixel has each colour, (k, h, w), and a colour that is lacking.

    Up to ``most`` of the drawing may be of no such blend.
    """
    count = len(palette.colours)
    parts = (np.arange(count)[:, None, None] == palette.number).astype(np.float32)
    near = np.stack([scipy.ndimage.maximum_filter(one, _NEAR) for one in parts]) > 0
    mixed = palette.number < 0
    pixels, beside = blended[mixed], near[:, mixed]
    colours = [palette.at(one, mixed) for one in range(count)]
    best = np.full(len(pixels), np.inf, np.float32)
    first, second = np.zeros((2, len(pixels)), np.intp)
    share = np.zeros(len(pixels), np.float32)
    missed = best.copy()
    for one in range(count):
        for other in range(one):
            way = colours[one] - colours[other]
            length = np.maximum(np.einsum("nc,nc->n", way, way), 1)
            rest = pixels - colours[other]
            at = np.clip(
                np.einsum("nc,nc->n", rest, np.broadcast_to(way, rest.shape)) / length, 0, 1
            )
            rest -= at[:, None] * way
            away = np.einsum("nc,nc->n", rest, rest)
            absent = (~beside[one] & (at > 0.1)) + 1 * (~beside[other] & (at < 0.9))
            cost = away + absent * _ABSENT**2
            better = cost < best
            best = np.where(better, cost, best)
            missed = np.where(better, away, missed)
            first, second = np.where(better, one, first), np.where(better, other, second)
            share = np.where(better, at, share)
    drawn = (palette.number != palette.counts.argmax()).sum()
    lacking = None
    if (missed > _ASTRAY**2).sum() > most * drawn:
        lacking = pixels[missed.argmax()]  # the farthest from all others blends the least
    values = np.zeros((count, len(pixels)), np.float32)
    index = np.arange(len(pixels))
    values[first, index] = share
    values[second, index] += 1 - share
    parts[:, mixed] = values
    return parts, lacking


def _painted(
    parts: NDArray[np.float32], palette: Palette, ground: int, cut: bool
) -> NDArray[np.uint8] | None:
    """Return the drawing without what of its ground is outside; None if it has one colour.

    The colour of the ground counts as one if it lies on a tile. ``cut`` drawings reach the edge of
    the bitmap.
    """
    drawn = parts[ground] < 0.5
    rows, columns = np.flatnonzero(drawn.any(axis=1)), np.flatnonzero(drawn.any(axis=0))
    if not len(rows):
        return None
    crop = np.s_[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    labels, colours = _enlarged(parts[(slice(None), *crop)], palette, ground, crop)
    pieces, _ = scipy.ndimage.label(np.pad(labels == ground, 1, constant_values=True))
    inside = (pieces != pieces[0, 0])[1:-1, 1:-1]
    if palette.colours[ground, 3] < CLEAR:
        inside = labels != ground
    own = has_colours(colours[inside & (labels != ground)])
    if not own and not (has_colours(colours[inside]) and inside.mean() > _FULL):
        return None
    painted = on_square(np.where(inside[..., None], colours, 0))
    on_tile = own or cut or Omission.TILE in pictogram(painted).omissions
    return painted if on_tile else None


def _enlarged(
    parts: NDArray[np.float32], palette: Palette, ground: int, crop: tuple[slice, slice]
) -> tuple[NDArray[np.intp], NDArray[np.float32]]:
    """Return the number (h, w) of the colour of each pixel of the drawing, and it (h, w, 4)."""
    pad = [(2, 2), (2, 2)]
    padded = [np.pad(one, pad, constant_values=n == ground) for n, one in enumerate(parts)]
    scale = SIDE * min(_FILLED / max(parts.shape[1:]), 1 / max(padded[0].shape))
    shape = tuple(max(1, round(side * scale)) for side in padded[0].shape)
    best = np.full(shape, -np.inf, np.float32)
    labels = np.full(shape, ground)
    for number, one in enumerate(padded):
        here = reconstructed(one, shape)
        labels = np.where(here > best, number, labels)
        best = np.maximum(here, best)
    colours = palette.colours[labels]
    for number, shade in palette.shades.items():
        at = labels == number
        wide = resized(np.pad(shade[crop], [*pad, (0, 0)], mode="edge"), shape)
        colours[at] = wide[at]
    return labels, colours
