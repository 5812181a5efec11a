import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.iconification import matching
from iconstudio.algorithms.iconification.matching import FAR, Matcher, prepare, sources_of
from iconstudio.algorithms.iconification.region_error import RegionError, Term, least
from iconstudio.algorithms.iconification.saliency import Region
from iconstudio.algorithms.iconification.sliding import Waves
from iconstudio.algorithms.iconification.tsdf import tsdf
from iconstudio.algorithms.raster import placed_ink, scaled_ink, shifted, solid
from iconstudio.model import CANVAS, Placement, Polygon
from tests.oracles.exhaustive import exhaustive
from tests.shapes import blob, exemplar, regions_of

pytestmark = pytest.mark.thorough(but=1)

EVERYONE = range(12)


def finished(generator):
    while True:
        try:
            next(generator)
        except StopIteration as end:
            return end.value


@pytest.fixture(scope="module")
def collection():
    return [prepare(exemplar(blob(seed), f"blob-{seed}")) for seed in EVERYONE]


@pytest.fixture
def matcher(collection):
    return Matcher(collection)


def sketch_of(shape, placement=None):
    return tsdf(placed_ink(shape, placement or Placement())[1])


def regions_of_a_square():
    return regions_of(Polygon.of([(60, 60), (196, 60), (196, 196), (60, 196)]))


def direct(field, region, one, placement):
    """Equation 4 as it is written: exemplar ``one`` goes on beyond the canvas."""
    theirs = tsdf(solid(scaled_ink(one.coverage, placement.scale, 64)))
    if placement.flip:
        theirs = theirs[:, ::-1]
    moved = shifted(theirs, placement.dx, placement.dy, CANVAS, FAR)
    return float((region.mask.astype(float) * (moved - field) ** 2).sum())


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
def test_an_exemplar_that_equals_the_sketch_is_found_exactly(matcher, placement):
    field = sketch_of(matcher.exemplars[4].exemplar, placement)
    for row in finished(matcher.match(field, regions_of_a_square(), EVERYONE)):
        assert row[0].index == 4
        assert row[0].placement == placement
        assert row[0].error == pytest.approx(0, abs=1e-6)


@pytest.mark.thorough
@pytest.mark.parametrize("seed", [99, 100, 101])
def test_matches_are_those_of_the_exhaustive_search_at_full_resolution(matcher, seed):
    regions = regions_of_a_square()
    field = sketch_of(exemplar(blob(seed)))
    found = finished(matcher.match(field, regions, EVERYONE))
    for row, errors in zip(found, exhaustive(field, regions, matcher.exemplars), strict=True):
        assert [match.index for match in row] == list(np.argsort(errors)[:3])
        assert np.allclose([match.error for match in row], np.sort(errors)[:3], atol=1e-4)


@settings(max_examples=30)
@given(
    st.sampled_from(range(3)),
    st.booleans(),
    st.integers(-200, 200),
    st.integers(-200, 200),
    st.sampled_from(range(4)),
)
def test_errors_are_equation_4(collection, scale, flip, dx, dy, number):
    field = sketch_of(exemplar(blob(77)))
    region, one = regions_of_a_square()[number], collection[number]
    region_error = RegionError([Term(field - FAR)], region, Waves(CANVAS))
    placement = Placement(one.scales[scale], flip, dx, dy)
    expected = direct(field, region, one.exemplar, placement)
    assert region_error.error([one.field(scale)], flip, dx, dy) == pytest.approx(expected, rel=1e-4)


def test_no_neighbouring_placement_is_better(matcher):
    field = sketch_of(exemplar(blob(78)))
    region = regions_of_a_square()[0]
    ((match, *_),) = finished(matcher.match(field, [region], EVERYONE))
    at, one = match.placement, matcher.exemplars[match.index].exemplar
    errors = {
        (dx, dy): direct(field, region, one, Placement(at.scale, at.flip, at.dx + dx, at.dy + dy))
        for dx in (-1, 0, 1)
        for dy in (-1, 0, 1)
    }
    assert match.error == pytest.approx(errors[0, 0], rel=1e-4)
    assert min(errors.values()) >= match.error * (1 - 1e-4)


def test_matches_are_of_different_pictograms_by_rising_error(matcher):
    field = sketch_of(exemplar(blob(50)))
    matches = finished(matcher.match(field, regions_of_a_square(), EVERYONE))
    for number, row in enumerate(sources_of(matches, matcher.exemplars)):
        assert len({source.exemplar.id for source in row}) == 3
        assert [source.error for source in row] == sorted(source.error for source in row)
        assert {source.region for source in row} == {number}


def test_only_admitted_exemplars_are_matched(matcher):
    field = sketch_of(matcher.exemplars[4].exemplar)
    for admitted in ([1, 7, 9], [7, 2], [3], []):
        for row in finished(matcher.match(field, regions_of_a_square()[:2], admitted)):
            assert {match.index for match in row} == set(admitted)


def test_nothing_to_match():
    whole = np.ones(CANVAS, np.float32)
    run = Matcher([]).match(
        np.zeros((CANVAS, CANVAS), np.float32), [Region((9, 9), whole, whole)], []
    )
    assert finished(run) == [[]]


