"""Which of two layers occludes the other, told by the junctions of their contours.

Where three areas meet, that of the uppermost layer is bounded by one smooth contour, beneath which
the contour between the two others ends: it takes up about half of what is around the junction.
"""

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

Seen = NDArray[np.int16]
"""(h, w), the number of the layer that is seen in each pixel."""
Integers = NDArray[np.int64]
Bitmap = NDArray[np.bool_]

_RADIUS = 80, 4
"""Of what is looked at around a junction: a part of the image's side, and pixels at least."""
_HALF = 0.4, 0.62
"""How much of it the uppermost layer takes up."""
_LEAST, _LESS = 0.08, 0.08
"""How much of it both others do, at least, and by how much less than it: what meets at a narrow
angle tells little."""
_MAJORITY = 3
"""How many times as many junctions tell so as tell the opposite."""
_FEWEST = 2
"""Junctions that tell anything."""


def occlusions(seen: Seen, count: int) -> Integers:
    """Return (count, count) at how many junctions a layer lies over another."""
    votes = np.zeros((count, count), np.int64)
    bits = (np.uint32(1) << seen.astype(np.uint32)).astype(np.uint32)
    padded = np.pad(bits, 1, mode="edge")
    rows, columns = seen.shape
    around = np.zeros_like(bits)
    for down in range(3):
        for right in range(3):
            around |= padded[down : down + rows, right : right + columns]
    many = sum(((around >> np.uint32(n)) & 1).astype(np.uint8) for n in range(count)) >= 3
    places, found = ndimage.label(many, np.ones((3, 3)))
    if not found:
        return votes
    radius = max(_RADIUS[1], max(seen.shape) // _RADIUS[0])
    y, x = np.mgrid[-radius : radius + 1, -radius : radius + 1]
    disc = np.hypot(y, x) <= radius
    wide = np.pad(seen, radius, constant_values=-1)
    for middle in ndimage.center_of_mass(many, places, range(1, found + 1)):
        row, column = np.rint(middle).astype(int)
        around_it = wide[row : row + 2 * radius + 1, column : column + 2 * radius + 1][disc]
        if (around_it < 0).any():
            continue
        shares = np.bincount(around_it, minlength=count) / len(around_it)
        upper = int(shares.argmax())
        others = np.flatnonzero(shares >= _LEAST)
        others = others[others != upper]
        clear = shares[upper] - shares[others].max(initial=0) >= _LESS
        if len(others) == 2 and clear and _HALF[0] <= shares[upper] <= _HALF[1]:
            votes[upper, others] += 1
    return votes


def order_of(votes: Integers, sizes: Integers) -> Integers:
    """Return layers from the lowest up, the ground, 0, first; of two that may be, the larger one.

    Parameters
    ----------
    votes
        Of ``occlusions``.
    sizes
        In pixels.
    """
    above = hides(votes)
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
    many = votes >= _FEWEST
    many[0] = many[:, 0] = False
    contested: Bitmap = many & many.T & ~hides(votes) & ~hides(votes).T
    return contested
