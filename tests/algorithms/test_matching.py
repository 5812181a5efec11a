import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms import matching
from iconstudio.algorithms.matching import (
    FAR,
    SlidingWindow,
    coarse_search,
    direct_error,
    prepare,
    refine,
    sources_of,
)
from iconstudio.algorithms.raster import placed_ink
from iconstudio.algorithms.saliency import Region
from iconstudio.algorithms.tsdf import tsdf
from iconstudio.model import CANVAS, Placement, Polygon
from tests.shapes import blob, exemplar, regions_of


def finished(generator):
    while True:
        try:
            next(generator)
        except StopIteration as end:
            return end.value


def best_matches(field, regions, exemplars, **options):
    hits = finished(coarse_search(field, regions, exemplars))
    return refine(field, regions, exemplars, hits, range(len(exemplars)), **options)


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 2**32 - 1), st.integers(4, 9), st.integers(0, 4))
def test_fourier_errors_equal_the_direct_sum_at_every_translation(seed, n, border):
    rng = np.random.default_rng(seed)
    side = n + 2 * (border // 2)
    field = rng.uniform(-2, 0, (n, n)).astype(np.float32)
    masks = rng.uniform(0, 1, (2, n, n)).astype(np.float32)
    shape = rng.uniform(-2, 0, (side, side)).astype(np.float32)
    window = SlidingWindow(field, masks, side)
    errors = window.errors(shape)
    seen = set()
    for y in range(window.size):
        for x in range(window.size):
            dx, dy = window.translation(y, x)
            if max(abs(dx), abs(dy)) > (n + side) // 2:
                continue  # a longer transform than needed: the shapes no longer meet
            seen.add((dx, dy))
            for mask, error in zip(masks, errors, strict=True):
                expected = direct_error(field, mask, shape, dx, dy)
                assert error[y, x] == pytest.approx(expected, abs=1e-3)
    reach = (n + side) // 2 - 1
    assert {(dx, dy) for dx in (-reach, 0, reach) for dy in (-reach, 0, reach)} <= seen


def test_direct_error_is_equation_4():
    rng = np.random.default_rng(1)
    field, mask, shape = rng.normal(size=(3, 5, 5)).astype(np.float32)
    total = 0.0
    for y in range(5):
        for x in range(5):
            inside = 0 <= y - 1 < 5 and 0 <= x + 2 < 5
            value = shape[y - 1, x + 2] if inside else 0.0
            total += mask[y, x] * (value - field[y, x]) ** 2
    assert direct_error(field, mask, shape, -2, 1) == pytest.approx(total, rel=1e-5)


@pytest.fixture(scope="module")
def collection():
    return [prepare(exemplar(blob(seed), f"blob-{seed}")) for seed in range(12)]


def sketch_of(shape, placement):
    return tsdf(placed_ink(shape, placement)[1])


def regions_of_a_square():
    return regions_of(Polygon.of([(60, 60), (196, 60), (196, 196), (60, 196)]))


@pytest.mark.parametrize(
    "placement",
    [
        Placement(),
        Placement(flip=True),
        Placement(dx=13, dy=-22),
        Placement(scale=0.9, dx=-7, dy=3),
        Placement(scale=1.1, flip=True, dx=5, dy=9),
    ],
)
def test_an_exemplar_that_equals_the_sketch_is_found_exactly(collection, placement):
    field = sketch_of(collection[4].exemplar, placement)
    for row in best_matches(field, regions_of_a_square(), collection):
        assert row[0].index == 4
        assert row[0].placement == placement
        assert row[0].error == pytest.approx(0, abs=1e-6)


def test_matches_are_those_of_the_exhaustive_search_at_full_resolution(collection):
    regions = regions_of_a_square()
    field = sketch_of(exemplar(blob(99)), Placement())
    found = best_matches(field, regions, collection)
    masks = np.stack([region.mask for region in regions])
    window = SlidingWindow(field - FAR, masks, collection[0].variants[0].field.shape[0])
    least = np.full((len(regions), len(collection)), np.inf)
    for index, one in enumerate(collection):
        for variant in one.variants:
            errors = window.errors(variant.field).reshape(len(regions), -1)
            least[:, index] = np.minimum(least[:, index], errors.min(axis=1))
    for row, exhaustive in zip(found, least, strict=True):
        best = np.sort(exhaustive)[:3]
        assert np.allclose([match.error for match in row[:3]], best, rtol=0.01, atol=1e-4)


def test_matches_are_of_different_pictograms_by_rising_error(collection):
    field = sketch_of(exemplar(blob(50)), Placement())
    regions = regions_of_a_square()
    matches = best_matches(field, regions, collection)
    for number, row in enumerate(sources_of(matches, collection)):
        assert len({source.exemplar.id for source in row}) == 3
        assert [source.error for source in row] == sorted(source.error for source in row)
        assert {source.region for source in row} == {number}


def test_only_admitted_exemplars_are_refined(collection):
    field = sketch_of(collection[4].exemplar, Placement())
    regions = regions_of_a_square()[:2]
    hits = finished(coarse_search(field, regions, collection))
    for row in refine(field, regions, collection, hits, [1, 7, 9]):
        assert {match.index for match in row} == {1, 7, 9}


def test_errors_are_those_of_the_placement_that_is_named(collection):
    field = sketch_of(exemplar(blob(77)), Placement())
    regions = regions_of_a_square()[:1]
    match = best_matches(field, regions, collection)[0][0]
    placed = tsdf(placed_ink(collection[match.index].exemplar, match.placement)[1])
    expected = (regions[0].mask * (placed - field) ** 2).sum()
    # The canvas cuts a placed exemplar off; the matched one goes on beyond it.
    assert match.error == pytest.approx(expected, rel=0.02)


def test_nothing_to_match():
    region = Region((128, 128), np.ones((CANVAS, CANVAS), np.float32))
    assert best_matches(np.zeros((CANVAS, CANVAS), np.float32), [region], []) == [[]]


def test_padding_keeps_the_largest_scale_whole():
    whole = np.zeros((CANVAS, CANVAS), bool)
    whole[16:240, 16:240] = True
    for scales in ((1.0,), (0.9, 1.1), (0.8, 1.25), (1.5,)):
        for variant in prepare(exemplar(whole), scales).variants:
            assert (variant.field[0] == 0).all() and (variant.field[:, -1] == 0).all()
            assert variant.field.shape[0] % matching.COARSEN == 0
