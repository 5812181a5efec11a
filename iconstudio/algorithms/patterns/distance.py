"""Signed distance functions of layers (section 2, figure 1).

Distances are exact to the contour that linear interpolation finds between the pixels' centres
(marching squares), so they are finer than pixels. They are clamped to ``CLAMP`` pixels: farther off
they tell nothing about shapes.
"""

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray
from skimage.measure import find_contours

from iconstudio.algorithms.compiled import entry

Field = NDArray[np.float32]

CLAMP = 8.0
"""Pixels of the finest resolution."""
_BAND = 64
"""Rows whose contours are found at once: all together take too long to be stopped in time."""


def signed_distances(masks: Field) -> Field:
    """Return the signed distances (L, h, w) of layers with these masks (L, h, w) from 0 to 1."""
    return np.stack([signed_distance(mask - np.float32(0.5)) for mask in masks])


def signed_distance(
    height: Field, tile: bool = False, ask: Callable[[], None] = lambda: None
) -> Field:
    """Return the distance in pixels to where a field (h, w) is 0, negative where it is positive.

    Parameters
    ----------
    height
        Such as a mask less a half, or a distance function that is none any more, negated.
    tile
        Whether opposite borders meet. Else a contour lies only between pixels.
    ask
        Called for each contour; what it raises ends the work.
    """
    margin = int(CLAMP) + 1 if tile else 0
    padded = bordered(height, margin, tile)
    nearest = np.full(padded.shape, CLAMP**2)
    for contour in contours(padded, ask):
        lower_to_segments(nearest, contour, CLAMP)
    distance = np.where(padded > 0, -np.sqrt(nearest), np.sqrt(nearest)).astype(np.float32)
    rows, columns = height.shape
    inside: Field = distance[margin : margin + rows, margin : margin + columns]
    return inside


def contours(height: Field, ask: Callable[[], None]) -> Iterator[NDArray[np.float64]]:
    """Give the contours where a field (h, w) is 0, (n, 2) rows and columns, in bands of rows.

    Those that reach into several bands come in pieces that begin where others end.

    Parameters
    ----------
    ask
        Called for each band and each contour; what it raises ends the work.
    """
    for top in range(0, len(height) - 1, _BAND):
        ask()
        for piece in find_contours(height[top : top + _BAND + 1], 0.0):
            ask()
            yield piece + np.array([top, 0])


def bordered(field: Field, margin: int, tile: bool) -> Field:
    """Return a field with a margin: what lies opposite if it is a tile, else its edge repeated."""
    return np.pad(field, margin, mode="wrap") if tile else np.pad(field, margin, mode="edge")


@entry
def lower_to_segments(nearest, contour, reach):  # type: ignore[no-untyped-def]
    """Lower squared distances (h, w) to those from a polyline (n, 2) of rows and columns."""
    rows, columns = nearest.shape
    for k in range(len(contour) - 1):
        y, x = contour[k]
        dy, dx = contour[k + 1, 0] - y, contour[k + 1, 1] - x
        length = dy * dy + dx * dx
        top, bottom = min(y, y + dy) - reach, max(y, y + dy) + reach
        left, right = min(x, x + dx) - reach, max(x, x + dx) + reach
        for i in range(max(0, int(np.ceil(top))), min(rows, int(bottom) + 1)):
            for j in range(max(0, int(np.ceil(left))), min(columns, int(right) + 1)):
                along = 0.0
                if length > 0.0:
                    along = min(max(((i - y) * dy + (j - x) * dx) / length, 0.0), 1.0)
                off, aside = i - y - along * dy, j - x - along * dx
                nearest[i, j] = min(nearest[i, j], off * off + aside * aside)


def coverage(distance: Field) -> Field:
    """Return how much of each pixel lies where distances are negative, from 0 to 1."""
    covered: Field = np.clip(np.float32(0.5) - distance, 0, 1)
    return covered
