"""Tracing a drawing to curves (section 3.4, post-processing).

The paper traces its bitmap by potrace, which sees black and white only. Our drawings have soft
edges that tell where the outline runs to a hundredth of a canvas unit; so we follow the coverage
of one half, find the corners and the straight sides, and fit cubics to the rest.
Points are complex numbers, x + iy, in pixels of the drawing; outlines are rows of points one
pixel apart.
"""

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray
from skimage.measure import find_contours

from iconstudio.algorithms.tracing.pieces import Outline, Piece, pieces_of
from iconstudio.model import CANVAS, Point
from iconstudio.model.path import Contour, Path, Segment

SPECK = 2.0
"""Pieces and holes smaller than this many square canvas units are left out."""
TOLERANCE = 0.08
"""How far, in canvas units, a line or curve may stray from the outline."""


def trace(coverage: NDArray[np.uint8], speck: float = SPECK) -> Path:
    """Return the outline of a drawing in canvas units, to a hundredth of one.

    ``coverage`` is (n, n) uint8, 255 = ink; n canvas pixels to CANVAS. Outlines run around ink,
    holes the other way round. Those of less than ``speck`` square canvas units are left out. The
    path is empty if there is no ink.
    """
    unit = CANVAS / coverage.shape[0]
    return Path(tuple(contour_along(one, unit) for one in outlines(coverage, speck)))


def outlines(coverage: NDArray[np.uint8], speck: float = SPECK) -> Iterator[Outline]:
    """Yield the outlines of a drawing as points in its pixels: see ``trace``."""
    unit = CANVAS / coverage.shape[0]
    framed = np.pad(coverage, 1).astype(np.float32)
    for rows in find_contours(framed, 127.5):
        outline = (rows[:, 1] - 0.5) + 1j * (rows[:, 0] - 0.5)
        area = abs((outline[:-1].conj() * outline[1:]).imag.sum()) / 2
        if area * unit**2 >= speck:
            yield Outline(outline[:-1])


def contour_along(
    outline: Outline, unit: float, tolerance: float = TOLERANCE, blur: int = 1
) -> Contour:
    """Return the lines and cubics of an outline in pixels, each of ``unit`` canvas units.

    They stray from it by no more than ``tolerance`` canvas units. What does not close is one turn
    of it, and open.

    Parameters
    ----------
    blur
        How many times as much corners are blunted as in a drawing.
    """
    pieces = pieces_of(outline.even(), tolerance / unit, blur)
    return contour_of(pieces, unit, closed=not outline.step)


def contour_of(pieces: Sequence[Piece], unit: float, closed: bool = True) -> Contour:
    """Return pieces in pixels as a contour, but for lines that are nothing once rounded."""
    start = at = _rounded(pieces[0][0] * unit)
    segments: list[Segment] = []
    for piece in pieces:
        points = [_rounded(point * unit) for point in piece[1:]]
        if len(points) == 3:
            segments.append((points[0], points[1], points[2]))
        elif points[0] != at:
            segments.append((points[0],))
        at = points[-1]
    return Contour(start, tuple(segments), closed)


def _rounded(point: complex) -> Point:
    return round(float(point.real), 2) + 0.0, round(float(point.imag), 2) + 0.0
