from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.iconification.energy import joined_ink, placed_sources
from iconstudio.algorithms.iconification.matching import Matcher, prepare
from iconstudio.algorithms.iconification.style import STYLES
from iconstudio.model import CANVAS, Frame, IconstudioError, Inner, Placement, Polygon, Sketch
from iconstudio.svg.placed import render_placed
from iconstudio.svg.resvg import render_coverage
from iconstudio.workflows.events import (
    Progress,
    RegionsFound,
    Remark,
    Result,
    StyleMatched,
    StyleSkipped,
)
from iconstudio.workflows.grid import ENOUGH, GridSettings, admitted_to, distinct
from iconstudio.workflows.modelling.modelling import FEWEST, model
from tests.shapes import blob, exemplar, icons

LIGHTEST, *_, DARK = STYLES
HOUSE = Polygon.of([(16, 128), (128, 16), (240, 128), (210, 128), (210, 240), (46, 240), (46, 128)])


def house_ink():
    from iconstudio.algorithms.raster import fill_polygon

    return fill_polygon(HOUSE)


@pytest.fixture(scope="module")
def prepared():
    shapes = [exemplar(blob(seed), f"blob-{seed}") for seed in range(FEWEST)]
    shapes.append(exemplar(house_ink(), "house"))
    return Matcher([prepare(shape) for shape in shapes])


@pytest.fixture(scope="module")
def events(prepared, workers):
    sketch = Sketch(HOUSE, "house")
    settings = GridSettings(styles=("lightest", "dark"), lambdas=(0.05, 0.75))
    return list(model(sketch, prepared, settings, workers, render_placed))


def of(kind, events):
    return [event for event in events if isinstance(event, kind)]


def test_an_exemplar_that_equals_the_sketch_comes_back_exactly(events):
    results = icons(events)
    assert [round(result.composite.lambda_s, 3) for result in results] == [0.75, 0.05]
    for result in results:
        composite = result.composite
        assert composite.iou == 1
        assert composite.energy == composite.data_cost == composite.smoothness_cost == 0
        owner = composite.sources[int(np.argmax(composite.shares))]
        assert (owner.exemplar.id, owner.placement) == ("test:house", Placement())
        svg = (
            '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 256 256">'
            f'<path d="{result.path.svg()}"/></svg>'
        )
        drawn = render_coverage(svg, Frame(0, 0, CANVAS), CANVAS) > 127
        assert (drawn ^ house_ink()).sum() < 60


def test_a_style_with_too_few_exemplars_says_so(events):
    (skipped,) = of(StyleSkipped, events)
    assert (skipped.style, skipped.retrieved) == ("lightest", 0)
    assert "no icons" in skipped.reason


def test_matches_come_before_results_and_progress_ends_at_one(events):
    kinds = [type(event) for event in events if not isinstance(event, Progress)]
    assert kinds[0] is RegionsFound
    assert kinds.index(StyleMatched) < kinds.index(Result)
    remixed = [event.done for event in of(Progress, events) if event.stage == "remix"]
    assert remixed[-1] == 1
    assert remixed == sorted(remixed)


def test_three_sources_for_each_region(events):
    (matched,) = of(StyleMatched, events)
    (found,) = of(RegionsFound, events)
    assert len(matched.matches) == len(found.centres)
    assert all(len(row) == 3 for row in matched.matches)
    sources = distinct(matched.matches)
    assert len({(s.exemplar.id, s.placement) for s in sources}) == len(sources) <= 27


def test_a_result_adds_up(events):
    composite = icons(events)[-1].composite
    assert sum(composite.shares) == pytest.approx(1)
    assert composite.labels.shape == (CANVAS, CANVAS)
    assert composite.labels.max() < len(composite.sources)
    assert composite.energy == pytest.approx(
        composite.data_cost + composite.lambda_s * composite.smoothness_cost
    )


def test_closing_the_generator_stops_the_work(prepared, workers):
    run = model(Sketch(HOUSE, "house"), prepared, GridSettings(), workers, render_placed)
    for event in run:
        if isinstance(event, StyleMatched):
            break
    run.close()
    assert workers.submit(sum, [1, 2, 3]).result(timeout=20) == 6


def test_unknown_styles_are_refused(prepared, workers):
    settings = GridSettings(styles=("shiny",))
    with pytest.raises(IconstudioError, match=r"shiny.*lightest, light, medium, dark"):
        next(model(Sketch(HOUSE), prepared, settings, workers, render_placed))


