"""The compiled search against the plain loop, and what it is made of against brute force."""

from dataclasses import replace

import numpy as np
import pytest

from iconstudio.algorithms.curves.analogy import Search, Synthesised
from iconstudio.algorithms.curves.constraints import Constraint, combined, softened
from iconstudio.algorithms.curves.curve import Curve
from iconstudio.algorithms.curves.example import Pair
from iconstudio.algorithms.curves.parameters import Parameters
from iconstudio.algorithms.curves.pyramid import pyramid, swept
from tests.line_styles import castle, jitter, pair_of, unit
from tests.oracles.curve_analogies import Refinement

pytestmark = pytest.mark.thorough(but=1)

PARAMETERS = replace(Parameters(), levels=0, epsilon=0.0, late=0.0)


def shaken(plain, spacing, seed):
    """A curve to be refined: the plain one, its points moved a little."""
    curve = plain.resampled(spacing)
    random = np.random.default_rng(seed)
    moved = random.normal(size=len(curve.points)) + 1j * random.normal(size=len(curve.points))
    return replace(curve, points=curve.points + moved)


@pytest.mark.parametrize("style", [jitter, castle])
@pytest.mark.parametrize("rotation", [False, True])
def test_a_pass_over_a_curve_is_that_of_the_plain_loop(style, rotation):
    whole = pair_of(style()[:160])
    pair = Pair(whole.plain.resampled(1.0), whole.styled.resampled(1.0))
    plain = unit(np.array([20 + 30j, 90 + 60j]))
    (level,) = pyramid([whole], PARAMETERS)
    made = shaken(plain, level.spacing, 3)
    sources = np.full(len(made.points), -1)
    search = Search(
        level, plain, PARAMETERS, np.ones(1, np.uint64), rotation, sweep=swept(plain, PARAMETERS)
    )
    found = search.refined(Synthesised(made, sources), None)
    oracle = Refinement(pair, PARAMETERS, level.spacing, rotation)
    points, taken = oracle.run(plain, made, level.parameters, level.order.arc)
    assert found.sources.tolist() == taken
    assert found.curve.points == pytest.approx(points, abs=1e-6)


@pytest.mark.parametrize("seed", range(5))
def test_the_rotation_in_closed_form_is_the_best_of_all_angles(seed):
    random = np.random.default_rng(seed)
    a, b = random.normal(size=(2, 9)) + 1j * random.normal(size=(2, 9))
    w = random.uniform(0.1, 1, 9)
    a, b = (one - (w @ one) / w.sum() for one in (a, b))
    product = (w * a.conj() * b).sum()
    closed = w @ abs(a) ** 2 + w @ abs(b) ** 2 - 2 * abs(product)
    angles = np.exp(1j * np.linspace(0, 2 * np.pi, 20_000))
    tried = (w[:, None] * abs(angles * a[:, None] - b[:, None]) ** 2).sum(axis=0)
    assert closed == pytest.approx(tried.min(), abs=1e-6)
    assert product / abs(product) == pytest.approx(angles[tried.argmin()], abs=1e-3)


def test_constraints_soften_by_level():
    for weight in (0.5, 4.0, np.inf):
        for above in (1, 3):
            one = softened(Constraint(0.2, 1j, weight), above)
            assert 1 / one.weight == pytest.approx(1 / weight + above)
            assert (one.parameter, one.place) == (0.2, 1j)


def test_constraints_at_one_point_act_as_their_mean():
    at = np.array([0.0, 0.5, 1.0])
    some = [Constraint(0.5, 0j, 1.0), Constraint(0.5, 6 + 0j, 2.0), Constraint(1.0, 2j)]
    places, weights = combined(some, at)
    assert places.tolist() == [0, 4, 2j]
    assert weights.tolist() == [0, 3, np.inf]


def test_hard_constraints_that_contradict_meet_in_the_middle():
    some = [Constraint(0.0, 0j), Constraint(0.0, 4 + 0j), Constraint(0.0, 100j, 5.0)]
    places, weights = combined(some, np.array([0.0, 1.0]))
    assert places[0] == 2
    assert weights[0] == np.inf


def test_candidates_make_whole_steps_of_each_level():
    for level in pyramid([pair_of(jitter())], Parameters()):
        apart = np.diff(level.order.arc)
        assert level.spacing / apart == pytest.approx(np.round(level.spacing / apart), rel=1e-3)
        assert not Curve.of(level.styled.middles).closed
