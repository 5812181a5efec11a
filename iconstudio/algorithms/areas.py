"""Areas: polygons with holes, filled, stroked, united and cut (with GEOS).

Outlines and lines are rows of points (n, 2). An area is a polygon or several of shapely's, valid
and without overlaps.
"""

import math
from collections.abc import Iterable, Sequence
from typing import Any, Literal

import numpy as np
import shapely
from numpy.typing import NDArray

Points = NDArray[np.float64]
Area = Any
"""A polygon, or several, of shapely's, which has no types."""
Cap = Literal["round", "flat", "square"]
Join = Literal["round", "mitre", "bevel"]

FINE = 0.02
"""How far the sides of a stroke, in canvas units, may stray from its arcs."""
_FEWEST, _MOST = 4, 64
"""Sides of a quarter of a circle."""
_SAMPLES = 24
"""Points of a contour that tell what it is in."""
NOTHING: Area = shapely.Polygon()


def filled(contours: Iterable[Points], even_odd: bool = False) -> Area:
    """Return what closed contours enclose together, by the nonzero rule or the even-odd rule."""
    rings = _rings(contours)
    if not rings:
        return NOTHING
    if len(rings) == 1:
        whole = shapely.polygons(rings[0])
        if shapely.is_valid(whole):
            return whole
    faces = _faces(rings)
    turns = _turns(_within(faces), rings).sum(axis=0)
    return _joined(faces[turns % 2 == 1 if even_odd else turns != 0])


def inked(contours: Iterable[Points]) -> Area:
    """Return what contours that may cross themselves, and each other, are meant to enclose.

    As long as they do not, that is what the nonzero rule says. A hole that reaches out of what it
    is in, or goes round twice somewhere, is no ink there.
    """
    rings = _rings(contours)
    if len(rings) < 2:
        return filled(one[:-1] for one in rings)
    faces = _faces(rings)
    signs = np.sign([_signed_area(one) for one in rings])
    some = np.concatenate([_spread(one) for one in rings])
    around = signs[:, None] * (_turns(some, rings) != 0)
    others = around.sum(axis=0) - around.reshape(len(rings), len(rings), -1).diagonal().T.ravel()
    within = others.reshape(len(rings), -1) == -signs[:, None]
    kinds = np.where(within.mean(axis=1) > 0.5, -1, 1)
    depth = kinds @ (_turns(_within(faces), rings) != 0)
    return _joined(faces[depth > 0])


def beneath(areas: Sequence[Area], part: float) -> list[int | None]:
    """Return for each area the last one before it that covers more than a part of it, if any."""
    tree = shapely.STRtree(areas)
    found: list[int | None] = []
    for number, area in enumerate(areas):
        before = sorted((int(k) for k in tree.query(area) if k < number), reverse=True)
        least = part * area.area
        found.append(next((k for k in before if areas[k].intersection(area).area > least), None))
    return found


def _rings(contours: Iterable[Points]) -> list[Points]:
    return [np.concatenate([one, one[:1]]) for one in contours if len(one) > 2]


def _faces(rings: Sequence[Points]) -> NDArray[np.object_]:
    """Return the polygons into which contours divide the plane."""
    noded = shapely.union_all([shapely.linestrings(one) for one in rings])
    faces: NDArray[np.object_] = shapely.get_parts(shapely.polygonize(shapely.get_parts(noded)))
    return faces


def _joined(faces: NDArray[np.object_]) -> Area:
    return shapely.coverage_union_all(faces) if len(faces) else NOTHING


def _within(faces: NDArray[np.object_]) -> Points:
    """Return a point of each face, (n, 2)."""
    points: Points = shapely.get_coordinates(shapely.point_on_surface(faces))
    return points


def _spread(ring: Points) -> Points:
    """Return points at equal distances along a ring."""
    along = np.append(0.0, np.cumsum(np.hypot(*np.diff(ring, axis=0).T)))
    places = (np.arange(_SAMPLES) + 0.5) / _SAMPLES * along[-1]
    return np.column_stack([np.interp(places, along, ring[:, axis]) for axis in (0, 1)])


def _signed_area(ring: Points) -> float:
    (x, y), (x_end, y_end) = ring[:-1].T, ring[1:].T
    return float((x * y_end - x_end * y).sum())


