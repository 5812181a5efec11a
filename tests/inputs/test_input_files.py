"""The user's files: what is written is read again, and every mistake is told."""

import dataclasses
import itertools
import json
import math
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from iconstudio.inputs.formats import Reference
from iconstudio.inputs.json import load, write
from iconstudio.model import (
    Axis,
    Edit,
    IconstudioError,
    Layer,
    Mix,
    Montage,
    Placement,
    Polygon,
    Sketch,
    Stroke,
)
from iconstudio.workflows.editing.file import EditFile, read_edit
from iconstudio.workflows.hybrids.file import HybridsFile, read_hybrids
from iconstudio.workflows.modelling.file import SketchFile, read_sketch
from iconstudio.workflows.montage.file import LayerFile, MontageFile, read_montage
from iconstudio.workflows.montage.strokes import visible
from tests.shapes import pictogram

SQUARE = [[0, 0], [100, 0], [100, 80], [0, 80]]
LINE = [[10, 10], [200, 90]]


def hundredths(least, most):
    return st.integers(100 * least, 100 * most).map(lambda n: n / 100)


def triangle(x, y, size):
    corners = (x, y), (x + size, y), (x + size / 2, y + size)
    return Polygon.of([(round(px, 2), round(py, 2)) for px, py in corners])


polygons = st.builds(triangle, hundredths(-200, 400), hundredths(-200, 400), st.floats(5, 200))
axes = st.none() | st.sampled_from(Axis)
words = st.text(st.characters(exclude_categories=["Cs", "Cc"]), max_size=9)
names = st.text("abz09-", min_size=1, max_size=9).map(lambda name: f"game-icons:{name}")
icons = st.text("abz09-", min_size=1, max_size=9).map(lambda name: pictogram(name, ""))
inside = st.tuples(hundredths(0, 256), hundredths(0, 256))
strokes = st.builds(
    Stroke, st.floats(0.01, 300), st.lists(inside, min_size=2, unique=True).map(tuple)
)
placements = st.builds(
    Placement, st.floats(0.02, 20), st.booleans(), st.integers(-500, 500), st.integers(-500, 500)
)


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    return tmp_path_factory.mktemp("inputs") / "input.json"


def named(icon):
    return Reference(icon.id)


def found(reference):
    return pictogram(reference.partition(":")[2], "")


def saved(path, data):
    path.write_text(data if isinstance(data, str) else json.dumps(data), "utf-8")
    return path


pins = st.builds(Layer, icons, placements, st.tuples(strokes))


@given(st.builds(Sketch, polygons, words, st.frozensets(names), axes, st.lists(pins, max_size=2)))
def test_sketches_come_back(path, sketch):
    seen = [any(map(visible, pin.strokes)) for pin in sketch.pins]
    sketch = dataclasses.replace(sketch, pins=tuple(itertools.compress(sketch.pins, seen)))
    write(path, SketchFile.of(sketch, named))
    again = read_sketch(path).resolved(found)
    assert dataclasses.replace(again, pins=()) == dataclasses.replace(sketch, pins=())
    assert [(pin.icon, pin.placement) for pin in again.pins] == [
        (pin.icon, pin.placement) for pin in sketch.pins
    ]
    for pin, other in zip(again.pins, sketch.pins, strict=True):
        assert pin.strokes[0].width == pytest.approx(other.strokes[0].width)
        assert pin.strokes[0].points == other.strokes[0].points


def test_a_pin_without_strokes_is_refused(path):
    pin = {"icon": "mdi:cat", "scale": 1.1}
    with pytest.raises(IconstudioError, match="pin of “mdi:cat” has no strokes"):
        read_sketch(saved(path, {"polygon": SQUARE, "pins": [pin]}))


areas = st.lists(polygons, max_size=2).map(tuple)


@given(st.builds(Edit, icons, words, areas, areas, axes, st.frozensets(names)), words)
def test_edits_come_back(path, edit, title):
    write(path, replace(EditFile.of(edit, named), title=title))
    assert read_edit(path).resolved(found) == edit
    assert read_edit(path).title == title


