"""The masks that guide editing, hybrids and montage (sections 4.2 to 4.4).

All three are the same truncated distance field: 0 on what is marked, rising to 1 at a distance.
"""

from collections.abc import Sequence

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.model import CANVAS, Axis, Placement, Point, Stroke

EDIT_REACH = 25
"""t of D_E, in canvas units (section 4.2)."""
HYBRID_REACH = 40
"""t of D_H (section 4.3)."""
MONTAGE_REACH = 20
"""t of D_M (section 4.4)."""
HELD = 1e4
"""Data cost of giving up what the user marked: more than any seam around a pixel could save."""
EDIT_WEIGHT = 0.1
"""w_E of equation 11."""
_FAR_CORNER = 0.75
"""The centre of a pixel is nearer to all that runs through it."""
_LEVEL = 1e-9
"""A segment that rises by less is level."""
_AT_ONCE = 1000
"""Segments of a stroke that are drawn at a time: this bounds the memory."""


def truncated_distance(marked: NDArray[np.bool_], reach: float) -> NDArray[np.float32]:
    """Return the distance from the marked pixels (h, w) bool, cut off at ``reach``, from 0 to 1.

    Without a mark it is 1 everywhere.

    >>> truncated_distance(np.array([[True, False, False, False]]), 2)
    array([[0. , 0.5, 1. , 1. ]], dtype=float32)
    """
    if not marked.any():
        return np.ones(marked.shape, dtype=np.float32)
    distance: NDArray[np.float64] = scipy.ndimage.distance_transform_edt(~marked)
    return np.minimum(distance / reach, 1).astype(np.float32)


def edit_penalty(
    mask: NDArray[np.float32], kept: NDArray[np.float32], count: int
) -> NDArray[np.float32]:
    """Return P_E of ``count`` labels, (count, h, w) (equation 11); label 0 is the icon E_0.

    Parameters
    ----------
    mask
        D_E, (h, w): 0 inside the changed area.
    kept
        The same for what E_0 gives way to, (h, w). In the paper it is D_E; but beside what is only
        taken off nothing is wanted in its place.
    """
    penalty = np.repeat(EDIT_WEIGHT * mask[None], count, axis=0)
    penalty[0] = EDIT_WEIGHT * (1 - kept)
    return penalty.astype(np.float32)


def seed_cost(seeds: Sequence[Sequence[Point]], side: int = CANVAS) -> NDArray[np.float32]:
    """Return D_H of each icon, (K, side, side): the distance from its seed positions."""
    reach = HYBRID_REACH * side / CANVAS
    return np.stack([truncated_distance(points_mask(points, side), reach) for points in seeds])


