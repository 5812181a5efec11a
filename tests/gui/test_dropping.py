"""Everything that can be dropped on, or pasted into, each workspace: it is taken, or told."""

import base64
import json
import threading
from urllib.parse import quote

import numpy as np
import pytest
from fake_session import drawing, exemplar, read_simply
from hands import SQUARE, drop, threads_alive
from PySide6.QtCore import QByteArray, QMimeData, Qt, QUrl
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from iconstudio.gui.exchange.dragging import packed
from iconstudio.gui.exchange.mime import holds_words, items
from iconstudio.gui.pictures.picture import picture_of
from iconstudio.model import Composite, Placement, Polygon, Remix, Score, Sketch, Source
from iconstudio.output.svg import svg_document
from iconstudio.svg.decode import decode
from iconstudio.workflows.events import Progress

pytestmark = pytest.mark.thorough(but=1)

SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="M{0} 0h9v9z"/></svg>'
OTHERS = {"Edit": 1, "Hybrids": 2, "Montage": 3}
MOST = {"Hybrids": 12, "Montage": 30}
LEFT, NONE = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier


@pytest.fixture(params=OTHERS)
def place(window, request):
    """Each workspace that works on icons."""
    window.show_workspace(OTHERS[request.param])
    return window.workspace


@pytest.fixture(params=MOST)
def roomy(window, request):
    """Each workspace that holds several icons."""
    window.show_workspace(OTHERS[request.param])
    return window.workspace


@pytest.fixture
def edit(window):
    window.show_workspace(OTHERS["Edit"])
    return window.workspace


@pytest.fixture
def own(tmp_path):
    """Files of drawings, each of its own."""

    def files(count, first=0):
        paths = [tmp_path / f"icon-{number}.svg" for number in range(first, first + count)]
        for number, path in enumerate(paths, first):
            path.write_text(SVG.format(number))
        return paths

    return files


@pytest.fixture
def photo(tmp_path):
    image = QImage(30, 20, QImage.Format.Format_RGB32)
    image.fill(Qt.GlobalColor.red)
    path = tmp_path / "photo.png"
    assert image.save(str(path))
    return path


def urls(*paths):
    data = QMimeData()
    data.setUrls([one if isinstance(one, QUrl) else QUrl.fromLocalFile(str(one)) for one in paths])
    return data


def words(text):
    data = QMimeData()
    data.setText(text)
    return data


def paste(place, data):
    QApplication.clipboard().setMimeData(data)
    place.actions_by_name["paste"].trigger()


def there(place, qtbot, count):
    """Wait until so many icons are on the page, and all is told."""
    qtbot.waitUntil(lambda: len(place.icons) == count, timeout=20000)
    quiet(place, qtbot)
    return place.icons


def quiet(place, qtbot):
    opener = place.opener
    qtbot.waitUntil(lambda: not (opener.adding or opener.runner.running), timeout=20000)


def told(place):
    notice = place.window().pane.notice
    return notice.label.text() if notice.isVisible() else ""


def status(place):
    return place.window().pane.status.label.text()


# -- markup ----------------------------------------------------------------------------------------


def as_html(svg):
    data = QMimeData()
    data.setHtml(f"<html><body><!--StartFragment--><p>Look: {svg}</p></body></html>")
    data.setText("Look: ")
    return data


def as_svg(svg):
    data = QMimeData()
    data.setData("image/svg+xml", svg.encode())
    return data


def as_svg_and_picture(svg):
    data = as_svg(svg)
    image = QImage(9, 9, QImage.Format.Format_ARGB32)
    image.fill(Qt.GlobalColor.black)
    data.setImageData(image)
    return data


def as_inline_image(svg):
    data = QMimeData()
    coded = base64.b64encode(svg.encode()).decode()
    data.setHtml(f'<img src="data:image/svg+xml;base64,{coded}">')
    return data


WAYS = {
    "text": words,
    "text with white space": lambda svg: words(f"\n\n  \t{svg}  \n"),
    "text in text": lambda svg: words(f"Here it is:\n```svg\n{svg}\n```"),
    "html": as_html,
    "svg": as_svg,
    "svg and picture": as_svg_and_picture,
    "data in text": lambda svg: words("data:image/svg+xml," + quote(svg)),
    "data in html": as_inline_image,
    "data as address": lambda svg: urls(QUrl("data:image/svg+xml," + quote(svg))),
}


