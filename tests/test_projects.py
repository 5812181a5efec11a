"""Project files and journals, without a window: what is written is read, and nothing else is."""

import io
import json
import os
import struct
import subprocess
import sys
import time
import zipfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.files import read_bytes
from iconstudio.model import (
    CANVAS,
    Axis,
    ColouredLayer,
    Composite,
    Contour,
    Credit,
    Drawing,
    Exemplar,
    Fill,
    Frame,
    Icon,
    IconstudioError,
    Patterned,
    Pictogram,
    Placement,
    Remix,
    Score,
    Source,
)
from iconstudio.model import Path as Outline
from iconstudio.output.svg import svg_document
from iconstudio.project import archive
from iconstudio.project.archive import Index, Project
from iconstudio.project.journal import Journal, left_behind
from iconstudio.project.parts import Parts, StoredParts
from iconstudio.svg.reading import own_svg
from tests.shapes import outline

DRAWING = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="M1 1H8V5Z"/></svg>'
CAT = Pictogram("mdi:cat", DRAWING, Credit("cat", "Ada", "MIT", "https://e.org/l", "https://e.org"))

texts = st.text(st.characters(codec="utf-8", exclude_characters="\0"), max_size=30)
credits = st.builds(Credit, texts, texts, texts, texts, texts)
identifiers = st.one_of(
    st.sampled_from(["own:cat", "own:cat.svg", "made:a", "own:a/b", "own: c", "own:", "own:x:y"]),
    texts.map(lambda text: f"own:{text}"),
)
pictograms = st.builds(Pictogram, identifiers, st.just(DRAWING), credits)


class Library:
    """A session with one icon, for files that were written by others."""

    def __init__(self):
        self.gated = 0

    def icon(self, reference):
        if reference == CAT.id:
            return CAT
        raise IconstudioError(f"The collection has no icon {reference}.")

    def icon_from(self, data, name):
        self.gated += 1
        return own_svg(data, name)

    def exemplar(self, pictogram):
        ink = np.zeros((CANVAS, CANVAS), np.uint8)
        return Exemplar(pictogram, Frame(0, 0, 9), ink)


def stored(icons, contents, session=None):
    return StoredParts(icons, contents, session or Library())


def again(parts, session=None):
    """What was written, packed and unpacked."""
    data = archive.packed(Project(Index(icons=parts.icons), parts.contents))
    project = archive.unpacked(data)
    return StoredParts(project.index.icons, project.parts, session or Library())


class Gateless(Library):
    """For what is about names alone: to read a drawing takes a while."""

    def icon_from(self, data, name):
        return Pictogram(name, data.decode(), CAT.credit)


@settings(max_examples=50)
@given(st.lists(pictograms, max_size=4))
def test_icons_are_read_back_whatever_they_are_called(icons):
    parts = Parts()
    references = [parts.icon(one) for one in icons]
    there = again(parts, Gateless())
    found = [there.icon(one) for one in references]
    assert [(one.id, one.credit) for one in found] == [(one.id, one.credit) for one in icons]


def test_origins_and_remarks_of_icons_are_kept():
    made = Pictogram("made:a-1", DRAWING, CAT.credit, (CAT,), ("A bitmap was left out.",))
    parts = Parts()
    (found,) = [again(parts_of(parts, made)).icon("made:a-1")]
    assert [(one.id, one.credit) for one in found.made_of] == [(CAT.id, CAT.credit)]
    assert found.remarks == made.remarks


def parts_of(parts, *icons):
    for one in icons:
        parts.icon(one)
    return parts


def test_a_drawing_is_read_back_as_it_was():
    svg = svg_document(Icon(SQUARE, "a", (CAT,)))
    made = Pictogram("made:a-1", svg, CAT.credit, (CAT,))
    assert again(parts_of(Parts(), made)).icon("made:a-1").svg == svg
    coloured = svg.replace("<path", "<image href='http://example.org/x.png'/><path")
    safe = again(parts_of(Parts(), Pictogram("made:a-1", coloured, CAT.credit))).icon("made:a-1")
    assert "example.org" not in safe.svg and "<path" in safe.svg


