"""The flat colours of an image, and which of them each pixel shows or blends.

Areas of even colour are found first; those that go over into each other, as a gradient does, are
one. Lines too thin for an even area show by pixels that no two colours beside them blend to. Every
other pixel is of a soft edge: of the colours nearest to it, the two that blend to it tell where the
edge runs, finer than pixels, and no third colour appears between two.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from skimage.measure import label

from iconstudio.algorithms.extremes import maximum_filter, minimum_filter
from iconstudio.algorithms.patterns.clusters import (
    EXACT,
    FEWEST,
    LEAST,
    LOSSY,
    MOST,
    Lab,
    Limits,
    Numbers,
    Pixels,
    clustered,
    sums_of,
)
from iconstudio.algorithms.patterns.soft_edges import Blends, blends_of, nearest_colours
from iconstudio.algorithms.patterns.thin_lines import lines_of
from iconstudio.algorithms.tones.regions import cielab
from iconstudio.model import IconstudioError

_NOISY = 0.05
"""How much of an image differs from what is beside it, but by less than at an edge, if it has noise
or was compressed with losses."""
_EVEN_LEAST = 0.1
"""So much of an image has to be of even colour."""
_TOUCHING = 8, 0.25
"""Areas with more sides of pixels between them than that, and than so many roots of the smaller's
pixels, go over into each other."""
_UNKNOWN_MOST = 0.35
"""How much of an image may be neither of even colour nor blends."""
_PHOTOGRAPH = 30, 0.15, 40
"""A photograph strays from flat colours by so many levels in so much of it; and so many pixels has
less than half of its areas."""
_GRADIENT = 64, 32
"""A colour is that of a gradient if it has so many even pixels, and nine in ten of them differ by
more than so many levels."""
_SPECK = 6
"""Pixels of one colour that are none."""


@dataclass(frozen=True, slots=True, eq=False)
class FlatColours:
    """An image in k flat colours."""

    colours: NDArray[np.uint8]
    """(k, 3), red, green and blue."""
    first: Numbers
    """(h, w), the colour of which each pixel shows most,"""
    second: Numbers
    """and the one that it blends with it."""
    share: NDArray[np.float32]
    """(h, w), how much of the pixel has the first, from 0.5 to 1."""

    def coverage(self, which: NDArray[np.bool_]) -> NDArray[np.float32]:
        """Return how much of each pixel some of the colours (k,) cover, from 0 to 1."""
        rest = np.where(which[self.second], 1 - self.share, np.float32(0))
        covered: NDArray[np.float32] = np.where(which[self.first], self.share, 0) + rest
        return covered


def flat_colours(pixels: Pixels, count: int | None = None) -> FlatColours:
    """Return the colours of an image, the commonest first, and where they are.

    Parameters
    ----------
    count
        How many colours there are at most; None: as many as cover enough, up to ``MOST``.

    Raises
    ------
    IconstudioError
        If it is no image in flat colours, or has only one.
    """
    lab = cielab(pixels)
    noisy = is_noisy(pixels)
    limits = LOSSY if noisy else EXACT
    cores = _cores(lab, limits, count)
    blends = blends_of(pixels, cores)
    palette = [np.median(pixels[cores == one], axis=0) for one in range(int(cores.max()) + 1)]
    more = MOST - len(palette) if count is None else 0
    lines = lines_of(pixels, cores, palette, blends.stray, limits, more)
    if lines is not None:
        palette += lines.colours
        number, ridge = lines.number, lines.number >= 0
        blends = blends_of(pixels, np.where(ridge, number, cores))
        beside = nearest_colours(cores)[ridge]
        own = Blends(number[ridge], beside, lines.share[ridge], blends.stray[ridge])
        blends.put(ridge, own)
    first, second, share, stray = blends
    if ((cores < 0) & (stray > 2 * limits.stray)).mean() > _UNKNOWN_MOST:
        raise _no_flat_colours()
    _without_specks(first, second, share)
    kept = np.unique(first)
    if len(kept) < 2:
        raise IconstudioError("The exemplar has only one colour. Give one with a drawing on it.")
    renamed = np.full(MOST + 1, -1, np.int16)
    renamed[kept] = np.arange(len(kept))
    first = renamed[first]
    second = np.where(renamed[second] < 0, first, renamed[second])
    colours = np.rint(np.array(palette)[kept]).astype(np.uint8)
    if noisy and _is_photograph(pixels, colours[first], first):
        raise _no_flat_colours()
    return FlatColours(colours, first, second, share)


def _no_flat_colours() -> IconstudioError:
    return IconstudioError(
        "The image has no areas of even colour to separate: it is a photograph, or noise. "
        "Give one in flat colours, such as a drawing."
    )


# -- areas of even colour --------------------------------------------------------------------------


def is_noisy(pixels: Pixels) -> bool:
    """Whether an image has noise, or was compressed with losses."""
    spread = _spread(cielab(pixels))
    slight = ((spread > 0) & (spread < EXACT.even)).mean()
    return bool(slight > _NOISY or np.median(spread) > EXACT.even)


def is_grainy(pixels: Pixels) -> bool:
    """Whether noise is in all of an image, so strong that no area is even."""
    return bool(np.median(_spread(cielab(pixels))) > EXACT.even)


def has_gradient(pixels: Pixels, flat: FlatColours) -> bool:
    """Whether the image differs much within one of its flat colours."""
    even = minimum_filter(flat.share, 3) >= 1
    fewest, levels = _GRADIENT
    for number in range(len(flat.colours)):
        own = pixels[even & (flat.first == number)]
        if len(own) >= fewest:
            low, high = np.percentile(own, (5, 95), axis=0)
            if (high - low).max() > levels:
                return True
    return False


def _is_photograph(pixels: Pixels, flat: Pixels, first: Numbers) -> bool:
    """Whether an image strays much from its flat colours, and most areas of these are small."""
    stray = np.abs(pixels.astype(np.int16) - flat).max(axis=2) > _PHOTOGRAPH[0]
    sizes = np.bincount(label(first + 1, connectivity=2).ravel())
    return bool(stray.mean() > _PHOTOGRAPH[1] and np.median(sizes) < _PHOTOGRAPH[2])


def _spread(lab: Lab) -> NDArray[np.float32]:
    """Return by how much a channel differs within three pixels (h, w), at most."""
    spread: NDArray[np.float32] = np.max(
        [maximum_filter(one, 3) - minimum_filter(one, 3)
         for one in np.moveaxis(lab, 2, 0)],
        axis=0,
    )  # fmt: skip
    return spread


def _cores(lab: Lab, limits: Limits, count: int | None) -> Numbers:
    """Return the colours of the pixels in areas of even colour; -1 of all others."""
    even = _spread(lab) < limits.even
    if even.mean() < _EVEN_LEAST:
        raise _no_flat_colours()
    least = max(FEWEST, LEAST * even.size)
    numbers = np.full(even.shape, -1, np.int16)
    numbers[even] = clustered(lab[even], np.ones(int(even.sum())), least / 4, limits.alike, None)
    areas = label(numbers + 1, connectivity=1).astype(np.int64)
    areas = _flowing(areas, even)[areas]
    sizes = np.bincount(areas.ravel())
    sizes[0] = 0
    means = sums_of(areas.ravel(), lab.reshape(-1, 3)) / np.maximum(sizes, 1)[:, None]
    colours = np.full(len(sizes), -1, np.int16)
    known = sizes > 0
    colours[known] = clustered(means[known], sizes[known], least, limits.alike, count)
    cores: Numbers = colours[areas]
    return cores


def _flowing(areas: NDArray[np.int64], even: NDArray[np.bool_]) -> NDArray[np.int64]:
    """Return which areas are one: between those of flat colours is an edge, which is not even."""
    count = int(areas.max()) + 1
    ends = []
    for one, other in ((np.s_[:, :-1], np.s_[:, 1:]), (np.s_[:-1], np.s_[1:])):
        meet = (areas[one] != areas[other]) & even[one] & even[other]
        ends.append(np.sort(np.stack([areas[one][meet], areas[other][meet]]), axis=0))
    pairs, sides = np.unique(np.concatenate(ends, axis=1), axis=1, return_counts=True)
    sizes = np.bincount(areas.ravel(), minlength=count)
    fewest, factor = _TOUCHING
    many = sides > np.maximum(fewest, factor * np.sqrt(sizes[pairs].min(axis=0)))
    many &= pairs[0] > 0
    graph = coo_array((np.ones(int(many.sum())), pairs[:, many]), (count, count))
    return np.asarray(connected_components(graph, directed=False)[1], np.int64)


def _without_specks(first: Numbers, second: Numbers, share: NDArray[np.float32]) -> None:
    """Give specks, in place, to what is around them."""
    pieces = label(first + 1, connectivity=2)
    specks = np.bincount(pieces.ravel())[pieces] < _SPECK
    if specks.any() and not specks.all():
        nearest = tuple(
            ndimage.distance_transform_edt(specks, return_distances=False, return_indices=True)
        )
        for numbers in (first, second):
            numbers[specks] = first[nearest][specks]
        share[specks] = 1
