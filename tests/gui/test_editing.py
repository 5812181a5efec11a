"""Editing in the real window: choose an icon, mark it, remix, go on with a result."""

import json
import math
import re
import threading
from dataclasses import replace

import pytest
from fake_session import RECOMMENDED, exemplar
from hands import at, click, drag, drop, press, save_to, search, type_keyword, workspaces
from images import pixels
from PySide6.QtCore import QMimeData, Qt, QUrl
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog

from iconstudio.gui.canvas.tools.areas import DrawTool, SelectTool
from iconstudio.gui.exchange.dragging import packed
from iconstudio.gui.workspaces.symmetry import PAUSE
from iconstudio.model import Axis
from iconstudio.workflows.areas import Area, Kind
from iconstudio.workflows.editing.file import read_edit
from iconstudio.workflows.editing.page import EditPage
from iconstudio.workflows.grid import GridSettings

LAMBDAS = GridSettings().lambdas
RED = [(40.0, 40.0), (120.0, 45.0), (115.0, 120.0), (45.0, 110.0)]
GREEN = [(140.0, 60.0), (220.0, 60.0), (180.0, 130.0)]
SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="M1 1h7v7z"/></svg>'


@pytest.fixture
def empty(window):
    """The workspace, in sight, without an icon."""
    place = window.workspace_of("Edit")
    window.show_workspace(workspaces(window).index(place))
    return place


def settle(place, qtbot):
    """Wait until the icon is on the canvas, drawn crisply."""
    qtbot.waitUntil(lambda: place.document.page.icon is not None)
    qtbot.waitUntil(lambda: place.outlines.outline(place.document.page.icon) is not None)


@pytest.fixture
def editing(empty, qtbot):
    """The workspace with a frame (a square ring) on its canvas."""
    empty.take(exemplar(5).pictogram)
    settle(empty, qtbot)
    assert not empty.start_panel.isVisible()
    return empty


def polygon(place, points):
    """Click all points, then the first again."""
    for point in (*points, points[0]):
        click(place, point)


def lasso(place, points, steps=6):
    """Press, drag along the points and back to the first, let go."""
    left = Qt.MouseButton.LeftButton
    QTest.mousePress(place.view, left, pos=at(place, points[0]))
    for (x0, y0), (x1, y1) in zip(points, [*points[1:], points[0]], strict=True):
        for step in range(1, steps + 1):
            t = step / steps
            QTest.mouseMove(place.view, at(place, (x0 + t * (x1 - x0), y0 + t * (y1 - y0))))
    QTest.mouseRelease(place.view, left, pos=at(place, points[0]))


def near(vertices, expected, tolerance=2.0):
    assert len(vertices) == len(expected)
    assert all(math.dist(a, b) < tolerance for a, b in zip(vertices, expected, strict=True))


def areas(place):
    return place.document.page.areas


def notice(place):
    label = place.window().pane.notice
    return label.label.text() if label.isVisible() else ""


def finish(place, qtbot):
    qtbot.waitUntil(lambda: not place.runner.running, timeout=20000)


# -- choosing an icon ------------------------------------------------------------------------


def test_an_empty_canvas_offers_to_choose_an_icon_and_the_cursor_is_there(empty, qtbot):
    assert empty.start_panel.isVisible()
    assert empty.window().focusWidget() is empty.start_panel.chooser.field
    assert not empty.start_panel.close_button.isVisible()
    QTest.keyClicks(empty.start_panel.chooser.field, "frames")
    choices = empty.start_panel.chooser.sheet
    qtbot.waitUntil(lambda: choices.model().rowCount() == 60)
    spot = choices.visualRect(choices.model().index(1)).center()
    QTest.mouseClick(choices.viewport(), Qt.MouseButton.LeftButton, pos=spot)
    settle(empty, qtbot)
    assert empty.document.page.icon.id == "shapes:frame-1"
    assert empty.document.page.keyword == "frame", "named after the icon"
    assert empty.keyword_panel.field.text() == "frame"
    assert not empty.start_panel.isVisible()
    assert empty.view.hasFocus()
    assert "Remove" in empty.view.tool.hint