def test_an_icon_that_the_collection_has_lost_is_there_all_the_same():
    lost = Pictogram("mdi:lost", DRAWING, CAT.credit)
    session = Library()
    there = again(parts_of(Parts(), CAT, lost), session)
    assert there.icon("mdi:cat") is CAT
    assert session.gated == 0
    assert there.icon("mdi:lost").credit == lost.credit
    assert there.icon("mdi:lost").id == "mdi:lost"


@pytest.mark.parametrize(
    "reference", ["/etc/passwd", "../secret.svg", "own:unknown", "made:x-1", "mdi:nothing", "x"]
)
def test_nothing_outside_of_the_file_is_opened(reference, monkeypatch):
    monkeypatch.setattr(Library, "icon_from", lambda *_: pytest.fail("it was opened"))
    there = stored({}, {})
    with pytest.raises(IconstudioError):
        there.icon(reference)


def test_a_stored_drawing_goes_through_the_gate():
    evil = b'<!DOCTYPE svg [<!ENTITY a SYSTEM "file:///etc/passwd">]><svg>&a;</svg>'
    there = stored({"own:a": {"part": "icons/a.svg"}}, {"icons/a.svg": evil})
    with pytest.raises(IconstudioError, match="cannot be used"):
        there.icon("own:a")
    with pytest.raises(IconstudioError, match="missing"):
        stored({"own:a": {"part": "icons/b.svg"}}, {}).icon("own:a")


# -- results --------------------------------------------------------------------------------------

coordinates = st.floats(-300, 300)
points = st.tuples(coordinates, coordinates)
segments = st.one_of(st.tuples(points), st.tuples(points, points, points))
contours = st.builds(Contour, points, st.lists(segments, min_size=2, max_size=5).map(tuple))
SQUARE = outline([(20, 20), (200, 20), (200.5, 200.125), (20, 200)])


def result(parts, name):
    """Return the result of that name; complaints are raised."""
    steps = parts.results((name,))
    while True:
        try:
            next(steps)
        except StopIteration as end:
            if parts.complaints:
                raise IconstudioError(parts.complaints[0]) from None
            return end.value[0]


@settings(max_examples=8)
@given(st.lists(contours, max_size=3), texts)
def test_the_outline_of_a_result_is_exact(some, title):
    path = Outline((*SQUARE.contours, *some))
    parts = Parts()
    name = parts.result(Icon(path, title, (CAT,)))
    found = result(again(parts), name)
    assert (found.path, found.title) == (path, title)
    assert [one.credit for one in found.credits] == [CAT.credit]


def remix(seeds=()):
    ink = np.zeros((CANVAS, CANVAS), np.uint8)
    sources = tuple(
        Source(Exemplar(one, Frame(0, 0, 9), ink), Placement(1.1, True, number, -3), 0.5, number)
        for number, one in enumerate([CAT, Pictogram("own:b", DRAWING, CAT.credit), CAT])
    )
    labels = np.zeros((CANVAS, CANVAS), np.uint8)
    labels[100:] = 2
    composite = Composite(
        "dark", 0.3, sources, labels, 3.5, 2.0, 5.0, (0.25, 0.0, 0.75), 0.8, Axis.DIAGONAL
    )
    drawing = Drawing(SQUARE, np.zeros((512, 512), np.uint8), labels[:250, :250].copy())
    icon = Remix.of(composite, drawing, Score(0.1, 0.2, 0.3, 0.4, 0.5), "dog")
    return Remix(**{**vars(icon), "seeds": seeds, "draw": 7, "unchanged": 0.9})


