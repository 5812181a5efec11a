"""Styled lines give way where the plain ones do not meet."""

import numpy as np
import shapely

from iconstudio.algorithms.curves.curve import Curve
from iconstudio.algorithms.curves.untangling import untangled
from tests.line_styles import unit


def loops(length, count, radius):
    """A straight line, on its way a few loops around itself."""
    turn = np.linspace(0, 2 * np.pi * count, 20 * count)
    return length * turn / turn[-1] + radius * (np.sin(turn) + 1j * (1 - np.cos(turn)))


def test_small_loops_on_a_slanted_line_give_way():
    """Rounding once told that the points of a straight line cross already: so loops stayed."""
    random = np.random.default_rng(1)
    plain = unit(np.array([0, 60 + 60j]))
    points = (1 + 1j) * loops(60, 12, 1.0)
    at = np.sort(random.uniform(0, 1, len(points)))
    (made,) = untangled([plain], [Curve(points, at, plain.end, False)], [0.0])
    assert not _is_simple(points)
    assert _is_simple(made.points)


def test_loops_as_long_as_the_style_s_may_stay():
    plain = unit(np.array([0, 200 + 0j]))
    points = loops(200, 6, 6.0)
    curve = Curve(points, np.linspace(0, plain.end, len(points)), plain.end, False)
    (made,) = untangled([plain], [curve], [0.0], loop=40.0)
    assert np.array_equal(made.points, points)


def _is_simple(points):
    return shapely.LineString(np.column_stack([points.real, points.imag])).is_simple