def test_choosing_another_icon_starts_afresh_and_undo_brings_all_back(editing, qtbot):
    polygon(editing, RED)
    before = editing.document.page
    editing.actions_by_name["icon"].trigger()
    assert editing.start_panel.isVisible()
    search(editing.start_panel.chooser, "ring")
    choices = editing.start_panel.chooser.sheet
    qtbot.waitUntil(lambda: choices.model().rowCount() == 60)
    spot = choices.visualRect(choices.model().index(0)).center()
    QTest.mouseClick(choices.viewport(), Qt.MouseButton.LeftButton, pos=spot)
    qtbot.waitUntil(lambda: editing.document.page != before)
    assert areas(editing) == ()
    assert not editing.start_panel.isVisible()
    editing.actions_by_name["undo"].trigger()
    assert editing.document.page == before


def test_the_choice_is_given_up_with_escape(editing):
    before = editing.document.page
    editing.actions_by_name["icon"].trigger()
    QTest.keyClick(editing.start_panel.chooser.field, Qt.Key.Key_Escape)
    assert not editing.start_panel.isVisible()
    assert editing.view.hasFocus()
    assert editing.document.page == before


def test_an_icon_can_be_dropped_from_elsewhere_in_the_window(empty, qtbot):
    drop(empty.view, packed(exemplar(3).pictogram))
    settle(empty, qtbot)
    assert empty.document.page.icon.id == "shapes:triangle-3"


def test_an_svg_of_ones_own_can_be_dropped_or_pasted(empty, qtbot, tmp_path):
    path = tmp_path / "logo.svg"
    path.write_text(SVG)
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path))])
    drop(empty.view, data)
    settle(empty, qtbot)
    assert empty.document.page.icon.id.startswith("own:logo-")
    empty.actions_by_name["undo"].trigger()
    QApplication.clipboard().setMimeData(data)
    empty.actions_by_name["paste"].trigger()
    settle(empty, qtbot)


def test_what_is_no_icon_is_told_and_nothing_is_lost(editing, qtbot, tmp_path):
    polygon(editing, RED)
    before = editing.document.page
    path = tmp_path / "letter.svg"
    path.write_text("Dear dog")
    editing.opener.open_file(str(path))
    qtbot.waitUntil(lambda: "letter.svg" in notice(editing))
    QApplication.clipboard().setText("dog")
    editing.actions_by_name["paste"].trigger()
    assert "no drawing to paste" in notice(editing)
    assert editing.document.page == before


# -- marking ---------------------------------------------------------------------------------


def test_corners_are_clicked_around_what_should_go(editing):
    assert isinstance(editing.view.tool, DrawTool)
    assert "drag around what should go" in editing.view.tool.hint
    for point in RED:
        click(editing, point)
    assert not areas(editing)[0].closed
    assert "first point" in editing.view.tool.hint
    click(editing, RED[0])
    (area,) = areas(editing)
    assert (area.kind, area.closed) == (Kind.REMOVE, True)
    near(area.vertices, RED)


def test_a_freehand_line_becomes_an_area_of_few_corners(editing):
    lasso(editing, RED)
    (area,) = areas(editing)
    assert (area.kind, area.closed) == (Kind.REMOVE, True)
    near(area.vertices, RED)
    assert editing.document.undo_stack.count() == 2, "the icon, and one step"
    assert "Now add" in editing.view.tool.hint


def test_what_should_come_is_drawn_over_what_goes(editing):
    lasso(editing, RED)
    press(editing, Qt.Key.Key_A)
    assert editing.actions_by_name["add"].isChecked()
    shifted = [(x + 10, y + 10) for x, y in RED]
    lasso(editing, shifted)
    polygon(editing, GREEN)
    assert [area.kind for area in areas(editing)] == [Kind.REMOVE, Kind.ADD, Kind.ADD]
    edit = editing.document.page.edit()
    assert len(edit.remove) == 1
    near(edit.add[1].vertices, GREEN)


def test_an_area_that_crosses_itself_is_taken_and_told(editing, qtbot):
    for point in ((100, 60), (200, 160), (200, 60), (100, 150)):
        click(editing, point)
    press(editing, Qt.Key.Key_Return)
    type_keyword(editing, "cup")
    editing.run()
    said = editing.window().pane.notice.label.text()
    assert said == "Removed area 1 crosses itself: all that it encloses counts as inside."


def test_a_line_to_and_fro_encloses_nothing(editing):
    lasso(editing, [(40.0, 40.0), (120.0, 40.0)])
    assert areas(editing) == ()
    assert "encloses nothing" in editing.view.tool.hint
    click(editing, RED[0])
    assert "next point" in editing.view.tool.hint


