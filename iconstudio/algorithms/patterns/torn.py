"""How much of a pattern is torn: a measure of its elements against the exemplar's."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from iconstudio.algorithms.patterns.elements import EIGHT
from iconstudio.algorithms.raster import solid

Bitmap = NDArray[np.bool_]

_DIFFERENT = 0.05
"""An element whose area differs by more from all of the exemplar's, beyond a pixel, is torn."""
_SHIFTS = (0, 1, -1)


@dataclass(frozen=True, slots=True, eq=False)
class _Shape:
    """A component with its holes filled, in the smallest rectangle and two pixels more."""

    solid: Bitmap
    thick: Bitmap
    """The same, a pixel thicker."""
    area: int
    ink: int


def torn_ink(
    ink: Bitmap, exemplar: Bitmap, tile: bool = False, ask: Callable[[], None] = lambda: None
) -> float:
    """Return the share of a pattern's ink that lies in torn elements, from 0 to 1.

    Elements are connected components with their holes filled; those at the border are left out.
    One is torn if it is like none of the exemplar's, moved by whole pixels: if more than a
    twentieth of its area lies more than a pixel outside that one, or the reverse.

    Parameters
    ----------
    ink, exemplar
        (H, W) and (h, w).
    tile
        Whether opposite borders of the pattern meet.
    ask
        Called for each element; what it raises ends the work.
    """
    known = _shapes(exemplar, False, ask)
    found = _shapes(ink, tile, ask)
    total = sum(shape.ink for shape in found)
    if not known or not total:
        return 0.0
    torn = 0
    for shape in found:
        ask()
        torn += 0 if _is_like_any(shape, known) else shape.ink
    return torn / total


def _shapes(ink: Bitmap, tile: bool, ask: Callable[[], None]) -> list[_Shape]:
    """Return the components that do not touch the border."""
    height, width = ink.shape
    top, left = (height // 2, width // 2) if tile else (0, 0)
    if tile:  # what begins within half a period of the middle is whole
        ink = np.pad(ink, ((top, height - top), (left, width - left)), mode="wrap")
    ask()
    filled = solid(ink)
    ask()
    labels, _ = ndimage.label(filled, EIGHT)
    shapes = []
    for number, (rows, columns) in enumerate(ndimage.find_objects(labels), 1):
        if min(rows.start, columns.start) == 0 or (
            rows.stop == len(ink) or columns.stop == ink.shape[1]
        ):
            continue
        if tile and not (0 <= rows.start - top < height and 0 <= columns.start - left < width):
            continue
        ask()
        own = np.pad(labels[rows, columns] == number, 2)
        inside = int((own[2:-2, 2:-2] & ink[rows, columns]).sum())
        shapes.append(_Shape(own, ndimage.binary_dilation(own, EIGHT), int(own.sum()), inside))
    return shapes


def _is_like_any(shape: _Shape, known: list[_Shape]) -> bool:
    order = sorted(known, key=lambda other: abs(other.area - shape.area))
    return any(_is_like(shape, other) for other in order)


def _is_like(one: _Shape, other: _Shape) -> bool:
    """Return whether they are the same but for a pixel, moved by whole pixels."""
    extents = zip(one.solid.shape, other.solid.shape, strict=True)
    if any(abs(n - m) > 4 for n, m in extents):
        return False
    shape = np.maximum(one.solid.shape, other.solid.shape) + 2
    a, thick_a = _centred(one.solid, shape, 0, 0), _centred(one.thick, shape, 0, 0)
    most = _DIFFERENT * max(one.area, other.area)
    for down in _SHIFTS:
        for right in _SHIFTS:
            b = _centred(other.solid, shape, down, right)
            thick_b = _centred(other.thick, shape, down, right)
            if (a & ~thick_b).sum() + (b & ~thick_a).sum() <= most:
                return True
    return False


def _centred(bitmap: Bitmap, shape: NDArray[np.int64], down: int, right: int) -> Bitmap:
    picture = np.zeros(tuple(shape), np.bool_)
    top, left = (shape - bitmap.shape) // 2 + (down, right)
    picture[top : top + bitmap.shape[0], left : left + bitmap.shape[1]] = bitmap
    return picture
