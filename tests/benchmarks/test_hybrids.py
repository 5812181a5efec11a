"""Forty hybrids of five icons under a symmetry constraint, beside plain alpha-expansion.

Run with ``pytest -n 0 tests/benchmarks/test_hybrids.py --benchmark-only``. The mean rank score
of all draws stands in ``extra_info``; those that repeat others are dropped by the workflow only.
"""

import itertools
import statistics
from dataclasses import replace

import numpy as np
import pytest

from iconstudio.algorithms.iconification import ranking
from iconstudio.algorithms.iconification.alpha_expansion import AlphaExpansion
from iconstudio.algorithms.iconification.energy import RemixProblem, placed_sources
from iconstudio.algorithms.iconification.guidance import seed_cost
from iconstudio.model import Placement, Source
from iconstudio.resources import resource
from iconstudio.session import Session
from iconstudio.workflows.events import Result
from iconstudio.workflows.hybrids.file import read_hybrids
from iconstudio.workflows.hybrids.hybrids import LAMBDA_S, draw_seeds
from iconstudio.workflows.hybrids.spec import HYBRIDS
from tests.oracles.expansion import minimise
from tests.oracles.lattice import Lattice


@pytest.fixture(scope="module")
def session():
    with Session() as session:
        yield session


@pytest.fixture(scope="module")
def mix(session):
    """Five robots, held to left and right; 40 draws."""
    return read_hybrids(resource("examples/hybrids/robots.json")).resolved(session.icon)


@pytest.fixture(scope="module")
def problems(session, mix):
    """The problems of all draws."""
    sources = [Source(session.exemplar(icon), Placement()) for icon in mix.icons]
    ink, filled = placed_sources(sources)
    return [
        RemixProblem(seed_cost(draw_seeds(mix, number, filled)), ink, filled, mix.symmetry)
        for number in range(mix.draws)
    ]


def mean_score(problems, found):
    scores = [
        ranking.score(problem, labels, sharing=True).total
        for problem, labels in zip(problems, found, strict=True)
    ]
    return statistics.mean(scores)


@pytest.mark.benchmark(group="40 hybrids of 5 icons, symmetric")
def test_session(benchmark, session, mix):
    assert (len(mix.icons), mix.draws) == (5, 40)
    numbers = itertools.count()

    def another():
        return (replace(mix, seed=next(numbers)),), {}

    def run(wanted):
        return [event for event in session.run(HYBRIDS, wanted) if isinstance(event, Result)]

    results = benchmark.pedantic(run, setup=another, rounds=3, warmup_rounds=1)
    benchmark.extra_info["kept"] = len(results)


@pytest.mark.benchmark(group="40 hybrids of 5 icons, symmetric: cuts only, one thread")
def test_cuts(benchmark, problems):
    AlphaExpansion(problems[0]).solve(LAMBDA_S)  # compiles
    found = benchmark.pedantic(
        lambda: [AlphaExpansion(one).solve(LAMBDA_S) for one in problems], rounds=2
    )
    benchmark.extra_info["mean rank score"] = mean_score(problems, found)


@pytest.mark.benchmark(group="40 hybrids of 5 icons, symmetric: cuts only, one thread")
def test_cuts_by_plain_expansion(benchmark, problems):
    def plain():
        found = []
        for problem in problems:
            lattice = Lattice(problem)
            cheapest = lattice.data.argmin(axis=0).astype(np.uint8)
            found.append(lattice.full(minimise(lattice, cheapest, LAMBDA_S)))
        return found

    found = benchmark.pedantic(plain, rounds=1)
    benchmark.extra_info["mean rank score"] = mean_score(problems, found)
