"""The lines of a drawing's own shapes, as they are painted one over the other.

What is painted over is cut away, as far as shapes tell; the result is compared with the picture of
the drawing, and if it is another one, these are not its lines.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms import areas
from iconstudio.algorithms.areas import NOTHING, Area, Points
from iconstudio.algorithms.contours import contours_of, pairs
from iconstudio.algorithms.dashing import dashed, length_of, part
from iconstudio.algorithms.flattening import STRAY, flattened
from iconstudio.model import CANVAS, Frame, IconstudioError, Line
from iconstudio.svg.lengths import Box, Matrix, inverse, scale_of
from iconstudio.svg.resvg import render_coverage
from iconstudio.svg.shapes import Clip, NotOfShapesError, Shape, shapes_on_canvas

_SPECK = 0.25
"""Square canvas units: what is smaller is no piece, no hole and no overlap."""
_COVERED = 0.01
"""Part of a stroke that may be covered, or cut off, without an end to its being one."""
_SKEWED = 1.03
"""How many times as wide a stroke may be in one direction as in another."""
_APART = 100
"""Grey levels by which ink and paper differ."""
_ALIKE = 0.01
"""Part of the ink by which the lines' picture may differ from the drawing's."""
_PAGE_EDGE = 0.1
"""Canvas units by which a shape may reach out of its page without being cut."""


@dataclass(frozen=True, eq=False)
class _Stroke:
    """A centre line, and what the pen covers along it."""

    points: Points
    closed: bool
    width: float
    """0 if it is none that a round pen of one width could draw."""
    flat: bool
    """Whether it ends where its ends are, and not half a width further."""
    area: Area


def own_lines(svg: str, frame: Frame, coverage: NDArray[np.uint8]) -> tuple[Line, ...] | None:
    """Return the lines of a document's own shapes; None if they give another picture."""
    try:
        page, drawn = shapes_on_canvas(svg, frame)
        found = _Ink()
        for shape in drawn:
            found.paint(shape)
        found.cut_to(_with_edge(page))
    except (NotOfShapesError, IconstudioError):
        return None
    return found.lines() if _looks_like(found.area(), coverage) else None


class _Ink:
    """What has been painted so far: filled areas, and strokes that nothing has cut yet."""

    def __init__(self) -> None:
        self._parts: list[Area] = []
        """All that is filled; united only when that is needed."""
        self._strokes: list[_Stroke] = []

    def paint(self, shape: Shape) -> None:
        """Paint one more shape."""
        rows = _mapped(flattened(shape.path, STRAY / (scale_of(shape.matrix) or 1)), shape.matrix)
        clips = [_clipping(clip) for clip in shape.clips]
        inside = NOTHING
        if shape.fill != "none":
            inside = _clipped(areas.filled((row for row, _ in rows), shape.even_odd), clips)
            self._parts.append(inside) if shape.fill == "ink" else self._cut(inside)
        if shape.stroke == "none":
            return
        is_solid = shape.fill == "ink" and areas.size_of(inside) > _SPECK
        for stroke in _strokes(shape, rows):
            left = _clipped(stroke.area, clips)
            if shape.stroke == "paper":
                self._cut(left)
            elif is_solid or not stroke.width or _is_cut(stroke.area, left):
                self._parts.append(left)
            else:
                self._strokes.append(stroke)

    def cut_to(self, page: Area) -> None:
        """Cut off what lies outside of the page."""
        self._parts = [areas.common(self._filled(), page)]
        self._keep_strokes(lambda one: areas.common(one, page))

    def area(self) -> Area:
        """Return all that is ink."""
        return areas.united([*self._parts, *(one.area for one in self._strokes)])

    def lines(self) -> tuple[Line, ...]:
        """Return the contours, then the strokes that are not hidden by what is filled."""
        filled = self._filled()
        seen = [one for one in self._strokes if not _is_within(one.area, filled)]
        return (
            *contours_of(areas.without_specks(filled, _SPECK)),
            *(_centre_line(one, seen) for one in seen),
        )

    def _filled(self) -> Area:
        if len(self._parts) > 1:
            self._parts = [areas.united(self._parts)]
        return self._parts[0] if self._parts else NOTHING

    def _cut(self, area: Area) -> None:
        self._parts = [areas.without(self._filled(), area)]
        self._keep_strokes(lambda one: areas.without(one, area) if areas.meet(one, area) else one)

    def _keep_strokes(self, cut: Callable[[Area], Area]) -> None:
        """Let those strokes be areas of which ``cut`` leaves only a part."""
        kept = []
        for stroke in self._strokes:
            left = cut(stroke.area)
            if _is_cut(stroke.area, left):
                self._parts.append(left)
            else:
                kept.append(stroke)
        self._strokes = kept


