import itertools
from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.iconification.alpha_expansion import AlphaExpansion
from iconstudio.algorithms.iconification.block_expansion import (
    BlockExpansion,
    Stopped,
    plane_words,
)
from iconstudio.algorithms.iconification.energy import F_INT, Labels, RemixProblem
from iconstudio.algorithms.iconification.expansion_capacities import UNIT
from iconstudio.algorithms.mincut import cuts
from iconstudio.model import CANVAS, Axis
from tests.oracles import expansion
from tests.oracles.expansion import minimise
from tests.oracles.lattice import Lattice
from tests.shapes import blob, problem

pytestmark = pytest.mark.thorough(but=1)


def busy_problem(seed: int = 0, count: int = 4, symmetry: Axis | None = None) -> RemixProblem:
    """Sources that differ in the middle of the canvas, with a data cost that varies smoothly."""
    ink = np.stack([blob(seed + k) & ~blob(seed + k, level=0.5) for k in range(count)])
    rng = np.random.default_rng(seed)
    data = rng.uniform(0, 0.1, (count, 8, 8)).repeat(CANVAS // 8, 1).repeat(CANVAS // 8, 2)
    plain = problem(ink, data)
    return RemixProblem(plain.data, plain.ink, plain.solid, symmetry)


def energy(one: RemixProblem, labels: Labels, lambda_s: float) -> float:
    return expansion.energy(one, labels, lambda_s)


def never() -> bool:
    return False


def is_symmetric(labels: Labels, axis: Axis) -> bool:
    lattice = Lattice(busy_problem(symmetry=axis))
    return np.array_equal(lattice.full(lattice.reduced(labels)), labels)


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("symmetry", "block"),
    [(None, 4), (None, 8), *zip(Axis, itertools.cycle([4, 8]))],  # endless
)
def test_expansions_are_those_of_the_plain_program(symmetry, block):
    one = busy_problem(3, symmetry=symmetry)
    level, lattice = BlockExpansion(one, block, plane_words(one)), Lattice(one, block)
    assert one.interior.any()
    rng = np.random.default_rng(block)
    labels = level.cheapest()
    for lambda_s in (0.3, 0.05, 0.1):  # flows are kept from one to the next
        for alpha in rng.permutation([0, 1, 2, 3, 0, 1]).tolist():
            level.begin(lambda_s)
            before = level.full(labels)
            plain, gain = expansion.expand(lattice, lattice.reduced(before), alpha, lambda_s)
            gained = level.expand(labels, alpha) / UNIT
            after = level.full(labels)
            assert gained == pytest.approx(gain, rel=2e-5, abs=0.005)
            assert energy(one, after, lambda_s) == pytest.approx(
                energy(one, lattice.full(plain), lambda_s), rel=2e-5, abs=0.005
            )
            fallen = energy(one, before, lambda_s) - energy(one, after, lambda_s)
            assert fallen == pytest.approx(gained, rel=2e-4, abs=0.02)


@pytest.mark.thorough
def test_where_only_a_box_is_looked_at_the_rest_is_as_if_all_were():
    one = busy_problem(5)
    words = plane_words(one)
    kept, fresh = BlockExpansion(one, 4, words), BlockExpansion(one, 4, words)
    rng = np.random.default_rng(1)
    labels = kept.cheapest()
    kept.begin(0.1)
    for _ in range(60):
        alpha = int(rng.integers(4))
        alone = labels.copy()
        fresh.begin(0.1)
        gain = kept.expand(labels, alpha)
        assert fresh.expand(alone, alpha) == gain
        assert np.array_equal(alone, labels)
        if not gain:  # go on from elsewhere, as a box of random labels
            y, x = rng.integers(1, 50, 2)
            picture = labels.reshape(66, 66)
            picture[y : y + 9, x : x + 6] = rng.integers(4)
            kept.touch((int(y) - 2, int(y) + 9, int(x) - 2, int(x) + 6))


def test_a_search_ends_where_no_expansion_gains():
    one = busy_problem(2)
    level = BlockExpansion(one, 4, plane_words(one))
    labels = level.cheapest()
    level.descend(labels, 0.1, never)
    lattice = Lattice(one, 4)
    for alpha in range(4):
        reduced = lattice.reduced(level.full(labels))
        assert expansion.expand(lattice, reduced, alpha, 0.1)[1] < 0.005


