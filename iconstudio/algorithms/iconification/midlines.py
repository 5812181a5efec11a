"""Lines in the middle of a shape, with its width along them: its medial axis (Blum 1967)."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.geometry import merged_lines
from iconstudio.algorithms.raster import Bitmap
from iconstudio.model import CANVAS, Point

Midline = tuple[tuple[Point, ...], tuple[float, ...]]
"""Points of a line, and the width of the shape around each, in canvas units."""


def midlines(shape: Bitmap) -> tuple[Midline, ...]:
    """Return lines through the middle of a shape (m, m) bool, from the widest down.

    Discs of these widths along the lines lie in the shape and cover it, but for its corners. A part
    that is a dot comes as one point.
    """
    from skimage.morphology import medial_axis

    if not shape.any():
        return ()
    unit = CANVAS / len(shape)
    # The border of the canvas bounds it, too.
    padded = np.pad(shape, 1)
    axis, away = medial_axis(padded, return_distance=True, rng=0)
    widths = unit * (2 * away - 1)
    found = []
    for pixels in _branches(axis):
        along = widths[pixels[:, 0], pixels[:, 1]]
        points = tuple((unit * (x - 0.5), unit * (y - 0.5)) for y, x in pixels.tolist())
        found.append((points, tuple(along.tolist())))
    return tuple(sorted(found, key=lambda one: -max(one[1])))


def _branches(axis: Bitmap) -> Iterator[NDArray[np.intp]]:
    """Yield the pixels (n, 2), rows of (y, x), of each branch of lines one pixel wide."""
    pixels = np.argwhere(axis)
    number = np.full(axis.shape, -1)
    number[tuple(pixels.T)] = np.arange(len(pixels))
    segments = []
    for dy, dx in ((0, 1), (1, 0), (1, 1), (1, -1)):
        ys, xs = pixels.T
        here = axis[ys + dy, xs + dx]
        if dy and dx:  # no shortcut past a pixel that both are beside
            here = here & ~axis[ys, xs + dx] & ~axis[ys + dy, xs]
        segments.append(np.stack([pixels[here], pixels[here] + (dy, dx)], axis=1))
    joined = np.concatenate(segments)
    alone = np.ones(len(pixels), bool)
    alone[number[joined[..., 0], joined[..., 1]].ravel()] = False
    yield from pixels[alone][:, None]
    for line in merged_lines(joined.astype(np.float64)):
        yield line.astype(int)