def _turns(points: Points, rings: Sequence[Points]) -> NDArray[np.intp]:
    """Return how often each ring goes round each point, (rings, n)."""
    order = np.argsort(points[:, 1])
    x, y = points[order].T
    starts, ends = ([one[part] for one in rings] for part in (slice(-1), slice(1, None)))
    ring = np.repeat(np.arange(len(rings)), [len(one) for one in starts])
    (x0, y0), (x1, y1) = np.concatenate(starts).T, np.concatenate(ends).T
    # Every edge that a level ray to the right of a point meets turns once about it.
    first = np.searchsorted(y, np.minimum(y0, y1), "left")
    met = np.searchsorted(y, np.maximum(y0, y1), "left") - first
    edge = np.repeat(np.arange(len(met)), met)
    point = np.arange(met.sum()) + np.repeat(first - np.cumsum(met) + met, met)
    up = np.sign(y1 - y0)[edge]
    side = (x1 - x0)[edge] * (y[point] - y0[edge]) - (x[point] - x0[edge]) * (y1 - y0)[edge]
    place = ring[edge] * len(points) + point
    counted = np.bincount(place, np.where(side * up > 0, up, 0), len(rings) * len(points))
    turns = np.empty((len(rings), len(points)), np.intp)
    turns[:, order] = counted.reshape(turns.shape).round()
    return turns


def stroked(
    points: Points,
    closed: bool,
    width: float,
    cap: Cap = "round",
    join: Join = "round",
    mitre: float = 4.0,
) -> Area:
    """Return what a pen of some width covers along a line; a dot if it has no length."""
    quarter = min(max(math.ceil(math.pi / 4 * math.sqrt(width / 4 / FINE)), _FEWEST), _MOST)
    if not (points != points[0]).any():
        if cap == "flat":
            return NOTHING
        shape: Cap = "square" if cap == "square" else "round"
        dot = shapely.points(points[0])
        return shapely.buffer(dot, width / 2, quad_segs=quarter, cap_style=shape)
    if closed:
        # A ring is thinned from within, which fails where the pen is wider than what it encloses:
        # so it is a line that goes on along its first side once more.
        points = np.concatenate([points, points[:2]])
    return shapely.buffer(
        shapely.linestrings(points),
        width / 2,
        quad_segs=quarter,
        cap_style="flat" if closed else cap,
        join_style=join,
        mitre_limit=mitre,
    )


def simplified(points: Points, closed: bool, stray: float) -> Points:
    """Return a line with fewer of its points, at most ``stray`` from it."""
    if len(points) < 3:
        return points
    row = np.concatenate([points, points[:1]]) if closed else points
    found: Points = shapely.get_coordinates(shapely.simplify(shapely.linestrings(row), stray))
    return found[:-1] if closed else found


def united(areas: Iterable[Area]) -> Area:
    """Return what is in any of some areas."""
    return shapely.union_all(list(areas))


def common(one: Area, other: Area) -> Area:
    """Return what is in both of two areas."""
    return _areal(shapely.intersection(one, other))


def without(one: Area, other: Area) -> Area:
    """Return what is in the one area and not in the other."""
    return _areal(shapely.difference(one, other))


def without_specks(area: Area, least: float, hole: float | None = None) -> Area:
    """Return an area without pieces smaller than ``least``, and holes smaller than ``hole``.

    Without ``hole``, the same holds for both.
    """
    hole = least if hole is None else hole
    kept = []
    for piece in shapely.get_parts(area):
        if shapely.area(piece) >= least:
            outer, *holes = shapely.get_rings(piece)
            large = [one for one in holes if shapely.area(shapely.polygons(one)) >= hole]
            kept.append(shapely.Polygon(outer, large))
    return shapely.MultiPolygon(kept)


def rectangle(left: float, top: float, right: float, bottom: float) -> Area:
    """Return a rectangle."""
    return shapely.box(left, top, right, bottom)


def holds(area: Area, point: Points) -> bool:
    """Whether a point (2,) is within an area, not at its edge."""
    return bool(shapely.contains(area, shapely.points(point)))


def meet(one: Area, other: Area) -> bool:
    """Whether two areas have a point in common."""
    return bool(shapely.intersects(one, other))


