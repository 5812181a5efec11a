"""How long remixes of the examples take for all lambda_S, beside plain expansion with PyMaxflow.

Run with ``python -m pytest tests/benchmarks/test_solver.py --benchmark-only``. The energies stand
in ``extra_info``, from the highest lambda_S down.
"""

import numpy as np
import pytest

from iconstudio.algorithms.energy import RemixProblem, remix_problem
from iconstudio.algorithms.expansion import LAMBDAS, Lattice, energy, minimise
from iconstudio.algorithms.matching import sources_of
from iconstudio.algorithms.raster import fill_polygon
from iconstudio.algorithms.style import STYLES
from iconstudio.algorithms.sweep import Sweep
from iconstudio.algorithms.tsdf import tsdf
from iconstudio.inputs.sketch import example
from iconstudio.session import Session
from iconstudio.workflows.grid import distinct
from tests.shapes import regions_of

FALLING = LAMBDAS[::-1]


def result_of(steps):
    while True:
        try:
            next(steps)
        except StopIteration as end:
            return end.value


@pytest.fixture(scope="module", params=["motorbike", "temple", "coffee"])
def medium(request):
    """The problem of an example's medium style."""
    sketch = example(request.param).sketch
    with Session() as session:
        matcher = result_of(session.prepare(sketch.keyword))
    polygon = sketch.polygon.fitted()
    field = tsdf(fill_polygon(polygon))
    admitted = [i for i, e in enumerate(matcher.exemplars) if STYLES[2].admits(e.blackness)]
    matches = result_of(matcher.match(field, regions_of(polygon), admitted))
    return remix_problem(field, distinct(sources_of(matches, matcher.exemplars)), sketch.symmetry)


def swept(problem: RemixProblem) -> Sweep:
    sweep = Sweep(problem)
    sweep.explore(LAMBDAS)
    for lambda_s in LAMBDAS:
        sweep.solve(lambda_s)
    return sweep


def plain(problem: RemixProblem, warm: bool) -> list[float]:
    """Energies from the highest lambda_S down."""
    lattice = Lattice(problem)
    cheapest = lattice.data.argmin(axis=0).astype(np.uint8)
    labels, found = cheapest, []
    for lambda_s in FALLING:
        labels = minimise(lattice, labels if warm else cheapest, lambda_s)
        found.append(energy(problem, lattice.full(labels), lambda_s))
    return found


@pytest.mark.benchmark(group="8 lambda_S of one style")
def test_sweep(benchmark, medium):
    swept(medium)  # compiles
    sweep = benchmark.pedantic(swept, (medium,), rounds=3)
    benchmark.extra_info["energies"] = [sweep.energy(lambda_s) for lambda_s in FALLING]


@pytest.mark.benchmark(group="8 lambda_S of one style")
def test_plain_expansion_begun_anew(benchmark, medium):
    found = benchmark.pedantic(plain, (medium, False), rounds=1)
    benchmark.extra_info["energies"] = found


@pytest.mark.benchmark(group="8 lambda_S of one style")
def test_plain_expansion_each_from_the_last(benchmark, medium):
    found = benchmark.pedantic(plain, (medium, True), rounds=1)
    benchmark.extra_info["energies"] = found


@pytest.mark.benchmark(group="preview of one lambda_S")
def test_preview(benchmark, medium):
    swept(medium)  # compiles
    benchmark.pedantic(lambda: Sweep(medium).preview(LAMBDAS[5]), rounds=5)


@pytest.mark.benchmark(group="4 icons, lambda_S = 3")
def test_small(benchmark, medium):
    few = RemixProblem(medium.data[:4], medium.ink[:4], medium.solid[:4])
    Sweep(few).solve(3.0)  # compiles
    benchmark.pedantic(lambda: Sweep(few).solve(3.0), rounds=7)


@pytest.mark.benchmark(group="4 icons, lambda_S = 3")
def test_small_by_plain_expansion(benchmark, medium):
    few = RemixProblem(medium.data[:4], medium.ink[:4], medium.solid[:4])
    lattice = Lattice(few)
    cheapest = lattice.data.argmin(axis=0).astype(np.uint8)
    benchmark.pedantic(minimise, (lattice, cheapest, 3.0), rounds=3)