mixes = st.builds(
    Mix,
    icons=st.lists(icons, min_size=2, max_size=12, unique=True).map(tuple),
    draws=st.integers(1, 1000),
    seed=st.integers(0, 2**63 - 1),
    symmetry=axes,
    pins=st.lists(st.lists(inside, max_size=2).map(tuple), max_size=2).map(tuple),
)


@given(mixes, words)
def test_mixes_come_back(path, mix, title):
    write(path, replace(HybridsFile.of(mix, named), title=title))
    assert read_hybrids(path).resolved(found) == mix
    assert read_hybrids(path).title == title


@given(
    st.builds(
        HybridsFile,
        keyword=words.filter(str.strip),
        count=st.none() | st.integers(2, 12),
        draws=st.integers(1, 1000),
        symmetry=axes,
    )
)
def test_icons_to_be_picked_come_back(path, hybrids):
    write(path, hybrids)
    assert read_hybrids(path) == hybrids


layers_of_icons = st.builds(Layer, icons, placements, st.lists(strokes, max_size=3).map(tuple))


@settings(max_examples=40)
@given(st.builds(Montage, st.lists(layers_of_icons, max_size=5).map(tuple)), words)
def test_montages_come_back(path, montage, title):
    write(path, replace(MontageFile.of(montage, named), title=title))
    assert read_montage(path).resolved(found) == montage
    assert read_montage(path).title == title


def test_a_dot_is_written_as_a_short_stroke_at_its_place(path):
    dot = Stroke(12, ((30.0, 40.0),))
    montage = Montage((Layer(found("test:dog"), Placement(), (dot,)),))
    write(path, MontageFile.of(montage, named))
    ((stroke,),) = (layer.strokes for layer in read_montage(path).layers)
    assert stroke.width == 12
    assert all(math.dist(point, (30, 40)) < 0.2 for point in stroke.points)


@pytest.mark.parametrize("points", [[[30, 40]], [[30, 40]] * 600])
def test_a_stroke_of_one_point_is_a_dot(path, points):
    data = {"layers": [{"icon": "mdi:dog", "strokes": [{"width": 12, "points": points}]}]}
    (layer,) = read_montage(saved(path, data)).resolved(found).layers
    assert layer.strokes == (Stroke(12, ((30.0, 40.0),)),)


def test_icons_beside_the_canvas_are_told(path):
    places = [{}, {"dx": 5000}, {"dy": -300}, {"dy": -300, "scale": 2}, {"dx": 255}]
    layers = [{"icon": f"mdi:{name}"} | place for name, place in zip("abcde", places, strict=True)]
    remarks = read_montage(saved(path, {"layers": layers})).remarks
    starts = [one.partition(" lies outside the canvas")[0] for one in remarks]
    assert starts == ["Layer 2, “mdi:b”,", "Layer 3, “mdi:c”,"]


def test_layers_that_nothing_is_kept_of_are_told(path):
    drawn = {"icon": "mdi:a", "strokes": [{"width": 12, "points": [[30, 40], [50, 60]]}]}
    (told,) = read_montage(saved(path, {"layers": [drawn, {"icon": "mdi:b"}]})).remarks
    assert told.startswith("Layer 2, “mdi:b”, has no strokes")
    beside = {"icon": "mdi:b", "dx": 5000}
    (told,) = read_montage(saved(path, {"layers": [drawn, beside]})).remarks
    assert "lies outside the canvas" in told
    assert read_montage(saved(path, {"layers": [drawn]})).remarks == ()


def test_what_may_be_left_out(path):
    edit = read_edit(saved(path, {"icon": "mdi:dog", "add": [SQUARE]}))
    assert edit == EditFile(icon="mdi:dog", add=(tuple(map(tuple, SQUARE)),))
    assert read_hybrids(saved(path, {"keyword": "lamp", "symmetry": "none"})).symmetry is None
    hybrids = read_hybrids(saved(path, {"keyword": "lamp", "symmetry": None}))
    assert hybrids == HybridsFile(keyword="lamp", draws=40, seed=0)
    montage = read_montage(saved(path, {"layers": [{"icon": "mdi:dog"}]}))
    assert montage == MontageFile(layers=(LayerFile("mdi:dog", 1.0, False, 0, 0),))


