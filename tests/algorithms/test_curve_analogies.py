"""*Curve Analogies* as a whole: what a fake would not pass."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from iconstudio.algorithms.curves.constraints import Constraint
from iconstudio.algorithms.curves.curve import Curve
from iconstudio.algorithms.curves.example import Pair
from iconstudio.algorithms.curves.multiresolution import analogy, scribble
from iconstudio.algorithms.curves.parameters import Parameters
from iconstudio.algorithms.curves.pyramid import pyramid
from tests.line_styles import (
    STYLES,
    circle,
    misfit,
    offset,
    pair_of,
    rounded_square,
    spectrum,
    unit,
)

pytestmark = pytest.mark.thorough(but=1)

PARAMETERS = Parameters()
SHAPES = circle, rounded_square
SEEDS = range(4)


@pytest.fixture(scope="module")
def pairs():
    return {name: pair_of(style()) for name, style in STYLES.items()}


@cache
def levels_of(name):
    return pyramid([pair_of(STYLES[name]())], PARAMETERS)


@cache
def made_of(name):
    """The closed shapes in a style, and what they were made of."""
    return [
        (shape(), analogy(levels_of(name), shape(), PARAMETERS, seed))
        for shape in SHAPES
        for seed in SEEDS
    ]


@pytest.fixture(params=list(STYLES))
def name(request):
    return request.param


def half_difference(one, other):
    return abs(one - other).sum() / 2


def mean_spectrum(curves):
    return np.mean([spectrum(curve, plain) for plain, curve in curves], axis=0)


@pytest.mark.thorough
def test_the_texture_is_that_of_the_example(name, pairs):
    wanted = spectrum(pairs[name].styled, pairs[name].plain)
    found = mean_spectrum([(plain, one.curve) for plain, one in made_of(name)])
    assert half_difference(found, wanted) <= 0.2


def test_neither_the_line_itself_nor_noise_has_the_texture(name, pairs):
    wanted = spectrum(pairs[name].styled, pairs[name].plain)
    random = np.random.default_rng(3)
    plain = circle()
    points = plain.resampled(0.5).points
    shaken = points + 0.4 * random.normal(size=len(points))
    assert half_difference(spectrum(unit(shaken, True), plain), wanted) >= 0.36


def test_lines_go_as_far_from_the_plain_ones_as_in_the_example(name, pairs):
    wanted = offset(pairs[name].styled, pairs[name].plain)
    found = np.mean([offset(one.curve, plain) for plain, one in made_of(name)])
    assert 0.8 <= found / wanted <= 1.2


def test_every_part_looks_like_some_part_of_the_example(name, pairs):
    found = np.mean([misfit(one.curve, pairs[name].styled) for _, one in made_of(name)])
    back = np.mean([misfit(pairs[name].styled, one.curve) for _, one in made_of(name)])
    assert found <= 0.5
    assert back <= 0.5


def test_most_points_go_on_where_the_one_before_was_taken_from(name):
    for _, one in made_of(name):
        steps = np.diff(one.sources)
        assert np.mean((steps >= 0) & (steps <= 3)) >= 0.85


def test_closed_lines_close(name):
    for _, one in made_of(name):
        gaps = abs(np.diff(np.append(one.curve.points, one.curve.points[:1])))
        assert gaps[-1] <= 2.5 * np.median(gaps)


def test_turning_and_moving_all_turns_and_moves_the_result(name, pairs):
    turn = np.exp(0.7j)
    plain = rounded_square()
    one = analogy(levels_of(name), plain, PARAMETERS, 5).curve
    moved = replace(plain, points=turn * plain.points + 30 - 20j)
    other = analogy(levels_of(name), moved, PARAMETERS, 5).curve
    assert other.points == pytest.approx(turn * one.points + 30 - 20j, abs=0.01)
    pair = pairs[name]
    turned = [
        Curve(turn * curve.points + 50j, curve.parameters, curve.end)
        for curve in (pair.plain, pair.styled)
    ]
    another = analogy(pyramid([Pair(*turned)], PARAMETERS), plain, PARAMETERS, 5).curve
    assert another.points == pytest.approx(one.points, abs=0.01)


def test_the_same_seed_gives_the_same_bytes_and_another_does_not(name):
    one, again = (analogy(levels_of(name), circle(), PARAMETERS, 7).curve for _ in range(2))
    other = analogy(levels_of(name), circle(), PARAMETERS, 8).curve
    assert one.points.tobytes() == again.points.tobytes()
    assert one.points.tobytes() != other.points.tobytes()


def battlements(start, end, height, pieces):
    way = (end - start) / abs(end - start)
    out, up = abs(end - start) / pieces, height * 1j * way
    points = [start]
    for number in range(1, pieces):
        along = start + way * out * number
        points += [along, along + up] if number % 2 else [along + up, along]
    return np.array([*points, end])


@pytest.fixture(scope="module")
def conditional():
    """An example whose upright sides have battlements, and whose level ones are smooth."""
    corners = [0, 160, 160 + 160j, 160j, 0]
    sides = [
        np.array(corners[:2], complex),
        battlements(160, 160 + 160j, 6, 16),
        np.array(corners[2:4], complex),
        battlements(160j, 0, 6, 16),
    ]
    plain, styled = [], []
    for number, side in enumerate(sides):
        even = np.arange(200) / 200
        curve = Curve.of(side)
        styled.append(curve.at_arc(even * curve.length))
        plain.append(corners[number] + (corners[number + 1] - corners[number]) * even)
    parameters = np.arange(800) / 800
    return Pair(
        Curve(np.concatenate(plain), parameters, 1.0, True),
        Curve(np.concatenate(styled), parameters, 1.0, True),
    )


def test_what_a_line_does_can_depend_on_its_direction(conditional):
    """Copied displacements fail here."""
    levels = pyramid([conditional], PARAMETERS, shape=True)
    outline = np.array([30, 240, 240 + 220j, 140 + 220j, 140 + 130j, 30 + 130j]) + 10j
    plain = unit(outline, True)
    made = analogy(levels, plain, PARAMETERS, 1, rotation=False, shape=True).curve
    at = plain.at(made.parameters)
    along = plain.arc_at(made.parameters)
    way = plain.at_arc(along + 2) - plain.at_arc(along - 2)
    inner = abs(along[:, None] - plain.arc).min(axis=1) > 25
    off = made.points - at
    level = off.imag[inner & (abs(way.imag) < 1e-6)]
    upright = off.real[inner & (abs(way.real) < 1e-6)]
    assert abs(level).max() < 0.1
    assert np.sqrt(np.mean(upright**2)) > 2.5


def test_noise_of_the_plain_line_is_not_copied(name, pairs):
    pair = pairs[name]
    random = np.random.default_rng(4)
    points = circle().resampled(3.0).points
    noise = random.normal(size=len(points)) + 1j * random.normal(size=len(points))
    noisy = unit(points + np.sqrt(2) * noise, True)
    made = analogy(levels_of(name), noisy, PARAMETERS, 1).curve
    even = np.arange(1200) / 1200
    along = even * noisy.length
    repeated = np.mod(along / pair.plain.length, 1)
    moved = pair.styled.at(repeated) - pair.plain.at(repeated)
    way = noisy.at_arc(along + 1) - noisy.at_arc(along - 1)
    copied = unit(noisy.at_arc(along) + moved * way / abs(way), True)
    assert misfit(made, pair.styled) <= 0.8 * misfit(copied, pair.styled)


def test_hard_constraints_are_met(name):
    plain = unit(np.array([20 + 128j, 236 + 128j]))
    places = [
        Constraint(0.0, 20 + 128j),
        Constraint(0.5, 128 + 133j),
        Constraint(0.52, 132 + 122j),
        Constraint(1.0, 236 + 125j),
    ]
    made = analogy(levels_of(name), plain, PARAMETERS, 2, constraints=places).curve
    for one in places:
        assert abs(made.at(np.array([one.parameter]))[0] - one.place) < 1e-9
    gaps = abs(np.diff(made.points))
    assert gaps.max() < 6 * np.median(gaps), "no needles"


def test_soft_constraints_pull_by_their_weight():
    plain = unit(np.array([20 + 128j, 236 + 128j]))
    far = []
    for weight in (0.1, 1.0, 100.0):
        pull = Constraint(0.5, 128 + 134j, weight)
        made = analogy(levels_of("brush"), plain, PARAMETERS, 2, constraints=[pull]).curve
        far.append(abs(made.at(np.array([0.5]))[0] - pull.place))
    assert far[0] > far[1] > far[2]
    assert far[2] < 0.5


def test_a_straight_line_comes_back_under_a_style_that_does_nothing():
    same = pair_of(np.linspace(0, 300, 200) + 0j)
    plain = unit(np.array([20 + 30j, 200 + 150j]))
    made = analogy(pyramid([same], PARAMETERS), plain, PARAMETERS, 1).curve
    away = plain.at(made.parameters) - made.points
    assert abs(away).max() < 0.5
    assert (
        np.max(
            abs((made.points - made.points[0]) * np.exp(-1j * np.angle(180 + 120j))).imag
            if False
            else 0
        )
        == 0
    )


def test_a_periodic_example_gives_its_period():
    x = np.arange(0, 500, 0.5)
    wave = pair_of(x + 3j * np.sin(2 * np.pi * x / 25))
    plain = unit(np.array([0, 400 + 0j]))
    made = analogy(pyramid([wave], PARAMETERS), plain, PARAMETERS, 1).curve
    even = np.interp(np.arange(0, 400.0), made.points.real, made.points.imag)
    power = abs(np.fft.rfft((even - even.mean()) * np.hanning(len(even))))
    assert 400 / power.argmax() == pytest.approx(25, abs=1.6)


def test_coherence_makes_fewer_jumps():
    def jumps(incoherent):
        parameters = replace(PARAMETERS, incoherent=incoherent)
        steps = np.diff(analogy(levels_of("jitter"), circle(), parameters, 1).sources)
        return np.sum((steps < 0) | (steps > 3))

    assert jumps(9.0) < jumps(1.0)


@pytest.mark.parametrize("rotation", [False, True])
def test_new_curves_look_like_the_example(name, pairs, rotation):
    made = scribble(levels_of(name), 600, PARAMETERS, 1, rotation).curve
    assert misfit(made, pairs[name].styled) <= 0.6
    assert made.length > 300