def test_markup_is_pasted(place, qtbot):
    for number, (way, data) in enumerate(WAYS.items()):
        paste(place, data(SVG.format(number)))
        (icon,) = there(place, qtbot, 1)
        assert icon.svg == read_simply(SVG.format(number).encode(), "drawing").svg, way
        assert told(place) == "", way
        assert place.document.undo_stack.count() == 1, way
        place.document.undo_stack.undo()
        assert place.icons == (), way


def test_markup_is_dropped(place, qtbot):
    for way in ("text", "html", "svg", "data as address"):
        assert drop(place, WAYS[way](SVG.format(1))) == Qt.DropAction.CopyAction, way
        there(place, qtbot, 1)
        place.document.undo_stack.undo()
        assert place.icons == (), way


def test_markup_with_a_mistake_is_told(place, qtbot):
    paste(place, words("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'><path></svg>"))
    qtbot.waitUntil(lambda: "“drawing” cannot be used" in told(place))
    assert place.icons == ()


def test_keys_paste_a_drawing_though_the_cursor_is_in_a_field(place, qtbot):
    """That is where it is when one begins."""
    field = place.window().focusWidget()
    QApplication.clipboard().setText(SVG.format(1))
    QTest.keyClick(field, Qt.Key.Key_V, Qt.KeyboardModifier.ControlModifier)
    there(place, qtbot, 1)
    assert not getattr(field, "text", str)().strip()


def test_keys_paste_words_into_a_field(place):
    field = place.window().focusWidget()
    for text in ("dog", "mdi:home"):
        QApplication.clipboard().setText(text)
        QTest.keyClick(field, Qt.Key.Key_A, Qt.KeyboardModifier.ControlModifier)
        QTest.keyClick(field, Qt.Key.Key_V, Qt.KeyboardModifier.ControlModifier)
        assert field.text() == text
    html = QMimeData()
    html.setHtml(f"dog {SVG}")
    html.setText("dog")
    assert holds_words(html)
    assert not holds_words(words("/home/me/dog.svg"))
    assert not holds_words(QMimeData())


def test_what_copy_put_there_is_pasted_with_its_credits(place, qtbot):
    sources = (Source(exemplar(0), Placement()),)
    labels = np.zeros((256, 256), np.uint8)
    composite = Composite("light", 0.1, sources, labels, 1.0, 1.0, 0.0, (1.0,), 0.9)
    drawn = drawing(Sketch(Polygon(tuple(SQUARE))), 1, 1)
    icon = Remix.of(composite, drawn, Score(1, 1, 1, 1, 1), "Motor cycle")
    picture = picture_of(icon, 64)
    place.saver.copy_svg(picture)
    place.actions_by_name["paste"].trigger()
    document = svg_document(icon)
    (icon,) = there(place, qtbot, 1)
    assert icon.svg == read_simply(document.encode(), "drawing").svg
    assert icon.credit.title == "Motor cycle"
    assert [one.credit for one in icon.origins] == [exemplar(0).pictogram.credit]


STYLED = """<template><svg viewBox="0 0 24 24"><path class="a" d="M3 3h18v18H3z"/></svg></template>
<style scoped>.a{fill:none;stroke:#000;stroke-width:2}</style>"""
CODE = """const Box = ({ color = "#000" }) => (<svg viewBox="0 0 24 24" fill="none">
  <path d="M4 8h16v10H4z" stroke={color} strokeWidth={3} /></svg>);"""
ADDRESS = (
    "url(\"data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'%3E"
    "%3Cpath d='M0 0h9v9z'/%3E%3C/svg%3E\")"
)


@pytest.mark.parametrize(("kind", "text"), [("vue", STYLED), ("jsx", CODE), ("css", ADDRESS)])
def test_pasted_code_becomes_what_its_file_becomes(edit, qtbot, tmp_path, kind, text):
    path = tmp_path / f"{kind}.svg"  # whatever it is called
    path.write_text(text)
    assert drop(edit, urls(path)) is not None
    (dropped,) = there(edit, qtbot, 1)
    edit.actions_by_name["new"].trigger()
    paste(edit, words(text))
    (pasted,) = there(edit, qtbot, 1)
    assert (pasted.svg, pasted.remarks) == (dropped.svg, dropped.remarks)
    assert not holds_words(words(text))


