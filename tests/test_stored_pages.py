"""The pages of all workflows in project files: as they were first written, and ever since."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from msgspec import structs

from iconstudio.images.reading import Image
from iconstudio.inputs.styles import bundled
from iconstudio.model import (
    Axis,
    Correction,
    Icon,
    IconstudioError,
    Inner,
    Layer,
    Line,
    Motif,
    Patterning,
    Photo,
    Placement,
    Polygon,
    Remix,
    Restyling,
    Separation,
    Sketch,
    Stroke,
)
from iconstudio.project import archive
from iconstudio.project.archive import Index, Project
from iconstudio.project.contents import Contents, Formats, reading
from iconstudio.workflows.areas import Area, Kind
from iconstudio.workflows.hybrids.page import PickRequest
from iconstudio.workflows.line_style.page import RestylePage
from iconstudio.workflows.modelling.page import SketchPage
from iconstudio.workflows.pattern.page import PatternPage
from iconstudio.workflows.registry import registered, workflows
from tests.test_projects import CAT, DRAWING, SQUARE, Library
from tests.toy import MIRROR, Mirroring

FIRST = Path(__file__).parent / "projects" / "first.iconstudio"
POINTS = ((1.5, 2.0), (60.0, 2.0), (60.25, 70.0))


class Studio(Library):
    """A session with one icon, and a photo of 6 x 4 pixels."""

    def image(self, data):
        yield
        return Image(np.full((4, 6, 3), 200, np.uint8), 6, 4)


@pytest.fixture(scope="module")
def formats():
    return Formats({one.name: one for one in workflows()})


def contents(project, formats):
    *_, found = reading(Studio(), project, formats)
    return found


@pytest.fixture(scope="module")
def first(formats):
    """What the first project file of all says."""
    return contents(archive.read(FIRST), formats)


def test_the_share_of_a_project_that_has_been_read_grows_to_all_of_it(formats):
    *steps, _ = reading(Studio(), archive.read(FIRST), formats)
    shares = [one.done for one in steps]
    assert shares == sorted(shares)
    assert shares[0] < 0.5
    assert shares[-1] == 1.0
    assert len(set(shares)) > 2


def test_the_first_project_still_opens(first):
    assert (first.complaints, first.current) == ((), "hybrids")
    sketch, edit, mix, montage = (
        first.pages[name] for name in ("model", "edit", "hybrids", "montage")
    )
    assert (sketch.vertices, sketch.closed, sketch.sketch.keyword) == (POINTS, True, "dog")
    assert sketch.sketch.exclude == {"mdi:dog", "mdi:cow"}
    assert (sketch.sketch.symmetry, sketch.photo.width) == (Axis.HORIZONTAL, 6)
    assert edit.areas == (Area(Kind.REMOVE, POINTS), Area(Kind.ADD, POINTS[:2], closed=False))
    assert (edit.icon.pictogram, edit.keyword, edit.symmetry) == (CAT, "hat", None)
    assert [(one.id, one.pins) for one in mix.ingredients] == [
        ("mdi:cat", ((3.0, 4.5),)),
        ("own:b", ()),
    ]
    assert mix.ask == PickRequest("cat", 2, Axis.VERTICAL, 3)
    assert (mix.seed, mix.draws, mix.symmetry, mix.name) == (7, 12, Axis.DIAGONAL, "cats")
    below, above = montage.layers
    assert (below.number, below.placement, below.strokes) == (0, Placement(), ())
    assert (above.number, above.hidden, montage.chosen) == (2, True, 2)
    assert above.placement == Placement(1.25, True, 3, -4)
    assert above.strokes == (Stroke(9.5, POINTS), Stroke(3.0, POINTS[:1]))
    assert above.icon.pictogram.remarks == ("A bitmap was left out.",)
    square, remix = first.recent
    assert square.title == "square"
    for one in (remix, *mix.favourites):
        assert isinstance(one, Remix)
        assert (one.draw, one.unchanged, one.composite.lambda_s) == (7, 0.9, 0.3)


def test_what_is_written_is_read_back(first, formats):
    again = contents(archive.unpacked(archive.packed(first.project(formats))), formats)
    assert not again.complaints
    assert again.current == first.current
    assert all(one.looks_like(other) for one, other in zip(again.recent, first.recent, strict=True))
    for name, page in first.pages.items():
        other = again.pages[name]
        if name == "model":
            assert other.photo.data == page.photo.data
            page, other = (replace(one, photo=None) for one in (page, other))
        if name == "hybrids":
            assert [one.exemplar.id for one in other.ingredients] == ["mdi:cat", "own:b"]
            assert len(other.favourites) == len(page.favourites) == 1
        stored = formats[name].write(page, Written()), formats[name].write(other, Written())
        assert stored[0] == stored[1]


class Written:
    """Parts that name everything alike."""

    def icon(self, pictogram):
        return pictogram.id

    def result(self, icon):
        return icon.title


def test_the_pins_of_a_sketch_are_read_back_and_one_without_its_icon_is_told(formats):
    strokes = (Stroke(9.5, POINTS), Stroke(3.0, POINTS[:1]))
    pin = Layer(CAT, Placement(1.1, True, 3, -4), strokes)
    page = SketchPage(Sketch(Polygon(POINTS), "cat", pins=(pin,)), closed=True)
    project = Contents("model", {"model": page}).project(formats)
    again = contents(archive.unpacked(archive.packed(project)), formats)
    assert again.pages["model"] == page
    stored = project.index.pages["model"]
    (own,) = stored.pins
    lost = structs.replace(own, icon="mdi:lost")
    project.index.pages["model"] = structs.replace(stored, pins=(lost, own))
    again = contents(archive.unpacked(archive.packed(project)), formats)
    assert again.pages["model"] == page
    (complaint,) = again.complaints
    assert "pinned part" in complaint and "mdi:lost" in complaint


def test_what_is_inside_a_sketch_is_read_back_finished_or_not(formats):
    inner = Inner((Polygon(POINTS),), (POINTS[:2], POINTS))
    draft = Area(Kind.HOLE, POINTS[:2], closed=False)
    page = SketchPage(Sketch(Polygon(POINTS), "cat", inner=inner, detail=0.4), True, draft=draft)
    project = Contents("model", {"model": page}).project(formats)
    again = contents(archive.unpacked(archive.packed(project)), formats)
    assert again.pages["model"] == page


@pytest.mark.parametrize("with_image", [False, True])
def test_a_pattern_is_read_back_with_its_motifs_or_its_image(formats, with_image):
    photo = Photo("", 6, 4, (np.zeros((4, 6), np.uint32),), data=b"\x89PNG", suffix=".png")
    corrections = (Correction(2, Stroke(3.5, POINTS)),)
    motifs = (Motif(CAT, 10.5, 20.0, 64.0, -30.0, True, "#e4572e"), Motif(CAT))
    work = Patterning(
        () if with_image else motifs,
        Separation(photo, 3, corrections) if with_image else None,
        "#102030", 640, 300, False, 7, 0.5, 15.0, 2.0, CAT,
    )  # fmt: skip
    page = PatternPage(work, frozenset() if with_image else frozenset({1}))
    project = Contents("pattern", {"pattern": page}).project(formats)
    again = contents(archive.unpacked(archive.packed(project)), formats)
    assert not again.complaints
    found = again.pages["pattern"]
    if with_image:
        image = found.work.image
        assert (image.photo.data, image.photo.width) == (photo.data, 6)
        assert (image.colours, image.corrections) == (3, corrections)
        found = replace(found, work=replace(found.work, image=work.image))
    assert found == page
    stored = project.index.pages["pattern"]
    project.index.pages["pattern"] = structs.replace(stored, chosen=(1, 99))
    tampered = contents(archive.unpacked(archive.packed(project)), formats)
    assert tampered.pages["pattern"].chosen == page.chosen


def test_lines_are_read_back_as_they_were_whatever_a_file_may_say(formats):
    """A line without a width, a style of a line that is not there, and two of one."""
    style, other = list(bundled())[:2]
    others = ((0, other), (0, style), (99, other))
    work = Restyling(style, CAT, (Line(POINTS[:2]), Line(POINTS, width=9)), others=others)
    project = Contents("restyle", {"restyle": RestylePage(work)}).project(formats)
    again = contents(archive.unpacked(archive.packed(project)), formats)
    assert not again.complaints
    assert again.pages["restyle"].work == work


def test_a_page_of_a_workflow_without_a_format_of_its_own(formats):
    with registered(MIRROR):
        formats = Formats({one.name: one for one in workflows()})
        page = formats["mirror"].read(formats["mirror"].stored(("mdi:cat",)), _Parts())
        with pytest.raises(StopIteration) as end:
            next(page)
        work = end.value.value
        assert work.work == Mirroring((CAT,))
        project = Contents("mirror", {"mirror": work}).project(formats)
        again = contents(archive.unpacked(archive.packed(project)), formats)
        assert again.pages == {"mirror": work}


class _Parts:
    resources = Studio()


@pytest.mark.parametrize(
    ("name", "page", "said"),
    [
        ("model", [], "model: An object"),
        ("model", {}, '"polygon" is missing: a list of'),
        ("model", {"polygon": [[1, 2], [3]]}, 'Point 2 of "polygon" is not a pair'),
        ("edit", {"areas": [{"kind": "x", "points": []}]}, 'area 1: "kind" must be one of remove'),
        ("hybrids", {"icons": [{"icon": 7}]}, 'icon 1: "icon" must be a text'),
        ("hybrids", {"ask": {"count": 0}}, 'ask: "count" must be a whole number from 1 to 12'),
        ("montage", {"layers": [{"icon": "mdi:cat"}]}, 'layer 1: "number" is missing'),
        ("montage", {"layers": [{"icon": "mdi:cat", "number": 1}] * 2}, "the same number"),
        (
            "montage",
            {"layers": [{"icon": "a:b", "number": 1, "strokes": [{"width": 1, "points": []}]}]},
            "layer 1, stroke 1: The stroke has no point",
        ),
    ],
)
def test_a_page_that_is_no_good_is_told_and_the_others_are_there(formats, name, page, said):
    other, good = ("edit", {}) if name == "model" else ("model", {"polygon": []})
    pages = {name: page, other: good | {"keyword": "hat"}}
    data = json.dumps({"version": 1, "pages": pages}).encode()
    found = contents(archive.project_of(data, {}), formats)
    assert set(found.pages) == {other}
    (complaint,) = found.complaints
    assert said in complaint and complaint.endswith(".")


def test_icons_that_are_no_good_take_only_their_page_along(formats):
    pages = {"edit": {"icon": "own:a"}, "model": {"polygon": []}}
    index = Index(pages=pages, icons={"own:a": {"part": 7}})
    found = contents(Project(index, {}), formats)
    assert set(found.pages) == {"model"}
    assert '"part" must be a text' in found.complaints[0]


def test_what_later_versions_add_is_passed_over_and_told(formats):
    layer = {"icon": "own:a", "number": 1, "tilt": 2}
    pages = {"edit": {"new": {"a": [1]}, "newer": 1}, "montage": {"layers": [layer]}}
    icon = {"part": "icons/a.svg", "mood": "merry"}
    index = {"version": 1, "new": 1, "pages": pages, "icons": {"own:a": icon}}
    parts = {"icons/a.svg": DRAWING.encode()}
    found = contents(archive.project_of(json.dumps(index).encode(), parts), formats)
    assert set(found.pages) == {"edit", "montage"}
    beginnings = [one.partition(" passed over, which this version")[0] for one in found.complaints]
    assert beginnings == [
        "In the project, “new” was",
        "On the page of Edit, “new” and “newer” were",
        "On the page of Montage, “tilt” was",
        "Of the icons, “mood” was",
    ]


def test_what_later_versions_add_to_a_result_is_told(formats):
    icon = Icon(SQUARE, "a", ())
    project = Contents(recent=(icon,)).project(formats)
    (name,) = project.index.recent
    data = json.loads(project.parts[name]) | {"mood": "merry"}
    parts = {**project.parts} | {name: json.dumps(data).encode()}
    (told,) = contents(Project(project.index, parts), formats).complaints
    assert told.startswith("Of the results, “mood” was passed over")


def test_the_index_must_be_what_it_says(formats):
    for text in (b'{"version": 1, "pages": []}', b'{"version": 1, "recent": [1]}', b"[]"):
        with pytest.raises(IconstudioError, match=r"project\.json"):
            archive.project_of(text, {})