def test_how_a_result_was_made_is_kept():
    for seeds in ((), (((1.0, 2.0),), (), ((3.0, 4.0), (5.0, 6.0)))):
        icon, parts = remix(seeds), Parts()
        name = parts.result(icon)
        assert parts.result(icon) == name
        found = result(again(parts), name)
        assert isinstance(found, Remix)
        one, copy = icon.composite, found.composite
        for attribute in (
            "style",
            "lambda_s",
            "energy",
            "data_cost",
            "smoothness_cost",
            "iou",
            "symmetry",
        ):
            assert getattr(copy, attribute) == getattr(one, attribute)
        assert (found.seeds, found.draw, found.unchanged) == (seeds, 7, 0.9)
        assert found.score == icon.score
        assert len(found.drawing.coverage) == 512
        assert found.drawing.coverage.max() == 255
        owned = [[c.sources[k].placement for k in np.unique(c.labels)] for c in (one, copy)]
        assert owned[0] == owned[1]
        assert len(copy.sources) == (3 if seeds else 2)
        assert np.array_equal(copy.labels == copy.labels[0, 0], one.labels == one.labels[0, 0])
        assert copy.contributors == one.contributors


@pytest.mark.parametrize(
    "mend",
    [
        lambda entry: entry.update(outline=[{"segments": []}]),
        lambda entry: entry.update(outline=[{"segments": [[[0, 0]], [[1, 1], [2, 2]]]}]),
        lambda entry: entry.update(outline="M0 0"),
        lambda entry: entry.update(svg="results/none.svg"),
        lambda entry: entry["remix"].update(side=1 << 20),
        lambda entry: entry["remix"].update(side=300),
        lambda entry: entry["remix"].update(sources=[]),
        lambda entry: entry["remix"].update(labels=entry["svg"]),
        lambda entry: entry["remix"].update(owners="../labels"),
        lambda entry: entry["remix"].update(lambda_s=-1),
    ],
)
def test_a_result_that_was_tampered_with_is_told(mend):
    parts = Parts()
    name = parts.result(remix())
    entry = json.loads(parts.contents[name])
    mend(entry)
    parts.contents[name] = json.dumps(entry).encode()
    with pytest.raises(IconstudioError):
        result(again(parts), name)


def pattern(*colours, ground=""):
    """A pattern of squares in colours, which reach out of it."""
    fills = tuple(
        Fill(outline([(x, -5), (x + 30.125, -5), (x + 30, 60), (x, 60)]), colour)
        for x, colour in enumerate(colours)
    )
    layers = ColouredLayer("layer-1", fills[:1]), ColouredLayer("layer-2", fills[1:])
    return Patterned(
        SQUARE, "cats", (CAT,),
        layers=layers, ground=ground, width=300, height=50, tile=True, torn=0.125,
    )  # fmt: skip


@pytest.mark.thorough(but=1)
@pytest.mark.parametrize("ground", ["", "#fdfdf8", "#101010"])
def test_a_pattern_is_kept_whole(ground):
    for colours in (["#f0f0f0", "#FF8000"], ["", "#e4572e", "#e4572e"]):
        icon, parts = pattern(*colours, ground=ground), Parts()
        name = parts.result(icon)
        found = result(again(parts), name)
        assert found.looks_like(icon)
        for one in ("layers", "ground", "size", "tile", "torn", "path", "title"):
            assert getattr(found, one) == getattr(icon, one), one
        assert [one.credit for one in found.credits] == [CAT.credit]


@pytest.mark.parametrize(
    "mend",
    [
        lambda entry: entry.update(width=0),
        lambda entry: entry.update(height=1e9),
        lambda entry: entry.update(ground="red"),
        lambda entry: entry["layers"][0]["fills"][0].update(colour='#ff0000"/><script'),
        lambda entry: entry["layers"][0]["fills"][0].update(outline=[{"segments": []}]),
        lambda entry: entry.update(torn=2),
    ],
)
def test_a_pattern_that_was_tampered_with_is_told(mend):
    parts = Parts()
    name = parts.result(pattern("#ff0000", "#00ff00"))
    entry = json.loads(parts.contents[name])
    mend(entry["pattern"])
    parts.contents[name] = json.dumps(entry).encode()
    with pytest.raises(IconstudioError):
        result(again(parts), name)


# -- files ----------------------------------------------------------------------------------------


