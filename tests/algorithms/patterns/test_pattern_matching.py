"""Seams, candidates, M-steps and means, against slow and obvious oracles."""

from itertools import product

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter

from iconstudio.algorithms.patterns.fourier import Searched
from iconstudio.algorithms.patterns.matching import Neighbourhoods, differences, matched
from iconstudio.algorithms.patterns.quilting import quilted
from iconstudio.algorithms.patterns.seams import minimum_seam
from iconstudio.algorithms.patterns.texture import means, sources


@pytest.fixture
def random():
    return np.random.default_rng(3)


def test_squared_differences_are_those_of_the_sums(random):
    channels, patch = random.normal(size=(2, 20, 23)), random.normal(size=(2, 7, 6))
    mask = random.random((7, 6)).astype(np.float32)
    found = Searched(channels).squared_differences(patch, mask)
    for y, x in product(range(14), range(18)):
        expected = (mask * (channels[:, y : y + 7, x : x + 6] - patch) ** 2).sum()
        assert found[y, x] == pytest.approx(expected, rel=1e-4)


def test_a_seam_is_the_cheapest_of_all(random):
    difference = random.random((3, 4)).astype(np.float32)
    there = np.ones((3, 4), bool)
    there[:, 3] = False
    kept = np.zeros((3, 4), bool)
    kept[:, 0] = True
    _, cost = minimum_seam(difference, there, kept)
    charged = np.where(there, difference, 0) + 1e-4
    free = np.argwhere(there & ~kept)
    best = np.inf
    for choice in product((False, True), repeat=len(free)):
        taken = ~there
        taken[tuple(free.T)] = choice
        right, down = taken[:, 1:] != taken[:, :-1], taken[1:] != taken[:-1]
        best = min(best, ((charged[:, 1:] + charged[:, :-1]) * right).sum()
                   + ((charged[1:] + charged[:-1]) * down).sum())  # fmt: skip
    assert cost == pytest.approx(best, rel=1e-5)


def naive_differences(picture, exemplar, where, matches):
    w, (height, width) = where.window, where.shape
    rolled = np.take(np.take(picture, np.arange(height + w) % height, 0),
                     np.arange(width + w) % width, 1).astype(int)  # fmt: skip
    costs = np.zeros(matches.shape[:2], int)
    for i, y in enumerate(where.rows):
        for j, x in enumerate(where.columns):
            v, u = matches[i, j]
            costs[i, j] = (
                (rolled[y : y + w, x : x + w] - exemplar[v : v + w, u : u + w]) ** 2
            ).sum()
    return costs


@pytest.mark.parametrize("tile", [False, True])
def test_matches_get_better_and_are_nearly_the_best(random, tile):
    exemplar, picture = (
        (gaussian_filter(random.normal(0, 5000, (*shape, 2)), (2, 2, 0), mode="wrap")).astype(
            np.int16
        )
        for shape in ((20, 22), (18, 17))
    )
    picture[:12, :12] = exemplar[5:17, 7:19]
    where = Neighbourhoods.of((18, 17), 8, tile)
    start = np.zeros((len(where.rows), len(where.columns), 2), np.int32)
    before = differences(picture, exemplar, where, start)
    assert np.array_equal(before, naive_differences(picture, exemplar, where, start))
    matches, costs = matched(picture, exemplar, where, start, 5, sweeps=6)
    assert (costs <= before).all()
    assert np.array_equal(costs, naive_differences(picture, exemplar, where, matches))
    assert costs[0, 0] == 0 and tuple(matches[0, 0]) == (5, 7)
    least = np.min([naive_differences(picture, exemplar, where, np.full_like(start, (v, u)))
                    for v in range(13) for u in range(15)], axis=0)  # fmt: skip
    assert costs.sum() <= 1.05 * least.sum()


@pytest.mark.parametrize("tile", [False, True])
def test_means_are_those_of_all_matches_that_cover_a_pixel(random, tile):
    exemplar = random.integers(-1000, 1000, (16, 18, 3)).astype(np.int16)
    where = Neighbourhoods.of((14, 13), 8, tile)
    matches = random.integers(0, 9, (len(where.rows), len(where.columns), 2)).astype(np.int32)
    weights = random.random(matches.shape[:2])
    sums, masses = np.zeros((14, 13, 3)), np.zeros((14, 13, 1))
    for (i, y), (j, x) in product(enumerate(where.rows), enumerate(where.columns)):
        for a, b in product(range(8), range(8)):
            at = (y + a) % 14, (x + b) % 13
            sums[at] += weights[i, j] * exemplar[matches[i, j, 0] + a, matches[i, j, 1] + b]
            masses[at] += weights[i, j]
    mean = means(exemplar, where, matches, weights)
    assert np.abs(mean - sums / masses).max() <= 0.5 + 1e-9


@pytest.mark.parametrize("tile", [False, True])
def test_an_exemplar_that_is_its_own_target_stays_as_it_is(random, tile):
    exemplar = random.integers(-1000, 1000, (32, 32, 2)).astype(np.int16)
    if tile:  # its neighbourhoods go on across its borders only if it is a tile itself
        exemplar = np.tile(exemplar, (2, 2, 1))
    picture = exemplar[:32, :32]
    here = np.indices((32, 32), np.int32).transpose(1, 2, 0)
    where = Neighbourhoods.of((32, 32), 8, tile)
    matches, costs = matched(picture, exemplar, where, where.matches(here, exemplar), 1)
    assert not costs.any()
    assert np.array_equal(means(exemplar, where, matches, np.ones(costs.shape)), picture)
    source = sources(picture, exemplar, where, matches, costs)
    assert np.array_equal(exemplar[source[..., 0], source[..., 1]], picture)


@pytest.mark.parametrize("tile", [False, True])
def test_a_quilt_of_something_regular_has_no_seams(tile):
    y, x = np.mgrid[:32, :32]
    exemplar = np.stack([y % 8, x % 8], axis=2).astype(np.int16) * 100
    source = quilted(exemplar, np.zeros((32, 32), np.float32), (48, 40), 16, tile,
                     np.random.default_rng(0))  # fmt: skip
    picture = exemplar[source[..., 0], source[..., 1]]
    assert np.array_equal(picture[8:], picture[:-8]) and np.array_equal(
        picture[:, 8:], picture[:, :-8]
    )
