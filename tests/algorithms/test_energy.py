import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from iconstudio.algorithms.iconification.energy import (
    EPSILON,
    F_INT,
    PATCH,
    data_cost,
    distance_field,
    joining,
    lattice_edges,
    patch_words,
    remix_problem,
)
from iconstudio.algorithms.iconification.tsdf import tsdf
from iconstudio.model import CANVAS, Placement, Source
from tests.shapes import blob, exemplar, problem


def patch(ink, y, x):
    r = PATCH // 2
    return np.pad(ink, r)[y : y + PATCH, x : x + PATCH].astype(float)


def smoothness_oracle(inks, interiors, i, j, a, b):
    """Equations 7 and 8 as they are written; i and j are (y, x)."""
    if a == b:
        return 0.0
    f_n = sum(
        math.sqrt(((patch(inks[a], *site) - patch(inks[b], *site)) ** 2).sum()) for site in (i, j)
    )
    f_int = F_INT if interiors[a][i] or interiors[b][j] else 0.0
    return max(EPSILON, f_n + f_int)


def three_sources():
    inks = np.stack([blob(1), blob(2), blob(2) & ~blob(3, level=0.5)])
    return problem(inks, np.zeros(inks.shape))


@given(arrays(bool, (9, 11)), st.integers(0, 8), st.integers(0, 10))
def test_a_word_holds_the_neighbourhood(ink, y, x):
    word = int(patch_words(ink)[y, x])
    bits = [(word >> k) & 1 for k in range(PATCH * PATCH)]
    assert bits == patch(ink, y, x).ravel().tolist()


def test_smoothness_equals_the_equations_at_random_edges():
    remix = three_sources()
    rng = np.random.default_rng(0)
    for first, second in lattice_edges():
        # Where the sources differ something is to be seen.
        busy = np.flatnonzero(np.any(remix.ink != remix.ink[0], axis=0).ravel()[first])
        for edge in rng.choice(busy, 60):
            a, b = rng.integers(0, 3, 2)
            p, q = first[edge], second[edge]
            cost = remix.smoothness(p, q, np.uint8(a), np.uint8(b))
            i, j = divmod(int(p), CANVAS), divmod(int(q), CANVAS)
            expected = smoothness_oracle(remix.ink, remix.interior, i, j, a, b)
            assert math.isclose(cost, expected, rel_tol=1e-5, abs_tol=1e-6)


def test_smoothness_is_a_metric_on_every_edge():
    remix = three_sources()
    for first, second in lattice_edges():

        def cost(a, b, first=first, second=second):
            return remix.smoothness(first, second, np.uint8(a), np.uint8(b))

        for a, b, c in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
            assert (cost(a, c) <= cost(a, b) + cost(b, c) + 1e-5).all()
            assert (cost(a, b) >= np.float32(EPSILON)).all()
            assert (cost(a, a) == 0).all()


def test_least_cost_where_two_sources_agree():
    remix = three_sources()
    corner = remix.smoothness(np.int64(0), np.int64(1), np.uint8(0), np.uint8(1))
    assert corner == np.float32(EPSILON)


def test_costs_sum_over_sites_and_edges():
    remix = three_sources()
    labels = np.zeros((CANVAS, CANVAS), np.uint8)
    labels[100:104, 90:97] = 1
    labels[101, 92] = 2
    data, smoothness = remix.costs(labels)
    assert data == 0
    expected = 0.0
    for y in range(98, 107):
        for x in range(88, 100):
            for j in ((y, x + 1), (y + 1, x)):
                expected += smoothness_oracle(
                    remix.ink, remix.interior, (y, x), j, labels[y, x], labels[j]
                )
    assert math.isclose(smoothness, expected, rel_tol=1e-4)


def test_data_cost_is_the_difference_of_distance_fields():
    field = tsdf(blob(5))
    filled = np.stack([blob(5), blob(6)])
    cost = data_cost(field, filled)
    assert not cost[0].any()
    assert np.array_equal(cost[1], abs(field - tsdf(blob(6))))


def test_a_problem_shows_the_sources_at_their_placements():
    shape = exemplar(blob(7))
    source = Source(shape, Placement(dx=20, dy=-10))
    remix = remix_problem(tsdf(blob(7)), [source])
    assert np.array_equal(remix.ink[0, 30:200, 60:200], shape.ink[40:210, 40:180])
    assert (remix.solid >= remix.ink).all()


@pytest.mark.parametrize("side", [128, 512])
def test_distances_count_in_canvases_on_any_side(side):
    ys, xs = np.mgrid[:side, :side] * 256 // side  # pixels of the paper's canvas
    large, usual = distance_field(xs > 99), tsdf(np.mgrid[:256, :256][1] > 99)
    step = np.abs(large - usual[ys, xs]).max()
    assert 0 < step <= 1 / side + 1e-7  # distances to pixel centres; a pixel is 1 / side
    assert large.max() == usual.max()
    assert large.min() == usual.min()


@pytest.mark.parametrize("side", [128, 512])
def test_a_problem_on_another_side_is_the_same_picture(side):
    shape = exemplar(blob(7))
    source = Source(shape, Placement(dx=20, dy=-10, scale=1.2, flip=True))
    usual = remix_problem(tsdf(blob(7)), [source])
    field = distance_field(np.ones((side, side), bool))
    other = remix_problem(field, [source])
    assert other.side == side
    assert usual.side == CANVAS
    near = np.arange(256) * side // 256
    fine = near if side > 256 else slice(None)
    coarse = slice(None) if side > 256 else slice(None, None, 2)
    differ = other.ink[0][fine][:, fine] != usual.ink[0][coarse, coarse]
    assert differ.mean() < 0.02 < usual.ink[0].mean()
    drawn = joining(field, other.ink, other.solid)
    assert np.array_equal(drawn.data, other.data)
    assert drawn.patches.shape == (1, side * side)


@pytest.mark.parametrize("side", [8, 12, 32])
def test_costs_sum_over_sites_and_edges_on_any_side(side):
    rng = np.random.default_rng(side)
    remix = problem(rng.random((3, side, side)) < 0.4, rng.random((3, side, side)))
    labels = rng.integers(0, 3, (side, side)).astype(np.uint8)
    data, smoothness = remix.costs(labels)
    every = list(np.ndindex(side, side))
    assert data == pytest.approx(sum(remix.data[labels[i], *i] for i in every), rel=1e-5)
    expected = sum(
        smoothness_oracle(remix.ink, remix.interior, i, j, labels[i], labels[j])
        for i in every
        for j in ((i[0] + 1, i[1]), (i[0], i[1] + 1))
        if max(j) < side
    )
    assert smoothness == pytest.approx(expected, rel=1e-4)
