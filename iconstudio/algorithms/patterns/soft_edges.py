"""Soft edges: of the colours nearest to a pixel, the two that blend to it."""

from collections.abc import Iterator
from itertools import combinations
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from iconstudio.algorithms.patterns.clusters import Numbers, Pixels
from iconstudio.algorithms.scanning.blending import unblended

_EDGE = 4
"""Pixels from an area of even colour, in which its soft edge lies."""
_FARTHER = 3.0
"""Levels that it counts as much as, if a colour is a pixel farther off than the nearest."""
_THIRD = 12.0
"""Levels that it counts as much as, if three colours blend rather than two."""


class Blends(NamedTuple):
    """What pixels blend."""

    first: Numbers
    second: Numbers
    share: NDArray[np.float32]
    """Of the first, from 0.5 to 1."""
    stray: NDArray[np.float32]
    """By how many levels they stray from that."""

    def of(self, which: NDArray[np.bool_]) -> "Blends":
        """Return those of some pixels."""
        return Blends(self.first[which], self.second[which], self.share[which], self.stray[which])

    def put(self, at: tuple[NDArray[np.intp], ...] | NDArray[np.bool_], others: "Blends") -> None:
        """Put those of some pixels in place of their own."""
        self.first[at], self.second[at] = others.first, others.second
        self.share[at], self.stray[at] = others.share, others.stray


def nearest_colours(cores: Numbers) -> Numbers:
    """Return the colour of the even area that is nearest to each pixel."""
    nearest = ndimage.distance_transform_edt(cores < 0, return_distances=False, return_indices=True)
    numbers: Numbers = cores[tuple(nearest)]
    return numbers


def blends_of(pixels: Pixels, cores: Numbers) -> Blends:
    """Return what each pixel blends. Off all areas of even colour, it has that of the nearest."""
    first = nearest_colours(cores)
    share, stray = np.ones(first.shape, np.float32), np.full(first.shape, 255, np.float32)
    stray[cores >= 0] = 0
    blends = Blends(first, first.copy(), share, stray)
    rows, columns = np.nonzero(cores < 0)
    for some in np.array_split(np.arange(len(rows)), max(1, len(rows) // 100_000)):
        at = rows[some], columns[some]
        found = _unblended(pixels, cores, *at)
        inside = found.first >= 0
        at = at[0][inside], at[1][inside]
        blends.put(at, found.of(inside))
    return blends


def _unblended(
    pixels: Pixels, cores: Numbers, rows: NDArray[np.intp], columns: NDArray[np.intp]
) -> Blends:
    """Return what some pixels (n,) blend; -1 for those far from all areas of even colour."""
    numbers, colours, away = three_nearest(pixels, cores, rows, columns)
    own = pixels[rows, columns].astype(np.float32)
    first, second = np.full((2, len(rows)), -1, np.int16)
    share = np.ones(len(rows), np.float32)
    best = np.full(len(rows), np.inf, np.float32)
    stray = best.copy()
    for size in (1, 2, 3):
        for some in map(list, combinations(range(3), size)):
            there = (numbers[some] >= 0).all(axis=0)
            shares, off = unblended(own, [colours[one] for one in some])
            farther = np.float32(_FARTHER) * (away[some[-1]] - away[0])
            cost = np.where(there, off + farther**2 + (_THIRD**2 if size == 3 else 0), np.inf)
            better = cost < best
            at = np.flatnonzero(better)
            parts, own_numbers = shares[:, at], numbers[some][:, at]
            large, n = parts.argmax(axis=0), np.arange(len(at))
            first[at], whole = own_numbers[large, n], parts[large, n]
            parts[large, n] = -1 if size > 1 else 1
            small = parts.argmax(axis=0)
            second[at] = own_numbers[small, n]
            share[at] = whole / (whole + parts[small, n]) if size > 1 else 1
            stray, best = np.where(better, np.sqrt(off), stray), np.where(better, cost, best)
    return Blends(first, second, share, stray)


def three_nearest(
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
