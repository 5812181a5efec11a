import numpy as np
import pytest

from iconstudio.algorithms.iconification.matching import Matcher, prepare
from iconstudio.algorithms.raster import overlap
from iconstudio.model import CANVAS, Polygon, Sketch
from iconstudio.svg.placed import render_placed
from iconstudio.workflows.grid import GridSettings
from iconstudio.workflows.modelling.modelling import model
from iconstudio.workflows.montage.montage import check, montage_icons
from iconstudio.workflows.montage.page import IconShape, MontagePage
from iconstudio.workflows.montage.reproducing import reproduction
from tests.shapes import blob, exemplar, icons

YS, XS = np.mgrid[:CANVAS, :CANVAS] + 0.5


@pytest.fixture(scope="module")
def result(workers):
    """A remix of a square's left half, a disc's right half, and blobs."""
    square = exemplar((abs(XS - 128) < 88) & (abs(YS - 128) < 88), "square")
    disc = exemplar(np.hypot(XS - 128, YS - 128) < 88, "disc")
    shapes = [square, disc, *(exemplar(blob(seed), f"blob-{seed}") for seed in range(3))]
    outline = [(40, 40), (128, 40), (190, 66), (216, 128), (190, 190), (128, 216), (40, 216)]
    matcher = Matcher([prepare(shape) for shape in shapes])
    settings = GridSettings(styles=("dark",), lambdas=(0.03,))
    sketch = Sketch(Polygon.of(outline), "shape")
    (made,) = icons(list(model(sketch, matcher, settings, workers, render_placed)))
    return made


@pytest.fixture(scope="module")
def page(result):
    """Its montage as the window has it, where no strokes of two icons overlap."""
    drawn = {one.exemplar.id: one.exemplar for one in result.composite.sources}
    layers = reproduction(result.composite).layers
    return MontagePage.of(layers, [IconShape(drawn[one.icon.id]) for one in layers])


@pytest.mark.thorough
def test_the_montage_of_a_result_is_the_result(result, page, workers):
    assert len(result.composite.owners(0.02)) > 1  # else it would be too easy
    shapes = [one.icon.exemplar for one in page.layers]
    again = icons(list(montage_icons(page.montage(), shapes, workers, render_placed)))
    ink, other = (one.drawing.coverage > 127 for one in (result, *again))
    assert overlap(ink, other) > 0.95


def test_strokes_lie_on_what_each_source_owns(result, page):
    composite, montage = result.composite, page.montage()
    placed = {(one.exemplar.id, one.placement): k for k, one in enumerate(composite.sources)}
    marked = np.full((CANVAS, CANVAS), -1)
    for layer, scribbled in zip(montage.layers, check(montage), strict=True):
        marked[scribbled] = placed[layer.icon.id, layer.placement]
    right = marked == composite.labels
    assert right.sum() > 0.99 * (marked >= 0).sum() > 0
