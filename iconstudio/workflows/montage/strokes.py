"""Strokes as lines: make them of what a pen did, cut them, carry them along with their icon.

A pixel can be kept from one icon only, so strokes of two icons must not cover the same pixel
(``workflows.montage.check``). That holds by construction: whatever is laid down cuts the strokes
of all other icons where the two would come near enough to share a pixel.
"""

from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.geometry import near, simplified_line
from iconstudio.algorithms.iconification import guidance
from iconstudio.algorithms.iconification.guidance import points_on, scribble
from iconstudio.model import CANVAS, Placement, Point, Stroke

THINNEST, WIDEST = 1.0, 2.0 * CANVAS
"""Range of a stroke's width in canvas pixels."""

STRAY = 0.3
"""How far, in canvas pixels, a stroke may stray from what the hand drew, to have fewer points."""

_EXACT = 1e-3
"""How far what is left of a stroke may stray: so little that it stays clear of other strokes."""

_STEADY = 1.25
"""The width of a stroke is even if it changes by no more than this factor."""

_LEAST_REACH = 0.75
"""However thin, a stroke covers the pixels that it runs through: their centres are nearer."""

_CLEARANCE = 0.5
"""More than half the distance between neighbours of ``points_on``, and than rounding in a file."""


def strokes_of(points: Sequence[Point], widths: Sequence[float]) -> tuple[Stroke, ...]:
    """Return a line whose width changes as strokes, each of one width, the mean of its part.

    Neighbouring strokes share a point, so that the line has no gap.
    """
    strokes, start = [], 0
    least = most = widths[0]
    for end in range(1, len(points) + 1):
        if end < len(points):
            least, most = min(least, widths[end]), max(most, widths[end])
            if most <= _STEADY * least:
                continue
            least = most = widths[end]
        width = sum(widths[start:end]) / (end - start)
        line = simplified_line(points[start : end + 1], STRAY)
        strokes.append(Stroke(min(max(width, THINNEST), WIDEST), line))
        start = end
    return tuple(strokes)


def cut(strokes: Iterable[Stroke], knives: Sequence[Stroke]) -> tuple[Stroke, ...]:
    """Return what is left of ``strokes`` where they are clear of ``knives``.

    No pixel is covered both by what is left and by a knife.
    """
    return tuple(part for stroke in strokes for part in _cut(stroke, knives))


def carried(stroke: Stroke, before: Placement, after: Placement) -> Stroke:
    """Return a stroke over an icon, after the icon was put elsewhere: over the same part of it."""
    stroke = guidance.carried(stroke, before, after)
    return replace(stroke, width=min(max(stroke.width, THINNEST), WIDEST))


def near_canvas(stroke: Stroke) -> tuple[Stroke, ...]:
    """Return a stroke without what is far off the canvas, where enlarging its icon may take it."""
    far = 2.0 * CANVAS
    if all(abs(value) <= far for point in stroke.points for value in point):
        return (stroke,)
    line = points_on(stroke)
    return _parts(stroke, line, np.all(np.abs(line) <= far, axis=1))


def visible(stroke: Stroke) -> bool:
    """Whether a stroke covers any pixel of the canvas."""
    inside = all(0 <= value < CANVAS for value in stroke.points[0])
    return inside or bool(scribble((stroke,)).any())


def _cut(stroke: Stroke, knives: Sequence[Stroke]) -> tuple[Stroke, ...]:
    line = points_on(stroke)
    free = np.ones(len(line), dtype=bool)
    for knife in knives:
        clear = _reach(stroke) + _reach(knife) + _CLEARANCE
        corners = np.array(knife.points)
        low, high = corners.min(axis=0) - clear, corners.max(axis=0) + clear
        close = np.flatnonzero(free & ((line >= low) & (line <= high)).all(axis=1))
        if len(close):
            free[close] = ~near(line[close], knife.points, clear)
    return (stroke,) if free.all() else _parts(stroke, line, free)


def _parts(
    stroke: Stroke, line: NDArray[np.float64], kept: NDArray[np.bool_]
) -> tuple[Stroke, ...]:
    """Return the parts of a stroke where ``kept`` says so of the points along it, ``line``."""
    edges = np.flatnonzero(np.diff(np.concatenate(([False], kept, [False]))))
    return tuple(
        Stroke(stroke.width, simplified_line(line[start:end], _EXACT))
        for start, end in edges.reshape(-1, 2)
    )


def _reach(stroke: Stroke) -> float:
    return max(stroke.width / 2, _LEAST_REACH)
