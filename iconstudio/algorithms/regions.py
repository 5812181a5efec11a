"""What paths cover: joined, cut and stroked without flattening their curves, by skia-pathops.

A region is one of Skia's paths, filled by its rule. Its coordinates are 32-bit numbers.
"""

import itertools
import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import pathops
from fontTools.pens.transformPen import TransformPen
from numpy.typing import NDArray

from iconstudio.algorithms.areas import Cap, Join
from iconstudio.algorithms.tracing.bezier import Cubic, fit_one
from iconstudio.model import Point
from iconstudio.model.path import Contour, Path, PathPen, Pen

Region = Any
"""A ``pathops.Path``; the library has no types."""
Matrix = tuple[float, float, float, float, float, float]

RegionError = pathops.PathOpsError
"""Skia does not find a way through curves that touch in many places."""

_IDENTITY = 1.0, 0.0, 0.0, 1.0, 0.0, 0.0
_STRAY = 0.03
"""How far, in canvas units, a cubic may stray from the quadratic ones in whose place it stands."""
_FINER = 8
"""Strokes are outlined so many times as large: what Skia allows to be off is made for pixels."""
_LEVEL = 0.01
"""Slope, in radians, up to which a curve is level: a node of its cubics is at home there."""
_SMOOTH = 0.999
"""Cosine of the angle by which curves turn at most where they join smoothly."""
_POINTS = 4
"""Points of a quadratic curve that stand for it."""
_CAPS = {
    "flat": pathops.LineCap.BUTT_CAP,
    "round": pathops.LineCap.ROUND_CAP,
    "square": pathops.LineCap.SQUARE_CAP,
}
_JOINS = {
    "mitre": pathops.LineJoin.MITER_JOIN,
    "round": pathops.LineJoin.ROUND_JOIN,
    "bevel": pathops.LineJoin.BEVEL_JOIN,
}


def filled(path: Path, matrix: Matrix = _IDENTITY, even_odd: bool = False) -> Region:
    """Return what a path covers, moved by an affine map."""
    rule = pathops.FillType.EVEN_ODD if even_odd else pathops.FillType.WINDING
    region = pathops.Path(fillType=rule)
    path.draw(TransformPen(region.getPen(), matrix))
    return region


def rectangle(x: float, y: float, width: float, height: float) -> Region:
    """Return what a rectangle covers."""
    corners = (x + width, y), (x + width, y + height), (x, y + height)
    return filled(Path((Contour((x, y), tuple((corner,) for corner in corners)),)))


def stroked(
    path: Path,
    matrix: Matrix,
    width: float,
    cap: Cap,
    join: Join,
    mitre: float,
    dashes: Sequence[float] = (),
    offset: float = 0.0,
) -> Region:
    """Return what a pen covers along a path; both are moved by an affine map afterwards."""
    a, b, c, d, e, f = matrix
    finer = _FINER * math.sqrt(abs(a * d - b * c)) or 1.0
    pen = filled(path, (finer, 0, 0, finer, 0, 0))
    along = [one * finer for one in dashes]
    pen.stroke(width * finer, _CAPS[cap], _JOINS[join], mitre, along or None, offset * finer)
    pen.convertConicsToQuads(_STRAY)
    back = a / finer, b / finer, c / finer, d / finer, e, f
    region = pathops.Path()
    _draw(pen, TransformPen(region.getPen(), back), _STRAY * _FINER)
    return region


def united(regions: Sequence[Region]) -> Region:
    """Return what any of them covers.

    Raises
    ------
    RegionError
        If Skia fails.
    """
    if len(regions) == 1:
        region = pathops.Path(regions[0])
        region.simplify(fix_winding=True, keep_starting_points=True)
        return region
    joined = pathops.OpBuilder(fix_winding=True, keep_starting_points=True)
    for region in regions:
        joined.add(region, pathops.PathOp.UNION)
    return joined.resolve()


def common(one: Region, other: Region) -> Region:
    """Return what both cover; errors as for ``united``."""
    return pathops.op(one, other, pathops.PathOp.INTERSECTION)


