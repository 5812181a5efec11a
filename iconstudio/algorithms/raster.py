"""Bitmaps on the canvas: outlines filled, exemplars placed (sections 3.2 and 3.4)."""

from functools import lru_cache
from typing import TypeVar

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.geometry import crosses_itself, simplified_line
from iconstudio.model import CANVAS, Exemplar, Placement, Polygon

Bitmap = NDArray[np.bool_]
Scalar = TypeVar("Scalar", bound=np.generic)

_USUAL = 1.5
"""Exemplars at larger scales take too much memory to be remembered."""


def solid(ink: Bitmap) -> Bitmap:
    """Return ``ink`` (h, w) bool with every hole filled: all that the exterior contour encloses.

    The outside is what is 4-connected to the border without crossing ink.

    >>> ring = np.array([[1, 1, 1], [1, 0, 1], [1, 1, 1]], bool)
    >>> int(solid(ring).sum())
    9
    """
    background: NDArray[np.int32]
    background, _ = scipy.ndimage.label(np.pad(~ink, 1, constant_values=True))
    filled: Bitmap = background[1:-1, 1:-1] != background[0, 0]
    return filled


def overlap(first: Bitmap, second: Bitmap) -> float:
    """Return the intersection over the union of two shapes; of two empty ones 1.

    >>> overlap(np.array([True, True, False]), np.array([False, True, True]))
    0.3333333333333333
    """
    either = (first | second).sum()
    return float((first & second).sum() / either) if either else 1.0


def interior(ink: Bitmap, filled: Bitmap) -> Bitmap:
    """Return the interior structure: white pixels inside the contour (section 3.4)."""
    return filled & ~ink


def fill_polygon(polygon: Polygon, side: int = CANVAS) -> Bitmap:
    """Rasterise a polygon in canvas units: (side, side) bool, True inside (I_P of section 3.2).

    A pixel is inside if its centre is. Of an outline that crosses itself, all that it encloses
    counts as inside.
    """
    from PIL import Image, ImageDraw

    corners = np.array(polygon.vertices) * (side / CANVAS)
    inside = _enclosed_oddly(corners, side)
    if crosses_itself(polygon):  # the even-odd rule leaves out what is enclosed twice
        outline = Image.fromarray(inside)
        ImageDraw.Draw(outline).line([tuple(corner) for corner in (*corners, corners[0])], fill=1)
        inside = np.asarray(outline)
    return solid(inside)


def _enclosed_oddly(corners: NDArray[np.float64], side: int) -> Bitmap:
    """Return the pixels whose centres a polygon (n, 2) encloses an odd number of times.

    Along a row of pixels, every edge that the row meets turns outside to inside or back.
    """
    ends = np.roll(corners, -1, axis=0)
    (x, y), (x_end, y_end) = corners.T, ends.T
    above = np.minimum(y, y_end), np.maximum(y, y_end)
    first, last = np.clip(np.ceil(np.array(above) - 0.5), 0, side).astype(int)
    met = last - first
    edge = np.repeat(np.arange(len(corners)), met)
    row = np.arange(met.sum()) + np.repeat(first - np.cumsum(met) + met, met)
    with np.errstate(divide="ignore", invalid="ignore"):
        slope = (x_end - x) / (y_end - y)  # of level edges, which meet no row, it is no number
    crossing = x[edge] + (row + 0.5 - y[edge]) * slope[edge]
    column = np.clip(np.ceil(crossing - 0.5), 0, side).astype(int)
    turns = np.bincount(row * (side + 1) + column, minlength=side * (side + 1))
    odd: Bitmap = np.cumsum(turns.reshape(side, side + 1), axis=1)[:, :side] % 2 == 1
    return odd


def outlines(filled: Bitmap, tolerance: float = 1.5) -> tuple[Polygon, ...]:
    """Return the contours of a shape (CANVAS, CANVAS) bool as polygons in canvas pixels.

    They stray at most ``tolerance`` pixels from the contour of the bitmap, whose staircase would
    else be all corners.
    """
    from skimage.measure import find_contours

    contours = find_contours(np.pad(filled, 1).astype(np.float32), 0.5)
    corners = (simplified_line(contour[:, ::-1] - 0.5, tolerance)[:-1] for contour in contours)
    return tuple(Polygon(some) for some in corners if len(some) >= 3)


