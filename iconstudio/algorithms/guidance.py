"""The masks that guide editing, hybrids and montage (sections 4.2 to 4.4).

All three are the same truncated distance field: 0 on what is marked, rising to 1 at a distance.
"""

from collections.abc import Sequence
from itertools import pairwise

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


def truncated_distance(marked: NDArray[np.bool_], reach: float) -> NDArray[np.float32]:
    """Return the distance from the marked pixels (h, w) bool, cut off at ``reach``, from 0 to 1.

    Without a mark it is 1 everywhere.
    """
    if not marked.any():
        return np.ones(marked.shape, dtype=np.float32)
    distance = scipy.ndimage.distance_transform_edt(~marked)
    return np.minimum(distance / reach, 1).astype(np.float32)


def edit_penalty(mask: NDArray[np.float32], count: int) -> NDArray[np.float32]:
    """Return P_E of ``count`` labels, (count, h, w) (equation 11); label 0 is the icon E_0.

    ``mask`` is D_E, (h, w): 0 inside the changed area.
    """
    penalty = np.repeat(EDIT_WEIGHT * mask[None], count, axis=0)
    penalty[0] = EDIT_WEIGHT * (1 - mask)
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
    unit = side / CANVAS
    for stroke in strokes:
        stroke = Stroke(stroke.width * unit, tuple((x * unit, y * unit) for x, y in stroke.points))
        line = points_on(stroke)
        inside = line[((line >= 0) & (line < side)).all(axis=1)].astype(int)
        covered[inside[:, 1], inside[:, 0]] = True
        radius = stroke.width / 2
        left, top = np.maximum(np.floor(line.min(axis=0) - radius).astype(int), 0)
        right, bottom = np.minimum(np.ceil(line.max(axis=0) + radius).astype(int), side)
        if left < right and top < bottom:
            covered[top:bottom, left:right] |= (
                _distance_to_line(stroke.points, left, top, right, bottom) <= radius
            )
    return covered


def carried(stroke: Stroke, before: Placement, after: Placement) -> Stroke:
    """Return a stroke over an icon, after the icon was put elsewhere: over the same part of it."""
    grown = after.scale / before.scale
    mirror = -1 if before.flip != after.flip else 1
    half = CANVAS / 2
    points = tuple(
        (
            half + mirror * grown * (x - half - before.dx) + after.dx,
            half + grown * (y - half - before.dy) + after.dy,
        )
        for x, y in stroke.points
    )
    return Stroke(stroke.width * grown, points)


def points_on(stroke: Stroke) -> NDArray[np.float64]:
    """Return points (n, 2), rows of (x, y), along a stroke, at most half a pixel apart."""
    corners = np.array(stroke.points, dtype=np.float64)
    parts = [corners[:1]]
    for start, end in pairwise(corners):
        steps = max(1, int(np.ceil(2 * np.abs(end - start).max())))
        parts.append(start + (end - start) * np.arange(1, steps + 1)[:, None] / steps)
    return np.concatenate(parts)


def _distance_to_line(
    points: Sequence[Point], left: int, top: int, right: int, bottom: int
) -> NDArray[np.float64]:
    """Return the distance of the pixel centres of a window from a polyline."""
    xs, ys = np.meshgrid(np.arange(left, right) + 0.5, np.arange(top, bottom) + 0.5)
    nearest = np.hypot(xs - points[0][0], ys - points[0][1])
    for (x0, y0), (x1, y1) in pairwise(points):
        length = (x1 - x0) ** 2 + (y1 - y0) ** 2
        if length > 0:
            t = np.clip(((xs - x0) * (x1 - x0) + (ys - y0) * (y1 - y0)) / length, 0, 1)
            foot = np.hypot(xs - x0 - t * (x1 - x0), ys - y0 - t * (y1 - y0))
            np.minimum(nearest, foot, out=nearest)
    return nearest


def with_mirror_images(points: Sequence[Point], axis: Axis | None) -> tuple[Point, ...]:
    """Return points and their mirror images on the canvas (section 4.3: symmetric seed pairs)."""
    if axis is None:
        return tuple(points)
    return tuple(one for point in points for one in (point, mirror_image(point, axis)))


def mirror_image(point: Point, axis: Axis) -> Point:
    """Return the mirror image of a point of the canvas."""
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