def zipped(**members):
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archived:
        for name, data in members.items():
            archived.writestr(name.replace("__", "/").replace("_json", ".json"), data)
    return file.getvalue()


WHOLE = zipped(project_json=b'{"version": 1, "pages": {}}', icons__a=b"a" * 1000)


def test_what_was_saved_is_read_back(tmp_path):
    path = tmp_path / "dog.iconstudio"
    project = Project(Index(pages={"model": {"keyword": "Hündchen"}}), {"icons/a-1.svg": b"<svg/>"})
    archive.save(path, project)
    found = archive.read(path)
    assert found.index.pages == {"model": {"keyword": "Hündchen"}}
    assert dict(found.parts) == dict(project.parts) and not found.unknown
    archive.save(tmp_path / "again.iconstudio", project)
    assert path.read_bytes() == (tmp_path / "again.iconstudio").read_bytes()


def test_what_has_no_place_in_a_project_is_not_looked_at():
    data = zipped(**{"project_json": b'{"version": 1}', "../evil": b"x", "icons/../../x": b"y"})
    parts = archive.unpacked(data).parts
    assert not parts


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (b"", "no Iconstudio project"),
        (b"{}", "no Iconstudio project"),
        (zipped(mimetype=b"x"), "no Iconstudio project"),
        (zipped(project_json=b"{}"), "no Iconstudio project"),
        (zipped(project_json=b"{"), "damaged"),
        (zipped(project_json=b"[" * 100_000), "damaged"),
        (zipped(project_json=b"\xff\xff"), "damaged"),
        (zipped(project_json=b'{"version": 2}'), "later version"),
        (zipped(project_json=b'{"version": "1"}'), "whole number"),
        (WHOLE[:-10], "its end is missing"),
        (WHOLE[:200], "its end is missing"),
    ],
)
def test_what_is_no_project_is_told_in_a_sentence(tmp_path, data, said):
    path = tmp_path / "dog.iconstudio"
    path.write_bytes(data)
    with pytest.raises(IconstudioError, match=said) as told:
        archive.read(path)
    assert "“dog.iconstudio” cannot be opened." in str(told.value)


@settings(max_examples=150)
@given(st.data())
def test_damage_ends_in_a_sentence_or_does_no_harm(data):
    broken = bytearray(WHOLE)
    for _ in range(data.draw(st.integers(1, 4))):
        broken[data.draw(st.integers(0, len(broken) - 1))] = data.draw(st.integers(0, 255))
    cut = data.draw(st.sampled_from([len(broken), len(broken) - 1, 90]))
    try:
        archive.unpacked(bytes(broken[:cut]))
    except IconstudioError as error:
        assert str(error).endswith(".")


def test_bombs_are_bounded(monkeypatch):
    monkeypatch.setattr(archive, "MOST_BYTES", 1_000_000)
    zeros = bytes(900_000)
    assert len(archive.unpacked(zipped(project_json=b'{"version": 1}', icons__a=zeros)).parts)
    bomb = zipped(project_json=b'{"version": 1}', icons__a=zeros, icons__b=zeros)
    assert len(bomb) < 10_000
    with pytest.raises(IconstudioError, match=r"more than .* bytes"):
        archive.unpacked(bomb)
    # One that lies about its lengths is read no further, either.
    at = bomb.index(struct.pack("<L", 900_000))
    lying = bytearray(bomb)
    lying[at : at + 4] = struct.pack("<L", 5)
    with pytest.raises(IconstudioError):
        archive.unpacked(bytes(lying))
    many = zipped(**{f"icons__{number}": b"" for number in range(archive.MOST_PARTS + 1)})
    with pytest.raises(IconstudioError, match="more than 10,000 parts"):
        archive.unpacked(many)
    monkeypatch.setattr(archive, "_MOST_DIRECTORY", 1000)
    with pytest.raises(IconstudioError, match="more than 10,000 parts"):
        archive.unpacked(many)


def test_a_file_that_cannot_be_written_is_as_it_was(tmp_path):
    path = tmp_path / "dog.iconstudio"
    path.mkdir()
    with pytest.raises(IconstudioError, match="cannot be written"):
        archive.save(path, Project(Index(), {}))
    assert path.is_dir()
    assert not list(tmp_path.glob(".*"))


