"""Outlines and lines of many points: simplified, tested for crossings, measured (with GEOS)."""

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from iconstudio.model import Point, Polygon

if TYPE_CHECKING:
    from shapely import STRtree

Points = NDArray[np.float64]
"""(n, 2), rows of (x, y)."""

_PIECE = 2000
"""Points that are simplified at a time: the time grows with their square, in the worst case."""
_AT_ONCE = 64
"""Edges that are compared with all others at a time: this bounds the memory."""


def crosses_itself(polygon: Polygon) -> bool:
    """Whether two edges of a polygon cross; to touch is not to cross.

    >>> crosses_itself(Polygon(((0, 0), (1, 1), (1, 0), (0, 1))))
    True
    """
    starts = np.array(polygon.vertices)
    count = len(starts)
    if count < 4:
        return False
    ends = np.roll(starts, -1, axis=0)
    boxes, tree = _boxes(starts, ends)
    for first in range(0, count, _AT_ONCE):
        one, other = tree.query(boxes[first : first + _AT_ONCE])
        one += first
        apart = (other > one + 1) & ~((one == 0) & (other == count - 1))
        one, other = one[apart], other[apart]
        if _cross(starts[one], ends[one], starts[other], ends[other]).any():
            return True
    return False


def simplified(polygon: Polygon, stray: float) -> Polygon:
    """Return a polygon of fewer vertices, all of them ``polygon``'s, at most ``stray`` from it.

    It crosses itself only if ``polygon`` does. What would vanish stays as it is.
    """
    for careful in (False, True):  # careful is slow where much lies close together
        fewer = _simplified(polygon, stray, careful)
        if len(fewer.vertices) < 3:
            break
        if not crosses_itself(fewer) or crosses_itself(polygon):
            return fewer
    return polygon


def simplified_line(line: Points | Sequence[Point], stray: float) -> tuple[Point, ...]:
    """Return a line with as few of its points as keep it within ``stray``, its ends among them.

    >>> simplified_line([(0, 0), (1, 0.01), (2, 0), (2, 2)], 0.1)
    ((0.0, 0.0), (2.0, 0.0), (2.0, 2.0))
    """
    import shapely

    points = np.array(line, dtype=np.float64)
    points = points[np.append(True, (points[1:] != points[:-1]).any(axis=1))]  # no point twice
    if len(points) > 2:
        points = _joined(shapely.simplify(_pieces(points), stray, preserve_topology=False))
    return tuple(map(tuple, points.tolist()))


def merged_lines(segments: NDArray[np.float64]) -> list[Points]:
    """Return segments (n, 2, 2) joined to lines, as long as no more than two of them meet.

    >>> merged_lines(np.array([[[0.0, 0.0], [1.0, 0.0]], [[2.0, 0.0], [1.0, 0.0]]]))[0].tolist()
    [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]
    """
    import shapely

    if not len(segments):
        return []
    lines = shapely.line_merge(shapely.multilinestrings(shapely.linestrings(segments)))
    return [shapely.get_coordinates(line) for line in shapely.get_parts(lines)]


def near(points: Points, line: Sequence[Point], reach: float) -> NDArray[np.bool_]:
    """Return which of ``points`` are within ``reach`` of a line of one point or more, (n,).

    >>> near(np.array([[5.0, 2.0], [5.0, 9.0]]), [(0, 0), (10, 0)], 3)
    array([ True, False])
    """
    import shapely

    # GEOS takes fright at numbers of 1e-313.
    whole = shapely.linestrings(np.round(line if len(line) > 1 else [*line, *line], 12))
    shapely.prepare(whole)
    within: NDArray[np.bool_] = shapely.dwithin(whole, shapely.points(points), reach)
    return within


def _simplified(polygon: Polygon, stray: float, careful: bool) -> Polygon:
    import shapely

    pieces = shapely.multilinestrings(_pieces(np.array([*polygon.vertices, polygon.vertices[0]])))
    few = shapely.simplify(pieces, stray, preserve_topology=careful)
    return Polygon.of(_joined(shapely.get_parts(few)).tolist())


def _pieces(line: Points) -> NDArray[np.object_]:
    """Return a line cut into lines, each of which begins where the one before ends."""
    import shapely

    count = max(1, math.ceil((len(line) - 1) / _PIECE))
    cuts = np.linspace(0, len(line) - 1, count + 1).astype(int)
    return np.array([shapely.linestrings(line[start : end + 1]) for start, end in pairwise(cuts)])


def _joined(pieces: NDArray[np.object_]) -> Points:
    """Return the points of the lines that make up a line; those where they meet once."""
    import shapely

    found: tuple[Points, NDArray[np.intp]] = shapely.get_coordinates(pieces, return_index=True)
    points, piece = found
    first_again = np.diff(piece, prepend=0) > 0
    return points[~first_again]


def _boxes(starts: Points, ends: Points) -> "tuple[NDArray[np.object_], STRtree]":
    """Return the boxes of edges, and what finds those that overlap.

    All is turned so that long edges run along or across if they can, and have slim boxes.
    """
    import shapely

    edges = (ends - starts) @ (1, 1j)
    fourfold = (edges / np.maximum(np.abs(edges), 1e-300)) ** 4 * np.abs(edges)
    turn = np.exp(-1j * np.angle(fourfold.sum()) / 4)
    one, other = (points @ (1, 1j) * turn for points in (starts, ends))
    left, right = np.sort([one.real, other.real], axis=0)
    top, bottom = np.sort([one.imag, other.imag], axis=0)
    rounding = 1e-12 * np.abs(one).max()
    boxes = shapely.box(left - rounding, top - rounding, right + rounding, bottom + rounding)
    return boxes, shapely.STRtree(boxes)


def _cross(a: Points, b: Points, c: Points, d: Points) -> NDArray[np.bool_]:
    """Whether the edges ab and cd cross, row by row."""
    return (_side(a, b, c) * _side(a, b, d) < 0) & (_side(c, d, a) * _side(c, d, b) < 0)


def _side(p: Points, q: Points, r: Points) -> NDArray[np.float64]:
    """Return on which side of the line pq the point r lies: -1, 0 or 1, row by row."""
    (ux, uy), (vx, vy) = (q - p).T, (r - p).T
    side: NDArray[np.float64] = np.sign(ux * vy - uy * vx)
    return side
