import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.model import CANVAS
from iconstudio.workflows.grid import LAMBDAS
from tests.oracles import maxflow
from tests.oracles.expansion import energy, expand, minimise
from tests.oracles.lattice import Lattice
from tests.shapes import blob, problem

finite = st.floats(-5, 5)


@settings(max_examples=200)
@given(st.integers(1, 6).flatmap(lambda n: st.tuples(st.just(n), st.integers(0, 2**32 - 1))))
def test_minimum_cut_equals_brute_force(size_and_seed):
    n, seed = size_and_seed
    rng = np.random.default_rng(seed)
    unary = rng.normal(size=n)
    edges = [(i, j) for i in range(n) for j in range(n) if i != j and rng.random() < 0.5]
    first, second = np.array(edges, dtype=np.int64).reshape(-1, 2).T
    pairwise = rng.uniform(0, 2, len(edges))

    def value(x):
        return (unary * x).sum() + (pairwise * (1 - x[first]) * x[second]).sum()

    best = min(value(np.array(x)) for x in itertools.product((0, 1), repeat=n))
    assert value(maxflow.minimise(unary, first, second, pairwise).astype(int)) == pytest.approx(
        best
    )


def busy_problem(seed=0, count=3):
    """Sources that differ in a corner of the canvas, with a random data cost there."""
    rng = np.random.default_rng(seed)
    ink = np.stack([blob(seed + k) for k in range(count)])
    data = rng.uniform(0, 0.05, (count, CANVAS, CANVAS))
    return problem(ink, data)


class TinyLattice:
    """The fine lattice cut down to a few sites, so that all labellings can be tried."""

    def __init__(self, remix_problem, sites):
        whole = Lattice(remix_problem)
        self.whole, self.sites = whole, sites
        self.data = whole.data[:, sites]
        number = {int(site): k for k, site in enumerate(sites)}
        first, second = whole.edges
        inside = [
            e
            for e, (p, q) in enumerate(zip(first, second, strict=True))
            if int(p) in number and int(q) in number
        ]
        self._edges = np.array(inside)
        self.edges = (
            np.array([number[int(first[e])] for e in inside]),
            np.array([number[int(second[e])] for e in inside]),
        )

    def smoothness(self, edges, a, b):
        return self.whole.smoothness(self._edges[edges], a, b)

    def energy(self, labels, lambda_s):
        first, second = self.edges
        every = np.arange(len(first))
        smooth = self.smoothness(every, labels[first], labels[second]).sum()
        return self.data[labels, np.arange(len(labels))].sum() + lambda_s * smooth


@pytest.fixture(scope="module", params=range(4))
def tiny(request):
    remix_problem = busy_problem(request.param)
    differ = np.any(remix_problem.ink != remix_problem.ink[0], axis=0)
    y, x = np.argwhere(differ)[100 + 37 * request.param]
    sites = (np.arange(y, y + 3)[:, None] * CANVAS + np.arange(x, x + 3)).ravel()
    return TinyLattice(remix_problem, sites)


@pytest.mark.parametrize("lambda_s", [0.001, 0.01, 0.1])
def test_an_expansion_is_the_best_of_all_expansions(tiny, lambda_s):
    rng = np.random.default_rng(5)
    for alpha in range(3):
        labels = rng.integers(0, 3, 9).astype(np.uint8)
        moved, gain = expand(tiny, labels, alpha, lambda_s)
        every = (
            np.where(np.array(choice), np.uint8(alpha), labels)
            for choice in itertools.product((False, True), repeat=9)
        )
        best = min(tiny.energy(one, lambda_s) for one in every)
        assert tiny.energy(moved, lambda_s) == pytest.approx(best, abs=1e-6)
        before = tiny.energy(labels, lambda_s)
        assert before - tiny.energy(moved, lambda_s) == pytest.approx(gain, abs=1e-5)


def test_nodes_that_are_not_free_keep_their_labels(tiny):
    labels = np.array([0, 1, 2, 0, 1, 2, 0, 1, 2], np.uint8)
    free = np.array([True, False, True, True, False, False, True, True, False])
    moved, _ = expand(tiny, labels, 1, 0.01, free)
    assert np.array_equal(moved[~free], labels[~free])
    every = (
        np.where(np.array(choice) & free, np.uint8(1), labels)
        for choice in itertools.product((False, True), repeat=9)
    )
    best = min(tiny.energy(one, 0.01) for one in every)
    assert tiny.energy(moved, 0.01) == pytest.approx(best, abs=1e-6)


def test_blocks_have_the_energy_of_the_sites():
    remix_problem = busy_problem()
    rng = np.random.default_rng(3)
    blocks = Lattice(remix_problem, 2)
    first, second = blocks.edges
    for _ in range(3):
        labels = rng.integers(0, 3, blocks.side**2).astype(np.uint8)
        smooth = blocks.smoothness(np.arange(len(first)), labels[first], labels[second]).sum()
        data = blocks.data[labels, np.arange(len(labels))].sum()
        full = blocks.full(labels)
        assert np.array_equal(blocks.reduced(full), labels)
        assert remix_problem.costs(full) == pytest.approx((data, smooth), rel=1e-5)


def test_the_energy_never_rises():
    remix_problem = busy_problem(7, count=4)
    lattice = Lattice(remix_problem, 4)
    rng = np.random.default_rng(0)
    labels = rng.integers(0, 4, lattice.side**2).astype(np.uint8)
    last = energy(remix_problem, lattice.full(labels), 0.02)
    for alpha in [0, 1, 2, 3] * 2:
        labels, gain = expand(lattice, labels, alpha, 0.02)
        now = energy(remix_problem, lattice.full(labels), 0.02)
        assert gain >= 0
        assert now == pytest.approx(last - gain, rel=1e-4)
        last = now


def test_minimise_ends_where_no_expansion_helps():
    remix_problem = busy_problem(2)
    lattice = Lattice(remix_problem, 8)
    start = lattice.data.argmin(axis=0).astype(np.uint8)
    labels = minimise(lattice, start, 0.01)
    assert energy(remix_problem, lattice.full(labels), 0.01) < energy(
        remix_problem, lattice.full(start), 0.01
    )
    for alpha in range(3):
        assert expand(lattice, labels, alpha, 0.01)[1] == 0


def test_the_papers_lambdas():
    assert len(LAMBDAS) == 8
    assert LAMBDAS[0] == pytest.approx(0.03)
    assert LAMBDAS[-1] == pytest.approx(0.75)
    assert np.allclose(np.diff(np.log(LAMBDAS)), np.log(25) / 7)
