"""Other results in the places of near-copies, and of what is not plausible."""

from dataclasses import replace

import numpy as np
import pytest

from iconstudio.algorithms.iconification.ranking import Gallery
from iconstudio.model import CANVAS, Placement, Remix, Source
from iconstudio.svg.placed import render_placed
from iconstudio.workflows.events import Recommended, Result
from iconstudio.workflows.modelling.modelling import pose_sketch
from iconstudio.workflows.modelling.variety import DIFFERENT, YIELDING, weak, with_variety
from tests.output.made import BLOCK, DISC, RADIUS, RING, SKETCH, made
from tests.shapes import exemplar
from tests.workflows.test_symmetric import Fixed

THICK = exemplar((RADIUS < 100) & (RADIUS > 20), "thick")
SOURCES = tuple(Source(one, Placement(), 1.0, 0) for one in (BLOCK, RING, DISC, THICK))
LAMBDAS = (0.05, 0.1, 0.2, 0.3, 0.4, 0.5)


def pose(sources):
    return pose_sketch(SKETCH.fitted(), CANVAS, (), sources)


def whole(label, lambda_s, plausible=0.8):
    labels = np.full((CANVAS, CANVAS), label, np.uint8)
    icon = made(labels, lambda_s, sources=SOURCES)
    return replace(icon, score=replace(icon.score, plausible=plausible))


def row(*labels, plausible=0.9):
    some = zip(labels, LAMBDAS, strict=True)
    return [whole(label, value, plausible) for label, value in some]


def halves(number, lambda_s, plausible):
    """A ring above a block, cut lower for each number."""
    labels = np.zeros((CANVAS, CANVAS), np.uint8)
    labels[: 75 + 20 * number] = 1
    icon = made(labels, lambda_s, sources=SOURCES)
    return replace(icon, score=replace(icon.score, plausible=plausible))


def run(workers, icons, plausible, best=0.5):
    """Return the results that take the places of others."""
    events = iter([*map(Result, icons), Recommended("light", best)])
    found = with_variety((one for one in events), pose, workers, render_placed, Fixed(plausible))
    results = [event.icon for event in found if isinstance(event, Result)]
    assert results[: len(icons)] == icons
    return results[len(icons) :]


def pictures(icons):
    gallery = Gallery()
    return sum(gallery.add(icon.drawing.coverage[::2, ::2] > 127) for icon in icons)


def test_what_differs_takes_the_places_of_copies_but_not_of_what_is_recommended(workers):
    icons = row(0, 0, 0, 0, 0, 0)
    assert pictures(icons) == 1
    others = run(workers, icons, 0.9)
    assert others
    assert pictures([icons[-1], *others]) == 1 + len(others)
    assert {one.composite.lambda_s for one in others} <= set(LAMBDAS) - {0.5}
    for one in others:
        used = {one.composite.sources[k].exemplar.id for k in one.composite.owners()}
        assert one.composite.without
        assert one.composite.stands_in
        assert not used & set(one.composite.without)
        problem = pose(SOURCES).problem
        data, smoothness = problem.costs(one.composite.labels)
        assert one.composite.energy == pytest.approx(data + one.composite.lambda_s * smoothness)


def test_copies_give_way_first_then_what_is_least_plausible():
    many = row(0, 1, 2, 3, 0, 0)
    places = weak(many, 0.5, pose).places
    assert [place.lambda_s for place in places] == [0.4, 0.05, 0.1][:YIELDING]
    assert [place.least for place in places] == [0.5, 0.9, 0.9]


@pytest.mark.thorough
def test_what_is_least_plausible_gives_way_but_not_what_is_recommended():
    many = [halves(k, value, 0.6 - value) for k, value in enumerate(LAMBDAS)]
    places = weak(many, 0.5, pose).places
    assert [place.lambda_s for place in places] == [0.4, 0.3, 0.2]
    assert all(place.least == 0.5 for place in places)
    places = weak(
        [halves(k, value, 0.6 + value / 2) for k, value in enumerate(LAMBDAS)], 0.05, pose
    )
    assert [place.least for place in places.places] == pytest.approx([0.65, 0.7, 0.75])


def test_of_a_few_results_each_was_asked_for():
    assert weak(row(0, 0, 0, 0, 0, 0)[:DIFFERENT], 0.05, pose) is None


def test_without_a_judge_a_row_stays(workers):
    few = row(0, 0, 0, 0, 0, 0)
    events = iter([*map(Result, few), Recommended("light", 0.5)])
    found = with_variety((one for one in events), pose, workers, render_placed, None)
    assert len([event for event in found if isinstance(event, Result)]) == len(few)


@pytest.mark.thorough
def test_others_come_from_two_icons_first(workers):
    doubtful = [halves(k, value, 0.6) for k, value in enumerate(LAMBDAS)]
    composite = run(workers, doubtful, 0.9, best=0.3)[0].composite
    assert composite.lambda_s == 0.05
    assert len({composite.sources[k].exemplar.id for k in composite.owners()}) == 2
    assert len(composite.without) == len(SOURCES) - 2


def test_what_is_not_plausible_takes_no_place(workers):
    assert run(workers, row(0, 0, 0, 0, 0, 0), 0.4) == []


def test_copies_are_told_from_the_recommended_one_on():
    found = weak(row(1, 0, 1, 1, 0, 1), 0.2, pose)
    assert found.series.lambdas == (0.5, 0.3, 0.1)  # so that five differ
    assert len(found.seen) == 3
    (first, *_) = found.without
    assert first == {RING.id}


def test_a_symmetric_result_is_no_part_of_the_row(workers):
    icons = row(0, 0, 0, 0, 0, 0)
    symmetric = replace(icons[-1].composite, symmetry="horizontal")
    extra: Remix = replace(icons[-1], composite=symmetric)
    events = iter([*map(Result, icons), Recommended("light", 0.5), Result(extra)])
    found = with_variety((one for one in events), pose, workers, render_placed, Fixed(0.9))
    places = [e.icon.composite.lambda_s for e in found if isinstance(e, Result)][len(icons) + 1 :]
    assert len(places) == len(set(places))


def test_what_gives_way_does_not_depend_on_what_came_first():
    some = [*row(0, 1, 1, 2, 3, 0)]
    one, other = weak(some, 0.2, pose), weak(some[::-1], 0.2, pose)
    assert one.places == other.places and one.without == other.without
    assert all(map(np.array_equal, one.seen, other.seen))