@pytest.mark.parametrize("symmetry", [None, Axis.HORIZONTAL, Axis.ANTIDIAGONAL])
def test_it_is_about_as_good_as_plain_expansion(symmetry):
    one = busy_problem(1, symmetry=symmetry)
    lambdas = (0.03, 0.1, 0.4)
    search = AlphaExpansion(one, check=True)
    plain = Lattice(one, 2)
    for lambda_s in lambdas:
        labels = search.find(lambda_s, lambdas)
        found = energy(one, labels, lambda_s)
        assert search.energy(lambda_s) <= found * (1 + 1e-9)  # it is known from now on
        cold = minimise(plain, plain.data.argmin(axis=0).astype(np.uint8), lambda_s)
        assert found <= 1.01 * energy(one, plain.full(cold), lambda_s)
        if symmetry is not None:
            assert is_symmetric(labels, symmetry)


@pytest.mark.parametrize("symmetry", [None, Axis.HORIZONTAL])
def test_labels_that_are_left_out_are_as_if_they_were_not_there(symmetry):
    one = busy_problem(3, count=6, symmetry=symmetry)
    left = np.array([0, 2, 3, 5])
    fewer = RemixProblem(one.data[left], one.ink[left], one.solid[left], symmetry)
    search = AlphaExpansion(one, check=True)
    search.find(0.1, (0.05, 0.1))
    found = search.find_without(0.1, (1, 4))
    assert np.array_equal(found, left[AlphaExpansion(fewer).find_without(0.1, ())])
    assert energy(one, found, 0.1) >= search.energy(0.1)


def test_the_same_calls_give_the_same_labels():
    def run() -> list[Labels]:
        search = AlphaExpansion(busy_problem(4))
        first = search.preview(0.2)
        found = [search.find(value, (0.05, 0.2)) for value in (0.2, 0.05)]
        return [first, *found, search.solve(0.1)]

    for one, other in zip(run(), run(), strict=True):
        assert np.array_equal(one, other)


ROW = (0.03, 0.06, 0.12, 0.25, 0.5)


@cache
def found_anew(symmetry: Axis | None) -> list[Labels]:
    """What is found for each lambda_S of the row by a search that has found nothing before."""
    one = busy_problem(9, count=6, symmetry=symmetry)
    return [AlphaExpansion(one).find(value, ROW) for value in ROW]


@pytest.mark.thorough
@pytest.mark.parametrize("symmetry", [None, Axis.VERTICAL])
@pytest.mark.parametrize("order", [(2, 1, 3, 0, 4), (4, 3, 2, 1, 0)])
def test_what_is_found_depends_on_nothing_that_went_before(order, symmetry):
    one = busy_problem(9, count=6, symmetry=symmetry)
    elsewhere = AlphaExpansion(busy_problem(10, count=6, symmetry=symmetry)).preview(0.1)
    used = AlphaExpansion(one, check=True)
    used.add(elsewhere)
    used.preview(0.2)
    used.solve(0.05)
    for at in order:
        fresh = found_anew(symmetry)[at]
        assert np.array_equal(used.find(ROW[at], ROW), fresh)
        assert np.array_equal(used.find(ROW[at], ROW[::-1]), fresh)


def test_a_solution_is_a_fixed_point_of_the_fine_lattice():
    one = busy_problem(6, count=3)
    labels = AlphaExpansion(one).solve(0.1)
    fine = Lattice(one)
    for alpha in np.unique(labels).tolist():
        assert expansion.expand(fine, fine.reduced(labels), alpha, 0.1)[1] < 0.01


def test_what_is_known_counts_for_every_lambda():
    one = busy_problem(7)
    search = AlphaExpansion(one)
    flat = np.full((CANVAS, CANVAS), 2, np.uint8)
    search.add(flat)
    assert search.energy(0.5) == pytest.approx(energy(one, flat, 0.5))
    search.preview(0.5)
    assert search.energy(0.5) <= energy(one, flat, 0.5)
    assert search.energy(1e6) <= energy(one, flat, 1e6)
    assert np.array_equal(search.best(1e6), flat)


@pytest.mark.parametrize("patience", [1, 5, 23])
def test_it_can_be_used_after_it_was_stopped(monkeypatch, patience):
    monkeypatch.setattr(cuts, "SLICE", 200)  # stops within cuts, too
    asked = 0

    def stop() -> bool:
        nonlocal asked
        asked += 1
        return asked == patience

    one = busy_problem(8)
    search = AlphaExpansion(one, stop, check=True)
    with pytest.raises(Stopped):
        search.solve(0.1)
    assert asked == patience
    assert np.array_equal(search.solve(0.1), AlphaExpansion(one).solve(0.1))


