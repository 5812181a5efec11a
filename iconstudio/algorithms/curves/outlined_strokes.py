"""Strokes that were drawn as outlines: sets of line icons often fill what a pen would cover.

Beyond the paper. A texture along both sides of a line looks like that of another hand than one
along its middle. So what a round pen of one width can draw becomes what the pen follows: the medial
axis, made straight where lines meet, as it bends there. What is thicker stays filled, and strokes
that begin there reach into it.
"""

from collections.abc import Iterable, Sequence

import numpy as np

from iconstudio.algorithms.areas import (
    NOTHING,
    Area,
    filled,
    grown,
    hold,
    length_of_outline,
    opened,
    pieces,
    size_of,
    stroked,
    united,
    without,
)
from iconstudio.algorithms.contours import contours_of, pairs
from iconstudio.algorithms.curves.connecting import Centre, Row, connected, way_out
from iconstudio.algorithms.curves.medial_axis import axis_of
from iconstudio.algorithms.dashing import length_of
from iconstudio.model import Line

_THINNEST, _THICKEST = 2.0, 36.0
"""Canvas units of lines; what is thicker is a shape."""
_SLIT = 0.2
"""Canvas units: half the width of gaps that are a fault of a drawing."""
_FINE = 0.125
"""Between points of the outline, over the width."""
_MOST = 8_000
"""Such points; what has more is too fine to be drawn by a pen."""
_MOSTLY = 0.6
"""How much of an axis is that of lines, if there are any."""
_LONG = 1.5
"""Over their width: the length of all centre lines, at least. What has less is a dot, or a bar."""
_SOLID = 0.75
"""Over the width: what a disc of this radius fits into is no line, nor where lines meet."""
_CORE = 0.1
"""Of the square of the width: where the middle of such a disc may be, at least."""
_INTO = 0.8
"""Over the width: how far strokes reach into what is filled."""
_SLIVER = 0.05
"""Over the width: by so much the edges may differ all along,"""
_ALIKE = 0.08
"""by such a part of its area an area may differ from what is drawn instead,"""
_LARGEST = 0.6
"""and by such a part of the square of the width in one place: a sharp corner is one."""


def with_strokes(lines: Iterable[Line]) -> tuple[Line, ...]:
    """Return lines of which contours that enclose strokes are those; they come last."""
    lines = tuple(lines)
    contours = [np.array(one.points) for one in lines if not one.width]
    kept: list[Line] = []
    found: list[Line] = []
    for piece in pieces(grown(grown(filled(contours), _SLIT), -_SLIT)):
        solid, strokes = parted(piece)
        kept += contours_of(solid)
        found += strokes
    if not found:
        return lines
    return (*kept, *(one for one in lines if one.width), *found)


def parted(piece: Area) -> tuple[Area, list[Line]]:
    """Return what is solid of a polygon, and the strokes of one width that draw the rest."""
    nothing = piece, list[Line]()
    length = length_of_outline(piece)
    mean = 2 * size_of(piece) / max(length, 1e-9)
    if not _THINNEST < mean < _THICKEST or length > _MOST * _FINE * mean:
        return nothing
    centre = Centre.of(axis_of(piece, _FINE * mean))
    if centre is None or centre.share < _MOSTLY:
        return nothing
    width = 2 * centre.radius
    solid = opened(piece, _SOLID * width, _CORE * width**2)
    if solid.is_empty:
        rows = connected(centre)
    else:
        rows = []
        for part in pieces(without(piece, solid)):
            own = _rows_of(part, width)
            rows += [_into(solid, row, width) for row in own]
            if not own:
                solid = united([solid, part])
    drawn = sum(length_of(points) for points, _ in rows)
    if drawn < _LONG * width or not _draws(rows, width, solid, piece):
        return nothing
    return solid, [Line(pairs(points), closed, width) for points, closed in rows]


def _rows_of(part: Area, width: float) -> list[Row]:
    """Return what a pen of some width follows to draw a polygon; nothing if it cannot."""
    if size_of(part) < width**2:
        return []
    centre = Centre.of(axis_of(part, _FINE * width), width / 2)
    rows = [] if centre is None else connected(centre)
    return rows if _draws(rows, width, NOTHING, part) else []


def _into(solid: Area, row: Row, width: float) -> Row:
    """Return a line that goes on where it ends at what is solid."""
    points, closed = row
    if closed:
        return row
    first, last = (points[at] + _INTO * width * way_out(points, at, width / 2) for at in (0, -1))
    ahead, behind = hold(solid, np.array([first, last]))
    return np.concatenate([first[None][: int(ahead)], points, last[None][: int(behind)]]), False


def _draws(rows: Sequence[Row], width: float, solid: Area, piece: Area) -> bool:
    """Whether a pen that follows some lines draws a piece beside what is solid, but for corners."""
    drawn = united([solid, *(stroked(points, closed, width) for points, closed in rows)])
    spare = _SLIVER * width
    other = without(piece, grown(drawn, spare)), without(drawn, grown(piece, spare))
    sizes = [size_of(one) for some in other for one in pieces(some)]
    return sum(sizes) < _ALIKE * size_of(piece) and max(sizes, default=0.0) < _LARGEST * width**2
