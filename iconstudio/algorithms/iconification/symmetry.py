"""The symmetry constraint (section 3.4, equation 9): a site and its mirror image share a source.

The infinite cost of equation 9 is exact when both are one node of the graph; ``mirrored`` says
which these are. Only the source *positions* are symmetric, not the pixels.
"""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.raster import Scalar, overlap
from iconstudio.model import CANVAS, Axis

NEARLY = 0.9
"""Overlap with the own mirror image from which on a shape counts as nearly symmetric."""
ROUGHLY = 0.75
"""The same for one that is drawn by hand: a hat has 0.77 so, a house 0.78, a bell 0.82."""


def reflected(picture: NDArray[Scalar], axis: Axis) -> NDArray[Scalar]:
    """Return the mirror image of a square picture (..., n, n), as a view."""
    match axis:
        case Axis.HORIZONTAL:
            return picture[..., ::-1]
        case Axis.VERTICAL:
            return picture[..., ::-1, :]
        case Axis.DIAGONAL:
            return picture.swapaxes(-1, -2)
        case Axis.ANTIDIAGONAL:
            return picture[..., ::-1, ::-1].swapaxes(-1, -2)


def mirrored(side: int, axis: Axis) -> NDArray[np.int64]:
    """Return r_i, the mirror image of each site of a square, (side * side,).

    >>> mirrored(2, Axis.HORIZONTAL)
    array([1, 0, 3, 2])
    """
    return reflected(np.arange(side * side).reshape(side, side), axis).ravel()


def likeness(shape: NDArray[np.bool_], axis: Axis) -> float:
    """Return intersection over union of a shape (n, n) bool and its mirror image."""
    return overlap(shape, reflected(shape, axis))


def propose(shape: NDArray[np.bool_], least: float = NEARLY) -> Axis | None:
    """Return the axis about which a filled shape (n, n) bool is nearly symmetric, if any.

    It overlaps its mirror image by ``least`` or more.
    Of several (a disc has all) the most symmetric; of equals the first in the order of ``Axis``.
    """
    best = max(Axis, key=lambda axis: round(likeness(shape, axis), 2))
    return best if likeness(shape, best) >= least else None


def flipped(picture: NDArray[Scalar], aside: int = 0) -> NDArray[Scalar]:
    """Return the mirror image, left to right, of a picture (m, m); its edges go on.

    The axis lies by half of ``aside``, in canvas pixels, to the right of the canvas's.
    """
    m = len(picture)
    columns = m - 1 + aside * m // CANVAS - np.arange(m)
    return picture[:, np.clip(columns, 0, m - 1)]


def mirrored_halves(
    labels: NDArray[np.uint8], twins: NDArray[np.uint8], aside: int = 0
) -> Iterator[NDArray[np.uint8]]:
    """Yield a labelling (m, m) with its left half mirrored onto the right one, and the reverse.

    An addition to the paper: the pixels are symmetric, too. ``twins`` (K,) are the numbers of the
    sources' mirror images, and ``aside`` tells the axis as in ``flipped``.
    """
    twice = len(labels) + aside * len(labels) // CANVAS
    other = flipped(twins[labels], aside)
    left, right = (twice + 1) // 2, twice // 2
    yield np.concatenate([labels[:, :left], other[:, left:]], axis=1)
    yield np.concatenate([other[:, :right], labels[:, right:]], axis=1)
