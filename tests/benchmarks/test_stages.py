"""How long the stages take on the motorbike example, beside the plain way of doing the same.

Run with ``python -m pytest tests/benchmarks --benchmark-only``; figures are medians.
"""

import numpy as np
import pytest
from scipy import ndimage

from iconstudio.algorithms.energy import remix_problem
from iconstudio.algorithms.matching import (
    FAR,
    SlidingWindow,
    coarse_search,
    prepare,
    refine,
    sources_of,
)
from iconstudio.algorithms.raster import fill_polygon
from iconstudio.algorithms.style import STYLES
from iconstudio.algorithms.sweep import Sweep
from iconstudio.algorithms.tsdf import D_MAX, tsdf
from iconstudio.inputs.sketch import example
from iconstudio.library.resvg import render_placed
from iconstudio.model import CANVAS
from iconstudio.session import Session
from iconstudio.workflows.drawing import draw
from iconstudio.workflows.grid import distinct
from tests.shapes import regions_of


@pytest.fixture(scope="module")
def case():
    """Sketch, regions and prepared exemplars of the motorbike example."""
    sketch = example("motorbike").sketch
    with Session() as session:
        steps = session.prepare(sketch.keyword)
        while True:
            try:
                next(steps)
            except StopIteration as end:
                exemplars = end.value
                break
    polygon = sketch.polygon.fitted()
    return tsdf(fill_polygon(polygon)), regions_of(polygon), exemplars


def matched(field, regions, exemplars, admitted):
    steps = coarse_search(field, regions, exemplars)
    while True:
        try:
            next(steps)
        except StopIteration as end:
            return refine(field, regions, exemplars, end.value, admitted)


@pytest.fixture(scope="module")
def medium(case):
    """Sources and problem of the medium style."""
    field, regions, exemplars = case
    style = STYLES[2]
    admitted = [i for i, e in enumerate(exemplars) if style.admits(e.blackness)]
    sources = distinct(sources_of(matched(field, regions, exemplars, admitted), exemplars))
    return sources, remix_problem(field, sources)


@pytest.mark.benchmark(group="prepare an exemplar at 3 scales")
def test_prepare(benchmark, case):
    benchmark.pedantic(prepare, (case[2][0].exemplar,), rounds=20)


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


@pytest.mark.benchmark(group="match all exemplars, 9 regions")
def test_match(benchmark, case):
    field, regions, exemplars = case
    every = range(len(exemplars))
    benchmark.pedantic(matched, (field, regions, exemplars, every), rounds=3, warmup_rounds=1)


@pytest.mark.benchmark(group="match all exemplars, 9 regions")
def test_match_exhaustively_at_full_resolution(benchmark, case):
    field, regions, exemplars = case
    masks = np.stack([region.mask for region in regions])

    def plain():
        window = SlidingWindow(field - FAR, masks, exemplars[0].variants[0].field.shape[0])
        for one in exemplars:
            for variant in one.variants:
                window.errors(variant.field).reshape(len(regions), -1).argmin(axis=1)

    benchmark.pedantic(plain, rounds=1)


@pytest.mark.benchmark(group="redraw and trace a result at 1024 px")
def test_draw(benchmark, medium):
    sources, problem = medium
    labels = Sweep(problem).solve(0.19)
    drawn = [(s.exemplar.pictogram.svg, s.exemplar.frame, s.placement) for s in sources]
    benchmark.pedantic(draw, (labels, problem.ink, drawn, render_placed), rounds=5, warmup_rounds=1)
