"""What could not be read of a drawing is said as long as its icon lies on the page."""

import json
from dataclasses import replace

import pytest
from fake_session import FakeSession, exemplar
from PySide6.QtWidgets import QApplication

TEXT = "Text was left out; turn it into shapes."
COLOUR = "The colour “oklab(1 0 0 / x)” was not understood; write it as “#rrggbb”."
REMARKS = {"shapes:ring-0": (TEXT,), "shapes:cross-2": (TEXT, COLOUR), "shapes:ring-4": (TEXT,)}
PLACES = {"Edit": 1, "Hybrids": 2, "Montage": 3}
LONG = "A part that nobody has ever heard of was left out; draw it otherwise. " * 40


class RemarkingSession(FakeSession):
    def icon(self, reference):
        return replace(super().icon(reference), remarks=REMARKS.get(reference, ()))

    def icon_from(self, data, name):
        return replace(super().icon_from(data, name), remarks=(LONG,))

    def exemplar(self, pictogram):
        return replace(super().exemplar(pictogram), pictogram=pictogram)


@pytest.fixture
def session():
    return RemarkingSession()


@pytest.fixture(params=PLACES)
def place(window, request):
    window.show_workspace(PLACES[request.param])
    return window.workspace


@pytest.fixture(params=["Hybrids", "Montage"])
def roomy(window, request):
    window.show_workspace(PLACES[request.param])
    return window.workspace


def paste(place, qtbot, text, count):
    QApplication.clipboard().setText(text)
    place.actions_by_name["paste"].trigger()
    qtbot.waitUntil(lambda: len(place.icons) == count, timeout=20000)
    opener = place.opener
    qtbot.waitUntil(lambda: not (opener.adding or opener.runner.running), timeout=20000)


def told(place):
    notice = place.window().pane.notice
    return notice.label.text() if notice.isVisible() else ""


def test_a_remark_comes_and_goes_with_its_icon(place, qtbot):
    paste(place, qtbot, "shapes:ring-0", 1)
    assert told(place) == f"“ring 0”: {TEXT}"
    place.actions_by_name["undo"].trigger()
    assert told(place) == ""
    place.actions_by_name["redo"].trigger()
    assert TEXT in told(place)


def test_remarks_of_several_icons_are_all_there(roomy, qtbot):
    paste(roomy, qtbot, "shapes:ring-0\nshapes:frame-1", 2)
    paste(roomy, qtbot, "shapes:cross-2\nshapes:ring-4", 4)
    lines = [f"“ring 0” and “ring 4”: {TEXT}", f"“cross 2”: {TEXT} {COLOUR}"]
    assert told(roomy).splitlines() == lines
    QApplication.clipboard().setText("dog")
    roomy.actions_by_name["paste"].trigger()
    assert told(roomy).splitlines()[1:] == lines, "beside another message"
    roomy.window().pane.say("")
    assert told(roomy).splitlines() == lines


def test_the_remark_on_the_newest_icon_comes_first(roomy, qtbot):
    paste(roomy, qtbot, "shapes:ring-0", 1)
    paste(roomy, qtbot, "shapes:cross-2", 2)
    assert told(roomy).splitlines() == [f"“cross 2”: {TEXT} {COLOUR}", f"“ring 0”: {TEXT}"]


def test_what_is_dismissed_comes_back_with_its_icon_only(roomy, qtbot):
    paste(roomy, qtbot, "shapes:ring-0", 1)
    roomy.window().pane.notice._button.click()
    assert told(roomy) == ""
    paste(roomy, qtbot, "shapes:frame-1", 2)
    assert told(roomy) == ""
    paste(roomy, qtbot, "shapes:cross-2", 3)
    assert told(roomy) == f"“cross 2”: {TEXT} {COLOUR}"
    for _ in range(3):
        roomy.actions_by_name["undo"].trigger()
    roomy.actions_by_name["redo"].trigger()
    assert told(roomy) == f"“ring 0”: {TEXT}"


def test_remarks_are_those_of_the_workspace_in_sight(place, qtbot):
    paste(place, qtbot, "shapes:ring-0", 1)
    window = place.window()
    window.show_workspace(0)
    assert told(place) == ""
    window.show_workspace(PLACES[place.workflow.title])
    assert TEXT in told(place)


def test_a_file_of_work_brings_the_remarks_of_its_icons(window, qtbot, tmp_path):
    icons = ["shapes:ring-0", "shapes:frame-1"]
    works = {
        "Edit": {"icon": icons[0], "keyword": "ring"},
        "Hybrids": {"icons": icons},
        "Montage": {"layers": [{"icon": one} for one in icons]},
    }
    for title, work in works.items():
        window.show_workspace(PLACES[title])
        path = tmp_path / f"{title}.json"
        path.write_text(json.dumps(work))
        window.workspace.opener.open_work(str(path))
        qtbot.waitUntil(lambda: told(window.workspace) == f"“ring 0”: {TEXT}", timeout=20000)


def test_an_icon_that_is_sent_keeps_its_remarks(place, qtbot):
    place.take(replace(exemplar(3).pictogram, remarks=(COLOUR,)))
    qtbot.waitUntil(lambda: told(place) == f"“triangle 3”: {COLOUR}", timeout=20000)


def test_a_long_remark_scrolls_and_leaves_room_for_the_work(place, qtbot):
    svg = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="M0 0h9v9z"/></svg>'
    notice = place.window().pane.notice
    paste(place, qtbot, "shapes:ring-0", 1)
    qtbot.waitUntil(lambda: 0 < notice.height() < 50)
    short = notice.height()
    place.actions_by_name["undo"].trigger()
    paste(place, qtbot, svg, 1)
    assert " ".join(LONG.split()) in told(place)
    qtbot.waitUntil(lambda: notice._scroll.verticalScrollBar().maximum() > 0)
    qtbot.waitUntil(lambda: short < notice.height() < 100)
    assert place.window().height() == 720
    place.actions_by_name["undo"].trigger()
    paste(place, qtbot, "shapes:ring-0", 1)
    qtbot.waitUntil(lambda: notice.height() == short)
