"""Bitmaps of drawings in a few flat colours, as emoji and flat icons are: told, and made crisp.

A palette are the colours that areas are evenly painted with; at an edge, and in a thin line, a
pixel blends two of them. What part of a pixel each colour takes is enlarged, not the pixels: so the
edges of small bitmaps are as sharp as those of large ones, and no third colour appears between two.
What is lit unevenly, shaded or drawn with a pencil has no such palette. Colours are sRGB times
alpha, and alpha, from 0 to 255, so that nothing is a colour, too.
"""

from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.scanning.resampling import resized, shrunk
from iconstudio.algorithms.scanning.sheet import sheet_on_desk

SIDE = 512
"""Pixels to a side of the crisp drawing."""
_LONGEST = 384
"""Pixels of the longer side of the bitmap that is looked at."""
_FILLED = 0.94
"""How much of the longer side of the crisp drawing is not air."""
_EVEN = 20.0
"""Levels by which a channel differs within three pixels of an evenly painted area, at most."""
_BIN = 8
"""Levels of a channel that are counted as one."""
_SHARE = 0.0015
"""Least part of the evenly painted pixels that have a colour of the palette."""
_SPREAD = 9.0
"""Levels by which the pixels of one colour stray, as root of the mean square."""
_MOST = 16
"""Colours of a palette."""
_MISSED = 0.04
"""Part of the drawing that may be of other colours than those of the palette and their blends."""
_ASTRAY = 28.0
"""Levels by which a pixel misses its blend if it is no such blend."""
_LACKING = 4
"""Colours of lines and dots that are added to a palette, at most."""
_ABSENT = 14.0
"""Levels that it costs to blend a colour that no even area near has."""
_NEAR = 7
"""Pixels across, of what is near."""
_CLEAR, _SOLID = 12.0, 235.0
"""Levels of alpha of what is not there, and of what is opaque."""
_AROUND = 0.97
"""How much of the rim of a bitmap has the colour of the ground."""
_PAPER, _AT_RIM = 225.0, 0.3
"""Levels from which a colour is that of white paper, and how much of the rim that has at least."""
_APART = 30.0
"""Levels by which two colours of a drawing differ, and no blending of the palette makes."""
_PART = 0.015
"""Least part of a drawing that its second colour has."""


class _Palette(NamedTuple):
    colours: NDArray[np.float32]
    """(k, 4)"""
    counts: NDArray[np.intp]
    """(k,): pixels that are evenly painted so."""
    number: NDArray[np.intp]
    """(h, w): the number of each evenly painted pixel's colour, else -1."""

    def with_colour(self, colour: NDArray[np.float32]) -> "_Palette":
        """Return it with a colour (4,) of what is too small to be evenly painted."""
        colours = np.concatenate([self.colours, colour[None]])
        return _Palette(colours, np.append(self.counts, 0), self.number)