def test_several_drawings_in_one_text_are_one_step(roomy, qtbot):
    paste(roomy, words(SVG.format(1) + "\n" + SVG.format(2)))
    there(roomy, qtbot, 2)
    assert roomy.document.undo_stack.count() == 1


# -- names and paths -------------------------------------------------------------------------------


def test_names_and_paths_in_words_are_opened(place, qtbot, own):
    (path,) = own(1)
    for number, text in enumerate(
        ("shapes:ring-4", str(path), f'"{path}"', QUrl.fromLocalFile(str(path)).toString())
    ):
        place.actions_by_name["new"].trigger()
        paste(place, words(f" {text}\n"))
        (icon,) = there(place, qtbot, 1)
        assert icon.id == "shapes:ring-4" if number == 0 else icon.id.startswith("own:icon-0-")


NO_DRAWINGS = {
    "shapes:unicorn": "no icon",
    "/nowhere/at-all.svg": "no such file",
    "https://example.org/dog.svg": "Only files on this computer",
    "dog": "no drawing to paste",
    "dog\nshapes:ring-4": "no drawing to paste",
    "": "no drawing to paste",
    "x" * 100_000: "no drawing to paste",
}


def test_other_words_are_told(place, qtbot):
    for text, part in NO_DRAWINGS.items():
        paste(place, words(text))
        qtbot.waitUntil(lambda part=part: part in told(place))
        assert place.icons == ()
        assert place.document.undo_stack.count() == 0
        place.window().pane.notice._button.click()
        assert told(place) == ""


def test_an_empty_clipboard_is_told(place):
    paste(place, QMimeData())
    assert "no drawing to paste" in told(place)


def test_what_is_tried_next_is_another_story(place):
    drop(place, words("https://example.org/dog.svg"))
    drop(place, words("dog"))
    lines = ["There is no drawing in what was dropped. Drop a file, a drawing or its markup."]
    assert told(place).splitlines() == lines


# -- several files ---------------------------------------------------------------------------------


def test_all_of_several_files_are_taken_by_one_step(roomy, qtbot, own):
    assert drop(roomy, urls(*own(3))) is not None
    there(roomy, qtbot, 3)
    assert told(roomy) == ""
    assert status(roomy) == "Added “icon-0.svg”, “icon-1.svg” and “icon-2.svg”."
    assert roomy.document.undo_stack.count() == 1
    roomy.actions_by_name["undo"].trigger()
    assert roomy.icons == ()
    assert "Added" not in status(roomy)
    roomy.actions_by_name["redo"].trigger()
    assert len(roomy.icons) == 3


def test_several_files_are_pasted(roomy, qtbot, own):
    paste(roomy, urls(*own(2)))
    there(roomy, qtbot, 2)


def slowly(importer, monkeypatch):
    """Let an importer wait until an event is set before it reads."""
    go, read = threading.Event(), importer.reading

    def reading(item):
        while not go.wait(0.01):
            yield None
        return (yield from read(item))

    monkeypatch.setattr(importer, "reading", reading)
    return go


@pytest.mark.parametrize("good", [True, False])
def test_what_takes_long_to_open_is_told_meanwhile(place, qtbot, own, monkeypatch, good):
    go, (path,), told, failures = slowly(place.importer, monkeypatch), own(1), [], []
    path.write_text(SVG.format(0) if good else "no drawing")
    place.remarked.connect(told.append)
    place.failed.connect(failures.append)
    place.open_mime(urls(path))
    pane = place.window().pane
    qtbot.waitUntil(lambda: status(place) == "Opening…")
    pane.status._timer.timeout.emit()
    assert status(place) == "Opening…", "as long as it lasts, longer than remarks stay"
    assert pane.status.button.isVisible()
    go.set()
    qtbot.waitUntil(lambda: status(place) != "Opening…")
    qtbot.waitUntil(lambda: good or bool(failures))
    assert not pane.status.button.isVisible()
    assert bool(told[-1]) == good
    assert bool(failures) != good
    assert place.window().pane.notice.isVisible() != good


