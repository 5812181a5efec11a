"""What counts beside the outline: what is drawn inside of it, and fine details.

The paper names both as future work (section 6). What is drawn inside takes part in equations 4
and 6 as the outline does: by a distance field of its own, weighted by where something was drawn.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import Enum

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.energy import RemixProblem, distance_field
from iconstudio.algorithms.iconification.guidance import points_on, scribble
from iconstudio.algorithms.iconification.saliency import exterior_angles
from iconstudio.algorithms.raster import Bitmap, fill_polygon, interior, solid
from iconstudio.model import CANVAS, IconstudioError, Inner, Point, Polygon, Sketch, Stroke

HOLES = 1.0
"""Weight of holes in the errors and costs, where the outline's is 1."""
LINES, RIMS = 3.0, 2.0
"""Weight of lines, which cover less, and of the rims of holes, where there is a stroke, or an end
of paper."""
DETAIL = 8.0
"""How much more the outline counts at sharp turns, where details are weighted by 1."""
_BAND = 4.0
"""Deviation of the Gaussian by which a line counts across, in canvas units."""
_NOTHING = 0.01
"""What is less of it."""
_TURN = 8.0
"""The same of a sharp turn."""
_GENTLE, _SHARP = np.radians(25), np.radians(75)
"""What turns by less nearby is no detail; what turns by more is one altogether."""
INK, _GAP = 25, 17
"""Strokes of ink are less than so many canvas pixels wide, and those of paper in ink."""
_STRAY = 1.5
"""Canvas units by which what is drawn inside may reach over the outline: that is no crossing."""


class Channel(Enum):
    """Of what a field holds the distances."""

    INK = "ink"
    """The ink itself; the outline's own is of ink with its holes filled."""
    STROKES = "strokes"
    """The nearest stroke: of ink, of paper in ink, or where paper inside ends."""

    def pictures(self, ink: Bitmap) -> Bitmap:
        """Return of what the distances are, for ink (m, m)."""
        return ink if self is Channel.INK else strokes(ink)

    @property
    def outside_only(self) -> bool:
        """Whether all distances in what the pictures show are 0."""
        return self is Channel.STROKES

    def field(self, ink: Bitmap) -> NDArray[np.float32]:
        """Return the field of ink on a canvas of any side m, (m, m)."""
        return distance_field(self.pictures(ink), self.outside_only)


@dataclass(frozen=True, eq=False)
class Aim:
    """What is wanted of one of the fields, and how much it counts where; both (m, m) float32."""

    channel: Channel
    field: NDArray[np.float32]
    weight: NDArray[np.float32]


@dataclass(frozen=True, eq=False)
class Guide:
    """All that counts beside the outline, on a canvas of any side m."""

    inner: Inner = field(default_factory=Inner)
    """What is drawn inside the outline, in canvas units."""
    weight: NDArray[np.float32] | None = None
    """(m, m): how much the outline counts; 1 everywhere if None."""
    aims: tuple[Aim, ...] = ()
    """What it asks for."""

    def guided(self, problem: RemixProblem) -> NDArray[np.float32]:
        """Return the data cost of a problem, (K, m, m), when this counts, too."""
        data = problem.data if self.weight is None else problem.data * self.weight
        for aim in self.aims:
            fields = (aim.channel.field(ink) for ink in problem.ink)
            data = data + np.stack([aim.weight * np.abs(aim.field - field) for field in fields])
        return data


UNGUIDED = Guide()


def guide_of(sketch: Sketch, side: int = CANVAS) -> Guide:
    """Return what counts beside the outline of a sketch that is fitted to the canvas."""
    weight = None
    if sketch.detail:
        weight = 1 + np.float32(DETAIL * sketch.detail) * sharpness(sketch.polygon, side)
    return Guide(sketch.inner, weight, inner_aims(sketch.inner, side))


def inner_aims(inner: Inner, side: int = CANVAS) -> tuple[Aim, ...]:
    """Return what holes and lines in canvas units ask for."""
    if inner == Inner():
        return ()
    rims = [(*hole.vertices, hole.vertices[0]) for hole in inner.holes]
    lines, rim = (_band(drawn, side) for drawn in (inner.lines, rims))
    weight = np.maximum(np.float32(LINES) * lines, np.float32(RIMS) * rim)
    aims = [Aim(Channel.STROKES, np.zeros_like(weight), weight)]
    if inner.holes:  # a line in one is ink, though the hole is paper
        hole = filled_polygons(inner.holes, side)
        paper = np.where(hole, np.float32(HOLES) * (1 - lines), np.float32(0))
        aims.append(Aim(Channel.INK, distance_field(~hole), paper))
    return tuple(aims)


def _band(lines: Sequence[Sequence[Point]], side: int) -> NDArray[np.float32]:
    """Return how near lines are, (side, side) from 0 to 1; it ends where nothing counts."""
    if not lines:
        return np.zeros((side, side), np.float32)
    drawn = scribble([Stroke(0, tuple(line)) for line in lines], side)
    away = scipy.ndimage.distance_transform_edt(~drawn) * CANVAS / side
    near = np.exp(-0.5 * (away / _BAND) ** 2)
    return np.where(near > _NOTHING, near, 0).astype(np.float32)


