"""Regions against areas of polygons, and against what is known of circles."""

import math

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms import regions
from iconstudio.algorithms.flattening import flattened
from iconstudio.model import Path
from iconstudio.model.path import Contour
from tests.paths import circle

corners = st.tuples(st.integers(0, 64), st.integers(0, 64))
triangles = st.lists(corners, min_size=3, max_size=3, unique=True)


def path(points) -> Path:
    return Path((Contour(points[0], tuple((one,) for one in points[1:])),))


def area(region) -> float:
    """What a region covers: its outline must overlap itself nowhere."""
    return abs(regions.outline(region).area)


@settings(max_examples=60)
@given(triangles, triangles)
def test_operations_are_those_of_polygons(one, other):
    first, second = shapely.Polygon(one).buffer(0), shapely.Polygon(other).buffer(0)
    a, b = regions.filled(path(one)), regions.filled(path(other))
    assert area(regions.united([a, b])) == pytest.approx(first.union(second).area, abs=0.02)
    assert area(regions.common(a, b)) == pytest.approx(first.intersection(second).area, abs=0.02)
    assert area(regions.without(a, b)) == pytest.approx(first.difference(second).area, abs=0.02)


def test_the_rule_is_heeded():
    outer, inner = [(0, 0), (30, 0), (30, 30), (0, 30)], [(10, 10), (20, 10), (20, 20), (10, 20)]
    both = Path((*path(outer).contours, *path(inner).contours))
    assert area(regions.united([regions.filled(both)])) == 900
    assert area(regions.united([regions.filled(both, even_odd=True)])) == 800


def test_a_stroked_line_is_as_long_and_as_wide():
    line = Path((Contour((10, 20), (((50, 20),),), closed=False),))
    for cap, longer in (("flat", 0), ("square", 6)):
        pen = regions.stroked(line, (2, 0, 0, 2, 0, 0), 6, cap, "mitre", 4)
        assert area(regions.united([pen])) == pytest.approx((40 + longer) * 2 * 12)
    dashed = regions.stroked(line, (1, 0, 0, 1, 0, 0), 6, "flat", "mitre", 4, [5, 5])
    assert area(regions.united([dashed])) == pytest.approx(20 * 6, abs=0.01)


@pytest.mark.parametrize("radius", [5, 30, 110])
def test_a_stroked_circle_is_two_circles_of_few_nodes(radius):
    ring = circle(128, 128, radius)
    outline = regions.outline(
        regions.united([regions.stroked(ring, (1, 0, 0, 1, 0, 0), 8, "round", "round", 4)])
    )
    assert len(outline.contours) == 2
    for row, _ in flattened(outline):
        away = np.hypot(*(row - 128).T)
        assert min(abs(away - radius - 4).max(), abs(away - radius + 4).max()) < 0.08
    assert sum(len(one.segments) for one in outline.contours) <= 18
    ring_area = math.pi * ((radius + 4) ** 2 - (radius - 4) ** 2)
    assert abs(outline.area) == pytest.approx(ring_area, abs=0.05 * 2 * math.pi * 2 * radius)
