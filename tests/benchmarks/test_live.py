"""How soon results follow the hand, in a session that got ready while the outline was drawn.

Run with ``pytest -n 0 tests/benchmarks/test_live.py --benchmark-only``; figures are medians.
"""

import itertools
import statistics
from contextlib import closing
from dataclasses import replace
from time import perf_counter

import numpy as np
import pytest

from iconstudio.model import Polygon, Sketch
from iconstudio.session import Session
from iconstudio.workflows.events import Result
from iconstudio.workflows.grid import LAMBDAS, GridSettings
from iconstudio.workflows.modelling.file import example
from iconstudio.workflows.modelling.spec import MODELLING

FOCUS = ("medium", LAMBDAS[4])
LIVE = GridSettings(previews=True, focus=FOCUS)
VERTEX = 12
DRAGGED = 12.0
"""How far the vertex is dragged back and forth, in units of the canvas."""


@pytest.fixture(scope="module")
def sketch():
    """The motorbike, in units of the canvas."""
    traced = example("motorbike").sketch
    return replace(traced, polygon=traced.polygon.fitted())


@pytest.fixture(scope="module")
def session(sketch):
    """Ready: the icons are prepared and the worker processes have worked before."""
    with Session() as session:
        for steps in (
            session.get_ready(),
            session.prepare(sketch.keyword),
            session.run(MODELLING, sketch),
        ):
            for _ in steps:
                pass
        yield session


def moved(sketch: Sketch, by: np.ndarray) -> Sketch:
    """The sketch with its vertices moved, (n, 2)."""
    vertices = np.array(sketch.polygon.vertices) + by
    return replace(sketch, polygon=Polygon.of(vertices.tolist()))


def timed(events):
    """Yield the results with the seconds since the run was asked for; ending early ends it."""
    began = perf_counter()
    with closing(events):
        for event in events:
            if isinstance(event, Result):
                yield perf_counter() - began, event


@pytest.mark.benchmark(group="motorbike, from closing the polygon: 4 styles x 8 lambda_S")
def test_full_grid(benchmark, session, sketch):
    """Every round has an outline of its own, so that nothing is known of it."""
    random = np.random.default_rng(7)
    firsts = []

    def another():
        shaken = random.uniform(-3, 3, (len(sketch.polygon.vertices), 2))
        return (moved(sketch, shaken),), {}

    def run(wanted):
        times = [seconds for seconds, _ in timed(session.run(MODELLING, wanted, LIVE))]
        firsts.append(times[0])

    benchmark.pedantic(run, setup=another, rounds=5, warmup_rounds=1)
    benchmark.extra_info["first result, seconds"] = statistics.median(firsts[1:])


@pytest.mark.benchmark(group="motorbike, after dragging a vertex: the result in focus")
def test_drag(benchmark, session, sketch):
    """Back and forth, never twice to the same place; what is stale is still under way."""
    previews, ratios = [], []
    rounds = itertools.count()

    def drag():
        number = next(rounds)
        way = (DRAGGED + 0.4 * number) * (1 if number % 2 else -1)
        by = np.zeros((len(sketch.polygon.vertices), 2))
        by[VERTEX] = 0.6 * way, 0.8 * way
        return (moved(sketch, by),), {}

    def run(wanted):
        with closing(timed(session.run(MODELLING, wanted, LIVE))) as results:
            at, coarse = next(results)
            previews.append(at)
            for _, result in results:
                composite = result.icon.composite
                if not result.preview and (composite.style, composite.lambda_s) == FOCUS:
                    ratios.append(coarse.icon.composite.energy / composite.energy)
                    return

    benchmark.pedantic(run, setup=drag, rounds=10, warmup_rounds=2)
    benchmark.extra_info["preview, seconds"] = statistics.median(previews[2:])
    benchmark.extra_info["energy of the preview / refined, median"] = statistics.median(ratios[2:])
    benchmark.extra_info["energy of the preview / refined, greatest"] = max(ratios[2:])
