"""Restyling as a run of events: what comes when."""

from concurrent.futures import Future
from contextlib import closing
from dataclasses import replace

import numpy as np
import pytest
from shapely import LineString

from iconstudio.algorithms.curves.outline import path_of
from iconstudio.inputs.styles import named
from iconstudio.model import Line, Restyling
from iconstudio.workflows.events import Result
from iconstudio.workflows.line_style.restyling import (
    LARGEST_SEED,
    RestyleSettings,
    run,
    variations,
)

BAR = Line(((20.0, 128.0), (236.0, 128.0)), width=8.0)
WORK = Restyling(named("Waves"), strokes=(BAR,))


class Workers:
    """Does at once what is coarse, or all; the rest when it is told to."""

    def __init__(self, at_once):
        self.at_once = at_once
        self.waiting = []

    def ticket(self):
        return self

    def stop(self):
        self.waiting = None

    def submit(self, function, *args, timeout, memory, ticket):
        future = Future()
        if self.at_once or args[-1] is True:
            future.set_result(function(*args))
        else:
            self.waiting.append(lambda: future.set_result(function(*args)))
        return future


class Resources:
    def __init__(self, at_once=False):
        self.workers = Workers(at_once)


def results(resources, settings):
    with closing(run(resources, WORK, settings)) as events:
        for event in events:
            if isinstance(event, Result):
                yield event
                for finish in resources.workers.waiting:
                    finish()
                resources.workers.waiting = []


def test_a_coarse_result_comes_before_one_that_takes_longer():
    resources = Resources()
    coarse, finished = results(resources, RestyleSettings(previews=True))
    assert coarse.preview
    assert not finished.preview
    assert resources.workers.waiting is None, "the ticket is stopped"


def test_a_coarse_result_that_comes_too_late_is_left_out():
    (finished,) = results(Resources(at_once=True), RestyleSettings(previews=True))
    assert not finished.preview


def test_no_coarse_result_comes_unless_it_is_asked_for():
    (finished,) = results(Resources(at_once=True), RestyleSettings())
    assert not finished.preview


def test_the_finished_result_does_what_the_coarse_one_did():
    coarse, finished = results(Resources(), RestyleSettings(previews=True))
    (before,), (after,) = coarse.icon.lines, finished.icon.lines
    assert len(before.points) < 0.8 * len(after.points)
    off = np.ptp(np.array(after.points)[:, 1])
    assert LineString(before.points).hausdorff_distance(LineString(after.points)) < off / 2


def test_the_seeds_of_variations_can_all_be_kept_in_files():
    seeds = [one.seed for one in variations(replace(WORK, seed=LARGEST_SEED))]
    assert all(0 <= seed <= LARGEST_SEED for seed in seeds)
    assert len(set(seeds)) == 4


@pytest.mark.parametrize("name", ["Speed", "Drips", "Castle"])
def test_what_is_drawn_stays_on_the_canvas(name):
    frame = ((8.0, 8.0), (248.0, 8.0), (248.0, 248.0), (8.0, 248.0))
    work = Restyling(named(name), strokes=(Line(frame, closed=True, width=16.0),))
    with closing(run(Resources(at_once=True), work)) as events:
        (result,) = (event for event in events if isinstance(event, Result))
    left, top, right, bottom = result.icon.path.bounds
    assert min(left, top) > -1 and max(right, bottom) < 257
    outline, strokes = result.icon.path, path_of(result.icon.lines)
    assert outline.bounds == pytest.approx(strokes.bounds, abs=0.5), "as outline and as strokes"