def test_escape_gives_up_a_line_under_way(editing):
    left = Qt.MouseButton.LeftButton
    QTest.mousePress(editing.view, left, pos=at(editing, RED[0]))
    for point in RED[1:]:
        QTest.mouseMove(editing.view, at(editing, point))
    assert "Let go" in editing.view.tool.hint
    press(editing, Qt.Key.Key_Escape)
    QTest.mouseRelease(editing.view, left, pos=at(editing, RED[3]))
    assert areas(editing) == ()


def test_escape_gives_up_corners_and_undo_brings_them_back(editing):
    for point in RED[:3]:
        click(editing, point)
    before = editing.document.page
    press(editing, Qt.Key.Key_Escape)
    assert areas(editing) == ()
    editing.actions_by_name["undo"].trigger()
    assert editing.document.page == before
    click(editing, RED[3])
    assert len(areas(editing)[0].vertices) == 4, "tracing goes on"


def test_another_tool_finishes_what_is_open(editing):
    for point in RED[:3]:
        click(editing, point)
    press(editing, Qt.Key.Key_A)
    near(areas(editing)[0].vertices, RED[:3])
    assert areas(editing)[0].closed
    click(editing, GREEN[0])
    press(editing, Qt.Key.Key_V)
    assert len(areas(editing)) == 1, "one point is no area"


def test_moving_the_page_does_not_finish_what_is_open(editing):
    for point in RED[:3]:
        click(editing, point)
    before = editing.document.page
    press(editing, Qt.Key.Key_H)
    press(editing, Qt.Key.Key_R)
    assert editing.document.page == before


def test_the_area_just_drawn_can_be_corrected_at_once(editing):
    polygon(editing, RED)
    drag(editing, RED[2], (100, 100))
    near(areas(editing)[0].vertices, [*RED[:2], (100, 100), RED[3]])
    editing.actions_by_name["undo"].trigger()
    near(areas(editing)[0].vertices, RED)
    press(editing, Qt.Key.Key_Escape)
    press(editing, Qt.Key.Key_Backspace)
    assert areas(editing) == ()
    editing.actions_by_name["undo"].trigger()
    near(areas(editing)[0].vertices, RED)


def test_an_area_is_selected_moved_and_removed(editing):
    polygon(editing, RED)
    press(editing, Qt.Key.Key_A)
    polygon(editing, GREEN)
    press(editing, Qt.Key.Key_V)
    assert isinstance(editing.view.tool, SelectTool)
    click(editing, (250, 250))
    assert "Click an area" in editing.view.tool.hint
    drag(editing, (80, 80), (90, 100))
    near(areas(editing)[0].vertices, [(x + 10, y + 20) for x, y in RED])
    near(areas(editing)[1].vertices, GREEN)
    press(editing, Qt.Key.Key_Right)
    press(editing, Qt.Key.Key_Up, Qt.KeyboardModifier.ShiftModifier)
    near(areas(editing)[0].vertices, [(x + 11, y + 10) for x, y in RED])
    stack = editing.document.undo_stack
    stack.undo()
    near(areas(editing)[0].vertices, [(x + 10, y + 20) for x, y in RED])
    stack.undo()
    near(areas(editing)[0].vertices, RED)
    click(editing, (180, 80))
    press(editing, Qt.Key.Key_Delete)
    assert [area.kind for area in areas(editing)] == [Kind.REMOVE]
    stack.undo()
    assert [area.kind for area in areas(editing)] == [Kind.REMOVE, Kind.ADD]


def test_what_is_added_is_selected_before_what_is_removed_below_it(editing):
    polygon(editing, RED)
    press(editing, Qt.Key.Key_A)
    lasso(editing, [(60, 60), (100, 60), (80, 100)])
    press(editing, Qt.Key.Key_V)
    click(editing, (80, 70))
    assert editing.outline.area.kind is Kind.ADD
    click(editing, (50, 50))
    assert editing.outline.area.kind is Kind.REMOVE


def test_a_triangle_that_loses_a_corner_is_no_area_any_more(editing):
    press(editing, Qt.Key.Key_A)
    polygon(editing, GREEN)
    click(editing, GREEN[1], Qt.MouseButton.RightButton)
    assert areas(editing) == ()
    editing.actions_by_name["undo"].trigger()
    near(areas(editing)[0].vertices, GREEN)