def random_problem(seed: int) -> RemixProblem:
    """A small one of any kind: 8 or 16 sites in a row, up to five sources, some symmetric."""
    rng = np.random.default_rng(seed)
    side, count = int(rng.choice([8, 16])), int(rng.integers(2, 6))
    ink = rng.random((count, side, side)) < rng.random((count, 1, 1))
    data = rng.random((count, side, side)) ** 3 * rng.choice([0.1, 1, 10, 100])
    axis = [None, None, *Axis][rng.integers(6)]
    plain = problem(ink, data)
    return RemixProblem(plain.data, plain.ink, plain.solid, axis)


@settings(max_examples=200)
@given(st.integers(0, 2**32 - 1), st.sampled_from([1, 2, 4]))
def test_thousands_of_small_expansions_are_those_of_pymaxflow(seed, block):
    one = random_problem(seed)
    level, lattice = BlockExpansion(one, block, plane_words(one), check=True), Lattice(one, block)
    rng = np.random.default_rng(seed)
    labels = level.reduced(lattice.full(rng.integers(0, len(one.data), lattice.data.shape[1])))
    for lambda_s in rng.choice([0.01, 0.1, 0.5, 3.0], 3).tolist():
        level.begin(lambda_s)
        for alpha in rng.integers(0, len(one.data), 4).tolist():
            before = lattice.reduced(level.full(labels))
            gain = expansion.expand(lattice, before, alpha, lambda_s)[1]
            gained = level.expand(labels, alpha) / UNIT
            assert gained == pytest.approx(gain, rel=2e-5, abs=0.02)


@pytest.mark.parametrize("seed", range(40))
def test_an_expansion_is_the_best_of_all_labellings(seed):
    one = random_problem(seed)
    block = one.side // 4
    level = BlockExpansion(one, block, plane_words(one), check=True)
    rng = np.random.default_rng(seed)
    lattice = Lattice(one, block)
    start = lattice.full(rng.integers(0, len(one.data), lattice.data.shape[1]).astype(np.uint8))
    alpha = int(rng.integers(len(one.data)))
    nodes = np.arange(lattice.data.shape[1])
    best = np.inf
    for choice in itertools.product((False, True), repeat=min(len(nodes), 9)):
        moved = lattice.reduced(start)
        moved[: len(choice)][list(choice)] = alpha
        best = min(best, energy(one, lattice.full(moved), 0.2))
    labels = level.reduced(start)
    level.begin(0.2)
    level.expand(labels, alpha)
    found = energy(one, level.full(labels), 0.2)
    assert found <= best * (1 + 1e-5) + 0.02


@pytest.mark.parametrize("lambda_s", [0.0, 3.0, 1000.0])
def test_extreme_lambdas(lambda_s):
    one = busy_problem(9)
    search = AlphaExpansion(one)
    labels = search.solve(lambda_s)
    cheapest = one.data.argmin(axis=0).astype(np.uint8)
    assert energy(one, labels, lambda_s) <= energy(one, cheapest, lambda_s) + 0.01


def test_marks_hold_against_strong_seams():
    one = busy_problem(10, count=2)
    data = np.zeros_like(one.data)
    data[0, 100:110, 100:110] = 1e4
    data[1, 140:150, 140:150] = 1e4
    labels = AlphaExpansion(RemixProblem(data, one.ink, one.solid)).solve(3.0)
    assert (labels[100:110, 100:110] == 1).all()
    assert (labels[140:150, 140:150] == 0).all()


def test_the_only_source_owns_everything():
    assert not AlphaExpansion(busy_problem(11, count=1)).solve(0.1).any()


def test_interior_structure_costs_what_the_paper_says():
    one = busy_problem(12, count=2)
    level = BlockExpansion(one, 1, plane_words(one))
    level.begin(1.0)
    assert level.smoothness.through == F_INT * UNIT


@pytest.mark.parametrize("side", [8, 24, 40])
def test_a_canvas_may_have_any_side(side):
    rng = np.random.default_rng(side)
    one = problem(rng.random((3, side, side)) < 0.4, rng.random((3, side, side)))
    search = AlphaExpansion(one)
    search.preview(0.1)
    labels = search.find(0.1, [0.02, 0.1])
    assert labels.shape == (side, side)
    fine = Lattice(one)
    for alpha in np.unique(labels).tolist():
        assert expansion.expand(fine, fine.reduced(labels), alpha, 0.1)[1] < 0.01