def _strokes(shape: Shape, rows: Sequence[tuple[Points, bool]]) -> list[_Stroke]:
    """Return the strokes of a shape, one for each of its contours or dashes."""
    pen, scale = shape.pen, scale_of(shape.matrix)
    if pen.dashes and scale:
        pattern = [one * scale for one in pen.dashes]
        rows = [
            (dash, False)
            for points, closed in rows
            for dash in dashed(points, closed, pattern, pen.offset * scale)
        ]
    even = _is_even(shape.matrix)
    back = None if even else inverse(shape.matrix)
    if not even and back is None:
        return []
    found = []
    for points, closed in rows:
        if back is None:
            width = pen.width * scale
            area = areas.stroked(points, closed, width, pen.cap, pen.join, pen.mitre)
        else:
            ((local, _),) = _mapped([(points, closed)], back)
            width = 0.0
            flat = areas.stroked(local, closed, pen.width, pen.cap, pen.join, pen.mitre)
            area = areas.mapped(flat, shape.matrix)
        is_flat = pen.cap == "flat" and not closed
        if pen.cap != "round" and not closed and length_of(points) <= width:
            width = 0.0  # with round ends it would be another shape
        found.append(_Stroke(points, closed, width, is_flat, area))
    return found


def _centre_line(stroke: _Stroke, others: Sequence[_Stroke]) -> Line:
    """Return the line of a stroke whose ends come out round.

    Where they are flat, it ends so much sooner, unless another stroke goes on from there.
    """
    points = stroke.points
    if stroke.flat:
        free = [
            not any(areas.holds(one.area, end) for one in others if one is not stroke)
            for end in (points[0], points[-1])
        ]
        whole = length_of(points)
        first, last = (stroke.width / 2 * one for one in free)
        points = part(points, first, whole - last) if any(free) else points
    return Line(pairs(points), stroke.closed, stroke.width)


def _mapped(rows: Sequence[tuple[Points, bool]], matrix: Matrix) -> list[tuple[Points, bool]]:
    a, b, c, d, e, f = matrix
    linear = np.array([[a, b], [c, d]])
    return [(points @ linear + (e, f), closed) for points, closed in rows]


def _is_even(matrix: Matrix) -> bool:
    """Whether a matrix keeps circles nearly round."""
    a, b, c, d, _, _ = matrix
    large, small = np.linalg.svd([[a, b], [c, d]], compute_uv=False)
    return bool(large <= _SKEWED * small)


def _clipping(clip: Clip) -> Area:
    return areas.united(
        areas.filled((row for row, _ in flattened(path)), even_odd) for path, even_odd in clip.paths
    )


def _clipped(area: Area, clips: Sequence[Area]) -> Area:
    for clip in clips:
        area = areas.common(area, clip)
    return area


def _is_cut(whole: Area, left: Area) -> bool:
    missing = areas.size_of(whole) - areas.size_of(left)
    return missing > max(_SPECK, _COVERED * areas.size_of(whole))


def _is_within(one: Area, other: Area) -> bool:
    return areas.size_of(areas.without(one, other)) <= _COVERED * areas.size_of(one)


def _with_edge(page: Box) -> Area:
    x, y, width, height = page
    edge = _PAGE_EDGE
    return areas.rectangle(x - edge, y - edge, x + width + edge, y + height + edge)


def _looks_like(area: Area, coverage: NDArray[np.uint8]) -> bool:
    """Whether an area drawn on the canvas gives the picture of a drawing."""
    data = "".join(
        "M" + "L".join(f"{x:.2f} {y:.2f}" for x, y in ring) + "Z" for ring in areas.outlines(area)
    )
    box = f"0 0 {CANVAS} {CANVAS}"
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}"><path d="{data}"/></svg>'
    drawn = render_coverage(svg, Frame(0, 0, CANVAS), len(coverage))
    other = (drawn > 127) != (coverage > 127)
    apart = abs(drawn.astype(int) - coverage) > _APART
    return int((other & apart).sum()) <= _ALIKE * int((coverage > 127).sum())
