"""Lines drawn: near the truth, closed, without overlaps, and of few segments."""

import math

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.curves.outline import path_of, strokes_of
from iconstudio.algorithms.flattening import flattened
from iconstudio.model import Line

BOUND = 0.2
"""Canvas units by which a drawing may be off the lines."""


def wavy(count, radius=80.0, height=4.0, seed=1, turn=1.0):
    """Return a circle with waves of several lengths, or a part of one."""
    rng = np.random.default_rng(seed)
    t = np.linspace(0, 2 * np.pi * turn, count, endpoint=turn < 1)
    waves = sum(rng.normal() * np.cos(k * t + rng.uniform(0, 6)) for k in range(5, 25))
    r = radius + height * waves / math.sqrt(20)
    return tuple(zip((128 + r * np.cos(t)).tolist(), (128 + r * np.sin(t)).tolist(), strict=True))


def area_of(path):
    """Return what a path fills, whose contours do not cross, as shapely sees it."""
    rings = [shapely.Polygon(points) for points, _ in flattened(path, 0.002)]
    assert all(map(shapely.is_valid, rings))
    found = shapely.Polygon()
    for ring in sorted(rings, key=shapely.area, reverse=True):
        found = shapely.symmetric_difference(found, ring)
    return found


def off(path, truth):
    """Return how far the outline of a path is from the boundary of what it should be."""
    return shapely.hausdorff_distance(
        shapely.segmentize(shapely.boundary(area_of(path)), 0.5),
        shapely.segmentize(shapely.boundary(truth), 0.5),
    )


def check_sound(path):
    for contour in path.contours:
        assert contour.closed
        assert np.isfinite(list(contour.points)).all()
        gap = math.dist(contour.segments[-1][-1], contour.start)  # which is closed by a line
        assert gap == 0 or gap > 1e-6


def test_a_contour_is_fitted_by_few_cubics_near_to_it():
    points = wavy(1000)
    path = path_of([Line(points, True)])
    check_sound(path)
    assert off(path, shapely.Polygon(points)) < BOUND
    assert sum(len(one.segments) for one in path.contours) < 100


@pytest.mark.parametrize("closed", [True, False])
def test_a_stroke_is_drawn_with_round_ends_and_joins(closed):
    points = wavy(500, turn=1.0 if closed else 0.8)
    path = path_of([Line(points, closed, width=14.0)])
    check_sound(path)
    line = shapely.LinearRing(points) if closed else shapely.LineString(points)
    assert off(path, shapely.buffer(line, 7.0, quad_segs=32)) < BOUND
    assert len(path.contours) == 1 + closed


def test_a_width_that_changes_is_drawn_as_it_does():
    count = 400
    points = wavy(count, turn=0.7)
    widths = tuple((10 + 6 * np.sin(np.arange(count) / 25)).tolist())
    path = path_of([Line(points, False, 10.0, widths)])
    check_sound(path)
    pieces = [
        shapely.convex_hull(
            shapely.union(
                *(
                    shapely.buffer(shapely.Point(points[at]), widths[at] / 2, quad_segs=24)
                    for at in (k, k + 1)
                )
            )
        )
        for k in range(count - 1)
    ]
    assert off(path, shapely.union_all(pieces)) < BOUND