def test_what_waits_to_be_opened_is_told_beside_the_work_it_waits_for(
    place, qtbot, own, monkeypatch
):
    go, bar = slowly(place.importer, monkeypatch), place.window().pane.status.bar
    place.open_mime(urls(*own(1)))
    qtbot.waitUntil(lambda: status(place) == "Opening…")
    assert bar.maximum() == 0, "nobody knows how far it is: the bar only moves"
    joining = Progress("remix", 0.5, "Joining parts")
    place.progressed.emit(joining)
    assert status(place) == "Opening… · Joining parts"
    assert bar.value() == bar.maximum() / 2 > 0
    go.set()
    qtbot.waitUntil(lambda: not place.opener.patience.asked)
    place.progressed.emit(joining)
    place.window().pane.status.say("")
    assert status(place) == "Joining parts"


@pytest.mark.parametrize("title", ["Sketch", "Edit", "Montage"])
def test_opening_can_be_cancelled(window, qtbot, own, photo, monkeypatch, title):
    window.show_workspace(OTHERS.get(title, 0))
    place = window.workspace
    before = place.page
    slowly(place.importer, monkeypatch)
    place.open_mime(urls(*(own(1) if title != "Sketch" else [photo])))
    qtbot.waitUntil(lambda: status(place) == "Opening…")
    place.window().pane.status.button.click()
    assert status(place) != "Opening…"
    assert not place.opener.adding and not place.opener.runner.running
    assert place.page == before


def test_a_dropped_project_that_cannot_be_opened_is_told_until_it_is_read(place, qtbot, tmp_path):
    """Patience was never told that this is somebody else's: it said “Opening…” for good."""
    path, told = tmp_path / "empty.iconstudio", []
    path.write_bytes(b"")
    place.remarked.connect(told.append)
    place.open_mime(urls(path))
    pane = place.window().pane
    qtbot.waitUntil(lambda: pane.notice.isVisible())
    qtbot.wait(700)
    assert "Opening…" not in told
    assert pane.notice.isVisible()


def test_of_several_files_an_edit_takes_one_and_says_so(edit, qtbot, own):
    drop(edit.view, urls(*own(3)))
    there(edit, qtbot, 1)
    assert edit.icons[0].id.startswith("own:icon-0-")
    assert told(edit) == (
        "Only “icon-0.svg” was opened, not “icon-1.svg” and “icon-2.svg”: an edit has one icon."
    )
    assert "icon-0.svg" in status(edit)


def test_what_there_is_no_room_for_is_named(roomy, qtbot, own):
    most = MOST[roomy.workflow.title]
    drop(roomy, urls(*own(most - 1)))
    there(roomy, qtbot, most - 1)
    drop(roomy, urls(*own(3, first=most)))
    icons = there(roomy, qtbot, most)
    assert icons[-1].id.startswith(f"own:icon-{most}-")
    assert f"icon-{most + 1}" in told(roomy) and f"icon-{most + 2}" in told(roomy)
    assert f"at most {most} icons" in told(roomy) and "own:" not in told(roomy)
    assert roomy.document.undo_stack.count() == 2
    drop(roomy, urls(*own(2, first=99)))
    qtbot.waitUntil(lambda: "first." in told(roomy))
    assert roomy.icons == icons


def test_of_very_many_files_only_so_many_are_read(roomy, qtbot, own, session):
    most = MOST[roomy.workflow.title]
    drop(roomy, urls(*own(200)))
    there(roomy, qtbot, most)
    assert f"and {200 - most - 3} more were not added" in told(roomy)
    assert sum(call[0] == "icon" for call in session.calls) == most


def test_the_same_file_twice_is_one(roomy, qtbot, own):
    (path,) = own(1)
    drop(roomy, urls(path, path))
    there(roomy, qtbot, 1)


def test_an_icon_that_is_mixed_already_is_told(window, qtbot, own):
    window.show_workspace(OTHERS["Hybrids"])
    place, (path,) = window.workspace, own(1)
    for said in ("Added “icon-0.svg”.", "“icon-0.svg” is among the icons already."):
        drop(place, urls(path))
        there(place, qtbot, 1)
        assert status(place) == said


def test_of_a_mixture_each_is_taken_or_told(place, qtbot, own, tmp_path, photo):
    first, second = own(2)
    (tmp_path / "broken.svg").write_text("<svg")
    (tmp_path / "work.json").write_text("{}")
    (tmp_path / "folder.svg").mkdir()
    others = ("broken.svg", "work.json", "folder.svg", "gone.svg")
    web = QUrl("https://example.org/dog.svg")
    data = urls(*(tmp_path / one for one in others), photo, web, first, second)
    drop(place, data)
    there(place, qtbot, 1 if place.workflow.title == "Edit" else 2)
    for name in ("broken.svg", "work.json", "folder.svg", "gone.svg", "example.org/dog.svg"):
        assert name in told(place), name
    assert "is a folder" in told(place)
    assert "open it by itself" in told(place)
    assert ("icon-1.svg" in told(place)) == (place.workflow.title == "Edit")
    assert place.document.undo_stack.count() == 1


