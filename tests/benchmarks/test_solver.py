"""How long remixes of the examples take for all lambda_S, beside plain expansion with PyMaxflow.

Run with ``pytest -n 0 tests/benchmarks/test_solver.py --benchmark-only``. Three problems take
some four minutes; ``ICONSTUDIO_PROBLEMS=20`` in the environment takes all twenty, in half an hour.
The energies stand in ``extra_info``, from the highest lambda_S down; the last test sums up: the
ratio to the lower energy of both plain ways, for each lambda_S, and the speed-up.
"""

import os
from time import process_time

import numpy as np
import pytest

from iconstudio.algorithms.iconification.alpha_expansion import AlphaExpansion
from iconstudio.algorithms.iconification.energy import RemixProblem, remix_problem
from iconstudio.algorithms.iconification.matching import sources_of
from iconstudio.algorithms.iconification.style import STYLES
from iconstudio.algorithms.iconification.tsdf import tsdf
from iconstudio.algorithms.raster import fill_polygon
from iconstudio.resources import resource
from iconstudio.session import Session
from iconstudio.workflows.grid import LAMBDAS, distinct
from iconstudio.workflows.modelling.file import read_sketch
from tests.oracles.expansion import energy, minimise
from tests.oracles.lattice import Lattice
from tests.shapes import regions_of

FALLING = LAMBDAS[::-1]
PROBLEMS = (
    "motorbike-medium", "temple-medium", "coffee-medium", "airplane-medium", "bicycle-light",
    "boot-dark", "car-lightest", "castle-medium", "cat-light", "chair-dark", "dog-medium",
    "elephant-dark", "fish-light", "guitar-dark", "hammer-light", "house-lightest", "lamp-medium",
    "flower-lightest", "horse-dark", "shuttle-light",
)  # fmt: skip
CHOSEN = PROBLEMS[: int(os.environ.get("ICONSTUDIO_PROBLEMS", "3"))]
FOUND: dict[str, dict[str, tuple[float, list[float]]]] = {}
"""By way and problem: seconds of the processor, and energies."""


def result_of(steps):
    while True:
        try:
            next(steps)
        except StopIteration as end:
            return end.value


@pytest.fixture(scope="module", params=CHOSEN)
def posed(request):
    """The problem of an example in one style."""
    name, style = request.param.split("-")
    examples = resource("examples")
    sketch = read_sketch(next(examples.rglob(f"{name}.json"))).sketch
    with Session() as session:
        matcher = result_of(session.prepare(sketch.keyword))
    polygon = sketch.polygon.fitted()
    field = tsdf(fill_polygon(polygon))
    admits = next(one.admits for one in STYLES if one.name == style)
    admitted = [i for i, e in enumerate(matcher.exemplars) if admits(e.blackness)]
    matches = result_of(matcher.match(field, regions_of(polygon), admitted))
    return remix_problem(field, distinct(sources_of(matches, matcher.exemplars)), sketch.symmetry)


def swept(problem: RemixProblem) -> AlphaExpansion:
    expansion = AlphaExpansion(problem)
    for lambda_s in FALLING:
        expansion.find(lambda_s, LAMBDAS)
    return expansion


def plain(problem: RemixProblem, warm: bool) -> list[float]:
    """Energies from the highest lambda_S down."""
    lattice = Lattice(problem)
    cheapest = lattice.data.argmin(axis=0).astype(np.uint8)
    labels, found = cheapest, []
    for lambda_s in FALLING:
        labels = minimise(lattice, labels if warm else cheapest, lambda_s)
        found.append(energy(problem, lattice.full(labels), lambda_s))
    return found


def timed(request, way, function, *given):
    """Run, and note the seconds of the processor and the energies."""
    began = process_time()
    energies = function(*given)
    name = request.node.callspec.params["posed"]
    FOUND.setdefault(way, {})[name] = process_time() - began, energies
    return energies


def by_sweep(problem: RemixProblem) -> list[float]:
    expansion = AlphaExpansion(problem)
    return [energy(problem, expansion.find(lambda_s, LAMBDAS), lambda_s) for lambda_s in FALLING]


@pytest.mark.benchmark(group="8 lambda_S of one style")
def test_sweep(benchmark, request, posed):
    swept(posed)  # compiles
    found = benchmark.pedantic(timed, (request, "sweep", by_sweep, posed), rounds=3)
    benchmark.extra_info["energies"] = found


@pytest.mark.benchmark(group="8 lambda_S of one style")
def test_plain_expansion_begun_anew(benchmark, request, posed):
    found = benchmark.pedantic(timed, (request, "cold", plain, posed, False), rounds=1)
    benchmark.extra_info["energies"] = found


@pytest.mark.benchmark(group="8 lambda_S of one style")
def test_plain_expansion_each_from_the_last(benchmark, request, posed):
    found = benchmark.pedantic(timed, (request, "warm", plain, posed, True), rounds=1)
    benchmark.extra_info["energies"] = found


@pytest.mark.benchmark(group="preview of one lambda_S")
def test_preview(benchmark, posed):
    swept(posed)  # compiles
    benchmark.pedantic(lambda: AlphaExpansion(posed).preview(LAMBDAS[5]), rounds=5)


@pytest.mark.benchmark(group="4 icons, lambda_S = 3")
def test_small(benchmark, posed):
    few = RemixProblem(posed.data[:4], posed.ink[:4], posed.solid[:4])
    AlphaExpansion(few).solve(3.0)  # compiles
    benchmark.pedantic(lambda: AlphaExpansion(few).solve(3.0), rounds=7)


@pytest.mark.benchmark(group="4 icons, lambda_S = 3")
def test_small_by_plain_expansion(benchmark, posed):
    few = RemixProblem(posed.data[:4], posed.ink[:4], posed.solid[:4])
    lattice = Lattice(few)
    cheapest = lattice.data.argmin(axis=0).astype(np.uint8)
    benchmark.pedantic(minimise, (lattice, cheapest, 3.0), rounds=3)


def test_all_together(benchmark):
    """Sums up what the tests above have found."""
    names = [name for name in FOUND.get("sweep", ()) if name in FOUND.get("warm", ())]
    if not names:
        pytest.skip("nothing to compare")
    cold, warm = (np.array([FOUND[way][name][1] for name in names]) for way in ("cold", "warm"))
    found = np.array([FOUND["sweep"][name][1] for name in names])
    ratio = benchmark.pedantic(np.divide, (found, np.minimum(cold, warm)))
    faster = [FOUND["cold"][name][0] / FOUND["sweep"][name][0] for name in names]
    benchmark.extra_info.update(
        {
            "problems": len(names),
            "energies": ratio.size,
            "ratio, mean": float(ratio.mean()),
            "ratio, max": float(ratio.max()),
            "above 1.01": int((ratio > 1.01).sum()),
            "processor seconds, median": float(np.median([FOUND["sweep"][n][0] for n in names])),
            "times as fast as plain cold, median": float(np.median(faster)),
            "times as fast, least": min(faster),
        }
    )