def test_corners_are_kept():
    steps = [(20 + 10 * (k // 2), 92 if k % 4 in (1, 2) else 100) for k in range(1, 35)]
    points = (*((float(x), float(y)) for x, y in steps), (190.0, 200.0), (20.0, 200.0))
    path = path_of([Line(points, True)])
    drawn = {one for contour in path.contours for one in contour.points}
    sharp = shapely.get_coordinates(shapely.simplify(shapely.Polygon(points), 0.01))
    for corner in sharp:
        assert min(math.dist(corner, one) for one in drawn) < 1e-6
    assert all(len(one) == 1 for contour in path.contours for one in contour.segments)


def test_a_circle_is_four_cubics():
    t = np.linspace(0, 2 * np.pi, 200, endpoint=False)
    ring = tuple(zip((128 + 90 * np.cos(t)).tolist(), (128 + 90 * np.sin(t)).tolist(), strict=True))
    assert len(path_of([Line(ring, True)]).contours[0].segments) == 4


def test_everything_is_one_outline_without_overlaps():
    contour = Line(((20.0, 20.0), (200.0, 20.0), (200.0, 200.0), (20.0, 200.0)), True)
    hole = Line(((60.0, 60.0), (60.0, 160.0), (160.0, 160.0), (160.0, 60.0)), True)
    stroke = Line(((110.0, 40.0), (110.0, 230.0)), False, 20.0)
    path = path_of([contour, hole, stroke])
    check_sound(path)
    truth = shapely.union(
        shapely.Polygon(contour.points, [hole.points]),
        shapely.buffer(shapely.LineString(stroke.points), 10, quad_segs=32),
    )
    assert off(path, truth) < BOUND
    assert len(path.contours) == 3


POINT = st.tuples(st.integers(0, 64), st.integers(0, 64)).map(
    lambda one: (one[0] * 4.0, one[1] * 4.0)
)


@settings(max_examples=60)
@given(
    st.lists(
        st.builds(
            Line,
            st.lists(POINT, min_size=1, max_size=12).map(tuple),
            st.booleans(),
            st.sampled_from([0.0, 0.5, 6.0, 30.0]),
        ),
        max_size=4,
    )
)
def test_whatever_the_lines_are_the_drawing_is_sound(lines):
    path = path_of(lines)
    check_sound(path)
    again = path_of(lines)
    assert path == again
    for one, width in strokes_of(lines):
        for contour in one.contours:
            assert np.isfinite(list(contour.points)).all()
            assert contour.closed or width > 0


@settings(max_examples=25)
@given(
    st.lists(POINT, min_size=2, max_size=10, unique=True),
    st.booleans(),
    st.lists(st.sampled_from([0.0, 1.0, 12.0]), min_size=10, max_size=10),
)
def test_any_width_along_any_line_is_sound(points, closed, widths):
    line = Line(tuple(points), closed, 6.0, tuple(widths[: len(points)]))
    check_sound(path_of([line]))


def test_degenerate_lines_are_drawn_as_far_as_they_can_be():
    assert not path_of([])
    assert not path_of([Line(((5.0, 5.0),), True)])
    assert not path_of([Line(((5.0, 5.0), (9.0, 5.0)), True)])
    dot = path_of([Line(((50.0, 50.0), (50.0, 50.0)), False, 8.0)])
    assert area_of(dot).area == pytest.approx(16 * math.pi, rel=0.02)
    assert area_of(path_of([Line(((50.0, 50.0),), False, 8.0, (8.0,))])).area == pytest.approx(
        16 * math.pi, rel=0.02
    )


def test_strokes_stay_strokes():
    lines = [
        Line(wavy(300), True, 12.0),
        Line(wavy(200, radius=30, turn=0.5), False, 12.0),
        Line(((100.0, 100.0), (100.0, 100.0)), False, 5.0),
        Line(((10.0, 10.0), (40.0, 10.0), (40.0, 40.0)), True),
    ]
    (filled, none), (thick, width), (dot, small) = strokes_of(lines)
    assert (none, width, small) == (0.0, 12.0, 5.0)
    assert len(filled.contours) == 1
    assert [one.closed for one in thick.contours] == [True, False]
    assert dot.svg() == "M100 100H100.01"
    for contour, line in zip(thick.contours, lines, strict=False):
        ((points, closed),) = flattened(type(thick)((contour,)), 0.002)
        assert closed == line.closed
        drawn = shapely.LinearRing(points) if closed else shapely.LineString(points)
        truth = shapely.LinearRing(line.points) if closed else shapely.LineString(line.points)
        assert shapely.hausdorff_distance(drawn, truth) < BOUND
        if not closed:
            assert (contour.start, contour.segments[-1][-1]) == (line.points[0], line.points[-1])
