"""Which of two layers occludes the other, told by the junctions of their contours.

Where three areas meet, the contour of the uppermost layer goes on smoothly; beneath it ends the
contour between the two others, so that theirs make a corner.
"""

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage
from scipy.spatial import cKDTree

from iconstudio.algorithms.patterns.completion import Mask, Points, outlines_of

Seen = NDArray[np.int16]
"""(h, w), the number of the layer that is seen in each pixel."""
Integers = NDArray[np.int64]
Bitmap = NDArray[np.bool_]

_NEAR = 2.5
"""Pixels from a junction to the contours that meet there, at most."""
_REACH = 64, 6
"""Of a contour, so much to either side of a junction is looked at: a part of the image's side, and
pixels at least."""
_SMOOTH, _CORNER = np.radians([20.0, 25.0])
"""By how much a contour turns that goes on smoothly, at most, and by how much more one at a corner
does, at least."""
_MAJORITY = 2
"""How many times as many junctions tell so as tell the opposite."""
_MINORITY = 0.15
"""How many, of those that tell the opposite, tell that layers hide each other."""
_FEWEST = 2
"""Junctions that tell anything."""


def occlusions(seen: Seen, coverage: NDArray[np.float32]) -> Integers:
    """Return (n, n) at how many junctions a layer lies over another.

    Parameters
    ----------
    seen
        Which of n layers is seen where.
    coverage
        (n, h, w), how much of each pixel each covers, from 0 to 1.
    """
    count = len(coverage)
    votes = np.zeros((count, count), np.int64)
    junctions = _junctions(seen, count)
    if not junctions:
        return votes
    contours = [_Contours(one) for one in coverage]
    reach = round(max(_REACH[1], max(seen.shape) / _REACH[0]))
    for middle, layers in junctions:
        turns = np.array([contours[one].turn(middle, reach) for one in layers])
        upper = int(turns.argmin())
        others = np.delete(np.arange(len(layers)), upper)
        if turns[upper] < _SMOOTH and turns[others].min() > turns[upper] + _CORNER:
            votes[layers[upper], layers[others]] += 1
    return votes


def _junctions(seen: Seen, count: int) -> list[tuple[complex, Integers]]:
    """Return where three layers meet, as x + iy in pixels, and which."""
    bits = np.left_shift(np.uint64(1), seen.astype(np.uint64))
    padded = np.pad(bits, 1, mode="edge")
    rows, columns = seen.shape
    around = np.zeros_like(bits)
    for down in range(3):
        for right in range(3):
            around |= padded[down : down + rows, right : right + columns]
    three = sum(((around >> np.uint64(n)) & np.uint64(1)) for n in range(count)) == 3
    places, found = ndimage.label(three, np.ones((3, 3)))
    junctions = []
    for number, (row, column) in enumerate(
        ndimage.center_of_mass(three, places, range(1, found + 1)), start=1
    ):
        box = np.bitwise_or.reduce(around[places == number])
        layers = np.flatnonzero([(int(box) >> n) & 1 for n in range(count)])
        if len(layers) == 3:
            junctions.append((complex(column, row), layers))
    return junctions


class _Contours:
    """The contours of a layer, by where they are."""

    def __init__(self, coverage: Mask) -> None:
        self._outlines: list[Points] = outlines_of(coverage)
        self._shape = coverage.shape
        points = np.concatenate([np.zeros(0, complex), *self._outlines])
        sizes = [len(one) for one in self._outlines]
        self._number = np.repeat(np.arange(len(sizes)), sizes)
        self._index = np.concatenate([np.zeros(0, int), *map(np.arange, sizes)])
        self._tree = cKDTree(np.stack([points.real, points.imag], axis=1)) if len(points) else None

    def turn(self, middle: complex, reach: int) -> float:
        """Return by how many radians the contour at a junction turns; pi if that is not known."""
        away, nearest = np.inf, 0
        if self._tree is not None:
            away, nearest = self._tree.query((middle.real, middle.imag))
        rows, columns = self._shape
        edge = min(middle.real, middle.imag, columns - 1 - middle.real, rows - 1 - middle.imag)
        if away > _NEAR or edge < reach:
            return float(np.pi)
        outline, index = self._outlines[self._number[nearest]], int(self._index[nearest])
        if len(outline) < 3 * reach:
            return float(np.pi)
        near, far = (_turn(outline, index, step) for step in (reach // 2, 2 * (reach // 2)))
        return abs(2 * near - far)  # what a curve turns, it turns by twice as much in twice as far


def _turn(outline: Points, index: int, step: int) -> float:
    """Return by how many radians an outline turns at a point, between those so far off."""
    before, at, after = outline.take((index - step, index, index + step), mode="wrap")
    return float(np.angle((after - at) * np.conj(at - before)))


def order_of(votes: Integers, sizes: Integers) -> Integers:
    """Return layers from the lowest up, the ground, 0, first; of two that may be, the larger one.

    Parameters
    ----------
    votes
        Of ``occlusions``.
    sizes
        In pixels.
    """
    above = votes > votes.T
    left = list(range(1, len(sizes)))
    order = [0]
    while left:
        lowest = min(left, key=lambda one: (above[one, left].sum(), -sizes[one]))
        left.remove(lowest)
        order.append(lowest)
    return np.array(order)


def hides(votes: Integers) -> Bitmap:
    """Return (count, count) which layers hide others; the ground, 0, is none."""
    hiding: Bitmap = (votes >= _FEWEST) & (votes >= _MAJORITY * votes.T)
    hiding[0] = hiding[:, 0] = False
    return hiding


def contests(votes: Integers) -> Bitmap:
    """Return (count, count) which hide each other, one here and the other there."""
    many = votes >= np.maximum(_FEWEST, _MINORITY * votes.T)
    many[0] = many[:, 0] = False
    contested: Bitmap = many & many.T
    return contested