# -- the journal ----------------------------------------------------------------------------------

KILLED = """
import sys
from pathlib import Path
from iconstudio.project.archive import Index, Project
from iconstudio.project.journal import Journal
journal = Journal(Path(sys.argv[1]))
journal.write(Project(Index(current="1"), {"icons/a-1.svg": b"a"}))
journal.write(Project(Index(current="2"), {"icons/b-2.svg": b"b"}))
print("written", flush=True)
sys.stdin.read()
"""


@pytest.fixture
def writer(tmp_path):
    process = subprocess.Popen(
        [sys.executable, "-c", KILLED, str(tmp_path)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        cwd=Path(__file__).parents[1],
    )
    process.stdout.readline()
    yield process
    process.kill()
    process.communicate()


def test_the_work_of_a_window_that_was_killed_is_offered_once(tmp_path, writer):
    assert list(left_behind(tmp_path)) == []
    writer.kill()
    writer.wait()
    (left,) = left_behind(tmp_path)
    project = left.read()
    assert project.index.current == "2"
    assert project.parts == {"icons/b-2.svg": b"b"}
    assert abs(left.when - time.time()) < 60
    assert list(left_behind(tmp_path)) == []  # it is held
    left.release()
    (left,) = left_behind(tmp_path)
    left.discard()
    assert list(left_behind(tmp_path)) == []
    assert not list(tmp_path.iterdir())


_FIRST_EDIT = """
import sys
from pathlib import Path
from iconstudio.project.archive import Index, Project
from iconstudio.project.journal import Journal, left_behind
folder = Path(sys.argv[1])
list(left_behind(folder))  # as when the window has just opened
before = set(sys.modules)
Journal(folder).write(Project(Index(), {}))
print(*set(sys.modules) - before)
"""


def test_the_first_edit_waits_for_nothing_to_be_loaded(tmp_path):
    command = [sys.executable, "-c", _FIRST_EDIT, str(tmp_path)]
    assert subprocess.run(command, check=True, capture_output=True, text=True).stdout.split() == []


def test_a_journal_that_is_cleared_leaves_nothing(tmp_path):
    journal = Journal(tmp_path / "journals")
    assert not (tmp_path / "journals").exists()
    journal.clear()
    for _ in range(2):
        journal.write(Project(Index(), {"photos/a-1.png": b"a"}))
        assert (journal.folder / "photos/a-1.png").read_bytes() == b"a"
        journal.clear()
        assert not journal.folder.exists()


def test_parts_are_written_once(tmp_path):
    journal = Journal(tmp_path)
    for number in range(3):
        journal.write(Project(Index(current=str(number)), {"photos/a-1.png": b"a"}))
        if not number:
            os.utime(journal.folder / "photos/a-1.png", (1, 1))
    assert (journal.folder / "photos/a-1.png").stat().st_mtime == 1
    assert b'"current":"2"' in read_bytes(journal.folder / "project.json", 1000)
    journal.clear()


def test_a_journal_that_cannot_be_written_is_told(tmp_path):
    (tmp_path / "journals").touch()
    with pytest.raises(IconstudioError, match="cannot be kept"):
        Journal(tmp_path / "journals").write(Project(Index(), {}))


def test_a_damaged_journal_is_told_when_it_is_read(tmp_path, writer):
    writer.kill()
    writer.wait()
    next(tmp_path.glob("*/project.json")).write_text("{")
    (left,) = left_behind(tmp_path)
    with pytest.raises(IconstudioError, match="damaged"):
        left.read()
    left.discard()


def test_folders_without_work_go_once_they_are_old(tmp_path):
    for name, when in (("old", 1), ("new", time.time())):
        (tmp_path / name).mkdir()
        os.utime(tmp_path / name, (when, when))
    assert list(left_behind(tmp_path)) == []
    assert [one.name for one in tmp_path.iterdir()] == ["new"]
