"""A keyword may name the new part alone: whole icons come as large as the part is sketched."""

from dataclasses import replace

import numpy as np
import pytest
import scipy
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.iconification.matching import Matcher, prepare
from iconstudio.algorithms.raster import fill_polygon, overlap, placed_ink
from iconstudio.model import CANVAS, Edit, Polygon
from iconstudio.svg.placed import render_placed
from iconstudio.workflows.editing.additions import shown
from iconstudio.workflows.editing.editing import edit_icon, own_styles, run
from iconstudio.workflows.editing.fitting import ALIKE, COUNT, fitted
from iconstudio.workflows.editing.lookalikes import names_part
from iconstudio.workflows.editing.placing import place_edit
from iconstudio.workflows.events import Recommended, Remark
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
    (found,) = fitted([area], FACE.ink, SHAPES)
    assert found and found[0].exemplar.id == SHAPES[1].id and found[0].placement.flip == flip
    assert overlap(placed_ink(found[0].exemplar, found[0].placement)[1], area) > 0.8
    assert all(source.exemplar.id != SHAPES[2].id for source in found)


def test_of_each_area_there_are_a_few_and_each_icon_once():
    many = [exemplar(fill_polygon(HAT), f"hat-{number}") for number in range(2 * COUNT)]
    areas = [np.hypot(XS - x, YS - 60) < 40 for x in (60, 190)]
    found = fitted(areas, FACE.ink, many)
    assert [len(row) for row in found] == [COUNT, COUNT]
    assert len({(one.exemplar.id, one.placement) for row in found for one in row}) == 2 * COUNT
    assert fitted([np.zeros((CANVAS, CANVAS), bool)], FACE.ink, many) == ((),)
    assert fitted([], FACE.ink, many) == ()


@pytest.mark.parametrize(("pen", "first"), [(4, "thin"), (20, "thick")])
def test_of_what_fits_as_well_strokes_as_wide_as_the_icons_come_first(pen, first):
    whole = fill_polygon(HAT)
    depth = scipy.ndimage.distance_transform_edt(whole)
    hats = [exemplar(whole & (depth < width), name) for width, name in ((9, "thin"), (40, "thick"))]
    far = np.hypot(XS - 128, YS - 160)
    small = [(128 + 0.4 * (a - 128), 60 + 0.4 * (b - 130)) for a, b in HAT.vertices]
    area = fill_polygon(Polygon.of(small))
    (found,) = fitted([area], abs(far - 70) < pen / 2, [*hats, SHAPES[2]])
    assert [one.exemplar.id for one in found][:1] == [f"test:{first}"]
    assert len(found) == 2


def test_of_what_fits_less_well_that_which_fits_best_comes_first():
    area = fill_polygon(polygon((88, 90), (104, 80), (92, 30), (112, 30), (140, 80), (168, 90)))
    (found,) = fitted([area], FACE.ink, SHAPES)
    parts = [overlap(placed_ink(one.exemplar, one.placement)[1], area) for one in found]
    assert parts == sorted(parts, reverse=True)
    assert min(parts) >= ALIKE


def test_a_keyword_of_another_thing_names_the_part():
    hats = [replace_name(one, f"test:hat-{n}") for n, one in enumerate(SHAPES * 5)]
    cat, cats = replace_name(FACE, "test:cat"), [replace_name(one, "test:cat-fill") for one in hats]
    assert names_part(cat, Matcher([prepare(one) for one in hats]))
    assert names_part(cat, Matcher([prepare(one) for one in (*hats, cats[0])]))
    assert not names_part(cat, Matcher([prepare(one) for one in (*hats, *cats[:3])]))
    assert not names_part(cat, Matcher([prepare(one) for one in (*hats, cat)]))


def replace_name(icon, name):
    return replace(icon, pictogram=replace(icon.pictogram, id=name))


BAR = exemplar(abs(XS - 128) < 20, "bar")


def of_hats(workers, hats, sketch, keyword="hat"):
    edit = Edit(FACE.pictogram, keyword, add=(Polygon.of(sketch),))
    matcher = Matcher([prepare(one) for one in hats])
    chosen = GridSettings(styles=("dark",), lambdas=(0.03, 8.0))
    change = place_edit(edit, FACE)
    return list(edit_icon(change, matcher, chosen, workers, render_placed)), change


ROUND = [(128 + 44 * np.cos(t), 50 + 40 * np.sin(t)) for t in np.linspace(0, 2 * np.pi, 40)]
SQUARE = exemplar((abs(XS - 128) < 100) & (abs(YS - 128) < 100), "square")
BALL = exemplar(np.hypot(XS - 128, YS - 128) < 42, "ball")


def test_a_part_is_whole_though_it_was_sketched_roughly(workers):
    """The corners of a square reach out of a round sketch; another icon would fill that exactly."""
    events, change = of_hats(workers, [SQUARE, BALL], ROUND)
    ((square,),) = fitted(change.areas, FACE.ink, [SQUARE, BALL])
    ink = placed_ink(square.exemplar, square.placement)[0]
    results = icons(events)
    assert results
    for result in results:
        drawn = result.drawing.coverage.reshape(CANVAS, 2, CANVAS, 2).mean(axis=(1, 3)) > 127
        assert drawn[ink].mean() > 0.99
        assert overlap(drawn, FACE.ink | ink) > 0.98
    (named,) = (event for event in events if isinstance(event, Recommended))
    assert named.lambda_s is not None
    assert not any(isinstance(event, Remark) for event in events)


def test_that_no_icon_fits_as_a_whole_is_told(workers):
    events, _ = of_hats(workers, [BAR, SHAPES[2]], ROUND)
    said = [event.sentence for event in events if isinstance(event, Remark)]
    assert any("No icon of “hat” fits what you added as a whole" in text for text in said)


@pytest.mark.thorough(but=1)
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