def without(one: Region, other: Region) -> Region:
    """Return what one covers and the other does not; errors as for ``united``."""
    return pathops.op(one, other, pathops.PathOp.DIFFERENCE)


def doubled(path: Path) -> float:
    """Return the area that the nonzero rule fills and the even-odd rule does not.

    Raises
    ------
    RegionError
        If Skia fails.

    >>> square = Contour((0, 0), (((8, 0),), ((8, 8),), ((0, 8),)))
    >>> doubled(Path((square,))), doubled(Path((square, square)))
    (0.0, 64.0)
    """
    nonzero, odd = (united([filled(path, even_odd=rule)]) for rule in (False, True))
    return abs(float(abs(nonzero.area) - abs(odd.area)))


def outline(region: Region) -> Path:
    """Return the outline of a region of the nonzero rule, quadratic curves as cubic ones.

    >>> square = Path((Contour((0, 0), (((8, 0),), ((8, 8),), ((0, 8),))),))
    >>> to_the_right = filled(square, (1, 0, 0, 1, 4, 0))
    >>> outline(united([filled(square), to_the_right])).bounds
    (0.0, 0.0, 12.0, 8.0)
    """
    pen = PathPen()
    _draw(region, pen, _STRAY)
    return pen.path


def _draw(region: Region, pen: Pen, stray: float) -> None:
    """Draw a region without conics; a cubic in place of quadratic curves may stray so far."""
    at: Point = (0.0, 0.0)
    quadratic: list[list[Point]] = []
    for verb, points in region:
        if verb == pathops.PathVerb.QUAD:
            quadratic.append([at, *points])
        elif quadratic:
            _draw_quadratic(quadratic, pen, stray)
            quadratic = []
        if verb == pathops.PathVerb.MOVE:
            pen.moveTo(points[0])
        elif verb == pathops.PathVerb.LINE:
            pen.lineTo(points[0])
        elif verb == pathops.PathVerb.CUBIC:
            pen.curveTo(*points)
        elif verb == pathops.PathVerb.CLOSE:
            pen.closePath()
        at = points[-1] if points else at


def _draw_quadratic(curves: list[list[Point]], pen: Pen, stray: float) -> None:
    """Draw cubics in place of quadratic curves; nodes are at corners, and where they are level."""
    points = np.array(curves) @ (1, 1j)
    ways = np.diff(points, axis=1)
    ways /= np.maximum(abs(ways), 1e-9)
    out, into = ways[:-1, 1], ways[1:, 0]
    corner = (out.conj() * into).real < _SMOOTH
    level = np.minimum(abs(out.real), abs(out.imag)) < _LEVEL
    nodes = [0, *(np.flatnonzero(corner | level) + 1).tolist(), len(curves)]
    for first, last in itertools.pairwise(nodes):
        for cubic in _cubics(points[first:last], ways[first:last], stray):
            pen.curveTo(*((one.real, one.imag) for one in cubic[1:]))


def _cubics(
    curves: NDArray[np.complex128], ways: NDArray[np.complex128], stray: float
) -> Iterator[Cubic]:
    """Yield cubics in place of quadratic curves (n, 3) that join smoothly.

    ``ways`` (n, 2) are the directions in which they begin and end.
    """
    if len(curves) == 1:
        a, b, c = curves[0].tolist()
        yield a, (a + 2 * b) / 3, (2 * b + c) / 3, c
        return
    t = np.arange(_POINTS) / _POINTS
    weights = np.array([(1 - t) ** 2, 2 * (1 - t) * t, t * t])
    row = np.append((curves @ weights).ravel(), curves[-1, 2])
    cubic, away = fit_one(row, complex(ways[0, 0]), complex(-ways[-1, 1]), stray)
    if away < stray:
        yield cubic
        return
    middle = len(curves) // 2
    yield from _cubics(curves[:middle], ways[:middle], stray)
    yield from _cubics(curves[middle:], ways[middle:], stray)
