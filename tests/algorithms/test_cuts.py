import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.mincut.cuts import minimum_cut
from iconstudio.algorithms.mincut.trees import SOURCE, new_trees
from tests.oracles import maxflow


class Grid:
    """A random network of height x width nodes, in the layout with a border."""

    def __init__(self, height: int, width: int, seed: int) -> None:
        self.rng = rng = np.random.default_rng(seed)
        self.offset = np.array([1, -1, width + 2, -width - 2], np.int32)
        picture = np.zeros((height + 2, width + 2), bool)
        picture[1:-1, 1:-1] = rng.random((height, width)) < rng.choice([0.6, 1.0])
        self.inside = picture.ravel()
        self.whole = np.zeros((picture.size, 4), np.int32)
        self.excess = np.zeros(picture.size, np.int32)
        self.flow = np.zeros_like(self.whole)
        self.change(1.0)

    def change(self, share: float) -> None:
        """Draw a share of the capacities and the excess anew."""
        size = len(self.excess)
        top = self.rng.choice([2, 20, 1000])
        for d in range(4):
            there = self.inside & np.roll(self.inside, -self.offset[d])
            new = self.rng.integers(0, top, size) * (self.rng.random(size) < 0.8) * there
            self.whole[:, d] = np.where(self.rng.random(size) < share, new, self.whole[:, d])
        new = self.rng.integers(-2 * top, 2 * top, size) * self.inside
        self.excess = np.where(self.rng.random(size) < share, new, self.excess).astype(np.int32)

    def neighbour(self, values: np.ndarray, d: int) -> np.ndarray:
        return np.roll(values, -self.offset[d])

    def cut(self, anew: bool = True, far: bool = True) -> tuple[np.ndarray, int]:
        """Return the source's side and the gain; keep the flow for the next time."""
        for d in (0, 2):  # cut the old flow off at the new capacities
            back = self.neighbour(self.whole[:, d + 1], d)
            self.flow[:, d] = np.clip(self.flow[:, d], -back, self.whole[:, d])
            self.flow[:, d + 1] = -self.neighbour(self.flow[:, d], d + 1)
        capacity, excess = self.whole - self.flow, self.excess - self.flow.sum(axis=1)
        excess = excess.astype(np.int32)
        trees = new_trees(len(excess))
        minimum_cut(self.offset, capacity, excess, trees, anew, far)
        self.flow = self.whole - capacity
        taken = trees.tree == SOURCE
        self.check(capacity, excess, taken)
        return taken, int(excess[taken].sum())

    def check(self, capacity: np.ndarray, excess: np.ndarray, taken: np.ndarray) -> None:
        """The flow is feasible, nothing is lost, and nothing more can be sent."""
        assert (capacity >= 0).all()
        for d in range(4):
            assert np.array_equal(self.flow[:, d], -self.neighbour(self.flow[:, d ^ 1], d))
            assert not (capacity[:, d] > 0)[taken & ~self.neighbour(taken, d)].any()
        assert np.array_equal(excess, self.excess - self.flow.sum(axis=1))
        assert (excess[taken] >= 0).all()
        assert (excess[~taken] <= 0).all()

    def value(self, taken: np.ndarray) -> int:
        """What a cut gains."""
        cost = sum(self.whole[taken & ~self.neighbour(taken, d), d].sum() for d in range(4))
        return int(self.excess[taken].sum() - cost)

    def oracle(self) -> np.ndarray:
        """The source's side by PyMaxflow."""
        nodes = np.arange(len(self.excess))
        first = np.concatenate([self.neighbour(nodes, d) for d in range(4)])
        return maxflow.minimise(
            -self.excess.astype(float), first, np.tile(nodes, 4), self.whole.T.ravel().astype(float)
        )


sizes = st.tuples(st.integers(1, 7), st.integers(1, 7), st.integers(0, 2**32 - 1))


@pytest.mark.thorough
@settings(max_examples=600)
@given(sizes)
def test_a_cut_is_that_of_pymaxflow_also_from_old_flow(size):
    grid = Grid(*size)
    for k, share in enumerate((0.1, 1.0, 0.02, 0.3, 0.3)):
        taken, gain = grid.cut(anew=k % 2 == 0)
        assert np.array_equal(taken, grid.oracle())
        assert gain == grid.value(taken)
        grid.change(share)


@pytest.mark.parametrize("seed", range(40))
def test_a_cut_is_the_best_of_all(seed):
    grid = Grid(2, 4, seed)
    places = np.flatnonzero(grid.inside)
    best = 0
    for choice in itertools.product((False, True), repeat=len(places)):
        taken = np.zeros(len(grid.excess), bool)
        taken[places] = choice
        best = max(best, grid.value(taken))
    assert grid.cut()[1] == best


@pytest.mark.parametrize("size", [(100, 132), (64, 64), (128, 260), (99, 132), (300, 1)])
def test_large_grids_with_long_ways(size):
    grid = Grid(*size, seed=7)
    for far, anew in itertools.product((True, False), repeat=2):
        taken, gain = grid.cut(anew, far)
        assert np.array_equal(taken, grid.oracle())
        assert gain == grid.value(taken)
        grid.change(0.05)


def test_without_excess_nothing_is_taken():
    grid = Grid(4, 4, 0)
    grid.excess = -np.abs(grid.excess)
    assert not grid.cut()[0].any()