@pytest.mark.thorough
def test_a_remix_of_two_halves_joins_them(workers):
    """Left half of the sketch like one exemplar, right half like another."""
    square, disc = np.zeros((2, CANVAS, CANVAS), bool)
    square[40:216, 40:216] = True
    ys, xs = np.mgrid[:CANVAS, :CANVAS] - 127.5
    disc[np.hypot(xs, ys) < 88] = True
    shapes = [exemplar(square, "square"), exemplar(disc, "disc")]
    shapes += [exemplar(blob(seed), f"blob-{seed}") for seed in range(FEWEST)]
    outline = Polygon.of(
        [(40, 40), (128, 40)]
        + [(128 + 88 * np.sin(a), 128 - 88 * np.cos(a)) for a in np.linspace(0, np.pi, 40)]
        + [(40, 216)]
    )
    settings = GridSettings(styles=("dark",), lambdas=(0.03,), scales=(1.0,))
    matcher = Matcher([prepare(one, (1.0,)) for one in shapes])
    run = model(Sketch(outline), matcher, settings, workers, render_placed)
    (result,) = icons(run)
    assert result.composite.iou > 0.93
    composite = result.composite
    corners = [(y, x) for y in (43, 212) for x in (44, 211)]
    owners = [composite.sources[composite.labels[corner]].exemplar.id for corner in corners]
    ink = joined_ink(placed_sources(composite.sources)[0], composite.labels)
    assert owners[::2] == ["test:square"] * 2
    assert [bool(ink[corner]) for corner in corners] == [True, False] * 2


def test_few_exemplars_that_are_unlike_the_sketch_are_skipped(workers):
    """Thin bars for a square: enough to choose from, but nothing to make a square of."""
    bars = np.zeros((FEWEST, CANVAS, CANVAS), bool)
    for number, bar in enumerate(bars):
        bar[120 : 126 + number, 16:240] = True
    prepared = Matcher([prepare(exemplar(bar, f"bar-{n}"), (1.0,)) for n, bar in enumerate(bars)])
    settings = GridSettings(styles=("dark",), lambdas=(0.1,), scales=(1.0,))
    square = Polygon.of([(0, 0), (9, 0), (9, 9), (0, 9)])
    (skipped,) = of(
        StyleSkipped, list(model(Sketch(square), prepared, settings, workers, render_placed))
    )
    assert skipped.retrieved == FEWEST
    assert "none resembles" in skipped.reason


def test_of_what_is_drawn_inside_nothing_is_told_if_there_are_no_results(prepared, workers):
    inside = Inner((Polygon.of([(100, 150), (140, 150), (140, 190), (100, 190)]),))
    settings = GridSettings(styles=("light",), lambdas=(0.1,), scales=(1.0,))
    sketch = Sketch(HOUSE, "house", inner=inside)
    events = list(model(sketch, prepared, settings, workers, render_placed))
    assert of(StyleSkipped, events)
    assert not of(Result, events)
    assert not of(Remark, events)


def squares(count):
    """Dark exemplars, none of them like another."""
    sides = np.zeros((count, CANVAS, CANVAS), bool)
    for number, ink in enumerate(sides):
        ink[16:240, 16 : 240 - 8 * number] = True
    return [exemplar(ink, f"square-{number}") for number, ink in enumerate(sides)]


@pytest.fixture(scope="module")
def ten():
    return [prepare(one, (1.0,)) for one in squares(ENOUGH + 2)]


@settings(max_examples=40)
@given(st.data())
def test_strangers_serve_only_where_too_few_others_do_and_none_is_lost(ten, data):
    ids = [one.exemplar.id for one in ten]
    some = st.frozensets(st.sampled_from(ids))
    strangers, include, without = (data.draw(some) for _ in range(3))
    matcher = Matcher(ten, strangers=strangers)
    used = {ids[number] for number in admitted_to(DARK, matcher, include, without)}
    others = set(ids) - (strangers - include) - without
    assert used | (strangers - include - without) == set(ids) - without
    assert used == (others if len(others) >= ENOUGH else set(ids) - without)
    assert not admitted_to(LIGHTEST, matcher)


def test_strangers_are_no_sources_until_they_are_brought_in(ten, workers):
    settings = GridSettings(styles=("dark",), lambdas=(0.1,), scales=(1.0,))
    stranger = ten[0].exemplar
    matcher = Matcher(ten, strangers=frozenset({stranger.id}))
    square = Sketch(Polygon.of([(0, 0), (9, 0), (9, 9), (0, 9)]))
    for sketch, used in (square, False), (replace(square, include=frozenset({stranger.id})), True):
        run = model(sketch, matcher, settings, workers, render_placed)
        (matched,) = of(StyleMatched, list(run))
        assert (stranger in matched.exemplars) is used
        assert (stranger.id in {one.exemplar.id for one in matched.whole}) is used


def test_an_icons_own_silhouette_matches_it_as_a_whole(events):
    (matched,) = of(StyleMatched, events)
    first, *others = matched.whole
    assert (first.exemplar.id, first.placement, first.region) == ("test:house", Placement(), -1)
    assert first.error == pytest.approx(0, abs=1e-6)
    assert [one.error for one in others] == sorted(one.error for one in others)
    (result, *_) = icons(events)
    pairs = {(one.exemplar.id, one.placement) for one in result.composite.sources}
    assert {(one.exemplar.id, one.placement) for one in matched.whole} <= pairs