def test_all_areas_are_cleared_and_the_icon_stays(editing):
    assert not editing.actions_by_name["clear"].isEnabled()
    polygon(editing, RED)
    press(editing, Qt.Key.Key_A)
    polygon(editing, GREEN)
    editing.actions_by_name["clear"].trigger()
    assert areas(editing) == ()
    assert editing.document.page.icon is not None
    editing.actions_by_name["undo"].trigger()
    assert len(areas(editing)) == 2


def test_undo_and_redo_go_through_every_state(editing):
    pages: list[EditPage] = [editing.document.page]
    stack = editing.document.undo_stack
    base = stack.index()
    editing.document.page_changed.connect(pages.append)
    polygon(editing, RED)
    press(editing, Qt.Key.Key_A)
    lasso(editing, GREEN)
    press(editing, Qt.Key.Key_Escape)
    click(editing, GREEN[0])
    press(editing, Qt.Key.Key_V)
    editing.hold_to(Axis.HORIZONTAL)
    editing.actions_by_name["clear"].trigger()
    editing.actions_by_name["new"].trigger()
    editing.document.page_changed.disconnect(pages.append)
    assert stack.count() - base == len(pages) - 1
    for page in reversed(pages[:-1]):
        stack.undo()
        assert editing.document.page == page
    for page in pages[1:]:
        stack.redo()
        assert editing.document.page == page


def colour(place, point):
    """Return red, green and blue where a page point is seen, from 0 to 1."""
    image: QImage = place.view.grab().toImage()
    spot = at(place, point) * image.devicePixelRatio()
    return pixels(image)[spot.y(), spot.x(), :3]


def test_what_goes_is_red_what_comes_is_green_and_the_rest_grey(editing):
    ink = editing.document.page.icon.ink
    assert ink[128, 40] and ink[128, 215], "the sides of the frame"
    r, g, b = colour(editing, (40, 200))
    assert r == pytest.approx(g, abs=0.03) and g == pytest.approx(b, abs=0.03) and r < 0.7
    lasso(editing, [(20, 100), (70, 100), (70, 160), (20, 160)])
    press(editing, Qt.Key.Key_A)
    lasso(editing, [(180, 5), (240, 5), (240, 30), (180, 30)])
    press(editing, Qt.Key.Key_Escape)
    r, g, b = colour(editing, (40, 130))
    assert r > g + 0.2 and r > b + 0.2
    r, g, b = colour(editing, (210, 20))
    assert g > r + 0.1 and g > b + 0.05


def test_the_axis_of_symmetry_is_drawn(editing):
    before = editing.view.grab().toImage()
    editing.symmetry.chosen.emit(Axis.VERTICAL)
    assert editing.document.page.symmetry is Axis.VERTICAL
    assert editing.symmetry.accessibleName().startswith("Symmetry: vertical")
    assert editing.view.grab().toImage() != before


# -- remixing --------------------------------------------------------------------------------


@pytest.fixture
def marked(editing):
    lasso(editing, RED)
    return editing


def test_remix_fills_the_rows_of_the_icons_own_styles(marked, qtbot, session):
    press(marked, Qt.Key.Key_Return, Qt.KeyboardModifier.ControlModifier)
    finish(marked, qtbot)
    ((_, edit, settings),) = [call for call in session.calls if call[0] == "edit"]
    assert edit == marked.document.page.edit()
    assert settings.styles == ("medium", "dark"), "three quarters of a frame are black"
    assert len(marked.browser.results.pictures) == 8
    picked = marked.browser.detail.picture.icon.composite
    assert (picked.style, picked.lambda_s) == ("medium", LAMBDAS[RECOMMENDED])
    about = marked.browser.detail._about.text()
    assert "fits the change by 87%" in about and "unchanged elsewhere 90%" in about
    assert marked.browser.results.note.text() == ""


def test_parts_of_all_styles_can_be_had(marked, qtbot, session):
    marked.run()
    finish(marked, qtbot)
    marked.actions_by_name["styles"].trigger()
    assert "earlier edit" in marked.browser.results.note.text()
    marked.run()
    finish(marked, qtbot)
    assert session.calls[-1][2].styles == GridSettings().styles


def test_results_of_an_earlier_edit_are_called_so(marked, qtbot):
    marked.run()
    finish(marked, qtbot)
    drag(marked, RED[2], (100, 100))
    assert "earlier edit" in marked.browser.results.note.text()
    marked.actions_by_name["undo"].trigger()
    assert marked.browser.results.note.text() == ""


def test_remix_closes_an_open_area(editing, qtbot, session):
    for point in RED:
        click(editing, point)
    editing.run()
    finish(editing, qtbot)
    near(session.calls[-1][1].remove[0].vertices, RED)


