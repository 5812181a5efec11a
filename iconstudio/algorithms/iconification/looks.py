"""What a drawing looks like, in terms that a remix and its sources are compared by.

An addition to the paper: what the eye objects to in a remix is mostly what none of its sources has.
"""

from functools import cached_property

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.raster import Bitmap, overlap, solid

WINDOW = 40
"""Length of the stretches of contour that are compared, in canvas pixels."""
STRIDE = 2
"""A stretch begins at every so many pixels, and has a point at every so many."""
THUMB = 48
"""Side of the thumbs by which drawings are compared as wholes."""
PALEST = 0.02
"""The ink of a thumb is taken for this part of it at least."""
_SOFT = 1.2
"""Standard deviation in pixels by which the staircase of a bitmap is smoothed."""
_SHORT = 16
_EIGHT = np.ones((3, 3), bool)

Thumb = NDArray[np.float32]
"""(THUMB, THUMB), from 0 to 1 = ink."""
Stretches = NDArray[np.float32]
"""(n, WINDOW / STRIDE + 1, 2): stretches of contour, x and y of their points."""


class Looks:
    """A drawing, and what is seen of it; each is worked out when it is first asked for.

    Parameters
    ----------
    ink
        (CANVAS, CANVAS) bool, True = black.
    filled
        The same with its holes filled, if that is known.
    """

    def __init__(self, ink: Bitmap, filled: Bitmap | None = None) -> None:
        self.ink = ink
        self._filled = filled

    @cached_property
    def area(self) -> int:
        """Pixels of ink."""
        return int(self.ink.sum())

    @cached_property
    def filled(self) -> Bitmap:
        """(CANVAS, CANVAS) bool: the ink and what it encloses."""
        return solid(self.ink) if self._filled is None else self._filled

    @cached_property
    def pieces(self) -> NDArray[np.int64]:
        """Pixels of each piece that hangs together."""
        return _sizes(self.ink, _EIGHT)

    @cached_property
    def holes(self) -> NDArray[np.int64]:
        """Pixels of each hole."""
        return _sizes(self.filled & ~self.ink, None)

    @cached_property
    def symmetry(self) -> float:
        """Overlap of the filled shape with its mirror image, left to right."""
        shape = boxed(self.filled)
        return overlap(shape, shape[:, ::-1])

    @cached_property
    def ink_symmetry(self) -> float:
        """The same of the ink."""
        ink = boxed(self.ink)
        return overlap(ink, ink[:, ::-1])

    @cached_property
    def thumb(self) -> Thumb:
        """The ink, so stretched that it fills a small square."""
        return stretched(self.ink)

    @cached_property
    def filled_thumb(self) -> Thumb:
        """The same of the filled shape."""
        return stretched(self.filled)

    @cached_property
    def ends(self) -> NDArray[np.int64]:
        """Where lines end, (n, 2) as y, x in canvas pixels."""
        middle = self._middle
        around = scipy.ndimage.uniform_filter(middle.astype(np.float32), 3, mode="constant") * 9
        return np.argwhere(middle & (around < 2.5)) * 2

    @cached_property
    def widths(self) -> NDArray[np.float64]:
        """Widths along the middle of all strokes, in canvas pixels."""
        depth = scipy.ndimage.distance_transform_edt(np.pad(self._half, 1))[1:-1, 1:-1]
        widths: NDArray[np.float64] = 4.0 * depth[self._middle]
        return widths

    @cached_property
    def width(self) -> float:
        """The median width of its strokes."""
        return float(np.median(self.widths)) if len(self.widths) else 1.0

    @cached_property
    def width_spread(self) -> float:
        """How far the widths differ: 10th to 90th percentile, in parts of the median."""
        if not len(self.widths):
            return 0.0
        low, high = np.percentile(self.widths, [10, 90])
        return float((high - low) / max(self.width, 1.0))

    @cached_property
    def contours(self) -> tuple[NDArray[np.complex128], ...]:
        """The contours, as points x + iy a pixel apart; closed, all run the same way round."""
        from skimage.measure import find_contours

        soft = scipy.ndimage.gaussian_filter(np.pad(self.ink, 4).astype(np.float32), _SOFT)
        traced = find_contours(soft[::2, ::2], 0.5)  # so smooth that every second pixel will do
        found = (2 * (c[:, 1] + 1j * c[:, 0]) - (3.5 + 3.5j) for c in traced)
        return tuple(some for some in map(_spaced, found) if len(some))

    @cached_property
    def length(self) -> int:
        """That of all contours, in canvas pixels."""
        return sum(map(len, self.contours))

    @cached_property
    def stretches(self) -> Stretches:
        """Stretches of all contours."""
        return stretches(self.contours)

    @cached_property
    def _half(self) -> Bitmap:
        return self.ink[::2, ::2]

    @cached_property
    def _middle(self) -> Bitmap:
        from skimage.morphology import skeletonize

        middle: Bitmap = skeletonize(self._half)
        return middle