def test_if_nothing_of_several_can_be_read_all_are_told_and_nothing_is_lost(
    place, qtbot, tmp_path, own
):
    drop(place, urls(*own(1)))
    before = there(place, qtbot, 1)
    names = [f"bad-{number}.svg" for number in range(20)]
    for name in names:
        (tmp_path / name).write_text("Dear dog")
    drop(place, urls(*(tmp_path / name for name in names)))
    qtbot.waitUntil(lambda: "bad-0.svg" in told(place))
    quiet(place, qtbot)
    assert "12 more could not be opened" in told(place)
    assert place.icons == before


def test_a_reader_that_fails_on_one_file_reads_the_others(place, qtbot, own, session, monkeypatch):
    read, paths = session.icon, own(2)

    def fail(reference):
        if reference == str(paths[0]):
            raise MemoryError("no room")
        return read(reference)

    monkeypatch.setattr(session, "icon", fail)
    drop(place, urls(*paths))
    there(place, qtbot, 1)
    assert told(place) == "“icon-0.svg” stopped the reader (MemoryError)."


def test_of_two_files_of_work_one_is_opened_and_the_other_told(edit, qtbot, tmp_path):
    for name in ("one", "two"):
        file = {"icon": "shapes:ring-4", "keyword": name}
        (tmp_path / f"{name}.json").write_text(json.dumps(file))
    drop(edit, urls(tmp_path / "one.json", tmp_path / "two.json"))
    there(edit, qtbot, 1)
    assert edit.document.page.keyword == "one"
    assert "two.json" in told(edit) and "one.json" not in told(edit)


def test_what_is_told_of_one_drop_is_not_lost_by_the_next(roomy, qtbot, tmp_path, own):
    """Two drops, one after the other, before the first is read."""
    (tmp_path / "bad.svg").write_text("Dear dog")
    drop(roomy, urls(tmp_path / "bad.svg"))
    drop(roomy, urls(*own(2)))
    there(roomy, qtbot, 2)
    assert "bad.svg" in told(roomy)
    drop(roomy, urls(*own(1, first=7)))
    there(roomy, qtbot, 3)
    assert told(roomy) == "", "that is over"


# -- where, and how --------------------------------------------------------------------------------


def test_anything_can_be_dropped_anywhere(place, qtbot, own):
    parts = {"Edit": "browser keyword_panel view",
             "Hybrids": "sheet favourites_panel detail column",
             "Montage": "layers detail view chooser"}[place.workflow.title].split()  # fmt: skip
    paths = own(len(parts))
    for part, path in zip(parts, paths, strict=True):
        count = 1 if place.workflow.title == "Edit" else len(place.icons) + 1
        widget = getattr(place, part)
        assert drop(getattr(widget, "viewport", lambda widget=widget: widget)(), urls(path))
        there(place, qtbot, count)
        assert place.icons[-1].id.startswith(f"own:{path.stem}-")


def test_a_drop_takes_nothing_away_from_where_it_comes_from(place, qtbot):
    """A text editor deletes what was moved out of it."""
    move = Qt.DropAction.MoveAction
    assert drop(place, words(SVG.format(1)), action=move) == Qt.DropAction.CopyAction
    there(place, qtbot, 1)


def test_several_files_on_the_chooser_are_the_workspaces(roomy, qtbot, own, window):
    chooser = getattr(roomy, "chooser", None) or roomy.column.chooser
    drop(chooser.field, urls(*own(2)))
    there(roomy, qtbot, 2)
    assert roomy.document.undo_stack.count() == 1


def test_an_icon_of_the_window_goes_where_icons_are_only(window, qtbot):
    window.show_workspace(OTHERS["Hybrids"])
    place, data = window.workspace, packed(exemplar(3).pictogram)
    assert drop(place.favourites_panel, data) is None, "that is where it may come from"
    assert drop(place.column.cards, data)
    there(place, qtbot, 1)


def test_nothing_at_all_is_not_welcome(place):
    assert drop(place, QMimeData()) is None


# -- browsers --------------------------------------------------------------------------------------


