"""Which exemplars of a keyword are shaped unlike drawings of the thing itself (section 3.1).

What a keyword retrieves is not only the thing: a bicycle in a garage, and a wheel of it, are called
after it, too. A drawing of the thing looks like some of the others, at the same place.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from iconstudio.model import CANVAS

SIDE = 64
"""Silhouettes are compared on a canvas of so many pixels a side."""
NEAREST = 4
"""A drawing of the thing looks like so many others: it need not look like most of them, as a dog's
head is none less for all the whole dogs."""
FEWEST = 8
"""Of fewer drawings of the thing, none tells what it looks like."""
FAR = 0.34, 0.5
"""Unlikeness from which an exemplar is a stranger, at least and at most: in between it is SPREAD
deviations above the median of drawings of the thing. Chosen by eye over the icons of twenty-two
keywords."""
SPREAD = 3.0


def strangers(
    inks: Sequence[NDArray[np.bool_]], named: NDArray[np.bool_], doubtful: NDArray[np.bool_]
) -> NDArray[np.bool_]:
    """Return which of n exemplars are strangers, (n,) bool: by their names, or by their shapes.

    Parameters
    ----------
    inks
        Each (CANVAS, CANVAS).
    named
        (n,) bool: which ones' names say that they show something else, or more.
    doubtful
        (n,) bool: which ones' names say no more than that they may. Their shapes, and those of the
        ``named``, do not count as the thing's.
    """
    things = ~(named | doubtful)
    if things.sum() < FEWEST:
        return named | doubtful
    far = unlikeness(silhouettes(inks), things)
    own = far[things]
    middle = float(np.median(own))
    deviation = 1.4826 * float(np.median(np.abs(own - middle)))
    limit = np.clip(middle + SPREAD * deviation, *FAR)
    found: NDArray[np.bool_] = named | (far > np.where(doubtful, middle + deviation, limit))
    return found


def silhouettes(inks: Sequence[NDArray[np.bool_]]) -> NDArray[np.float32]:
    """Return what exemplars cover, from afar: (n, SIDE, SIDE), 0 or 1.

    That is what has ink at all four sides, so that a gap in a contour takes little away.
    """
    step = CANVAS // SIDE
    rows = [ink.reshape(SIDE, step, CANVAS).any(axis=1) for ink in inks]
    small = np.array(rows).reshape(-1, SIDE, SIDE, step).any(axis=3)
    covered = np.ones_like(small)
    for axis in (1, 2):
        covered &= np.logical_or.accumulate(small, axis=axis)
        covered &= np.flip(np.logical_or.accumulate(np.flip(small, axis), axis=axis), axis)
    return covered.astype(np.float32)


def unlikeness(shapes: NDArray[np.float32], things: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Return how far each of n shapes is from drawings of the thing, (n,), 0 to 1.

    That is the mean distance of Jaccard to the ``NEAREST`` other
    ones of ``things`` (n,) bool, mirrored or not, whichever is less.

    >>> squares = np.eye(4, dtype=np.float32).reshape(4, 2, 2)
    >>> unlikeness(squares, np.ones(4, bool)).round(2)  # each has one mirror image
    array([0.67, 0.67, 0.67, 0.67])
    """
    flat = shapes.reshape(len(shapes), -1)
    others = np.flatnonzero(things)
    size = (flat * flat).sum(axis=1)
    distance = np.ones((len(flat), len(others)))
    for seen in (shapes, shapes[:, :, ::-1]):
        common = flat @ seen[others].reshape(len(others), -1).T
        either = size[:, None] + size[others] - common
        np.minimum(distance, 1 - common / np.maximum(either, 1e-6), out=distance)
    distance[others, np.arange(len(others))] = np.inf
    near = min(NEAREST, len(others) - 1)
    mean: NDArray[np.float64] = np.sort(distance, axis=1)[:, :near].mean(axis=1)
    return mean