def flat_drawing(pixels: NDArray[np.uint8]) -> NDArray[np.uint8] | None:
    """Return a coloured drawing (SIDE, SIDE, 4), free and crisp; None if the bitmap shows none.

    ``pixels`` are (h, w, 3) RGB or (h, w, 4) RGBA, in sRGB. The drawing is fitted to the square and
    has two colours or more; its ground, which is what is all around, is transparent. A drawing in
    one colour is none of these: its darkness tells more.
    """
    if min(pixels.shape[:2]) < 8:
        return None
    small = shrunk(pixels, -(-max(pixels.shape[:2]) // _LONGEST)) * np.float32(255)
    blended = _premultiplied(small)
    palette = _palette(blended)
    if palette is None or _is_veiled(palette):
        return None
    ground = _ground(palette, blended)
    if ground is None or _lies_on_a_desk(small, palette.colours[ground]):
        return None
    parts, amiss = _parts(blended, palette)
    for _ in range(_LACKING):
        if amiss is None:
            break
        palette = palette.with_colour(amiss)
        parts, amiss = _parts(blended, palette)
    if amiss is not None:
        return None
    labels = _enlarged(parts, palette, ground)
    return _painted(labels, palette, ground)


def _premultiplied(small: NDArray[np.float32]) -> NDArray[np.float32]:
    alpha = small[..., 3:] if small.shape[2] == 4 else np.full_like(small[..., :1], 255)
    return np.concatenate([small[..., :3] * (alpha / 255), alpha], axis=2)


def _palette(blended: NDArray[np.float32]) -> _Palette | None:
    """Return the colours of evenly painted areas; None if these are not flat, or too many."""
    high = scipy.ndimage.maximum_filter(blended, (3, 3, 1))
    low = scipy.ndimage.minimum_filter(blended, (3, 3, 1))
    even = (high - low).max(axis=2) < _EVEN
    if not even.any():
        return None
    colours = blended[even]
    bins = (colours / _BIN).astype(np.intp)
    counts = np.zeros((256 // _BIN,) * 4, np.intp)
    np.add.at(counts, tuple(bins.T), 1)
    least = max(6, _SHARE * len(colours))
    # What lies in bins side by side is one colour.
    clusters, count = scipy.ndimage.label(counts >= least / 4, np.ones((3, 3, 3, 3)))
    of = clusters[tuple(bins.T)] - 1
    sizes = np.bincount(of[of >= 0], minlength=count)
    kept = np.flatnonzero(sizes >= least)
    if not 2 <= len(kept) <= _MOST:
        return None
    means = np.stack([np.median(colours[of == one], axis=0) for one in kept]).astype(np.float32)
    for one, mean in zip(kept, means, strict=True):
        strays = ((colours[of == one] - mean) ** 2).mean(axis=0).max() ** 0.5
        if strays > _SPREAD:
            return None
    renumbered = np.full(count + 1, -1)
    renumbered[kept] = np.arange(len(kept))
    number = np.full(even.shape, -1)
    number[even] = np.where(of >= 0, renumbered[of], -1)
    return _Palette(means, sizes[kept], number)


def _is_veiled(palette: _Palette) -> bool:
    """Whether something is half transparent, which may be paper or a part of the drawing."""
    alpha = palette.colours[:, 3]
    return bool(((alpha > _CLEAR) & (alpha < _SOLID)).any())


def _ground(palette: _Palette, blended: NDArray[np.float32]) -> int | None:
    """Return the number of the colour all around; None if there is none."""
    away = np.linalg.norm(palette.colours[:, None, None] - blended, axis=3)
    on_rim = np.concatenate([away[:, 0], away[:, -1], away[:, :, 0], away[:, :, -1]], axis=1)
    if (palette.colours[:, 3] < _CLEAR).any():
        return int(palette.colours[:, 3].argmin())
    shares = (on_rim < _ASTRAY).mean(axis=1)
    paper = (palette.colours.min(axis=1) > _PAPER) & (shares > _AT_RIM)
    if shares.max() > _AROUND or not paper.any():
        return int(shares.argmax()) if shares.max() > _AROUND else None
    return int(np.where(paper, shares, 0).argmax())


def _lies_on_a_desk(small: NDArray[np.float32], ground: NDArray[np.float32]) -> bool:
    """Whether it is a sheet of paper; a ground as white as that is no desk."""
    if small.shape[2] == 4 or ground.min() > _PAPER:
        return False
    return sheet_on_desk(small / np.float32(255)) is not None


def _parts(
    blended: NDArray[np.float32], palette: _Palette
) -> tuple[NDArray[np.float32], NDArray[np.float32] | None]:
    """Return how much of each pixel has each colour, (k, h, w), and a colour that is lacking."""
    count = len(palette.colours)
    parts = (np.arange(count)[:, None, None] == palette.number).astype(np.float32)
    near = np.stack([scipy.ndimage.maximum_filter(one, _NEAR) for one in parts]) > 0
    mixed = palette.number < 0
    pixels, beside = blended[mixed], near[:, mixed]
    best = np.full(len(pixels), np.inf, np.float32)
    first, second = np.zeros((2, len(pixels)), np.intp)
    share = np.zeros(len(pixels), np.float32)
    missed = best.copy()
    for one in range(count):
        for other in range(one):
            way = palette.colours[one] - palette.colours[other]
            at = np.clip((pixels - palette.colours[other]) @ (way / (way @ way)), 0, 1)
            rest = pixels - palette.colours[other] - at[:, None] * way
            away = (rest**2).sum(axis=1)
            absent = (~beside[one] & (at > 0.1)) + 1 * (~beside[other] & (at < 0.9))
            cost = away + absent * _ABSENT**2
            better = cost < best
            best = np.where(better, cost, best)
            missed = np.where(better, away, missed)
            first, second = np.where(better, one, first), np.where(better, other, second)
            share = np.where(better, at, share)
    drawn = (palette.number != palette.counts.argmax()).sum()
    lacking = None
    if (missed > _ASTRAY**2).sum() > _MISSED * drawn:
        lacking = pixels[missed.argmax()]  # the farthest from all others blends the least
    values = np.zeros((count, len(pixels)), np.float32)
    index = np.arange(len(pixels))
    values[first, index] = share
    values[second, index] += 1 - share
    parts[:, mixed] = values
    return parts, lacking


def _enlarged(parts: NDArray[np.float32], palette: _Palette, ground: int) -> NDArray[np.intp]:
    """Return the number of the colour of each pixel (SIDE, SIDE), fitted to the drawing."""
    drawn = parts[ground] < 0.5
    rows, columns = np.flatnonzero(drawn.any(axis=1)), np.flatnonzero(drawn.any(axis=0))
    if not len(rows):
        return np.full((SIDE, SIDE), ground)
    top, bottom, left, right = rows[0], rows[-1] + 1, columns[0], columns[-1] + 1
    pad = 2
    crop = np.stack(
        [
            np.pad(one[top:bottom, left:right], pad, constant_values=number == ground)
            for number, one in enumerate(parts)
        ],
        axis=2,
    )
    scale = _FILLED * SIDE / max(bottom - top, right - left)
    shape = tuple(max(1, round(side * scale)) for side in crop.shape[:2])
    best = np.full(shape, -np.inf, np.float32)
    labels = np.full(shape, ground)
    for number in range(len(parts)):
        here = resized(crop[..., number], shape)
        labels = np.where(here > best, number, labels)
        best = np.maximum(here, best)
    square = np.full((SIDE, SIDE), ground)
    labels = labels[:SIDE, :SIDE] if max(shape) > SIDE else labels
    y, x = ((SIDE - side) // 2 for side in labels.shape)
    square[y : y + labels.shape[0], x : x + labels.shape[1]] = labels
    return square


def _painted(labels: NDArray[np.intp], palette: _Palette, ground: int) -> NDArray[np.uint8] | None:
    """Return the drawing without what of its ground is outside; None if it has one colour."""
    pieces, _ = scipy.ndimage.label(labels == ground)
    inside = pieces != pieces[0, 0]
    if palette.colours[ground, 3] < _CLEAR:
        inside = labels != ground
    counts = np.bincount(labels[inside], minlength=len(palette.colours))
    counts[ground] = 0
    most = counts.argmax()
    others = np.linalg.norm(palette.colours - palette.colours[most], axis=1) > _APART
    if counts[others].sum() < max(1, _PART * counts.sum()):
        return None
    colours = np.clip(np.rint(palette.colours), 0, 255).astype(np.uint8)
    painted = colours[labels]
    painted[..., 3] = np.where(inside, 255, 0)
    painted[~inside, :3] = 0
    return painted