def strokes(ink: Bitmap) -> Bitmap:
    """Return strokes of ink (m, m), those of paper in ink, and the border of paper inside."""
    unit = ink.shape[-1] / CANVAS
    paper = interior(ink, solid(ink))
    border = paper & ~scipy.ndimage.binary_erosion(paper)
    found: Bitmap = thin(ink, round(INK * unit)) | thin(paper, round(_GAP * unit)) | border
    return found


def thin(shape: Bitmap, width: int) -> Bitmap:
    """Return where a square of that width does not fit into a shape."""
    picture = shape.view(np.uint8)
    for turn in (scipy.ndimage.minimum_filter1d, scipy.ndimage.maximum_filter1d):
        for axis in (0, 1):
            picture = turn(picture, width, axis, mode="constant")
    thin: Bitmap = shape & ~picture.view(bool)
    return thin


def sharpness(polygon: Polygon, side: int = CANVAS) -> NDArray[np.float32]:
    """Return how near sharp turns of an outline are, (side, side) from 0 to 1.

    Turns that lie together count together, as those of a nose do: gentle ones never do.
    """
    theta = np.zeros((CANVAS, CANVAS))
    xs, ys = np.clip(np.array(polygon.vertices).T.astype(int), 0, CANVAS - 1)
    np.add.at(theta, (ys, xs), exterior_angles(polygon))
    turning = scipy.ndimage.gaussian_filter(theta, _TURN, mode="constant")
    turning *= 2 * np.pi * _TURN**2  # a turn alone comes to its angle
    near = np.clip((turning - _GENTLE) / (_SHARP - _GENTLE), 0, 1).astype(np.float32)
    finer = side // CANVAS
    return np.kron(near, np.ones((finer, finer), np.float32))


def check_inner(inner: Inner, outline: Bitmap, gone: Bitmap | None = None) -> None:
    """Refuse what does not lie inside an outline, (m, m); all is in canvas units.

    ``gone`` (m, m) was inside before it was removed.

    Raises
    ------
    IconstudioError
        A sentence that says which one.
    """
    if not (inner.holes or inner.lines):
        return
    side = len(outline)
    away = _away(outline)
    for name, shapes in (
        ("Hole", [(*hole.vertices, hole.vertices[0]) for hole in inner.holes]),
        ("Line", inner.lines),
    ):
        for number, points in enumerate(shapes, start=1):
            outside = _outside(points, away)
            is_hole = name == "Hole"
            filled = fill_polygon(Polygon(points), side) if is_hole else np.zeros_like(outline)
            if outside.any():
                if gone is not None and not _outside(points, _away(outline | gone)).any():
                    where = "lies in" if outside.all() else "reaches into"
                    raise IconstudioError(
                        f"{name} {number} {where} what is removed, where nothing is left for it. "
                        "Move it, or remove less."
                    )
                where = _beyond(outside, outline, filled)
                raise IconstudioError(
                    f"{name} {number} {where} the outline. Move it inside, or remove it."
                )
            if not (outline & ~filled).any():
                raise IconstudioError(
                    f"Hole {number} leaves nothing of the outline. Draw it smaller, or remove it."
                )
    for number, hole in enumerate(inner.holes, start=1):
        if not fill_polygon(hole, side).any():
            raise IconstudioError(
                f"Hole {number} is too small to be seen. Draw it larger, or remove it."
            )


def _beyond(outside: Bitmap, outline: Bitmap, filled: Bitmap) -> str:
    """Return how a line, or a hole that is ``filled``, lies to an outline it is not inside of."""
    if not (outline & ~filled).any():
        return "covers"
    if not outside.all():
        return "crosses"
    return "covers a part of" if (outline & filled).any() else "lies outside"


def _away(outline: Bitmap) -> NDArray[np.float64]:
    """Return how far away each site is from an outline (m, m), in canvas units."""
    away: NDArray[np.float64] = scipy.ndimage.distance_transform_edt(~outline)
    return away * CANVAS / len(outline)


def _outside(points: Sequence[Point], away: NDArray[np.float64]) -> Bitmap:
    """Return which points along a line are beyond an outline, ``away`` (m, m) from it."""
    near = np.clip(points, -CANVAS, 2 * CANVAS)  # what is farther away is outside, too
    along = points_on(Stroke(0, tuple(map(tuple, near.tolist()))))
    x, y = np.floor(along.T * len(away) / CANVAS).astype(int)
    inside = (np.minimum(x, y) >= 0) & (np.maximum(x, y) < len(away))
    outside: Bitmap = ~inside
    outside[inside] = away[y[inside], x[inside]] > _STRAY
    return outside


def filled_polygons(polygons: Sequence[Polygon], side: int = CANVAS) -> Bitmap:
    """Return what any of some polygons in canvas units encloses, (side, side)."""
    inside = np.zeros((side, side), dtype=bool)
    for polygon in polygons:
        inside |= fill_polygon(polygon, side)
    return inside
