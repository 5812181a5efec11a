import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.iconification.alpha_expansion import AlphaExpansion
from iconstudio.algorithms.iconification.energy import RemixProblem
from iconstudio.algorithms.iconification.symmetry import likeness, mirrored, propose, reflected
from iconstudio.algorithms.raster import solid
from iconstudio.model import CANVAS, Axis
from tests.oracles.expansion import energy, expand
from tests.oracles.lattice import Lattice
from tests.shapes import blob

AXES = list(Axis)


def symmetric_problem(axis, seed=0, count=3):
    rng = np.random.default_rng(seed)
    ink = np.stack([blob(seed + k) for k in range(count)])
    data = rng.uniform(0, 0.5, (count, CANVAS, CANVAS)).astype(np.float32)
    return RemixProblem(data, ink, np.stack([solid(one) for one in ink]), axis)


def test_mirror_images_of_a_small_square():
    square = np.arange(9).reshape(3, 3)
    assert reflected(square, Axis.HORIZONTAL).tolist() == [[2, 1, 0], [5, 4, 3], [8, 7, 6]]
    assert reflected(square, Axis.VERTICAL).tolist() == [[6, 7, 8], [3, 4, 5], [0, 1, 2]]
    assert reflected(square, Axis.DIAGONAL).tolist() == [[0, 3, 6], [1, 4, 7], [2, 5, 8]]
    assert reflected(square, Axis.ANTIDIAGONAL).tolist() == [[8, 5, 2], [7, 4, 1], [6, 3, 0]]


@pytest.mark.parametrize("axis", AXES)
def test_the_mirror_image_of_the_mirror_image_is_the_site(axis):
    image = mirrored(8, axis)
    assert np.array_equal(image[image], np.arange(64))


@settings(max_examples=12)
@given(st.sampled_from(AXES), st.sampled_from([1, 2, 4]), st.integers(0, 100))
def test_the_merged_lattice_has_the_energy_of_the_sites(axis, block, seed):
    lattice = Lattice(symmetric_problem(axis, seed % 3), block)
    labels = np.random.default_rng(seed).integers(0, 3, lattice.data.shape[1]).astype(np.uint8)
    full = lattice.full(labels)
    assert np.array_equal(full, reflected(full, axis))
    assert np.array_equal(lattice.reduced(full), labels)
    first, second = lattice.edges
    smooth = lattice.smoothness(np.arange(len(first)), labels[first], labels[second]).sum()
    data = lattice.data[labels, np.arange(len(labels))].sum()
    expected = lattice.problem.costs(full)
    assert (data, smooth) == pytest.approx(expected, rel=1e-5)


@pytest.mark.parametrize("axis", AXES)
def test_symmetry_halves_the_graph(axis):
    whole, merged = Lattice(symmetric_problem(None)), Lattice(symmetric_problem(axis))
    on_axis = 0 if axis in (Axis.HORIZONTAL, Axis.VERTICAL) else CANVAS
    assert merged.data.shape[1] == (CANVAS * CANVAS + on_axis) // 2
    assert len(merged.edges[0]) <= len(whole.edges[0]) // 2


@pytest.mark.parametrize("axis", AXES)
def test_a_symmetric_expansion_is_the_best_of_all_symmetric_expansions(axis):
    """By brute force: all choices of a few nodes, judged by the energy of the whole canvas."""
    lattice = Lattice(symmetric_problem(axis))
    rng = np.random.default_rng(1)
    start = lattice.full(rng.integers(0, 3, lattice.data.shape[1]).astype(np.uint8))
    labels = lattice.reduced(start)
    # Sites near the axis, where a node meets itself, and where the sources differ.
    differ = np.any(lattice.problem.ink != lattice.problem.ink[0], axis=0)
    ys, xs = np.mgrid[:CANVAS, :CANVAS]
    here, there = mirrored(CANVAS, axis).reshape(CANVAS, CANVAS), ys * CANVAS + xs
    distance = np.hypot(here // CANVAS - there // CANVAS, here % CANVAS - there % CANVAS)
    order = np.argsort(np.where(differ, distance, np.inf), axis=None, kind="stable")
    chosen = list(dict.fromkeys(lattice.node[order].tolist()))[:6]
    free = np.zeros(len(labels), dtype=bool)
    free[chosen] = True
    moved, _ = expand(lattice, labels, 1, 0.3, free)
    every = []
    for choice in itertools.product((False, True), repeat=len(chosen)):
        one = labels.copy()
        one[np.array(chosen)[np.array(choice)]] = 1
        every.append(energy(lattice.problem, lattice.full(one), 0.3))
    assert energy(lattice.problem, lattice.full(moved), 0.3) == pytest.approx(min(every), rel=1e-6)
    assert max(every) > min(every)


@pytest.mark.parametrize("axis", [Axis.HORIZONTAL, Axis.ANTIDIAGONAL])
def test_a_remix_keeps_the_constraint_and_costs_no_less_than_without(axis):
    held, free = symmetric_problem(axis), symmetric_problem(None)
    search = AlphaExpansion(held)
    labels = search.solve(0.1)
    assert np.array_equal(labels, reflected(labels, axis))
    assert len(np.unique(labels)) > 1
    assert energy(held, labels, 0.1) >= 0.99 * energy(free, AlphaExpansion(free).solve(0.1), 0.1)
    # Lower lambda_S from there: still symmetric.
    lower = search.solve(0.05)
    assert np.array_equal(lower, reflected(lower, axis))


def test_nearly_symmetric_shapes_are_proposed_their_axis():
    ys, xs = np.mgrid[:CANVAS, :CANVAS] - CANVAS / 2 + 0.5
    disc = np.hypot(xs, ys) < 90
    assert propose(disc) is Axis.HORIZONTAL
    bell = (ys > -80) & (ys < 80) & (abs(xs) < 60 + ys / 4)
    assert propose(bell) is Axis.HORIZONTAL
    assert propose(bell.T) is Axis.VERTICAL
    wedge = (xs + ys > -60) & (xs < 60) & (ys < 60) & (abs(xs - ys) < 70)
    assert propose(wedge) is Axis.DIAGONAL
    assert propose(wedge[:, ::-1]) is Axis.ANTIDIAGONAL
    flag = (abs(xs + 60) < 10) | ((abs(ys + 50) < 30) & (xs > -60) & (xs < 80))
    assert propose(flag) is None
    assert propose(flag, likeness(flag, Axis.HORIZONTAL)) is not None
    assert likeness(np.zeros((4, 4), dtype=bool), Axis.VERTICAL) == 1