def browser_drag(address, html="", image=b""):
    data = QMimeData()
    data.setUrls([QUrl(address)])
    data.setData("text/x-moz-url", address.encode("utf-16-le"))
    data.setHtml(html or f'<img src="{address}">')
    if image:
        data.setData("image/svg+xml", image)
    return data


def test_an_image_dragged_from_a_page_is_told(place):
    drop(place, browser_drag("https://example.org/dog.svg"))
    assert "Only files on this computer can be opened" in told(place)
    assert place.icons == ()


def test_a_drag_from_a_page_that_brings_the_drawing_is_taken(place, qtbot):
    address = "https://example.org/dog.svg"
    for data in (
        browser_drag(address, image=SVG.format(1).encode()),
        browser_drag(address, html=f'<a href="{address}">{SVG.format(2)}</a>'),
    ):
        place.actions_by_name["new"].trigger()
        drop(place, data)
        there(place, qtbot, 1)


# -- sketch ----------------------------------------------------------------------------------------


def has_photo(place):
    return lambda: place.document.page.photo is not None


def test_markup_is_no_photo(sketching, qtbot):
    paste(sketching, words(SVG.format(1)))
    qtbot.waitUntil(lambda: "Edit, Hybrids, Montage, Line style or Pattern" in told(sketching))
    assert sketching.document.page.photo is None


def test_a_picture_of_a_drawing_can_be_traced(sketching, qtbot):
    paste(sketching, as_svg_and_picture(SVG.format(1)))
    qtbot.waitUntil(has_photo(sketching))


def test_an_image_in_an_address_can_be_traced(sketching, qtbot, photo):
    coded = base64.b64encode(photo.read_bytes()).decode()
    drop(sketching.view, urls(QUrl(f"data:image/png;base64,{coded}")))
    qtbot.waitUntil(has_photo(sketching))
    assert (sketching.document.page.photo.width, sketching.document.page.photo.height) == (30, 20)


def test_of_several_photos_a_sketch_takes_one_and_says_so(sketching, qtbot, photo, tmp_path):
    other = tmp_path / "other.png"
    other.write_bytes(photo.read_bytes())
    drop(sketching.view, urls(photo, other))
    qtbot.waitUntil(has_photo(sketching))
    quiet(sketching, qtbot)
    assert told(sketching) == (
        "Only “photo.png” was opened, not “other.png”: a sketch has one photo."
    )
    assert sketching.document.undo_stack.count() == 1


def test_of_a_mixture_a_sketch_takes_the_photo(sketching, qtbot, photo, tmp_path):
    (tmp_path / "work.json").write_text(json.dumps({"keyword": "dog", "polygon": SQUARE}))
    (tmp_path / "folder").mkdir()
    drop(sketching.view, urls(tmp_path / "folder", tmp_path / "work.json", photo))
    qtbot.waitUntil(has_photo(sketching))
    quiet(sketching, qtbot)
    assert "is a folder" in told(sketching)
    assert "work.json" in told(sketching)
    assert not sketching.document.page.vertices


def test_a_reference_and_an_icon_are_no_photos(sketching, qtbot):
    for data in (words("shapes:ring-4"), packed(exemplar(3).pictogram)):
        drop(sketching.view, data)
        qtbot.waitUntil(lambda: "not over a drawing" in told(sketching))
        sketching.window().pane.notice._button.click()


# -- reading ---------------------------------------------------------------------------------------


def test_bytes_that_are_no_image_are_nothing():
    data = QMimeData()
    data.setImageData(QByteArray(b"no image"))
    assert items(data) == ()
    data.setData("image/svg+xml", QByteArray())
    assert items(data) == ()
    assert items(urls(QUrl("data:image/png;base64,AAAA"))) == ()
    assert items(urls(QUrl("data:text/plain,hello"))) == ()


def test_pasted_markup_may_declare_another_encoding():
    text = '<?xml version="1.0" encoding="iso-8859-1"?>' + SVG.replace(
        "<path", "<title>ü</title><path"
    )
    (item,) = items(words(text))
    assert "<title>ü</title>" in decode(item.data)


def test_a_drop_of_everything_at_once_leaves_no_trace_when_the_window_closes(window, own):
    for number in OTHERS.values():
        window.show_workspace(number)
        drop(window.workspace, urls(*own(40)))
    window.close()
    assert not threads_alive(window)
