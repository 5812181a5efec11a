"""Outlines of many points against slow, obvious oracles, and against the clock."""

import itertools
import math
import time

import numpy as np
import pytest
import shapely
from hypothesis import example, given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.geometry import (
    crosses_itself,
    near,
    simplified,
    simplified_line,
)
from iconstudio.model import Polygon

pytestmark = pytest.mark.thorough(but=1)

grid = st.tuples(st.integers(0, 9), st.integers(0, 9))
"""On a small grid edges touch, overlap and run back a lot."""
number = st.floats(0, 60).map(lambda value: round(value, 9))
"""Products of two do not vanish, as those of 1e-200 do: the oracle would be wrong."""
free = st.tuples(number, number)
polygons = (st.lists(grid, min_size=3, max_size=20) | st.lists(free, min_size=3, max_size=40)).map(
    Polygon.of
)


def edges(polygon):
    v = polygon.vertices
    return list(zip(v, (*v[1:], *v[:1]), strict=True))


def plainly_crosses(polygon):
    """Compare each edge with each other one."""

    def side(p, q, r):
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])

    return any(
        side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0
        for (a, b), (c, d) in itertools.combinations(edges(polygon), 2)
    )


def gap(point, segment):
    (x0, y0), (x1, y1) = segment
    length = (x1 - x0) ** 2 + (y1 - y0) ** 2
    t = ((point[0] - x0) * (x1 - x0) + (point[1] - y0) * (y1 - y0)) / length if length else 0
    t = min(1, max(0, t))
    return math.hypot(point[0] - x0 - t * (x1 - x0), point[1] - y0 - t * (y1 - y0))


def along(segments, count=9):
    """Points on segments, their ends among them."""
    for (x0, y0), (x1, y1) in segments:
        for t in np.linspace(0, 1, count).tolist():
            yield x0 + t * (x1 - x0), y0 + t * (y1 - y0)


def apart(one, other):
    """How far the points of one outline are from another at most."""
    return max(min(gap(p, segment) for segment in other) for p in along(one))


@given(polygons)
def test_crossings_are_those_that_all_pairs_of_edges_have(polygon):
    assert crosses_itself(polygon) == plainly_crosses(polygon)


@pytest.mark.parametrize(
    ("points", "crosses"),
    [
        ([(0, 0), (4, 4), (4, 0), (0, 4)], True),
        ([(0, 0), (4, 0), (2, 1), (4, 4)], False),
        ([(0, 0), (4, 0), (4, 4), (2, 0), (0, 4)], False),  # a corner on an edge
        ([(0, 0), (4, 0), (4, 4), (4, 1), (4, 3), (0, 4)], False),  # to and fro
        ([], False),
        ([(0, 0), (1, 0), (0, 1)], False),
    ],
)
def test_to_touch_is_not_to_cross(points, crosses):
    assert crosses_itself(Polygon.of(points)) == crosses


@settings(max_examples=200)
@given(polygons, st.sampled_from([0.2, 2.0, 6.0]))
def test_a_simplified_outline_is_near_and_crosses_itself_only_if_it_did(polygon, stray):
    few = simplified(polygon, stray)
    assert set(few.vertices) <= set(polygon.vertices)
    assert len(few.vertices) <= len(polygon.vertices)
    assert plainly_crosses(polygon) or not plainly_crosses(few)
    assert apart(edges(polygon), edges(few)) <= stray + 1e-9
    assert apart(edges(few), edges(polygon)) <= stray + 1e-9


@settings(max_examples=40)
@given(st.lists(st.floats(0.05, 0.95), min_size=1, max_size=8), st.sampled_from([0.2, 1.0, 4.0]))
def test_what_reaches_into_a_dent_is_not_crossed(depths, stray):
    """Dents smaller than the tolerance, into which tips reach: plain simplification fails here."""
    places = [10.0 * number for number in range(1, len(depths) + 1)]
    dents, tips = [], []
    for x, depth in zip(places, depths, strict=True):
        dents += [(x - 3, 0), (x, 0.9 * stray), (x + 3, 0)]
        tips[:0] = [(x + 0.1, -20), (x, 0.85 * stray * depth), (x - 0.1, -20)]
    end = places[-1] + 10
    polygon = Polygon.of([(0, 0), (2, 0), *dents, (end, 0), (end, -20), *tips, (0, -20)])
    assert not plainly_crosses(polygon)
    few = simplified(polygon, stray)
    assert not plainly_crosses(few)
    assert (2, 0) not in few.vertices
    assert apart(edges(polygon), edges(few)) <= stray + 1e-9


def test_the_corners_of_a_square_are_kept():
    sides = [(x, 0) for x in range(10)] + [(10, y) for y in range(10)]
    sides += [(x, 10) for x in range(10, 0, -1)] + [(0, y) for y in range(10, 0, -1)]
    assert simplified(Polygon.of(sides), 0.5).vertices == ((0, 0), (10, 0), (10, 10), (0, 10))