def test_an_icon_is_left_out(marked, qtbot, session):
    thumbnails = marked.keyword_panel.sheet
    qtbot.waitUntil(lambda: thumbnails.model().rowCount() == 60)
    spot = thumbnails.visualRect(thumbnails.model().index(2)).center()
    QTest.mouseClick(thumbnails.viewport(), Qt.MouseButton.LeftButton, pos=spot)
    marked.run()
    finish(marked, qtbot)
    assert session.calls[-1][1].exclude == {"shapes:cross-2"}


def test_what_is_missing_is_said_and_the_results_stay(editing, qtbot, session):
    editing.run()
    assert "Nothing is changed" in notice(editing)
    lasso(editing, [(2, 2), (12, 2), (12, 12), (2, 12)])
    assert notice(editing) == ""
    editing.run()
    assert "beside the icon" in notice(editing)
    editing.actions_by_name["undo"].trigger()
    lasso(editing, [(2, 2), (254, 2), (254, 254), (2, 254)])
    editing.run()
    assert "Nothing of the icon would be left" in notice(editing)
    editing.actions_by_name["undo"].trigger()
    lasso(editing, RED)
    editing.keyword_panel.field.selectAll()
    QTest.keyClick(editing.keyword_panel.field, Qt.Key.Key_Backspace)
    editing.run()
    assert "has no name" in notice(editing)
    assert editing.keyword_panel.field.hasFocus()
    assert not [call for call in session.calls if call[0] == "edit"]
    type_keyword(editing, "frame")
    editing.run()
    finish(editing, qtbot)
    assert len(editing.browser.results.pictures) == 8
    editing.actions_by_name["clear"].trigger()
    editing.run()
    assert "Nothing is changed" in notice(editing)
    assert len(editing.browser.results.pictures) == 8


def test_without_an_icon_remix_says_what_to_do(empty):
    empty.run()
    assert "no icon yet" in notice(empty)
    assert empty.start_panel.chooser.field.hasFocus()


def test_cancel_keeps_what_is_finished(marked, qtbot, session):
    session.gate = threading.Semaphore(3)
    marked.run()
    qtbot.waitUntil(lambda: len(marked.browser.results.pictures) == 3)
    marked.actions_by_name["cancel"].trigger()
    assert not marked.runner.running
    session.gate.release(100)
    assert len(marked.browser.results.pictures) == 3


def test_another_workspace_and_back_loses_nothing(marked, qtbot, session):
    session.gate = threading.Semaphore(2)
    marked.run()
    qtbot.waitUntil(lambda: len(marked.browser.results.pictures) == 2)
    before = marked.document.page
    window = marked.window()
    window.show_workspace(0)
    session.gate.release(100)
    finish(marked, qtbot)
    window.show_workspace(workspaces(window).index(marked))
    assert marked.document.page == before
    assert len(marked.browser.results.pictures) == 8
    assert marked.view.hasFocus()


def test_a_result_is_edited_further_with_its_credits(marked, qtbot):
    marked.run()
    finish(marked, qtbot)
    before = marked.document.page
    marked.send_picture(marked.picture, "Edit")
    qtbot.waitUntil(lambda: marked.document.page != before)
    page = marked.document.page
    assert page.icon.id.startswith("made:frame-")
    assert page.keyword == "frame"
    assert {one.id for one in page.icon.pictogram.origins} >= {"shapes:ring-0", "shapes:frame-1"}
    assert page.areas == ()
    settle(marked, qtbot)
    marked.actions_by_name["undo"].trigger()
    assert marked.document.page == before


# -- symmetry --------------------------------------------------------------------------------


