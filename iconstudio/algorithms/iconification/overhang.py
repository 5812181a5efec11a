"""What reaches past the canvas: drawn whole where its source owns the border.

An addition to section 3.4.

A labelling ends where the canvas does. A source that owns ink at the border would be sliced flat
there. So the label map is continued: what hangs together, beyond the border, with ink that a source
owns at the border belongs to that source; all else beyond is nobody's.
"""

from collections.abc import Sequence

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter
from iconstudio.algorithms.iconification.blending import spread
from iconstudio.algorithms.iconification.energy import Labels, joined_ink
from iconstudio.algorithms.raster import Bitmap, Scalar
from iconstudio.model import CANVAS, MARGIN, Drawing, Frame, Source

FARTHEST = 384
"""Canvas units around the canvas beyond which nothing is drawn."""
STEP = 32
"""The canvas is enlarged by a multiple of so many units on each side."""
_CLEAR = 8
"""Canvas units around what hangs over that are its source's too: room for its soft edges."""


def overhang(labels: Labels, ink: NDArray[np.bool_], sources: Sequence[Source]) -> int:
    """Return by how many canvas units to enlarge the canvas on each side, so that nothing is cut.

    Parameters
    ----------
    labels
        (m, m): index of each pixel's owner.
    ink
        (K, m, m) bool: the sources on the canvas.
    """
    edge = _border(labels.shape[0])
    inked = edge & joined_ink(ink, labels)
    reach = max((_reach(sources[k]) for k in np.unique(labels[inked])), default=0.0)
    return min(FARTHEST, STEP * int(np.ceil(reach / STEP))) if reach > 0 else 0


def continued(labels: Labels, ink: NDArray[np.bool_]) -> Labels:
    """Return the label map (w, w) of an enlarged canvas.

    Parameters
    ----------
    labels
        (m, m): index of each pixel's owner.
    ink
        (K, w, w) bool: the sources on the enlarged canvas. K, the next label, is nobody's.
    """
    m, (count, w) = len(labels), ink.shape[:2]
    pad = (w - m) // 2
    inside = slice(pad, pad + m)
    wide = np.full((w, w), count, dtype=np.uint8)
    wide[inside, inside] = labels
    outside = np.ones((w, w), dtype=bool)
    outside[inside, inside] = False
    nearest = np.pad(labels, pad, mode="edge")
    clear = _CLEAR * m // CANVAS or 1
    at_border = np.pad(_border(m), pad)
    owned = at_border & joined_ink(ink, nearest)
    for owner in np.unique(nearest[owned]):
        begun = owned & (nearest == owner)
        pieces, _ = scipy.ndimage.label(ink[owner] & (outside | begun), np.ones((3, 3)))
        whole = np.isin(pieces, np.unique(pieces[begun]))
        others = spread(ink[owner] & outside & ~whole)
        near = maximum_filter(whole, 2 * clear + 1)
        wide[outside & near & ~others & ((wide == count) | (nearest == owner))] = owner
    return wide


def framed(coverage: NDArray[np.uint8], pad: int) -> Frame:
    """Return the square that a drawing is shown in, in whole canvas units.

    That is the canvas, unless there is ink beyond: then its bounding box, with the usual margin.

    Parameters
    ----------
    coverage
        (n, n) uint8, 255 = ink: the canvas, enlarged by ``pad`` units on each side.
    """
    unit = len(coverage) // (CANVAS + 2 * pad)
    ink = coverage > 127
    rows, columns = (np.flatnonzero(ink.any(axis=axis)) for axis in (1, 0))
    if not len(rows):
        return Frame(0, 0, CANVAS)
    top, bottom, left, right = (
        value / unit - pad for value in (rows[0], rows[-1] + 1, columns[0], columns[-1] + 1)
    )
    if min(top, left) >= 0 and max(bottom, right) <= CANVAS:
        return Frame(0, 0, CANVAS)
    longer = max(bottom - top, right - left)
    size = 2 * int(np.ceil(longer * CANVAS / (CANVAS - 2 * MARGIN) / 2))
    x, y = (round((low + high - size) / 2) for low, high in ((left, right), (top, bottom)))
    return Frame(x, y, size)


def cropped(picture: NDArray[Scalar], pad: int, frame: Frame, fill: int = 0) -> NDArray[Scalar]:
    """Return what a frame in whole canvas units shows of a picture (n, n) of the enlarged canvas.

    What lies beyond the picture has the value ``fill``.
    """
    unit = len(picture) // (CANVAS + 2 * pad)
    x, y, size = (int(value) for value in (frame.x + pad, frame.y + pad, frame.size))
    most = max(0, -x, -y, x + size - len(picture) // unit, y + size - len(picture) // unit)
    roomy = np.pad(picture, most * unit, constant_values=fill)
    top, left, side = (y + most) * unit, (x + most) * unit, size * unit
    return roomy[top : top + side, left : left + side]


def owned_throughout(labels: Labels, nobody: int) -> Labels:
    """Give what is nobody's to the nearest owner."""
    free = labels == nobody
    if not free.any():
        return labels
    nearest = scipy.ndimage.distance_transform_edt(
        free, return_distances=False, return_indices=True
    )
    owned: Labels = labels[tuple(nearest)]
    return owned


def seen(picture: NDArray[Scalar], frame: Frame, size: int, fill: object = 0) -> NDArray[Scalar]:
    """Return a picture (m, m) of the canvas as a frame shows it, (size, size).

    What lies beyond the canvas has the value ``fill``.
    """
    m = len(picture)
    at = (np.arange(size) + 0.5) * frame.size / size
    ys, xs = (np.floor((at + start) * m / CANVAS).astype(int) for start in (frame.y, frame.x))
    out = picture[np.clip(ys, 0, m - 1)[:, None], np.clip(xs, 0, m - 1)]
    beyond = ((ys < 0) | (ys >= m))[:, None] | ((xs < 0) | (xs >= m))
    return np.where(beyond, np.asarray(fill, dtype=out.dtype), out)


def on_canvas(picture: NDArray[Scalar], frame: Frame) -> NDArray[Scalar]:
    """Return what a picture (n, n) of a frame shows on the canvas, (CANVAS, CANVAS)."""
    at = (np.arange(CANVAS) + 0.5) * len(picture) / frame.size
    ys, xs = (
        np.clip(np.floor(at - start * len(picture) / frame.size).astype(int), 0, len(picture) - 1)
        for start in (frame.y, frame.x)
    )
    shown: NDArray[Scalar] = picture[ys[:, None], xs]
    return shown


def drawn_ink(drawing: Drawing) -> Bitmap:
    """Return the ink of a drawing on the canvas, (CANVAS, CANVAS)."""
    return on_canvas(drawing.coverage > 127, drawing.frame)


def _border(side: int) -> Bitmap:
    border = np.zeros((side, side), dtype=bool)
    border[[0, -1]] = border[:, [0, -1]] = True
    return border


def _reach(source: Source) -> float:
    """Return how far a source's ink reaches past the canvas, in canvas units."""
    ys, xs = np.nonzero(source.exemplar.ink)
    box = (xs.min(), ys.min()), (xs.max() + 1, ys.max() + 1)
    corners = np.array(source.placement.transform.transformPoints(box))
    return float(max(-corners.min(), corners.max() - CANVAS))