def held(marked: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Return a data cost that holds marked pixels to their label, (K, h, w).

    The paper has D_M alone, which strong seams may outweigh: then a scribble is ignored. A user's
    mark is an order, so all other labels cost ``HELD`` there. ``marked`` is (K, h, w) bool.
    """
    others = marked.sum(axis=0)[None] - marked
    return np.where(others > 0, np.float32(HELD), np.float32(0))


def points_mask(points: Sequence[Point], side: int = CANVAS) -> NDArray[np.bool_]:
    """Return the pixels in which ``points``, in canvas units, lie; (side, side) bool."""
    mask = np.zeros((side, side), dtype=bool)
    for point in points:
        x, y = (min(max(int(v * side / CANVAS), 0), side - 1) for v in point)
        mask[y, x] = True
    return mask


def scribble(strokes: Sequence[Stroke], side: int = CANVAS) -> NDArray[np.bool_]:
    """Return the pixels that strokes, in canvas units, cover; (side, side) bool.

    A stroke covers all pixel centres within half its width of its line, and the pixels that the
    line runs through, however thin it is.
    """
    covered = np.zeros((side, side), dtype=bool)
    steps = np.zeros((side, side + 1), dtype=int)  # along each row, into what is near and out of it
    unit = side / CANVAS
    for stroke in strokes:
        corners, radius = np.array(stroke.points, dtype=np.float64) * unit, stroke.width / 2 * unit
        for first in range(0, max(1, len(corners) - 1), _AT_ONCE):
            some = corners[first : first + _AT_ONCE + 1]
            _add_near_line(steps, some, radius)
            if radius < _FAR_CORNER:
                line = _points_along(some)
                x, y = line[((line >= 0) & (line < side)).all(axis=1)].astype(int).T
                covered[y, x] = True
            if first and (steps.cumsum(axis=1)[:, :-1] > 0).all():  # scribbled all over
                break
    return covered | (steps.cumsum(axis=1)[:, :-1] > 0)


def carried(stroke: Stroke, before: Placement, after: Placement) -> Stroke:
    """Return a stroke over an icon, after the icon was put elsewhere: over the same part of it.

    >>> carried(Stroke(4, ((128.0, 138.0),)), Placement(), Placement(scale=2, dx=5))
    Stroke(width=8.0, points=((133.0, 148.0),))
    """
    if before == after:
        return stroke
    moved = after.transform.transform(before.transform.inverse())
    points = tuple(map(moved.transformPoint, stroke.points))
    return Stroke(stroke.width * after.scale / before.scale, points)


def points_on(stroke: Stroke) -> NDArray[np.float64]:
    """Return points (n, 2), rows of (x, y), along a stroke, at most half a pixel apart."""
    return _points_along(np.array(stroke.points, dtype=np.float64))


def _points_along(corners: NDArray[np.float64]) -> NDArray[np.float64]:
    along = np.diff(corners, axis=0)
    steps = np.maximum(1, np.ceil(2 * np.abs(along).max(axis=1, initial=0))).astype(int)
    part = np.repeat(np.arange(len(steps)), steps)
    step = np.arange(1, len(part) + 1) - np.repeat(np.cumsum(steps) - steps, steps)
    points = corners[part] + along[part] * (step / steps[part])[:, None]
    return np.concatenate([corners[:1], points])


def _add_near_line(steps: NDArray[np.int_], corners: NDArray[np.float64], radius: float) -> None:
    """Add the pixels whose centres lie within ``radius`` of a polyline (n, 2) to ``steps``.

    What is near a segment is convex: in a row of pixels, all between a first and a last one.
    """
    side = len(steps)
    starts, ends = (corners[:-1], corners[1:]) if len(corners) > 1 else (corners, corners)
    top, bottom = np.sort([starts[:, 1], ends[:, 1]], axis=0)
    first = np.clip(np.ceil(top - radius - 0.5), 0, side).astype(int)
    met = np.clip(np.floor(bottom + radius + 0.5), first, side).astype(int) - first
    part = np.repeat(np.arange(len(starts)), met)
    row = np.arange(len(part)) + np.repeat(first - np.cumsum(met) + met, met)
    left, right = _within(radius, starts[part].T, ends[part].T, row + 0.5)
    begin = np.clip(np.ceil(left - 0.5), 0, side).astype(int)
    end = np.clip(np.floor(right + 0.5), begin, side).astype(int)
    np.add.at(steps, (row, begin), 1)
    np.add.at(steps, (row, end), -1)


def _within(
    radius: float, start: NDArray[np.float64], end: NDArray[np.float64], y: NDArray[np.float64]
) -> list[NDArray[np.float64]]:
    """Return the first and the last x at which a level line is within ``radius`` of a segment.

    ``start`` and ``end`` are (2, n), x and y. Every line at ``y`` (n,) comes so near.
    """
    (x0, y0), (dx, dy) = start, end - start
    length = np.maximum(np.hypot(dx, dy), 1e-300)
    level = np.abs(dy) < _LEVEL
    bounds = []
    for way in (-1, 1):
        # Of all discs along the segment one reaches farthest that way: where the outline leaves it.
        below = -way * radius * dx * np.sign(dy) / length
        at = np.where(level, way * dx > 0, (y - y0 - below) / np.where(level, 1, dy))
        at = np.clip(at, 0, 1)
        half = np.sqrt(np.maximum(radius**2 - (y - y0 - at * dy) ** 2, 0))
        bounds.append(x0 + at * dx + way * half)
    return bounds


def with_mirror_images(points: Sequence[Point], axis: Axis | None) -> tuple[Point, ...]:
    """Return points and their mirror images on the canvas (section 4.3: symmetric seed pairs)."""
    if axis is None:
        return tuple(points)
    return tuple(one for point in points for one in (point, mirror_image(point, axis)))


def mirror_image(point: Point, axis: Axis) -> Point:
    """Return the mirror image of a point of the canvas.

    >>> mirror_image((10.0, 20.0), Axis.HORIZONTAL)
    (246.0, 20.0)
    """
    x, y = point
    match axis:
        case Axis.HORIZONTAL:
            return CANVAS - x, y
        case Axis.VERTICAL:
            return x, CANVAS - y
        case Axis.DIAGONAL:
            return y, x
        case Axis.ANTIDIAGONAL:
            return CANVAS - y, CANVAS - x