def test_notes_of_the_users_own_are_no_mistakes(path):
    notes = {"comment": "Mine.", "credit": "Me", "$schema": "a", "_by": ["me"]}
    assert read_sketch(saved(path, {"polygon": SQUARE} | notes)).sketch.polygon


def test_shifts_are_rounded_to_whole_pixels(path):
    layer = {"icon": "mdi:dog", "dx": 3.6, "dy": -0.4, "scale": 2, "flip": True}
    (read,) = read_montage(saved(path, {"layers": [layer]})).resolved(found).layers
    assert read.placement == Placement(2.0, True, 4, 0)
    assert isinstance(read.placement.dx, int)


def test_files_are_found_from_the_folder_of_the_input(tmp_path):
    path = saved(tmp_path / "edit.json", {"icon": "icons/mine.svg", "add": [SQUARE]})
    read = read_edit(path)
    assert read.icon == str(tmp_path.resolve() / "icons" / "mine.svg")
    write(path, read)
    assert json.loads(path.read_text("utf-8"))["icon"] == "icons/mine.svg"
    elsewhere = replace(read, icon=Reference(Path(tmp_path.anchor) / "other" / "mine.svg"))
    write(path, elsewhere)
    assert read_edit(path) == elsewhere


@pytest.mark.parametrize("name", ["mine.svg", "a:b.svg", "./a:b", "mine", "a:b:c", "a/b:c"])
def test_what_is_no_name_of_a_collection_is_a_file(tmp_path, name):
    path = saved(tmp_path / "edit.json", {"icon": name, "add": [SQUARE]})
    assert read_edit(path).icon == str((tmp_path / name).resolve())


def test_references_are_resolved_into_pictograms(path):
    known = {f"test:{name}": pictogram(name, "") for name in ("dog", "cat")}
    area = tuple(map(tuple, SQUARE))
    edit = EditFile(icon="test:dog", keyword="dog", remove=(area,), exclude=frozenset({"a:b"}))
    edit = replace(edit, include=frozenset({"c:d"}))
    assert edit.resolved(known.__getitem__) == Edit(
        known["test:dog"], "dog", (Polygon(area),), (), None, frozenset({"a:b"}), frozenset({"c:d"})
    )
    mix = HybridsFile(icons=("test:cat", "test:dog"), draws=3, seed=9).resolved(known.__getitem__)
    assert (mix.icons, mix.draws, mix.seed) == ((known["test:cat"], known["test:dog"]), 3, 9)
    file = MontageFile(layers=(LayerFile("test:cat", 0.5),))
    assert file.resolved(known.__getitem__) == Montage((Layer(known["test:cat"], Placement(0.5)),))


def edit(**fields):
    return {"icon": "mdi:dog", "keyword": "dog", "add": [SQUARE]} | fields


def layers(**fields):
    return {"layers": [{"icon": "mdi:dog", "strokes": [{"width": 9, "points": LINE}]} | fields]}


def stroke(**fields):
    return layers(strokes=[{"width": 9, "points": LINE} | fields])