def test_a_change_that_is_nearly_symmetric_can_be_held_to_symmetry(editing, qtbot):
    hint = editing.symmetry_hint
    lasso(editing, [(118, 20), (138, 20), (138, 90), (118, 90)])
    qtbot.waitUntil(hint.isVisible)
    before = editing.view.grab().toImage()
    QTest.mouseClick(hint, Qt.MouseButton.LeftButton)
    assert editing.document.page.symmetry is Axis.HORIZONTAL
    assert editing.symmetry.accessibleName().startswith("Symmetry: horizontal")
    assert not hint.isVisible()
    assert editing.view.grab().toImage() != before
    press(editing, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert editing.document.page.symmetry is None
    assert hint.isVisible(), "it is offered again at once"
    press(editing, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert not hint.isVisible(), "nothing is marked"


@pytest.mark.parametrize(
    "area", [[(20, 20), (150, 20), (150, 76), (20, 76)], [(2, 60), (22, 60), (22, 140)]]
)
def test_no_symmetry_is_offered_for_what_has_none_or_is_no_good(editing, qtbot, area):
    looked = []
    editing.symmetry_detection.found.connect(looked.append)
    polygon(editing, area)
    assert editing.document.page.open_area is None
    qtbot.wait(2 * PAUSE)
    assert set(looked) == {None}
    assert editing.symmetry_detection._outline is not None, "it was looked at"
    assert not editing.symmetry_hint.isVisible()


# -- files -----------------------------------------------------------------------------------


def test_an_edit_is_saved_and_opened_again(marked, qtbot, tmp_path, monkeypatch):
    press(marked, Qt.Key.Key_A)
    polygon(marked, GREEN)
    marked.hold_to(Axis.HORIZONTAL)
    path = tmp_path / "frame.json"
    save_to(marked, monkeypatch, path)
    marked.actions_by_name["save"].trigger()
    qtbot.waitUntil(path.exists)
    before = marked.document.page.edit()
    marked.actions_by_name["new"].trigger()
    assert marked.start_panel.isVisible()
    assert not marked.actions_by_name["save"].isEnabled()
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(path), ""))
    marked.actions_by_name["open"].trigger()
    settle(marked, qtbot)
    after = marked.document.page.edit()
    assert (after.icon, after.keyword, after.symmetry) == (
        before.icon,
        before.keyword,
        before.symmetry,
    )
    near(after.remove[0].vertices, before.remove[0].vertices, 0.01)
    near(after.add[0].vertices, before.add[0].vertices, 0.01)


def test_every_example_of_the_menu_opens(empty, qtbot, session, monkeypatch):
    monkeypatch.setattr(session, "icon", lambda reference: exemplar(5).pictogram)
    menu = empty.actions_by_name["examples"].menu().actions()
    assert [action.text() for action in menu] == [
        "Camera gains a flash",
        "Castle gains a dome",
        "Glass gains a handle",
    ]
    for action in menu:
        before = empty.document.page
        action.trigger()
        qtbot.waitUntil(lambda before=before: empty.document.page is not before)
        edit = empty.document.page.edit()
        assert edit.remove or edit.add
        assert "Mark more" in empty.view.tool.hint
        assert edit.keyword
        empty.run()
        finish(empty, qtbot)
        assert not notice(empty)


def test_an_icon_that_no_collection_has_is_saved_beside_the_edit(
    empty, qtbot, tmp_path, monkeypatch
):
    own = tmp_path / "elsewhere" / "logo.svg"
    own.parent.mkdir()
    own.write_text(SVG)
    empty.opener.open_file(str(own))
    settle(empty, qtbot)
    lasso(empty, RED)
    path = tmp_path / "new.json"
    save_to(empty, monkeypatch, path)
    empty.actions_by_name["save"].trigger()
    qtbot.waitUntil(path.exists)
    own.unlink()
    icon = json.loads(path.read_text())["icon"]
    assert "/" not in icon
    saved = (tmp_path / icon).read_text()
    assert "<dc:title>logo.svg</dc:title>" in saved
    drawn = empty.document.page.icon.pictogram.svg
    assert re.findall(" d=.*?/>", saved) == re.findall(" d=.*?/>", drawn)
    assert read_edit(path).icon == str(tmp_path / icon)


@pytest.mark.parametrize("text", ["", "{", '{"icon": "shapes:frame-5", "remove": [[[1, 2]]]}'])
def test_a_broken_edit_is_told_and_nothing_is_lost(marked, qtbot, tmp_path, text):
    before = marked.document.page
    path = tmp_path / "broken.json"
    path.write_text(text)
    marked.opener.open_work(str(path))
    qtbot.waitUntil(lambda: "broken.json" in notice(marked))
    assert marked.document.page == before


def test_an_area_without_an_icon_has_no_symmetry(window, qtbot):
    """As from events that come while the chooser covers the canvas."""
    place = window.workspace_of("Edit")
    window.show_workspace(workspaces(window).index(place))
    areas = (Area(Kind.ADD, ((40.0, 40.0), (90.0, 40.0), (90.0, 90.0))),)
    place.document.change("mark", replace(place.page, areas=areas))
    qtbot.wait(2 * PAUSE)
    assert place.page.criteria.symmetry is None
