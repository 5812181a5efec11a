"""A keyword may name the new part alone: whole icons come as large as the part is sketched."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.iconification.matching import Matcher, prepare
from iconstudio.algorithms.raster import fill_polygon, overlap, placed_ink
from iconstudio.model import CANVAS, Edit, Polygon
from iconstudio.svg.placed import render_placed
from iconstudio.workflows.editing.additions import shown
from iconstudio.workflows.editing.editing import edit_icon, own_styles, run
from iconstudio.workflows.editing.fitting import COUNT, fitted
from iconstudio.workflows.editing.placing import place_edit
from iconstudio.workflows.grid import GridSettings
from tests.shapes import exemplar, icons

YS, XS = np.mgrid[:CANVAS, :CANVAS] + 0.5


def polygon(*points):
    return Polygon.of(points)


HAT = polygon((20, 230), (80, 200), (90, 30), (166, 30), (176, 200), (236, 230))
SLANTED = polygon((20, 230), (80, 200), (40, 30), (110, 30), (176, 200), (236, 230))
WIDE = polygon((8, 110), (248, 110), (248, 146), (8, 146))
SHAPES = [
    exemplar(fill_polygon(one), name)
    for one, name in ((HAT, "hat"), (SLANTED, "slanted"), (WIDE, "wide"))
]
FACE = exemplar((XS - 128) ** 2 + (YS - 160) ** 2 < 80**2, "face")


@settings(max_examples=30)
@given(
    scale=st.floats(0.25, 0.6),
    x=st.integers(70, 186),
    y=st.integers(70, 186),
    flip=st.booleans(),
)
def test_what_is_sketched_as_an_icon_is_fitted_as_it_lies(scale, x, y, flip):
    side = -scale if flip else scale
    moved = [(x + side * (a - 128), y + scale * (b - 130)) for a, b in SLANTED.vertices]
    area = fill_polygon(Polygon.of(moved))
    found = fitted([area], SHAPES)
    assert found and found[0].exemplar.id == SHAPES[1].id and found[0].placement.flip == flip
    assert overlap(placed_ink(found[0].exemplar, found[0].placement)[1], area) > 0.8
    assert all(source.exemplar.id != SHAPES[2].id for source in found)


def test_of_each_area_there_are_a_few_and_each_icon_once():
    many = [exemplar(fill_polygon(HAT), f"hat-{number}") for number in range(2 * COUNT)]
    areas = [np.hypot(XS - x, YS - 60) < 40 for x in (60, 190)]
    found = fitted(areas, many)
    assert len(found) == 2 * COUNT
    assert len({(one.exemplar.id, one.placement) for one in found}) == 2 * COUNT
    assert fitted([np.zeros((CANVAS, CANVAS), bool)], many) == fitted([], many) == ()


@pytest.mark.parametrize("keyword_finds_the_icon", [False, True])
def test_a_hat_comes_as_large_as_it_is_sketched(workers, keyword_finds_the_icon):
    small = [(128 + 0.35 * (a - 128), 60 + 0.35 * (b - 130)) for a, b in HAT.vertices]
    edit = Edit(FACE.pictogram, "hat", add=(Polygon.of(small),))
    found = [*SHAPES, FACE] if keyword_finds_the_icon else SHAPES
    matcher = Matcher([prepare(one) for one in found])
    change = place_edit(edit, FACE)
    chosen = GridSettings(styles=("dark",), lambdas=(0.05,))
    (result,) = icons(edit_icon(change, matcher, chosen, workers, render_placed))
    at_sketch = [one for one in result.composite.sources if one.placement.scale < 0.5]
    assert bool(at_sketch) != keyword_finds_the_icon
    if not keyword_finds_the_icon:
        assert result.composite.iou > 0.97


@pytest.mark.thorough
def test_a_cat_gets_the_hat_that_is_sketched(session):
    hat = polygon((76, 70), (104, 60), (108, 10), (148, 10), (152, 60), (180, 70))
    edit = Edit(session.icon("tabler:cat"), "hat", add=(hat,))
    icon = session.exemplar(edit.icon)
    wanted = place_edit(edit, icon).wanted
    chosen = GridSettings(styles=own_styles(icon), lambdas=(0.1,))
    results = icons(run(session, edit, chosen))
    assert results
    for result in results:
        assert shown(result, wanted) > 0.7