MISTAKES = [
    (read_edit, "", "not valid JSON"),
    (read_edit, "[1, 2", "not valid JSON"),
    (read_edit, "[" * 5000, "not valid JSON"),
    (read_edit, "[]", "An object"),
    (read_edit, edit(icon=None), '"icon" is missing'),
    (read_edit, edit(icon=7), '"icon" must be a text'),
    (read_edit, edit(icon=" "), '"icon" is empty'),
    (read_edit, edit(icon="a\0b.svg"), "characters that are none"),
    (read_edit, edit(keyword=["dog"]), '"keyword" must be a text'),
    (read_edit, edit(keyword="\ud800"), "characters that are none"),
    (read_edit, edit(exclude="mdi:dog"), '"exclude" must be a list'),
    (read_edit, edit(exclude=[1]), '"exclude" must be a list of texts'),
    (read_edit, edit(exclude=["", "a\0b"]), '"exclude" holds characters that are none'),
    (read_edit, edit(symmetry="sideways"), "one of horizontal, vertical, diagonal, antidiagonal"),
    (read_edit, edit(symmetry=["horizontal"]), "null or one of"),
    (read_edit, edit(symmetry=" Vertical "), 'antidiagonal. Write "vertical" if you mean that.'),
    (read_sketch, {"polygon": SQUARE, "symmetry": "anti-diagonal"}, 'Write "antidiagonal" if'),
    (read_edit, edit(add=SQUARE), "Point 1 of polygon 1"),
    (read_edit, edit(add={"a": 1}), '"add" must be a list of polygons'),
    (read_edit, edit(add=[7]), 'polygon 1 of "add" must be a list'),
    (read_edit, edit(add=[SQUARE, []]), 'Polygon 2 of "add" is no good'),
    (read_edit, edit(remove=[SQUARE[:2]]), "at least 3"),
    (read_edit, edit(remove=[[[0, 0], [1, 1], [2, 2]]]), "no area"),
    (read_edit, edit(remove=[[[0, 0], [1, True], [2, 2]]]), "not a pair of numbers"),
    (read_edit, edit(remove=[[[0, 0], "12", [2, 2]]]), "not a pair of numbers"),
    (read_edit, edit(remove=[[[0, 0], [1, 2, 3], [2, 2]]]), "not a pair of numbers"),
    (read_edit, edit(remove=[[[0, 0], [1, math.nan], [2, 2]]]), "not a number, or too large"),
    (read_edit, edit(remove=[[[0, 0], [1, math.inf], [2, 2]]]), "not a number, or too large"),
    (read_edit, edit(remove=[[[0, 0], [1, 10**400], [2, 2]]]), "not a number, or too large"),
    (read_edit, edit(remove=[[[0, 0], [1, 1e300], [2, 2]]]), "out of all scale"),
    (read_hybrids, {}, "either"),
    (read_hybrids, {"keyword": "  "}, "either"),
    (read_hybrids, {"keyword": "dog", "icons": ["a:b", "a:c"]}, "not both"),
    (read_hybrids, {"icons": ["a:b", "a:c"], "count": 2}, '"count" goes with "keyword"'),
    (read_hybrids, {"icons": "a:b"}, '"icons" must be a list'),
    (read_hybrids, {"icons": ["a:b", 3]}, '"icons" must be a list of texts'),
    (read_hybrids, {"icons": ["a:b", ""]}, '"icons" is empty'),
    (read_hybrids, {"keyword": "dog", "count": 1}, "from 2 to 12"),
    (read_hybrids, {"keyword": "dog", "count": 13}, "from 2 to 12"),
    (read_hybrids, {"keyword": "dog", "count": 2.5}, "whole number"),
    (read_hybrids, {"keyword": "dog", "draws": 0}, "from 1 to 1000"),
    (read_hybrids, {"keyword": "dog", "draws": -4}, "from 1 to 1000"),
    (read_hybrids, {"keyword": "dog", "draws": 10**9}, "from 1 to 1000"),
    (read_hybrids, {"keyword": "dog", "draws": True}, "whole number"),
    (read_hybrids, {"keyword": "dog", "draws": "9"}, "whole number"),
    (read_hybrids, {"keyword": "dog", "draws": math.nan}, "whole number"),
    (read_hybrids, {"keyword": "dog", "seed": -1}, '"seed" must be a whole number'),
    (read_hybrids, {"keyword": "dog", "seed": 10**30}, '"seed" must be a whole number'),
    (read_hybrids, {"keyword": "dog", "symmetry": 3}, "null or one of"),
    (read_montage, {"layers": {}}, '"layers" must be a list'),
    (read_montage, {"layers": [7]}, "layer 1: An object"),
    (read_montage, layers(icon=None), 'layer 1: "icon" is missing'),
    (read_montage, layers(scale=0), '"scale" must be a number from 0.02 to 20'),
    (read_montage, layers(scale=-1), '"scale" must be a number'),
    (read_montage, layers(scale=21), '"scale" must be a number'),
    (read_montage, layers(scale="1"), '"scale" must be a number'),
    (read_montage, layers(scale=math.nan), '"scale" must be a number'),
    (read_montage, layers(flip=1), '"flip" must be true or false'),
    (read_montage, layers(dx=1e9), '"dx" must be a number'),
    (read_montage, layers(dy=math.inf), '"dy" must be a number'),
    (read_montage, layers(strokes=3), '"strokes" must be a list of strokes'),
    (read_montage, layers(strokes=[[1, 2]]), "layer 1, stroke 1: An object"),
    (read_montage, stroke(width=None), '"width" is missing: a number above 0 and up to 512'),
    (read_montage, stroke(width=0), '"width" must be a number above 0'),
    (read_montage, stroke(width=1e6), '"width" must be a number above 0 and up to'),
    (read_montage, stroke(points=None), '"points" is missing: a list of [x, y] points'),
    (read_montage, stroke(points={}), '"points" must be a list of [x, y] points'),
    (read_montage, stroke(points=[]), "no point"),
    (read_montage, stroke(points=[[9, 9], [9, None]]), "not a pair"),
    (read_montage, stroke(points=[[9, 9], [9, 1e8]]), "out of all scale"),
    (read_montage, stroke(points=[[-50, 9], [-20, 200]]), "outside the canvas"),
    (read_montage, stroke(points=[[9, 270], [90, 300]]), "outside the canvas"),
    (read_sketch, {"points": SQUARE}, '"points" is not known here. Write "polygon" if you mean'),
    (read_sketch, {"polygn": SQUARE}, '"polygn" is not known here. Write "polygon" if you mean'),
    (read_sketch, {"polygon": SQUARE, "Keyword": "dog"}, 'Write "keyword" if you mean that.'),
    (read_sketch, {"polygon": SQUARE, "mirror": True}, '"symmetry"'),
    (read_edit, edit(removed=[SQUARE]), 'Write "remove" if you mean that.'),
    (read_hybrids, {"keyword": "dog", "draw": 9}, 'Write "draws" if you mean that.'),
    (read_montage, layers(stroke=[]), 'layer 1: "stroke" is not known here. Write "strokes" if'),
    (read_montage, layers(at=9), '"at" is not known here. There are "icon"'),
    (read_montage, stroke(point=LINE), 'stroke 1: "point" is not known here.'),
    (read_sketch, {"polygon": SQUARE, "a.b": 1}, '"a.b" is not known here.'),
    (read_sketch, {"polygon": SQUARE, " - at `$.title": 1}, '" - at `$.title" is not known here.'),
    (read_sketch, {"polygon": SQUARE, "symmetry": " - at `$.polygon[0]`"}, "null or one of"),
    (read_sketch, {"polygon": [], "titel": 1, "keyword": 7}, 'Write "title" if you mean that.'),
    (read_montage, layers(strokes=[{"points": [[9, 9], 7]}]), '"width" is missing: a number above'),
]  # fmt: skip


