"""The flat colours of an image, and which of them each pixel shows or blends.

Areas of even colour are found first; those that go over into each other, as a gradient does, are
one. Lines too thin for an even area show by pixels that no two colours beside them blend to. Every
other pixel is of a soft edge: of the colours nearest to it, the two that blend to it tell where the
edge runs, finer than pixels, and no third colour appears between two.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from skimage.measure import label

from iconstudio.algorithms.scanning.blending import unblended
from iconstudio.algorithms.tones.regions import cielab
from iconstudio.model import IconstudioError

Pixels = NDArray[np.uint8]
"""(h, w, 3), red, green and blue."""
Numbers = NDArray[np.int16]
"""(h, w), the number of a colour; -1 for none."""
Lab = NDArray[np.float32]
"""(..., 3), CIELAB."""

MOST = 32
"""Colours."""
_NOISY = 0.05
"""How much of an image differs from what is beside it, but by less than at an edge, if it has noise
or was compressed with losses."""
_EVEN_LEAST = 0.1
"""So much of an image has to be of even colour."""
_LEAST, _FEWEST = 0.0015, 12
"""A colour has so much of the image at least, and so many pixels."""
_TOUCHING = 8, 0.25
"""Areas with more sides of pixels between them than that, and than so many roots of the smaller's
pixels, go over into each other."""
_EDGE = 4
"""Pixels from an area of even colour, in which its soft edge lies."""
_FARTHER = 3.0
"""Levels that it counts as much as, if a colour is a pixel farther off than the nearest."""
_UNKNOWN_MOST = 0.35
"""How much of an image may be neither of even colour nor blends."""
_SPECK = 6
"""Pixels of one colour that are none."""


class _Limits(NamedTuple):
    even: float
    """In areas of even colour, the channels of CIELAB differ by less within three pixels."""
    alike: float
    """Colours that differ by less, by their distance in CIELAB, are one."""
    stray: float
    """Levels by which a pixel of a soft edge strays from the blend of two colours, at most."""


_EXACT = _Limits(5.0, 7.0, 24.0)
_LOSSY = _Limits(10.0, 14.0, 48.0)


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
    limits = _LOSSY if is_noisy(pixels) else _EXACT
    cores = _cores(lab, limits, count)
    blends = _blends(pixels, cores)
    lines = _lines(lab, cores, blends, limits, count)
    if lines is not None:
        cores = lines
        blends = _blends(pixels, cores)
    first, second, share, stray = blends
    if ((cores < 0) & (stray > 2 * limits.stray)).mean() > _UNKNOWN_MOST:
        raise _no_flat_colours()
    _without_specks(first, second, share)
    kept = np.unique(first[cores >= 0])
    if len(kept) < 2:
        raise IconstudioError("The exemplar has only one colour. Give one with a drawing on it.")
    colours = [np.median(pixels[(cores == one) & (first == one)], axis=0) for one in kept]
    renamed = np.full(MOST + 1, -1, np.int16)
    renamed[kept] = np.arange(len(kept))
    first = renamed[first]
    second = np.where(renamed[second] < 0, first, renamed[second])
    return FlatColours(np.rint(colours).astype(np.uint8), first, second, share)


def _no_flat_colours() -> IconstudioError:
    return IconstudioError(
        "The image has no areas of even colour to separate: it is a photograph, or noise. "
        "Give one in flat colours, such as a drawing."
    )


# -- areas of even colour --------------------------------------------------------------------------


def is_noisy(pixels: Pixels) -> bool:
    """Whether an image has noise, or was compressed with losses."""
    spread = _spread(cielab(pixels))
    return bool(((spread > 0) & (spread < _EXACT.even)).mean() > _NOISY)


def _spread(lab: Lab) -> NDArray[np.float32]:
    """Return by how much a channel differs within three pixels (h, w), at most."""
    spread: NDArray[np.float32] = np.max(
        [ndimage.maximum_filter(one, 3) - ndimage.minimum_filter(one, 3)
         for one in np.moveaxis(lab, 2, 0)],
        axis=0,
    )  # fmt: skip
    return spread


def _cores(lab: Lab, limits: _Limits, count: int | None) -> Numbers:
    """Return the colours of the pixels in areas of even colour; -1 of all others."""
    even = _spread(lab) < limits.even
    if even.mean() < _EVEN_LEAST:
        raise _no_flat_colours()
    least = max(_FEWEST, _LEAST * even.size)
    numbers = np.full(even.shape, -1, np.int16)
    numbers[even] = _clustered(lab[even], np.ones(int(even.sum())), least / 4, limits.alike, None)
    areas = label(numbers + 1, connectivity=1).astype(np.int64)
    areas = _flowing(areas, even)[areas]
    sizes = np.bincount(areas.ravel())
    sizes[0] = 0
    means = (
        np.stack([np.bincount(areas.ravel(), lab[..., n].ravel()) for n in range(3)], axis=1)
        / np.maximum(sizes, 1)[:, None]
    )
    colours = np.full(len(sizes), -1, np.int16)
    known = sizes > 0
    colours[known] = _clustered(means[known], sizes[known], least, limits.alike, count)
    return colours[areas]


def _clustered(
    lab: NDArray[np.floating],
    weights: NDArray[np.floating],
    least: float,
    alike: float,
    count: int | None,
) -> Numbers:
    """Return which colour each of some (n, 3) belongs to, from the commonest, 0, down.

    One that is far from all that are common enough has -1, unless there may be only ``count``.
    """
    bins = np.rint(lab / (alike / 4)).astype(np.int64) + 200
    code, which = np.unique((bins * [1 << 20, 1 << 10, 1]).sum(axis=1), return_inverse=True)
    sizes = np.bincount(which, weights)
    means = np.stack([np.bincount(which, weights * one) for one in lab.T], axis=1)
    means /= np.maximum(sizes, 1e-9)[:, None]
    found = np.full(len(code), -1, np.int16)
    palette: list[NDArray[np.float64]] = []
    left = sizes.copy()
    while left.max() > 0 and len(palette) < (count or MOST):
        middle = means[left.argmax()]
        for _ in range(2):
            near = (left > 0) & (np.linalg.norm(means - middle, axis=1) < alike)
            if near.any():
                middle = np.average(means[near], axis=0, weights=sizes[near])
        near[left.argmax()] = True
        if sizes[near].sum() >= least:
            found[near] = len(palette)
            palette.append(middle)
        left[near] = 0
    if palette:
        away = np.linalg.norm(means[:, None] - np.array(palette), axis=2)
        near = away.min(axis=1) < (2 * alike if count is None else np.inf)
        found[near] = away.argmin(axis=1)[near]
    return found[which]


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
    return (
        connected_components(graph, directed=False)[1].astype(np.int64)
        if many.any()
        else (np.arange(count))
    )


# -- soft edges, and thin lines --------------------------------------------------------------------


def _blends(
    pixels: Pixels, cores: Numbers
) -> tuple[Numbers, Numbers, NDArray[np.float32], NDArray[np.float32]]:
    """Return first and second colours, the share of the first, and by how much each pixel strays.

    Off all areas of even colour, it is that of the nearest.
    """
    known = cores >= 0
    nearest = ndimage.distance_transform_edt(~known, return_distances=False, return_indices=True)
    first: Numbers = cores[tuple(nearest)]
    second, share = first.copy(), np.ones(first.shape, np.float32)
    stray = np.linalg.norm(pixels - pixels[tuple(nearest)].astype(np.float32), axis=2)
    rows, columns = np.nonzero(~known)
    for some in np.array_split(np.arange(len(rows)), max(1, len(rows) // 100_000)):
        at = rows[some], columns[some]
        found = _unblended(pixels, cores, *at)
        inside = found[0] >= 0
        at = at[0][inside], at[1][inside]
        first[at], second[at], share[at], stray[at] = (one[inside] for one in found)
    return first, second, share, stray.astype(np.float32)


def _unblended(
    pixels: Pixels, cores: Numbers, rows: NDArray[np.intp], columns: NDArray[np.intp]
) -> tuple[Numbers, Numbers, NDArray[np.float32], NDArray[np.float32]]:
    """Return what ``_blends`` does of some pixels (n,); -1 for those far from all even areas."""
    numbers, colours, away = _around(pixels, cores, rows, columns)
    own = pixels[rows, columns].astype(np.float32)
    none = np.full(len(rows), -1, np.int16)
    first, second, share = none, none.copy(), np.ones(len(rows), np.float32)
    best = np.full(len(rows), np.inf, np.float32)
    stray = best.copy()
    for size in (2, 1):
        for some in combinations(range(3), size):
            there = (numbers[list(some)] >= 0).all(axis=0)
            shares, off = unblended(own, [colours[one] for one in some])
            farther = np.float32(_FARTHER) * (away[some[-1]] - away[0])
            cost = np.where(there, off + farther**2, np.inf)
            better = cost < best
            larger = shares[0] >= 0.5
            one, other = numbers[some[0]], numbers[some[-1]]
            first = np.where(better, np.where(larger, one, other), first)
            second = np.where(better, np.where(larger, other, one), second)
            share = np.where(better, shares.max(axis=0), share)
            stray, best = np.where(better, np.sqrt(off), stray), np.where(better, cost, best)
    return first, second, share, stray


def _around(
    pixels: Pixels, cores: Numbers, rows: NDArray[np.intp], columns: NDArray[np.intp]
) -> tuple[Numbers, NDArray[np.float32], NDArray[np.float32]]:
    """Return the three colours of even areas that are nearest to some pixels, within ``_EDGE``.

    Their numbers (3, n), -1 for none; what they are in the nearest pixel, (3, n, 3); and how far
    that is, (3, n).
    """
    offsets = sorted(_disc(), key=lambda offset: offset[0] ** 2 + offset[1] ** 2)
    wide = np.pad(cores, _EDGE, constant_values=-1)
    numbers = np.full((3, len(rows)), -1, np.int16)
    places = np.zeros((3, 2, len(rows)), np.intp)
    away = np.zeros((3, len(rows)), np.float32)
    for down, right in offsets:
        there = wide[rows + down + _EDGE, columns + right + _EDGE]
        new = there >= 0
        for slot in range(3):
            taken = new & (numbers[slot] < 0)
            numbers[slot, taken] = there[taken]
            places[slot, 0, taken], places[slot, 1, taken] = (
                (rows + down)[taken],
                (columns + right)[taken],
            )
            away[slot, taken] = np.hypot(down, right)
            new &= numbers[slot] != there
    colours = pixels[places[:, 0], places[:, 1]].astype(np.float32)
    return numbers, colours, away


def _disc() -> Iterator[tuple[int, int]]:
    steps = range(-_EDGE, _EDGE + 1)
    return ((y, x) for y in steps for x in steps if y * y + x * x <= _EDGE * _EDGE)


def _lines(
    lab: Lab,
    cores: Numbers,
    blends: tuple[Numbers, Numbers, NDArray[np.float32], NDArray[np.float32]],
    limits: _Limits,
    count: int | None,
) -> Numbers | None:
    """Return the colours of even areas, and those of lines too thin for them; None without such.

    Along a line, the pixels that stray most from what is beside it have its colour.
    """
    stray = np.where(cores < 0, blends[3], 0)
    ridge = (stray > limits.stray) & (stray >= ndimage.maximum_filter(stray, 3) - 1)
    if not ridge.any():
        return None
    had = int(cores.max()) + 1
    means = np.stack([lab[cores == one].mean(axis=0) for one in range(had)])
    away = np.linalg.norm(lab[ridge][:, None] - means, axis=2)
    found = np.where(away.min(axis=1) < 1.5 * limits.alike, away.argmin(axis=1), -1).astype(
        np.int16
    )
    other = found < 0
    if other.any() and count is None:
        least = max(_FEWEST, _LEAST * cores.size)
        new = _clustered(
            lab[ridge][other], np.ones(int(other.sum())), least / 2, limits.alike, None
        )
        found[other] = np.where((new >= 0) & (new + had < MOST), new + had, -1)
    if (found < 0).all():
        return None
    with_lines = cores.copy()
    with_lines[ridge] = found
    return with_lines


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
