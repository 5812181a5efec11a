"""Order of results, previews, finer canvases, stopping: what modelling and editing share."""

import os
import time
from dataclasses import replace

import pytest

from iconstudio.algorithms.iconification.matching import Matcher, prepare
from iconstudio.algorithms.raster import overlap
from iconstudio.model import CANVAS, Polygon, Sketch
from iconstudio.svg.placed import render_placed
from iconstudio.workers import Workers
from iconstudio.workflows.events import Progress, Recommended, Result
from iconstudio.workflows.grid import GridSettings
from iconstudio.workflows.modelling.modelling import model
from iconstudio.workflows.remixing import FINE
from tests.shapes import blob, exemplar, icons

SKETCH = Sketch(Polygon.of([(30, 30), (220, 40), (200, 230), (60, 210)]), "blob")
BOTH = ("medium", "dark")
LAMBDAS = (0.05, 0.2, 0.75)


@pytest.fixture(scope="module")
def workers():
    with Workers(1) as pool:
        yield pool


@pytest.fixture(scope="module")
def prepared():
    return Matcher([prepare(exemplar(blob(seed), f"blob-{seed}")) for seed in range(6)])


def results(events):
    return [event for event in events if isinstance(event, Result)]


def first(events):
    """The first result of a run that ends with it."""
    found = next(event for event in events if isinstance(event, Result))
    events.close()
    return found


def cells(events):
    return [(one.composite.style, one.composite.lambda_s) for one in icons(events)]


def run(prepared, workers, **settings):
    wanted = GridSettings(lambdas=LAMBDAS, **settings)
    return list(model(SKETCH, prepared, wanted, workers, render_placed))


@pytest.mark.thorough
def test_results_come_from_the_highest_lambda_s_down(prepared, workers):
    assert cells(run(prepared, workers, styles=("dark",))) == [
        ("dark", value) for value in LAMBDAS[::-1]
    ]


@pytest.mark.thorough
def test_the_result_in_focus_comes_first_then_its_row_then_the_others(prepared, workers):
    events = run(prepared, workers, styles=BOTH, focus=("dark", 0.2), previews=True)
    rows = [style for style, _ in cells(events)]
    preview, finished, *_ = results(events)
    assert cells([preview, finished]) == [("dark", 0.2)] * 2
    assert (preview.preview, finished.preview) == (True, False)
    assert finished.icon.composite.energy <= preview.icon.composite.energy
    assert rows == sorted(rows, key=lambda style: style != "dark")
    assert sum(one.preview for one in results(events)) == 1
    done = [event.done for event in events if isinstance(event, Progress)]
    assert done[-1] == 1
    assert max(done) == 1


@pytest.mark.thorough
def test_a_row_is_recommended_once_all_its_results_are_finished(prepared, workers):
    events = run(prepared, workers, styles=("dark",), focus=("dark", 0.2), previews=True)
    kinds = [type(event) for event in events if isinstance(event, Result | Recommended)]
    assert kinds == [Result] * 4 + [Recommended]


@pytest.mark.thorough
def test_without_its_style_the_focus_is_still_a_lambda_s(prepared, workers):
    (first, *_) = cells(run(prepared, workers, styles=("dark",), focus=("light", 0.05)))
    assert first == ("dark", 0.05)


@pytest.mark.thorough
def test_a_fine_result_is_of_the_same_shape(prepared, workers):
    settings = GridSettings(lambdas=LAMBDAS, styles=("dark",), focus=("dark", 0.2))
    plain, fine = (
        first(model(SKETCH, prepared, replace(settings, side=side), workers, render_placed))
        for side in (CANVAS, FINE)
    )
    assert fine.icon.composite.labels.shape == (FINE, FINE)
    assert fine.icon.drawing.coverage.shape == plain.icon.drawing.coverage.shape
    assert fine.icon.composite.iou == pytest.approx(plain.icon.composite.iou, abs=0.05)
    drawn = [one.icon.drawing.coverage > 127 for one in (plain, fine)]
    assert overlap(*drawn) > 0.85  # other joins, but the same parts in the same places


def pid():
    return os.getpid()


def test_closing_a_run_stops_it_and_its_process_lives_on(prepared, workers):
    before = workers.submit(pid).result(timeout=60)
    settings = GridSettings(focus=("dark", 0.2), previews=True)
    events = model(SKETCH, prepared, settings, workers, render_placed)
    next(event for event in events if isinstance(event, Result))
    assert workers.load(0) > 0
    events.close()
    began = time.monotonic()
    assert workers.submit(pid).result(timeout=60) == before
    assert time.monotonic() - began < 30  # all that is left would take longer
    assert workers.load(0) == 0