def test_what_would_vanish_stays():
    small = Polygon.of([(0, 0), (1, 0), (0, 1)])
    assert simplified(small, 5) == small


@given(st.lists(free, min_size=1, max_size=40), st.sampled_from([0.2, 2.0]))
def test_a_simplified_line_is_near_and_has_its_ends(line, stray):
    line = [point for point in line for _ in range(1 + (len(line) % 3 == 0))]  # some points twice
    few = simplified_line(line, stray)
    assert (few[0], few[-1]) == (line[0], line[-1])
    assert set(few) <= set(line)
    segments = list(itertools.pairwise(few)) or [(few[0], few[0])]
    assert apart([*itertools.pairwise(line), (line[0], line[0])], segments) <= stray + 1e-9


@given(
    st.lists(free, min_size=1, max_size=9), st.lists(free, min_size=1, max_size=9), st.floats(0, 30)
)
@example([(0.0, 0.0)], [(0.0, 0.0), (0.0, 2.2250738585e-313)], 0.0)
def test_what_is_near_a_line_is_near_one_of_its_segments(points, line, reach):
    segments = list(itertools.pairwise(line)) or [(line[0], line[0])]
    gaps = np.array([min(gap(point, segment) for segment in segments) for point in points])
    ours = near(np.array(points), line, reach)
    assert ours[gaps < reach - 1e-9].all()
    assert not ours[gaps > reach + 1e-9].any()


# -- many points ---------------------------------------------------------------------------------

MANY = 20_000


def turned(points, angle):
    c, s = math.cos(angle), math.sin(angle)
    return (np.array(points) - 128) @ [[c, s], [-s, c]] + 128


def circle(noise):
    """An outline as a segmentation gives it, with so much noise."""
    random, angles = np.random.default_rng(0), np.linspace(0, 2 * np.pi, MANY, endpoint=False)
    radii = 90 + 15 * np.cos(3 * angles) + noise * random.normal(size=MANY)
    return 128 + radii[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)


def saw(angle):
    """Ten thousand teeth, closed below."""
    ys = np.where(np.arange(MANY) % 2, 20.0, 200.0)
    ys[[0, -1]] = 230
    return turned(np.stack([np.linspace(20, 236, MANY), ys], axis=1), angle)


def spiral():
    """A band wound up forty times."""
    angles = np.linspace(0, 80 * np.pi, MANY // 2)
    inner, outer = ((r + 80 * angles / angles[-1]) * np.exp(1j * angles) for r in (20, 20.8))
    whole = np.concatenate([inner, outer[::-1]])
    return np.stack([whole.real, whole.imag], axis=1) + 128


def fading():
    """A zigzag that fades: the farthest point of each part is the next one."""
    ys = 128 + np.where(np.arange(MANY) % 2, 1, -1) * np.linspace(100, 0, MANY)
    return [*zip(np.linspace(20, 236, MANY), ys, strict=True), (300, 128), (300, 400), (0, 400)]


def star():
    """A star all of whose edges cross."""
    angles = np.arange(MANY + 1) * 2 * np.pi * (MANY // 2) / (MANY + 1)
    return 128 + 100 * np.stack([np.cos(angles), np.sin(angles)], axis=1)


OUTLINES = {
    "smooth": (circle(0), False),
    "noisy": (circle(0.02), False),
    "ragged": (circle(0.5), False),
    "upright teeth": (saw(0), False),
    "slanting teeth": (saw(0.7), False),
    "teeth": (saw(0.5), False),
    "spiral": (spiral(), False),
    "fading": (fading(), False),
    "star": (star(), True),
    "random": (np.random.default_rng(1).uniform(20, 236, (MANY, 2)), True),
}


@pytest.mark.parametrize("name", OUTLINES)
def test_twenty_thousand_points_are_taken_in_a_moment(name):
    points, crosses = OUTLINES[name]
    assert crosses_itself(Polygon.of([(0, 0), (4, 4), (4, 0), (0, 4)]))  # loads the library
    began = time.process_time()
    polygon = Polygon.of(np.array(points).tolist())
    few = simplified(polygon, 0.1)
    few.fitted()
    assert crosses_itself(polygon) == crosses
    assert time.process_time() - began < 2.5  # a third of it on a machine with nothing else to do
    assert crosses or not crosses_itself(few)
    ring, corners = shapely.LinearRing(few.vertices), set(few.vertices)
    left_out = [point for point in polygon.vertices if point not in corners]
    shapely.prepare(ring)
    assert shapely.dwithin(ring, shapely.points(left_out), 0.1 + 1e-9).all()
