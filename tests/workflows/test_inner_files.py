"""What is inside an outline, in files of sketches and edits, and in projects."""

import json
import math

import pytest

from iconstudio.model import IconstudioError, Inner, Polygon, Sketch
from iconstudio.workflows.areas import Area, Kind
from iconstudio.workflows.editing.file import read_edit
from iconstudio.workflows.files import write_file
from iconstudio.workflows.modelling.file import read_sketch
from iconstudio.workflows.modelling.modelling import details_of, fitted_sketch
from iconstudio.workflows.modelling.page import SketchPage, problem
from iconstudio.workflows.modelling.spec import MODELLING

SQUARE = [[0, 0], [100, 0], [100, 100], [0, 100]]
HOLE = [[20, 20], [50, 20], [50, 50]]
LINE = [[60, 60], [80, 90]]
INNER = Inner(
    (Polygon(((20.0, 20.0), (50.0, 20.0), (50.0, 50.0))),), (((60.0, 60.0), (80.0, 90.0)),)
)
SKETCH = Sketch(Polygon.of(SQUARE), "dog", inner=INNER, detail=0.25)


def write(folder, **fields):
    path = folder / "work.json"
    path.write_text(json.dumps({"keyword": "dog", "polygon": SQUARE} | fields))
    return path


def test_a_sketch_comes_back_from_its_file(tmp_path):
    path = tmp_path / "sketch.json"
    write_file(path, MODELLING, SKETCH)
    written = json.loads(path.read_text())
    assert (written["holes"], written["lines"], written["detail"]) == ([HOLE], [LINE], 0.25)
    assert read_sketch(path).sketch == SKETCH


def test_a_sketch_with_nothing_inside_is_written_as_before(tmp_path):
    path = tmp_path / "sketch.json"
    write_file(path, MODELLING, Sketch(Polygon.of(SQUARE), "dog"))
    assert not {"holes", "lines", "detail"} & set(json.loads(path.read_text()))


def test_an_edit_in_a_file_has_holes_and_lines(tmp_path):
    path = write(tmp_path, icon="set:name", add=[SQUARE], holes=[HOLE], lines=[LINE])
    data = json.loads(path.read_text())
    del data["polygon"]
    path.write_text(json.dumps(data))
    file = read_edit(path)
    edit = file.resolved(lambda reference: reference)
    assert edit.inner == INNER
    again = type(file).of(edit, lambda icon: icon)
    assert (again.holes, again.lines) == (file.holes, file.lines)


@pytest.mark.parametrize(
    ("fields", "said"),
    [
        (
            {"holes": [[[1, 1], [2, 2]]]},
            "Hole 1 is no good. The polygon has 2 different points",
        ),
        ({"holes": [HOLE, [[1, 1], [2, 2], [3, 3]]]}, "Hole 2 is no good.*encloses no area"),
        ({"lines": [[[1, 1]]]}, "Line 1 has no length"),
        ({"lines": [LINE, [[1, 1], [1, 1]]]}, "Line 2 has no length"),
        ({"holes": 3}, '"holes" must be a list of holes'),
        ({"lines": [[[1, "x"]]]}, 'Point 1 of Line 1 of "lines"|Point 1 of line 1 of "lines"'),
        ({"holes": [[[1, 1], [math.inf, 2], [3, 1]]]}, "is not a number, or too large"),
        ({"holes": [[[0, 0]] * 200_001]}, "200,001 points; at most 200,000 are read"),
        ({"holes": [HOLE] * 201}, '"holes" has 201 entries; at most 200 are read'),
        ({"detail": 1e9}, '"detail" must be a number from 0 to 1'),
        ({"detail": -0.1}, '"detail" must be a number from 0 to 1'),
        ({"detail": math.nan}, '"detail" must be a number from 0 to 1'),
        ({"detail": "much"}, '"detail" must be a number from 0 to 1'),
    ],
)
def test_what_is_no_good_is_told(tmp_path, fields, said):
    with pytest.raises(IconstudioError, match=said):
        read_sketch(write(tmp_path, **fields))


@pytest.mark.parametrize("detail", [1e9, -1.0, math.nan])
def test_a_weight_out_of_range_is_told_before_any_work(detail):
    with pytest.raises(IconstudioError, match="out of range: it goes from 0, as in the paper, to"):
        fitted_sketch(Sketch(Polygon.of(SQUARE), "dog", detail=detail))


def test_what_crosses_the_outline_is_read_and_told_by_the_page(tmp_path):
    outside = [[-50, -50], [-20, -50], [-20, -20]]
    sketch = read_sketch(write(tmp_path, holes=[HOLE, outside])).sketch
    assert len(sketch.inner.holes) == 2
    said = problem(SketchPage(sketch, closed=True))
    assert said == "Hole 2 lies outside the outline. Move it inside, or remove it."
    with pytest.raises(IconstudioError, match="Hole 2 lies outside the outline"):
        fitted_sketch(sketch)


def test_what_is_inside_is_fitted_with_the_outline():
    fitted = fitted_sketch(SKETCH)
    assert fitted.polygon == SKETCH.polygon.fitted()
    assert fitted.inner.lines[0][0] == pytest.approx((16 + 0.6 * 224, 16 + 0.6 * 224))


def test_the_more_details_weigh_the_more_small_regions_there_are():
    fitted = [Sketch(Polygon.of(SQUARE), detail=one).fitted() for one in (0.0, 0.1, 1.0)]
    assert [len(details_of(one)) for one in fitted] == [0, 1, 6]


def test_a_page_keeps_what_is_drawn_inside_in_order():
    page = SketchPage(SKETCH, closed=True)
    draft = Area(Kind.LINE, ((1.0, 1.0),), closed=False)
    drawing = page.with_areas((*page.areas, draft))
    assert (drawing.sketch, drawing.draft) == (SKETCH, draft)
    hole = Area(Kind.HOLE, ((1.0, 1.0), (2.0, 1.0), (2.0, 2.0)))
    more = page.with_areas((*page.areas, hole))
    assert [area.kind for area in more.areas] == [Kind.HOLE, Kind.HOLE, Kind.LINE]


def test_a_hole_that_covers_the_outline_is_called_so():
    around = Polygon(((-10.0, -10.0), (210.0, -10.0), (210.0, 210.0), (-10.0, 210.0)))
    sketch = Sketch(Polygon.of(SQUARE), "dog", inner=Inner((around,), ()))
    with pytest.raises(IconstudioError, match="Hole 1 covers the outline"):
        fitted_sketch(sketch)


def test_a_hole_that_leaves_nothing_of_the_outline_is_refused():
    square = Polygon.of(SQUARE)
    sketch = Sketch(square, "dog", inner=Inner((square,), ()))
    with pytest.raises(IconstudioError, match="Hole 1 leaves nothing of the outline"):
        fitted_sketch(sketch)
