"""Areas against their definitions, point by point."""

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms import areas
from iconstudio.algorithms.curves.brush import sides, turns

COORDINATE = st.integers(0, 40)
CONTOUR = st.lists(st.tuples(COORDINATE, COORDINATE), min_size=3, max_size=9).map(
    lambda points: np.array(points, dtype=float)
)
RNG = np.random.default_rng(5)
PLACES = RNG.uniform(-2, 42, (300, 2)) + np.pi / 1000


def winding(place, ring):
    """Add up the angles under which the sides of a ring are seen."""
    seen = np.append(ring, ring[:1], axis=0) - place
    angles = np.arctan2(seen[:, 1], seen[:, 0])
    steps = (np.diff(angles) + np.pi) % (2 * np.pi) - np.pi
    return round(steps.sum() / (2 * np.pi))


def square(left, top, side, clockwise=True):
    ring = np.array([(0, 0), (1, 0), (1, 1), (0, 1)]) * side + (left, top)
    return ring if clockwise else ring[::-1]


@settings(max_examples=40)
@given(st.lists(CONTOUR, min_size=1, max_size=3), st.booleans())
def test_what_contours_enclose_is_what_they_go_round(contours, even_odd):
    area = areas.filled(contours, even_odd)
    assert shapely.is_valid(area)
    counts = np.array([sum(winding(place, one) for one in contours) for place in PLACES])
    wanted = counts % 2 == 1 if even_odd else counts != 0
    assert np.array_equal(shapely.contains_xy(area, PLACES), wanted)


def test_contours_that_do_not_cross_are_filled_by_the_nonzero_rule():
    nested = [square(0, 0, 40), square(5, 5, 30, clockwise=False), square(10, 10, 10)]
    for rings in (nested, [one[::-1] for one in nested], nested[::-1]):
        assert areas.size_of(areas.inked(rings)) == 1600 - 900 + 100
    apart = [square(0, 0, 10), square(20, 20, 10, clockwise=False)]
    assert areas.size_of(areas.inked(apart)) == 200


def test_a_hole_is_no_ink_outside_of_its_shape_nor_where_it_goes_round_twice():
    shape = square(0, 0, 40)
    out = square(30, 10, 20, clockwise=False)
    assert areas.size_of(areas.inked([shape, out - (5, 0)])) == 1600 - 15 * 20
    curl = np.array([(5, 5), (5, 35), (20, 35), (20, 20), (12, 20), (12, 27), (30, 27), (30, 5)])
    assert winding((16.0, 24.0), curl) == -2
    left = areas.inked([shape, curl])
    assert not shapely.contains_xy(left, 16, 24)
    assert shapely.contains_xy(areas.filled([shape, curl]), 16, 24)


def covered(places, points, closed, widths):
    """Whether places are within the brush, which is moved along the line in small steps."""
    row = np.append(points, points[:1], axis=0) if closed else points
    radii = (np.append(widths, widths[:1]) if closed else widths) / 2
    t = np.linspace(0, len(row) - 1, 400 * len(row))
    at = np.column_stack([np.interp(t, np.arange(len(row)), row[:, axis]) for axis in (0, 1)])
    off = np.hypot(*(places[:, None] - at).transpose(2, 0, 1))
    return (off - np.interp(t, np.arange(len(row)), radii)).min(axis=1)


@settings(max_examples=25)
@given(
    st.lists(st.tuples(COORDINATE, COORDINATE), min_size=1, max_size=7, unique=True),
    st.booleans(),
    st.integers(0, 2**16),
)
def test_a_brush_covers_what_its_discs_do(points, closed, seed):
    points = np.array(points, dtype=float)
    closed = closed and len(points) > 2
    widths = np.random.default_rng(seed).uniform(0, 12, len(points))
    row = points[:, 0] + 1j * points[:, 1]
    rings = [np.column_stack([one.real, one.imag]) for one in sides(row, closed, widths / 2)]
    discs = [areas.stroked(points[[at]], False, widths[at]) for at in turns(row, closed)]
    area = areas.united([areas.filled(rings), *discs])
    depth = covered(PLACES, points, closed, widths)
    clear = abs(depth) > 0.3  # arcs have sides, and steep cones are cut
    assert (shapely.contains_xy(area, PLACES) == (depth < 0))[clear].mean() > 0.99


