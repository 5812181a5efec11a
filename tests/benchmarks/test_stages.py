"""How long the stages take on the motorbike example, beside the plain way of doing the same.

Run with ``pytest -n 0 tests/benchmarks --benchmark-only``; figures are medians.
"""

import numpy as np
import pytest
from scipy import ndimage

from iconstudio.algorithms.iconification.alpha_expansion import AlphaExpansion
from iconstudio.algorithms.iconification.energy import remix_problem
from iconstudio.algorithms.iconification.matching import sources_of
from iconstudio.algorithms.iconification.style import STYLES
from iconstudio.algorithms.iconification.tsdf import D_MAX, tsdf
from iconstudio.algorithms.raster import fill_polygon
from iconstudio.model import CANVAS
from iconstudio.session import Session
from iconstudio.svg.placed import render_placed
from iconstudio.workflows.drawing import draw
from iconstudio.workflows.grid import distinct
from iconstudio.workflows.modelling.file import example
from tests.shapes import regions_of


@pytest.fixture(scope="module")
def case():
    """Field, regions and matcher of the motorbike example."""
    sketch = example("motorbike").sketch
    with Session() as session:
        matcher = result_of(session.prepare(sketch.keyword))
    polygon = sketch.polygon.fitted()
    return tsdf(fill_polygon(polygon)), regions_of(polygon), matcher


def result_of(steps):
    while True:
        try:
            next(steps)
        except StopIteration as end:
            return end.value


@pytest.fixture(scope="module")
def medium(case):
    """Sources and problem of the medium style."""
    field, regions, matcher = case
    style = STYLES[2]
    admitted = [i for i, e in enumerate(matcher.exemplars) if style.admits(e.blackness)]
    matches = result_of(matcher.match(field, regions, admitted))
    sources = distinct(sources_of(matches, matcher.exemplars))
    return sources, remix_problem(field, sources)


@pytest.mark.benchmark(group="distance field, 256 x 256")
def test_tsdf(benchmark, case):
    benchmark(tsdf, fill_polygon(example("motorbike").sketch.polygon.fitted()))


@pytest.mark.benchmark(group="distance field, 256 x 256")
def test_tsdf_by_full_distance_transforms(benchmark, case):
    filled = fill_polygon(example("motorbike").sketch.polygon.fitted())

    def plain():
        both = ndimage.distance_transform_edt(~filled) - ndimage.distance_transform_edt(filled)
        return np.clip(both, -D_MAX, D_MAX) / CANVAS

    benchmark(plain)


@pytest.mark.benchmark(group="redraw and trace a result at 1024 px")
def test_draw(benchmark, medium):
    sources, problem = medium
    labels = AlphaExpansion(problem).solve(0.19)
    benchmark.pedantic(
        draw, (labels, problem.ink, sources, render_placed), rounds=5, warmup_rounds=1
    )
