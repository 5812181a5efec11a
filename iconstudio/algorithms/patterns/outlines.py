"""The zero level sets of layers as rows of points; on a tile they go on across its borders.

Points are complex numbers, x + iy, in pixels from the pattern's top left corner, so that the middle
of the first pixel is (1 + 1j) / 2.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.patterns.distance import Field, bordered, contours
from iconstudio.algorithms.tracing.pieces import Outline

Rows = NDArray[np.float64]
"""(n, 2), rows and columns."""

BLEED = 2
"""Pixels by which what is cut by the border of a pattern that is no tile reaches beyond it."""
_CLEAR = 1e-3
"""A distance that is less counts as so much: contours then run between samples."""
_REACH = 2
"""Pixels to each side that tell what lies between pixels."""
_DIGITS = 6
_FAR = 1 << 30
"""The side of a tile whose borders nothing reaches."""


@dataclass(frozen=True, slots=True, eq=False)
class LevelSet:
    """A contour of a layer, ink always on the same side of it."""

    outline: Outline
    """It begins within the unit square at the origin,"""
    place: complex
    """and is to be moved by so many whole pixels: what is repeated differs in this alone."""
    inside: tuple[int, int]
    """Row and column of a sample beside it that is ink."""

    @property
    def area(self) -> float:
        """What a contour that closes encloses, in square pixels; negative if that is a hole."""
        points = self.outline.points
        if self.outline.step:
            return math.inf
        return float((points.conj() * np.roll(points, -1)).imag.sum() / 2)


def finer(field: Field, scale: int, tile: bool) -> Field:
    """Return a field (H, W) with ``scale`` samples a side in place of each, by cubic convolution.

    Straight between pixels, contours would have facets.
    """
    from PIL import Image

    wide = bordered(field, _REACH, tile)
    rows, columns = (scale * side for side in wide.shape)
    fine = Image.fromarray(wide).resize((columns, rows), Image.Resampling.BICUBIC)
    margin = scale * _REACH
    return np.asarray(fine)[margin : rows - margin, margin : columns - margin]


def level_sets(
    distance: Field, tile: bool, scale: int = 1, ask: Callable[[], None] = lambda: None
) -> list[LevelSet]:
    """Return the contours where a field (H, W) is 0; it is negative in ink.

    Each is there once. On a tile they go on across its borders, until they close, or until they
    repeat themselves, moved by ``step``. Else they close beyond the border.

    Parameters
    ----------
    scale
        Samples of the field to a pixel of the pattern, a side.
    ask
        Called for each contour; what it raises ends the work.
    """
    height = np.where(distance < 0, np.maximum(-distance, _CLEAR), np.minimum(-distance, -_CLEAR))
    if tile:
        wide = np.pad(height, ((0, 1), (0, 1)), mode="wrap")
        found = _joined(list(contours(wide, ask)), distance.shape, ask)
    else:
        margin = scale * BLEED + 1
        framed = np.pad(height, margin, mode="edge")
        inside = np.s_[1:-1, 1:-1]
        edge = np.ones(framed.shape, np.bool_)
        edge[inside] = False
        framed[edge] = -abs(framed[edge])
        pieces = _joined(list(contours(framed, ask)), (_FAR, _FAR), ask)
        found = [(one - margin, step) for one, step in pieces]
    sets = []
    for points, step in found:
        ask()
        sets.append(_level_set(points, step, distance, tile, scale))
    return sets


def _joined(
    rows: list[Rows], shape: tuple[int, ...], ask: Callable[[], None]
) -> list[tuple[Rows, Rows]]:
    """Return pieces of contours joined, also across the borders of a tile (H, W), and their steps.

    The last point of what closes is not its first.
    """
    size = np.array(shape)
    found = [(one[:-1], np.zeros(2)) for one in rows if (one[0] == one[-1]).all()]
    pieces = {tuple(one[0] % size): one for one in rows if (one[0] != one[-1]).any()}
    while pieces:
        ask()
        piece = first = next(iter(pieces.values()))
        parts, step = [], np.zeros(2)
        while pieces.pop(tuple(piece[0] % size), None) is not None:
            parts.append(piece[:-1] + step)
            end = piece[-1]
            piece = pieces.get(tuple(end % size), first)
            step = step + np.rint((end - piece[0]) / size) * size
        found.append((np.concatenate(parts), step))
    return found


def _level_set(points: Rows, step: Rows, distance: Field, tile: bool, scale: int) -> LevelSet:
    """Begin a contour where it is highest; one that does not close, where it is farthest aside."""
    row = (points @ np.array([1j, 1]) + (1 + 1j) / 2) / scale
    ahead = complex(step[1], step[0]) / scale
    heights = np.round((row * np.conj(1j * ahead)).real if ahead else row.imag, _DIGITS)
    first = np.lexsort((np.round(row.real, _DIGITS), heights))[0]
    row = Outline(row, ahead).at(range(first, first + len(row)))
    place = complex(np.floor(row[0].real), np.floor(row[0].imag))
    own = np.round(row - place, _DIGITS)
    rows, columns = distance.shape
    if tile:
        place = complex(place.real % (columns // scale), place.imag % (rows // scale))
    ends = np.stack([np.floor(points[0]), np.ceil(points[0])]).astype(int)  # of the crossed side
    ends = ends % distance.shape if tile else np.clip(ends, 0, (rows - 1, columns - 1))
    y, x = next(((y, x) for y, x in ends if distance[y, x] < 0), ends[0])
    return LevelSet(Outline(own, ahead), place, (int(y), int(x)))