@pytest.mark.parametrize(("read", "data", "words"), MISTAKES)
def test_mistakes_are_told_with_their_place(path, read, data, words):
    with pytest.raises(IconstudioError) as told:
        read(saved(path, data))
    assert words in str(told.value)
    assert path.name in str(told.value)


@pytest.mark.parametrize("read", [read_sketch, read_edit, read_hybrids, read_montage])
def test_files_that_cannot_be_read(tmp_path, read):
    with pytest.raises(IconstudioError, match="cannot be read"):
        read(tmp_path / "none.json")
    with pytest.raises(IconstudioError, match="cannot be read"):
        read(tmp_path)
    (tmp_path / "binary.json").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(IconstudioError, match="not valid JSON"):
        read(tmp_path / "binary.json")


def test_files_that_cannot_be_written(tmp_path):
    with pytest.raises(IconstudioError, match="cannot be written"):
        write(tmp_path / "no" / "edit.json", EditFile(icon="mdi:dog"))


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "it is empty."),
        (" \n", "it is empty."),
        ('{"keyword": "dog",\n', "it ends too early."),
        ("keyword: dog", "it cannot be understood from line 1, character 1 on."),
        ('{\n "keyword": dog}', "it cannot be understood from line 2, character 13 on."),
        ("{} {}", "it cannot be understood from line 1, character 4 on."),
    ],
)
def test_what_is_no_json_is_told_in_plain_words(tmp_path, text, reason):
    path = tmp_path / "work.json"
    path.write_text(text)
    with pytest.raises(IconstudioError) as told:
        load(path)
    assert str(told.value) == (
        f"“work.json” is not valid JSON: {reason} Save it again, or mend it in an editor."
    )