def test_the_part_that_is_done_rises_to_the_whole(matcher):
    parts = list(matcher.match(sketch_of(exemplar(blob(50))), regions_of_a_square(), EVERYONE))
    assert parts == sorted(parts)
    assert parts[-1] == 1


def threads_at_work():
    return [one for one in threading.enumerate() if one.name.startswith("match")]


def test_closing_the_generator_ends_its_threads(collection, monkeypatch):
    begun = []

    def slowly(self, spectra):
        begun.append(self)
        time.sleep(0.1)
        return estimates(self, spectra)

    estimates = RegionError.estimates
    monkeypatch.setattr(RegionError, "estimates", slowly)
    regions = regions_of_a_square() * 5
    run = Matcher(collection, threads=2).match(FIELDS[0], regions, EVERYONE)
    assert next(run) < 1
    assert len(threads_at_work()) == 2
    run.close()
    assert not threads_at_work()
    assert len(begun) < len(regions)


def test_a_mistake_in_a_thread_is_not_hidden(matcher, monkeypatch):
    monkeypatch.setattr(RegionError, "estimates", lambda self, spectra: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        finished(matcher.match(FIELDS[0], regions_of_a_square(), EVERYONE))
    assert not threads_at_work()


FIELDS = [sketch_of(exemplar(blob(seed))) for seed in (60, 61)]


@settings(max_examples=15)
@given(st.data())
def test_what_is_remembered_changes_no_answer(collection, data):
    """Also not what was remembered by a run that was closed half-way, or forgotten."""
    regions = regions_of_a_square()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(matching, "CHUNK", 5)
        patch.setattr(matching, "REMEMBERED", 3)
        old = Matcher(collection)
        for _ in range(4):
            field = data.draw(st.sampled_from(FIELDS))
            some = data.draw(st.lists(st.sampled_from(regions), max_size=3))
            admitted = data.draw(st.sets(st.sampled_from(EVERYONE)))
            begun = old.match(field, some, admitted)
            for _ in range(data.draw(st.integers(0, 4))):
                next(begun, None)
            begun.close()
            fresh = finished(Matcher(collection).match(field, some, admitted))
            assert finished(old.match(field, some, admitted)) == fresh
            assert len(old._memory) <= 3


def test_what_has_not_changed_is_not_estimated_again(matcher, monkeypatch):
    regions = regions_of_a_square()
    first = finished(matcher.match(FIELDS[0], regions, EVERYONE))
    monkeypatch.setattr(RegionError, "estimates", None)
    monkeypatch.setattr(RegionError, "follow", None)
    assert finished(matcher.match(FIELDS[0].copy(), regions[::-1], EVERYONE)) == first[::-1]
    with pytest.raises(TypeError):
        finished(matcher.match(FIELDS[1], regions, EVERYONE))


def test_a_change_where_the_mask_is_zero_counts_for_nothing(matcher, monkeypatch):
    across = np.zeros(CANVAS, np.float32)
    across[40:90] = 1
    region = Region((65, 65), across, across)
    finished(matcher.match(FIELDS[0], [region], EVERYONE))
    changed = FIELDS[0].copy()
    changed[100:] = FAR
    monkeypatch.setattr(RegionError, "estimates", None)
    finished(matcher.match(changed, [region], EVERYONE))


def test_two_threads_share_a_matcher(collection):
    regions = regions_of_a_square()
    wishes = [(field, set(EVERYONE) - {out}) for out in range(3) for field in FIELDS]
    expected = [finished(Matcher(collection).match(f, regions, some)) for f, some in wishes]
    matcher = Matcher(collection)
    with ThreadPoolExecutor(4) as threads:
        found = threads.map(lambda wish: finished(matcher.match(wish[0], regions, wish[1])), wishes)
    assert list(found) == expected


@given(
    st.floats(0.1, 5), st.floats(0.1, 5), st.floats(-0.09, 0.09),
    st.floats(1.6, 5.4), st.floats(1.6, 7.4), st.floats(-2, 2),
)  # fmt: skip
def test_the_lowest_point_of_a_paraboloid_is_found_between_the_samples(a, b, c, y0, x0, level):
    ys, xs = np.mgrid[:8, :10].astype(float)
    surface = a * (ys - y0) ** 2 + b * (xs - x0) ** 2 + 2 * c * (ys - y0) * (xs - x0) + level
    lowest, y, x = least(np.stack([surface, surface.T[::-1].T]))
    assert (lowest[0], y[0], x[0]) == pytest.approx((level, y0, x0), abs=1e-6)


def test_the_least_at_the_rim_is_taken_as_it_is():
    for y, x in ((0, 0), (0, 3), (4, 2), (2, 0), (4, 5)):
        surface = np.ones((5, 6))
        surface[y, x] = -1
        assert least(surface) == (-1, y, x)


def test_padding_keeps_the_largest_scale_whole():
    whole = np.zeros((CANVAS, CANVAS), bool)
    whole[16:240, 16:240] = True
    for scales in ((1.0,), (0.9, 1.1), (0.8, 1.25), (1.5,)):
        prepared = prepare(exemplar(whole), scales)
        for number in range(len(scales)):
            field = prepared.field(number)
            assert (field[0] == 0).all() and (field[:, -1] == 0).all()
