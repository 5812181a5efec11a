import numpy as np
import pytest
from scipy.spatial.distance import cdist

from iconstudio.algorithms.iconification import signed_distance
from iconstudio.algorithms.nearby import Nearby


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("within", [0.5, 3.0, 9.0, 40.0])
def test_the_nearest_is_that_of_all_distances(seed, within):
    random = np.random.default_rng(seed)
    points = random.uniform(-30, 60, size=(seed**3, 2)).round(seed)
    asked = random.uniform(-80, 120, size=(200, 2)).round(1)
    away, found = Nearby(points).nearest(asked, within)
    every = cdist(asked, points)
    least = every.min(axis=1, initial=np.inf)
    near = least < within
    assert np.array_equal(away, np.where(near, least, np.inf))
    assert np.array_equal(found >= 0, near)
    assert np.array_equal(every[near, found[near]], least[near])


def test_points_are_asked_about_in_any_order():
    points = np.array([[0.0, 0.0], [100.0, 3.0]])
    away, found = Nearby(points).nearest(np.array([[1.0, 0], [99, 3], [50, 0], [0, 1]]), 2.0)
    assert away.tolist() == [1, 1, np.inf, 1]
    assert found.tolist() == [0, 1, -1, 0]


@pytest.mark.parametrize("reach", [1, 5, 30])
def test_no_crossing_near_a_corner_is_missing(reach):
    random = np.random.default_rng(reach)
    coverage = random.integers(0, 256, size=(50, 50), dtype=np.uint8)
    corners = random.integers(0, 50, size=(3, 2))
    found = set(map(tuple, signed_distance._contour(coverage, corners, reach).tolist()))
    every = []
    for y, x in np.ndindex(50, 50):
        for dy, dx in ((1, 0), (0, 1)):
            if y + dy < 50 and x + dx < 50:
                a, b = float(coverage[y, x]), float(coverage[y + dy, x + dx])
                if (a > 127) != (b > 127):
                    part = (127.5 - a) / (b - a)
                    every.append((y + dy * part, x + dx * part))
    near = cdist(every, corners).min(axis=1) <= reach
    assert {one for one, close in zip(every, near, strict=True) if close} <= found <= set(every)
