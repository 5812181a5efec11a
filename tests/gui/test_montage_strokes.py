"""Strokes of two icons never cover the same pixel, whatever is drawn, rubbed out and moved."""

import math
from itertools import pairwise

import numpy as np
import pytest
from fake_session import exemplar
from hypothesis import example, given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.iconification.guidance import points_on, scribble
from iconstudio.inputs.formats import Reference
from iconstudio.inputs.json import write
from iconstudio.model import CANVAS, IconstudioError, Placement, Stroke
from iconstudio.workflows.montage.file import MontageFile, read_montage
from iconstudio.workflows.montage.montage import check

pytest.importorskip("PySide6.QtGui")


from iconstudio.workflows.montage.page import IconShape, MontagePage
from iconstudio.workflows.montage.strokes import carried, cut, strokes_of

coordinate = st.floats(-60, CANVAS + 60)
point = st.tuples(coordinate, coordinate)
stroke = st.builds(Stroke, st.floats(1, 60), st.lists(point, min_size=1, max_size=5).map(tuple))
placement = st.builds(
    Placement, st.floats(0.1, 4), st.booleans(), st.integers(-150, 150), st.integers(-150, 150)
)
number = st.integers(0, 2)
step = st.one_of(
    st.tuples(st.just("drawn"), number, st.lists(stroke, min_size=1, max_size=2)),
    st.tuples(st.just("erased"), number, st.lists(stroke, min_size=1, max_size=1)),
    st.tuples(st.just("placed"), number, placement),
    st.tuples(st.just("ordered"), number, number),
)


def named(icon):
    return Reference(icon.id)


def three_icons():
    return MontagePage().with_icons(IconShape(exemplar(n)) for n in range(3))


@settings(max_examples=150)
@given(st.lists(step, max_size=10))
@example([("drawn", 0, [Stroke(4.0, ((0.0, 0.0), (1.0, 1.9006040323566764e-308)))])])
def test_after_any_edits_the_montage_is_accepted_or_nothing_is_marked(tmp_path_factory, steps):
    page = three_icons()
    for name, which, what in steps:
        page = page.erased(what, which) if name == "erased" else getattr(page, name)(which, what)
    try:
        check(page.montage())
    except IconstudioError as error:
        assert "Nothing is marked" in str(error)
        assert not page.marked
    else:
        assert page.marked
        path = tmp_path_factory.getbasetemp() / "montage.json"
        write(path, MontageFile.of(page.montage(), named))
        check(read_montage(path).resolved(lambda _: page.layers[0].icon.pictogram))


@settings(max_examples=100)
@given(stroke, stroke)
def test_what_is_left_lies_where_the_stroke_was_and_is_as_much_as_can_be(one, knife):
    left = cut((one,), (knife,))
    before = points_on(one)
    gap = one.width / 2 + knife.width / 2 + 3
    far = [p for p in before.tolist() if _gap(p, knife) > gap]
    for p in far:
        assert min((_gap(p, part) for part in left), default=math.inf) < 0.6
    for part in left:
        assert part.width == one.width
        assert all(_gap(p, one) < 0.01 for p in part.points)


def _gap(p, line):
    return (
        float(np.hypot(*(points_on(line) - p).T).min()) if len(line.points) == 1 else _foot(p, line)
    )


def _foot(p, line):
    gaps = []
    for (x0, y0), (x1, y1) in pairwise(line.points):
        length = (x1 - x0) ** 2 + (y1 - y0) ** 2
        t = ((p[0] - x0) * (x1 - x0) + (p[1] - y0) * (y1 - y0)) / length if length else 0
        t = min(1, max(0, t))
        gaps.append(math.hypot(p[0] - x0 - t * (x1 - x0), p[1] - y0 - t * (y1 - y0)))
    return min(gaps)


def test_even_pressure_makes_one_stroke_and_growing_pressure_several():
    points = [(10.0 + 2 * n, 20.0) for n in range(40)]
    (even,) = strokes_of(points, [10.0, 11.0] * 20)
    assert even.width == pytest.approx(10.5)
    assert even.points == (points[0], points[-1])
    growing = strokes_of(points, [5 + 0.5 * n for n in range(40)])
    widths = [one.width for one in growing]
    assert len(growing) > 3
    assert widths == sorted(widths)
    assert growing[0].points[0] == points[0] and growing[-1].points[-1] == points[-1]
    for one, other in pairwise(growing):
        assert one.points[-1] == other.points[0]


def test_a_click_is_a_dot():
    (dot,) = strokes_of([(30.0, 40.0)], [12.0])
    assert dot == Stroke(12.0, ((30.0, 40.0),))


@given(stroke, placement, placement)
def test_strokes_go_with_their_icon_and_come_back(one, there, elsewhere):
    back = carried(carried(one, there, elsewhere), elsewhere, there)
    assert np.allclose(back.points, one.points, atol=1e-6)


def test_a_stroke_stays_over_the_same_ink():
    icon = exemplar(3)
    page = MontagePage().with_icons([IconShape(icon)])
    page = page.drawn(0, [Stroke(4.0, ((100.0, 150.0), (150.0, 190.0)))])
    moved = page.placed(0, Placement(0.5, True, 20, -10)).layers[0]
    assert moved.strokes[0].width == 2.0
    assert scribble(page.layers[0].strokes)[icon.ink].any()
    assert all(moved.inks(p) for p in moved.strokes[0].points)
    assert not moved.inks((100.0, 150.0))


def test_a_stroke_that_is_enlarged_beyond_all_bounds_can_be_saved(tmp_path):
    icon = exemplar(3)
    page = MontagePage().with_icons([IconShape(icon)])
    page = page.placed(0, Placement(0.1)).drawn(0, [Stroke(4.0, ((10.0, 128.0), (250.0, 128.0)))])
    page = page.placed(0, Placement(8.0))
    (layer,) = page.montage().layers
    assert scribble(layer.strokes)[128].all()
    path = tmp_path / "large.json"
    write(path, MontageFile.of(page.montage(), named))
    (layer,) = read_montage(path).resolved(lambda _: icon.pictogram).layers
    assert scribble(layer.strokes)[128].all()