def scaled_ink(
    coverage: NDArray[np.uint8], scale: float, pad: int = 0, side: int = CANVAS
) -> Bitmap:
    """Return an exemplar's ink scaled about the centre of the canvas.

    Parameters
    ----------
    coverage
        The exemplar's, (CANVAS, CANVAS).
    scale
        Uniform scale factor (section 3.3).
    pad
        Extra pixels on each side, so that a factor above 1 loses nothing.
    side
        Pixels of the canvas's side.

    Returns
    -------
    (side + 2 pad, side + 2 pad) bool
    """
    if scale == 1.0 and side == CANVAS:
        return np.pad(coverage > 127, pad)
    from PIL import Image

    scale *= side / CANVAS
    n = side + 2 * pad
    step, start = 1 / scale, CANVAS / 2 - (n / 2) / scale
    # PIL samples output pixel centres: x_in = step * x_out + start, with centres at + 0.5.
    picture = Image.fromarray(coverage).transform(
        (n, n),
        Image.Transform.AFFINE,
        (step, 0, start, 0, step, start),
        resample=Image.Resampling.BICUBIC,
    )
    return np.asarray(picture) > 127


def shifted(
    picture: NDArray[Scalar], dx: int, dy: int, size: int, fill: object = 0
) -> NDArray[Scalar]:
    """Return the central (size, size) window of a square picture moved by (dx, dy) pixels.

    What comes in from outside has the value ``fill``.

    >>> shifted(np.array([[1, 2], [3, 4]]), 1, 0, 2)
    array([[0, 1],
           [0, 3]])
    """
    n = picture.shape[-1]
    out = np.full((*picture.shape[:-2], size, size), fill, dtype=picture.dtype)
    offset = (n - size) // 2
    y0, x0 = offset - dy, offset - dx  # top left corner of the window in the picture
    ys = slice(max(0, -y0), min(size, n - y0))
    xs = slice(max(0, -x0), min(size, n - x0))
    if ys.start < ys.stop and xs.start < xs.stop:
        out[..., ys, xs] = picture[..., ys.start + y0 : ys.stop + y0, xs.start + x0 : xs.stop + x0]
    return out


def placed_ink(
    exemplar: Exemplar, placement: Placement, side: int = CANVAS, pad: int = 0
) -> tuple[Bitmap, Bitmap]:
    """Return ink and solid of an exemplar at a placement, both (side, side) bool.

    ``pad`` is by how many pixels the canvas is enlarged on each side. The holes are filled before
    the canvas cuts the drawing off: what it encloses stays enclosed.
    """
    scaled = _remembered if placement.scale <= _USUAL else _scaled
    both = scaled(exemplar.coverage.tobytes(), placement.scale, side)
    if placement.flip:
        both = both[:, :, ::-1]
    dx, dy = (round(shift * side / CANVAS) for shift in (placement.dx, placement.dy))
    ink, filled = shifted(both, dx, dy, side + 2 * pad, False)
    return ink, filled


def _scaled(coverage: bytes, scale: float, side: int) -> Bitmap:
    """Return ink and solid of an exemplar at a scale, (2, n, n), whole."""
    picture = np.frombuffer(coverage, np.uint8).reshape(CANVAS, CANVAS)
    ink = scaled_ink(picture, scale, max(0, int(np.ceil(side / 2 * (scale - 1)))), side)
    both = np.stack([ink, solid(ink)])
    both.flags.writeable = False
    return both


_remembered = lru_cache(maxsize=64)(_scaled)
"""The same exemplar often lies at several places, and both before an edit and after it."""


def inked_tiles(exemplar: Exemplar, placement: Placement, count: int, pad: int = 0) -> Bitmap:
    """Return which of ``count`` x ``count`` tiles of the canvas a placed exemplar may have ink in.

    No tile is left out that has any, however faint. What lies beyond the exemplar's own canvas is
    no part of it. ``pad`` is by how many units the canvas is enlarged on each side.
    """
    before = np.zeros((CANVAS + 1, CANVAS + 1), dtype=np.int32)  # how many pixels, to each corner
    before[1:, 1:] = (exemplar.coverage > 0).cumsum(axis=0).cumsum(axis=1)
    edges = np.linspace(-pad, CANVAS + pad, count + 1) - CANVAS / 2
    soft = 1 + 1 / placement.scale  # the soft edge of a pixel before, and of one after placing it
    ranges = []
    for shift, mirror in ((placement.dy, 1), (placement.dx, -1 if placement.flip else 1)):
        at = CANVAS / 2 + mirror * (edges - shift) / placement.scale
        first, last = np.minimum(at[:-1], at[1:]) - soft, np.maximum(at[:-1], at[1:]) + soft
        ranges.append(np.clip(np.rint([first, last]), 0, CANVAS).astype(int))
    (top, bottom), (left, right) = ranges
    upper, lower = before[top], before[bottom]
    pixels: NDArray[np.int32] = lower[:, right] - lower[:, left] - upper[:, right] + upper[:, left]
    return pixels > 0
