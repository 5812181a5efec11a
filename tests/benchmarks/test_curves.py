"""Curve Analogies: a line, a pass beside the plain loop, an icon, and how cost grows.

Run with ``pytest -n 0 tests/benchmarks/test_curves.py --benchmark-only``; figures are medians.
"""

from dataclasses import replace

import numpy as np
import pytest

from iconstudio.algorithms.curves.analogy import Search, Synthesised
from iconstudio.algorithms.curves.example import Pair
from iconstudio.algorithms.curves.multiresolution import analogy
from iconstudio.algorithms.curves.outline import path_of
from iconstudio.algorithms.curves.parameters import Parameters
from iconstudio.algorithms.curves.pyramid import pyramid, swept
from iconstudio.algorithms.curves.restyle import prepare, restyled
from iconstudio.inputs.styles import named
from iconstudio.session import Session
from tests.line_styles import circle, jitter, pair_of, unit
from tests.oracles.curve_analogies import Refinement

PARAMETERS = Parameters()
ICONS = "lucide:house", "tabler:coffee", "mdi:cat", "ph:dog-fill"


def example(length):
    styled = jitter()
    whole = np.concatenate([styled, styled + 800])
    return pair_of(whole[: 2 * length])


@pytest.mark.benchmark(group="a closed line of 800 units, 600 candidates")
def test_line(benchmark):
    levels = pyramid([example(1200)], PARAMETERS)
    plain = circle(127.3)
    analogy(levels, plain, PARAMETERS)
    made = benchmark(analogy, levels, plain, PARAMETERS, 1)
    benchmark.extra_info["candidates"] = len(levels[-1].order.arc)
    benchmark.extra_info["points"] = len(made.curve.points)


def once(compiled):
    """A pass over 60 units with 100 candidates, compiled or as a plain loop."""
    parameters = replace(PARAMETERS, levels=0, epsilon=0.0, late=0.0)
    whole = example(200)
    (level,) = pyramid([whole], parameters)
    plain = unit(np.array([20 + 30j, 75 + 55j]))
    made = plain.resampled(level.spacing)
    if not compiled:
        pair = Pair(whole.plain.resampled(1.0), whole.styled.resampled(1.0))
        oracle = Refinement(pair, parameters, level.spacing, True)
        return lambda: oracle.run(plain, made, level.parameters, level.order.arc)
    search = Search(level, plain, parameters, np.ones(1, np.uint64), sweep=swept(plain, parameters))
    begun = Synthesised(made, np.full(len(made.points), -1))
    return lambda: search.refined(begun, None)


@pytest.mark.benchmark(group="a pass over 60 units, 100 candidates")
def test_compiled_pass(benchmark):
    benchmark(once(compiled=True))


@pytest.mark.benchmark(group="a pass over 60 units, 100 candidates")
def test_plain_pass(benchmark):
    benchmark.pedantic(once(compiled=False), rounds=2)


@pytest.fixture(scope="module")
def lines():
    with Session() as session:
        return {icon: session.lines(session.icon(icon)) for icon in ICONS}


@pytest.mark.benchmark(group="an icon, from its lines to an outline")
@pytest.mark.parametrize("icon", ICONS)
def test_icon(benchmark, lines, icon):
    style = prepare(named("Ink"))

    def make(seed):
        return path_of(restyled([(one, style) for one in lines[icon]], seed))

    make(0)
    seeds = iter(range(1, 1000))
    benchmark.pedantic(lambda: make(next(seeds)), rounds=7)


@pytest.mark.benchmark(group="as B and A' grow")
@pytest.mark.parametrize("times", [1, 2, 4])
@pytest.mark.parametrize("what", ["B", "A'"])
def test_growth(benchmark, what, times):
    length = 300 * (times if what == "A'" else 1)
    levels = pyramid([example(length)], PARAMETERS)
    plain = circle(40.0 * (times if what == "B" else 1))
    analogy(levels, plain, PARAMETERS)
    benchmark.pedantic(analogy, (levels, plain, PARAMETERS, 1), rounds=7)
