"""Matching beside the plain way of doing the same, and whether it finds the same.

Run with ``pytest -n 0 tests/benchmarks/test_matching.py --benchmark-only``; figures are
medians.
"""

from pathlib import Path

import numpy as np
import pytest

from iconstudio.algorithms.iconification.matching import MATCHES, SCALES, Matcher, prepare
from iconstudio.algorithms.iconification.style import STYLES
from iconstudio.algorithms.iconification.tsdf import tsdf
from iconstudio.algorithms.raster import fill_polygon
from iconstudio.resources import resource
from iconstudio.session import Session
from iconstudio.workflows.modelling.file import example, read_sketch
from tests.oracles.exhaustive import exhaustive
from tests.shapes import regions_of

MANY = "house"
"""It retrieves as many icons as the paper's 200."""
EXAMPLES = sorted(resource("examples").glob("*.json")) + sorted(
    (resource("examples") / "gallery").glob("*.json")
)


def result_of(steps):
    while True:
        try:
            next(steps)
        except StopIteration as end:
            return end.value


@pytest.fixture(scope="module")
def session():
    with Session() as session:
        yield session


@pytest.fixture(scope="module")
def target():
    """The field and the nine regions of the motorbike."""
    polygon = example("motorbike").sketch.polygon.fitted()
    return tsdf(fill_polygon(polygon)), regions_of(polygon)


@pytest.fixture(scope="module")
def many(session):
    """200 prepared exemplars, also those of two tones."""
    icons = result_of(session.rasterise(session.search(MANY)))
    ready = [prepare(icon) for icon in icons]
    return (ready + ready)[:200]


def matched(field, regions, exemplars, admitted=None):
    every = range(len(exemplars)) if admitted is None else admitted
    return result_of(Matcher(exemplars).match(field, regions, every))


@pytest.mark.benchmark(group="match 200 icons, 3 scales, mirrored or not, 9 regions")
def test_match(benchmark, target, many):
    field, regions = target
    assert (len(many), len(regions)) == (200, 9)
    benchmark.extra_info["bytes an exemplar"] = many[0].squared.nbytes + many[0].spectra.nbytes
    benchmark.pedantic(matched, (field, regions, many), rounds=7, warmup_rounds=1)


@pytest.mark.benchmark(group="match 200 icons, 3 scales, mirrored or not, 9 regions")
def test_match_exhaustively(benchmark, target, many):
    """By fast Fourier transforms of whole pictures; 40 icons stand for 200."""
    field, regions = target
    benchmark.extra_info["icons"] = 40
    benchmark.pedantic(exhaustive, (field, regions, many[:40]), rounds=1)
    benchmark.extra_info["seconds for 200"] = benchmark.stats.stats.median * 5


@pytest.mark.benchmark(group="match the motorbike's icons anew")
@pytest.mark.parametrize("style", [*(style.name for style in STYLES), "every style in turn"])
def test_match_the_motorbike(benchmark, session, target, style):
    """As after a vertex was dragged, when nothing is remembered."""
    ready = result_of(session.prepare("motorcycle")).exemplars
    rows = [
        [number for number, one in enumerate(ready) if one_style.admits(one.blackness)]
        for one_style in STYLES
        if style in (one_style.name, "every style in turn")
    ]

    def run():
        matcher = Matcher(ready)
        for row in rows:
            result_of(matcher.match(*target, row))

    benchmark.extra_info["icons"] = [len(row) for row in rows]
    benchmark.pedantic(run, rounds=9, warmup_rounds=1)


@pytest.mark.benchmark(group="prepare an exemplar at 3 scales")
def test_prepare(benchmark, many):
    benchmark.pedantic(prepare, (many[0].exemplar, SCALES), rounds=20)


TIE = 1e-5
"""Errors that differ by this part are the same: the exhaustive way's own sums are no more exact."""


def compared(session, path: Path) -> tuple[int, list[float]]:
    """Return the number of a sketch's regions, and the error ratios of those that differ."""
    sketch = read_sketch(path).sketch
    ready = result_of(session.prepare(sketch.keyword, sketch.exclude)).exemplars
    polygon = sketch.polygon.fitted()
    field, regions = tsdf(fill_polygon(polygon)), regions_of(polygon)
    ratios = []
    for row, errors in zip(
        matched(field, regions, ready), exhaustive(field, regions, ready), strict=True
    ):
        best = np.argsort(errors)[:MATCHES]
        ratio = max(one.error / errors[k] for one, k in zip(row, best, strict=True))
        if {match.index for match in row} != set(best) and ratio > 1 + TIE:
            ratios.append(ratio)
    return len(regions), ratios


@pytest.mark.timeout(7200)
@pytest.mark.benchmark(group="the same pictograms as the exhaustive search")
def test_matches_are_those_of_the_exhaustive_search(benchmark, session):
    """A check rather than a benchmark: it takes minutes."""

    def check():
        return [compared(session, path) for path in EXAMPLES]

    found = benchmark.pedantic(check, rounds=1)
    count, ratios = sum(regions for regions, _ in found), [one for _, row in found for one in row]
    benchmark.extra_info["sketches"] = len(found)
    benchmark.extra_info["regions"] = count
    benchmark.extra_info["% of regions with the same pictograms"] = 100 * (1 - len(ratios) / count)
    benchmark.extra_info["worst error ratio where they differ"] = max(ratios, default=1.0)
    assert len(ratios) <= 0.01 * count
    assert max(ratios, default=1.0) <= 1.01