def stretches(contours: tuple[NDArray[np.complex128], ...]) -> Stretches:
    """Return stretches of closed contours, one for every STRIDE points: (n, points, x and y)."""
    around = np.arange(-WINDOW // 2, WINDOW // 2 + 1, STRIDE)
    rows = [one[(np.arange(0, len(one), STRIDE)[:, None] + around) % len(one)] for one in contours]
    found = np.concatenate(rows or [np.zeros((0, len(around)))])
    return np.stack([found.real, found.imag], axis=-1).astype(np.float32)


def foreignness(some: Stretches, others: Stretches) -> NDArray[np.float32]:
    """Return how unlike each stretch of contour is to the nearest of others, (n,), in pixels.

    That is the root mean square distance of their points once one is moved onto the other. Parts
    are never turned, so that what leans as no source does is unlike, too.
    """
    if not len(others):
        return np.full(len(some), np.inf, np.float32)
    points = some.shape[1]
    a, b = (one - one.mean(axis=1, keepdims=True) for one in (some, others))
    a, b = a.reshape(len(a), -1), b.reshape(len(b), -1)
    product = a @ b.T
    product *= -2
    product += (b * b).sum(axis=1)
    least = (a * a).sum(axis=1) + product.min(axis=1)
    distance: NDArray[np.float32] = np.sqrt(np.maximum(least, 0) / points)
    return distance


def boxed(shape: Bitmap) -> Bitmap:
    """Return what is in the bounding box of a shape; of nothing one empty pixel."""
    rows, columns = (np.flatnonzero(shape.any(axis=axis)) for axis in (1, 0))
    if not len(rows):
        return np.zeros((1, 1), bool)
    return shape[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]


def stretched(shape: Bitmap) -> Thumb:
    """Return the bounding box of a shape as a small square picture."""
    from PIL import Image

    picture = Image.fromarray(boxed(shape).astype(np.uint8) * 255)
    small = picture.resize((THUMB, THUMB), Image.Resampling.BOX)
    return np.asarray(small, np.float32) / np.float32(255)


def unlikeness(thumb: Thumb, other: Thumb) -> float:
    """Return by how much of its ink a thumb differs from another, mirrored or not."""
    apart = min(np.abs(thumb - some).mean() for some in (other, other[:, ::-1]))
    return float(apart / max(PALEST, float(thumb.mean())))


def _sizes(shape: Bitmap, structure: Bitmap | None) -> NDArray[np.int64]:
    numbers, _ = scipy.ndimage.label(shape, structure)
    sizes: NDArray[np.int64] = np.bincount(numbers.ravel())[1:]
    return sizes


def _spaced(points: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """Return a closed line (n,) by points a pixel apart; nothing of a very short one."""
    along = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(points)))])
    count = int(along[-1])
    if count < _SHORT:
        return points[:0]
    at = np.linspace(0, along[-1], count, endpoint=False)
    return np.interp(at, along, points.real) + 1j * np.interp(at, along, points.imag)