@pytest.mark.parametrize(("cap", "size"), [("round", np.pi * 4), ("flat", 0), ("square", 16)])
def test_a_stroke_without_length_is_a_dot(cap, size):
    dot = areas.stroked(np.array([[5.0, 5.0], [5.0, 5.0]]), False, 4.0, cap)
    assert areas.size_of(dot) == pytest.approx(size, rel=0.03)


def test_outlines_run_one_way_and_holes_the_other():
    area = areas.without(areas.rectangle(0, 0, 40, 40), areas.rectangle(10, 10, 20, 20))
    outer, hole = areas.outlines(area)
    assert winding((5.0, 5.0), outer) == -winding((15.0, 15.0), hole) != 0


def test_specks_are_left_out():
    area = areas.united([areas.rectangle(0, 0, 10, 10), areas.rectangle(20, 20, 20.1, 20.1)])
    area = areas.without(area, areas.rectangle(4, 4, 4.2, 4.2))
    assert areas.size_of(areas.without_specks(area, 0.25)) == 100


@pytest.mark.parametrize("seed", range(6))
def test_a_closed_stroke_wider_than_what_it_encloses_is_whole(seed):
    """Rings were torn there; the oracle is a capsule for each side."""
    corners = np.array([[100, 100], [116, 100], [108, 108]], float)
    after = np.roll(corners, -1, axis=0)
    sides = [np.linspace(a, b, 8, endpoint=False) for a, b in zip(corners, after, strict=True)]
    points = np.concatenate(sides) + np.random.default_rng(seed).normal(0, 1.0, (24, 2))
    following = np.roll(points, -1, axis=0)
    capsules = areas.united(
        areas.stroked(np.array([a, b]), False, 22.2) for a, b in zip(points, following, strict=True)
    )
    stroke = areas.stroked(points, True, 22.2)
    assert areas.size_of(areas.without(capsules, stroke)) < 0.5
    assert areas.size_of(areas.without(stroke, capsules)) < 0.5


@settings(max_examples=30)
@given(st.lists(st.tuples(COORDINATE, COORDINATE, COORDINATE, COORDINATE), max_size=12))
def test_sides_whose_boxes_meet_are_found(sides):
    ends = np.array(sides, dtype=float).reshape(-1, 2, 2)
    low, high = ends.min(axis=1), ends.max(axis=1)
    wanted = {
        (i, j)
        for j in range(len(ends))
        for i in range(j)
        if (low[i] <= high[j]).all() and (low[j] <= high[i]).all()
    }
    found = areas.meeting_boxes(ends[:, 0], ends[:, 1])
    assert set(map(tuple, found.tolist())) == wanted
    assert len(found) == len(wanted)


def test_what_a_contour_that_crosses_itself_encloses_is_one_piece():
    plain = np.array([(0.0, 0.0), (40, 0), (40, 40), (0, 40)])
    assert areas.one_piece(plain, 0.8) is plain
    loop = np.array([(0.0, 0), (18, 0), (22, -8), (18, -8), (22, 0), (40, 0), (40, 40), (0, 40)])
    for contour in (loop, loop[::-1]):
        outline = areas.one_piece(contour, 0.8)
        ring = shapely.LinearRing(outline)
        assert ring.is_simple
        assert ring.is_ccw == shapely.LinearRing(contour).is_ccw
        assert shapely.Polygon(ring).area == pytest.approx(1600 + 16, abs=1)
        assert outline[:, 1].min() < -7.9
