"""Lines of a smooth style are smooth, also where two stretches of its example meet."""

import numpy as np
import pytest

from iconstudio.algorithms.curves.constraints import Constraint
from iconstudio.algorithms.curves.curve import Curve
from iconstudio.algorithms.curves.kinks import without_kinks
from iconstudio.algorithms.curves.parameters import Parameters
from iconstudio.algorithms.curves.pyramid import pyramid
from iconstudio.algorithms.curves.restyle import prepare, restyled
from iconstudio.inputs.styles import named
from iconstudio.model import Line
from tests.line_styles import castle, circle, pair_of, unit

SMOOTH = Parameters(levels=0)
WAVES = np.arange(0, 400, 1.0) + 4j * np.sin(np.arange(0, 400, 1.0) / 9)


def sharpest(curve, arc=4.0):
    """By how many degrees a curve turns, at most, from one stretch of some length to the next."""
    at = np.arange(arc, curve.length - arc, 0.5)
    behind, here, ahead = (curve.at_arc(at + step) for step in (-arc, 0, arc))
    return np.degrees(abs(np.angle((ahead - here) * (here - behind).conj())).max())


def stepped(curve):
    """A curve that jumps aside in its middle."""
    points = curve.points.copy()
    points[len(points) // 2 :] += 4j
    return Curve(points, curve.parameters, curve.end)


def test_a_step_aside_becomes_smooth_and_nothing_else_changes():
    (level,) = pyramid([pair_of(WAVES)], SMOOTH)
    plain = unit(np.linspace(0, 200, 101).astype(complex))
    made = Curve(plain.points + 4j * np.sin(plain.points.real / 9), plain.parameters, 1.0)
    assert without_kinks(made, plain, level, []).points == pytest.approx(made.points)
    step = stepped(made)
    calm = without_kinks(step, plain, level, [])
    assert sharpest(step) > 40
    assert sharpest(calm) < 1.6 * sharpest(made)
    far = abs(np.arange(101) - 50) > 40
    assert calm.points[far] == pytest.approx(step.points[far])


def test_constraints_hold_where_a_line_becomes_smooth():
    (level,) = pyramid([pair_of(WAVES)], SMOOTH)
    plain = unit(np.linspace(0, 200, 101).astype(complex))
    step = stepped(plain)
    at = 48
    fixed = Constraint(step.parameters[at], step.points[at])
    calm = without_kinks(step, plain, level, [fixed])
    assert (calm.points[[0, at, -1]] == step.points[[0, at, -1]]).all()
    assert sharpest(calm) < sharpest(step)


def test_corners_of_the_example_and_of_the_line_stay():
    (level,) = pyramid([pair_of(castle())], SMOOTH)
    plain = unit(np.concatenate([np.linspace(0, 100, 51), 100 + 1j * np.linspace(2, 100, 50)]))
    assert without_kinks(plain, plain, level, []).points == pytest.approx(plain.points)
    (level,) = pyramid([pair_of(WAVES)], SMOOTH)
    assert without_kinks(plain, plain, level, []).points == pytest.approx(plain.points)


def test_a_smooth_style_makes_smooth_lines():
    """Around a circle, where the end meets the start, they turned by 70 degrees at once."""
    style = prepare(named("Wobbly"))
    ring = Line(tuple((z.real, z.imag) for z in circle(90.0).points.tolist()), True, 10.0)
    for seed in (1, 2, 4, 7):
        (made,) = restyled([(ring, style)], seed)
        assert sharpest(Curve.of(np.array(made.points) @ [1, 1j])) < 30
