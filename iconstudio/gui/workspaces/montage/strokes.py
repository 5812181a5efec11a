"""Strokes as lines: make them of what a pen did, cut them, carry them along with their icon.

A pixel can be kept from one icon only, so strokes of two icons must not cover the same pixel
(``workflows.montage.check``). That holds by construction: whatever is laid down cuts the strokes
of all other icons where the two would come near enough to share a pixel.
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms import guidance
from iconstudio.algorithms.guidance import points_on, scribble
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
        line = simplified(points[start : end + 1])
        strokes.append(Stroke(min(max(width, THINNEST), WIDEST), line))
        start = end
    return tuple(strokes)


def simplified(points: Sequence[Point], stray: float = STRAY) -> tuple[Point, ...]:
    """Return the line with as few of its points as keep it within ``stray`` (Douglas, Peucker)."""
    points = [tuple(point) for n, point in enumerate(points) if n == 0 or point != points[n - 1]]
    kept, spans = {0, len(points) - 1}, [(0, len(points) - 1)]
    while spans:
        first, last = spans.pop()
        if last - first < 2:
            continue
        inner = np.array(points[first + 1 : last])
        gaps = _distances(inner, (points[first], points[last]))
        farthest = int(gaps.argmax())
        if gaps[farthest] > stray:
            middle = first + 1 + farthest
            kept.add(middle)
            spans += [(first, middle), (middle, last)]
    return tuple(points[n] for n in sorted(kept))


def cut(strokes: Iterable[Stroke], knives: Sequence[Stroke]) -> tuple[Stroke, ...]:
    """Return what is left of ``strokes`` where they are clear of ``knives``.

    No pixel is covered both by what is left and by a knife.
    """
    left = tuple(strokes)
    for knife in knives:
        left = tuple(part for stroke in left for part in _cut(stroke, knife))
    return left


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
    return _parts(stroke, line, (np.abs(line) <= far).all(axis=1))


def visible(stroke: Stroke) -> bool:
    """Whether a stroke covers any pixel of the canvas."""
    inside = all(0 <= value < CANVAS for value in stroke.points[0])
    return inside or bool(scribble((stroke,)).any())


def _cut(stroke: Stroke, knife: Stroke) -> tuple[Stroke, ...]:
    clear = _reach(stroke) + _reach(knife) + _CLEARANCE
    if not _boxes_meet(stroke.points, knife.points, clear):
        return (stroke,)
    line = points_on(stroke)
    free = _distances(line, knife.points) > clear
    if free.all():
        return (stroke,)
    return _parts(stroke, line, free)


def _parts(
    stroke: Stroke, line: NDArray[np.float64], kept: NDArray[np.bool_]
) -> tuple[Stroke, ...]:
    """Return the parts of a stroke where ``kept`` says so of the points along it, ``line``."""
    edges = np.flatnonzero(np.diff(np.concatenate(([False], kept, [False]))))
    return tuple(
        Stroke(stroke.width, simplified(line[start:end].tolist(), _EXACT))
        for start, end in edges.reshape(-1, 2)
    )


def _reach(stroke: Stroke) -> float:
    return max(stroke.width / 2, _LEAST_REACH)


def _boxes_meet(one: Sequence[Point], other: Sequence[Point], clear: float) -> bool:
    return all(
        min(a) - clear <= max(b) and min(b) - clear <= max(a)
        for a, b in zip(zip(*one, strict=True), zip(*other, strict=True), strict=True)
    )


def _distances(points: NDArray[np.float64], line: Sequence[Point]) -> NDArray[np.float64]:
    """Return the distance of each of ``points`` (n, 2) from a polyline."""
    corners = np.array(line, dtype=np.float64)
    nearest = np.full(len(points), math.inf)
    starts, ends = (corners[:-1], corners[1:]) if len(corners) > 1 else (corners, corners)
    for start, end in zip(starts, ends, strict=True):
        along = end - start
        length = along @ along
        t = np.clip((points - start) @ along / length, 0, 1) if length else np.zeros(len(points))
        foot = points - start - t[:, None] * along
        np.minimum(nearest, np.hypot(foot[:, 0], foot[:, 1]), out=nearest)
    return nearest