def one_piece(contour: Points, neck: float) -> Points:
    """Return the outline of what a closed contour encloses: one piece that has no holes.

    One that does not cross itself is that already. Loops stay, joined to the rest by necks of about
    this width where they only touch it.
    """
    if shapely.is_simple(shapely.linearrings(contour)):
        return contour
    joined = shapely.buffer(shapely.buffer(filled([contour]), neck / 2), -neck / 2)
    parts = shapely.get_parts(joined)
    if not len(parts):
        return contour
    largest = shapely.get_exterior_ring(parts[int(shapely.area(parts).argmax())])
    outline: Points = shapely.get_coordinates(largest)[:-1]
    same = _signed_area(np.append(contour, contour[:1], axis=0)) > 0
    around = _signed_area(np.append(outline, outline[:1], axis=0)) > 0
    return outline if same == around else outline[::-1]


def meeting_boxes(starts: Points, ends: Points) -> NDArray[np.intp]:
    """Return the pairs (n, 2) of straight sides whose bounding boxes meet, the lower number first.

    Sides go from ``starts`` to ``ends``, (m, 2) each.
    """
    sides = shapely.linestrings(np.stack([starts, ends], axis=1))
    one, other = shapely.STRtree(sides).query(sides)
    pairs: NDArray[np.intp] = np.column_stack([one, other])[one < other]
    return pairs


def size_of(area: Area) -> float:
    """Return how large an area is."""
    return float(shapely.area(area))


def length_of_outline(area: Area) -> float:
    """Return how long the contours of an area are together."""
    return float(shapely.length(area))


def pieces(area: Area) -> list[Area]:
    """Return the polygons of an area."""
    return list(shapely.get_parts(area))


def grown(area: Area, by: float) -> Area:
    """Return an area with all that is so near to it."""
    return shapely.buffer(area, by)


def opened(area: Area, radius: float, least: float) -> Area:
    """Return what discs cover that fit into an area, if there is so much room for their middles."""
    middles = [one for one in pieces(shapely.buffer(area, -radius)) if size_of(one) > least]
    return common(shapely.buffer(united(middles), radius), area) if middles else NOTHING


def hold(area: Area, points: Points) -> NDArray[np.bool_]:
    """Return which of some points (n, 2) are within an area, not at its edge."""
    shapely.prepare(area)
    within: NDArray[np.bool_] = shapely.contains_xy(area, points)
    return within


def along_outline(area: Area, step: float) -> Points:
    """Return points (n, 2) of the contours of an area, about ``step`` apart."""
    found = []
    for ring in shapely.get_rings(area):
        count = max(8, math.ceil(ring.length / step))
        at = (np.arange(count) + 0.5) / count
        found.append(shapely.line_interpolate_point(ring, at, normalized=True))
    points: Points = shapely.get_coordinates(np.concatenate(found))
    return points


def from_outline(area: Area, points: Points) -> NDArray[np.float64]:
    """Return how far points (n, 2) are from the contours of an area, (n,)."""
    rings = [shapely.get_coordinates(ring) for ring in shapely.get_rings(area)]
    sides = np.concatenate([np.stack([one[:-1], one[1:]], axis=1) for one in rings])
    tree = shapely.STRtree(shapely.linestrings(sides))
    (place, _), away = tree.query_nearest(
        shapely.points(points), return_distance=True, all_matches=False
    )
    found = np.zeros(len(points))
    found[place] = away
    return found


def outlines(area: Area, stray: float = 0.0) -> list[Points]:
    """Return the contours of an area, holes the other way round than what is around them.

    Their last point is not their first. They may ``stray`` so far from the area's.
    """
    if stray:
        area = shapely.simplify(area, stray)
    found = []
    for part in shapely.get_parts(shapely.orient_polygons(area)):
        found += [shapely.get_coordinates(ring)[:-1] for ring in shapely.get_rings(part)]
    return found


def mapped(area: Area, matrix: Sequence[float]) -> Area:
    """Return an area whose points are mapped by a matrix a, b, c, d, e, f, as SVG has them."""
    a, b, c, d, e, f = matrix
    return shapely.transform(area, lambda at: at @ np.array([[a, b], [c, d]]) + (e, f))


def _areal(found: Area) -> Area:
    """Return an area without the lines and points that touching sides have in common."""
    parts = shapely.get_parts(found)
    return shapely.union_all(parts[shapely.get_dimensions(parts) == 2])
