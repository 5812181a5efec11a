"""Crumbs that a cut leaves behind, found and removed (an addition to section 3.4).

A cut may leave a small piece of a source floating where the rest of its shape was not taken. Such a
piece is a fragment; an eye or a spoke, which its source also draws apart, is not.
"""

from collections.abc import Callable
from functools import lru_cache

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.energy import Labels, joined_ink

SMALL = 0.02
"""A fragment holds at most this part of the ink."""
WHOLE = 0.5
"""A piece that shows more than this part of its source's shapes is no fragment."""
_EIGHT = np.ones((3, 3), dtype=bool)


def fragments(
    labels: Labels,
    ink: NDArray[np.bool_],
    small: float = SMALL,
    marked: NDArray[np.bool_] | None = None,
) -> NDArray[np.bool_]:
    """Return the pixels of all fragments, (h, w) bool.

    Parameters
    ----------
    labels
        (h, w): owner of each pixel.
    ink
        (K, h, w) bool: the sources.
    small
        The part of the ink that a fragment holds at most.
    marked
        (h, w) bool: what the user wants to keep. A piece with ink there is no fragment.
    """
    joined = joined_ink(ink, labels)
    pieces, count = scipy.ndimage.label(joined, _EIGHT)
    sizes = np.bincount(pieces.ravel(), minlength=count + 1)
    found = np.zeros_like(joined)
    wanted = np.zeros(count + 1, dtype=bool)
    if marked is not None:
        wanted[pieces[marked]] = True
    shapes = lru_cache(maxsize=None)(lambda owner: _shapes(ink[owner]))
    most = small * joined.sum()
    for piece in range(1, count + 1):
        if sizes[piece] <= most and not wanted[piece]:
            here = pieces == piece
            if not _shows_much(labels, shapes, here):
                found |= here
    return found


def _shapes(ink: NDArray[np.bool_]) -> tuple[NDArray[np.int32], NDArray[np.intp]]:
    """Return which shape each pixel of a source is of, 0 for paper, and the pixels of each."""
    shapes, _ = scipy.ndimage.label(ink, _EIGHT)
    return shapes, np.bincount(shapes.ravel())


def _shows_much(
    labels: Labels,
    shapes_of: Callable[[int], tuple[NDArray[np.int32], NDArray[np.intp]]],
    here: NDArray[np.bool_],
) -> bool:
    """Whether a piece shows more than WHOLE of its sources' shapes; two halves make a whole."""
    part = 0.0
    for owner in np.flatnonzero(np.bincount(labels[here])):
        own = here & (labels == owner)
        shapes, sizes = shapes_of(int(owner))
        shown = np.bincount(shapes[own], minlength=len(sizes)) > 0
        part += float(own.sum() / sizes[1:][shown[1:]].sum())
        if part > WHOLE:
            return True
    return False
