"""Name, remix, watch, pick and cancel, in the real window with the session that needs no icons."""

import itertools
import threading
import time

import pytest
from hands import SQUARE, click, press, trace, type_keyword
from PySide6.QtCore import Qt, QTimer
from PySide6.QtTest import QTest

from iconstudio.gui.panels.cell import CellState
from iconstudio.session import ModelSettings

STYLES = ModelSettings().styles
LAMBDAS = ModelSettings().lambdas


def cells(window, state):
    return [
        (style, value)
        for style in STYLES
        for value in LAMBDAS
        if window.results.cell(style, value).state is state
    ]


@pytest.fixture
def ready(window, qtbot):
    """A window with a finished outline and a name."""
    trace(window)
    type_keyword(window, "motorcycle")
    return window


def finish(window, qtbot):
    qtbot.waitUntil(lambda: not window.modelling.running, timeout=20000)


def test_icons_are_found_while_the_user_still_draws(window, qtbot, session):
    click(window, SQUARE[0])
    type_keyword(window, "motorcycle")
    sheet = window.keyword_panel.thumbnails.sheet()
    qtbot.waitUntil(lambda: sheet.rowCount() == 60)
    click(window, SQUARE[1])
    assert [call[1] for call in session.calls] == ["motorcycle"], "not once for each letter"
    assert threading.get_ident() not in session.thread_ids
    assert "60 icons found" in window.keyword_panel.caption.text()


def test_an_unknown_name_says_what_is_near(window, qtbot):
    type_keyword(window, "zzebra")
    qtbot.waitUntil(lambda: "zebra”, “zip" in window.keyword_panel.caption.text())
    assert window.keyword_panel.caption.property("error")


def test_a_run_fills_the_grid_cell_by_cell(ready, qtbot, session):
    session.gate = threading.Semaphore(0)
    press(ready, Qt.Key.Key_Return, Qt.KeyboardModifier.ControlModifier)
    assert ready.modelling.running
    assert len(cells(ready, CellState.PENDING)) == 32
    for count in (1, 2, 3):
        session.gate.release()
        qtbot.waitUntil(lambda count=count: len(ready.results.pictures) == count)
        assert ready.strip.button.isVisible()
    assert cells(ready, CellState.READY) == [("lightest", value) for value in LAMBDAS[:3]]
    assert f"{len(ready.results.pictures)} finished" in ready.strip.label.text()
    session.gate.release(100)
    finish(ready, qtbot)
    assert len(ready.results.pictures) == 24
    assert not cells(ready, CellState.PENDING)
    assert not ready.strip.button.isVisible()


def test_a_style_that_is_skipped_says_why_in_its_row(ready, qtbot):
    ready.run()
    finish(ready, qtbot)
    reason = ready.results._reasons["dark"]
    assert reason.isVisible()
    assert reason.text() == "Only 4 icons are dark; at least 9 are needed."
    assert not ready.results.cell("dark", LAMBDAS[0]).isVisible()


def test_a_run_closes_an_open_outline(window, qtbot, session):
    for point in SQUARE:
        click(window, point)
    type_keyword(window, "dog")
    QTest.keyClick(window.keyword_panel.field, Qt.Key.Key_Return)
    assert window.document.page.closed
    finish(window, qtbot)
    assert [call[0] for call in session.calls] == ["prepare", "model"]
    assert session.calls[1][1] == window.document.sketch


@pytest.mark.parametrize(
    ("points", "keyword", "part"),
    [
        ([], "dog", "There is no outline yet"),
        (SQUARE[:2], "dog", "draw at least 3"),
        ([(10, 10), (100, 100), (300, 300)], "dog", "encloses no area"),
        (SQUARE, "", "has no name yet"),
        (SQUARE, "   ", "has no name yet"),
    ],
)
def test_what_is_missing_is_said_in_the_window(window, session, points, keyword, part):
    for point in points:
        click(window, point)
    type_keyword(window, keyword)
    QTest.mouseClick(window.keyword_panel.button, Qt.MouseButton.LeftButton)
    assert window.notice.isVisible()
    assert part in window.notice.label.text()
    assert not window.modelling.running
    assert not [call for call in session.calls if call[0] == "model"]


def test_an_outline_that_crosses_itself_is_taken_and_told(window, qtbot):
    trace(window, [(100, 100), (400, 400), (400, 100), (100, 380)])
    type_keyword(window, "dog")
    window.run()
    assert "crosses itself" in window.notice.label.text()
    finish(window, qtbot)
    assert len(window.results.pictures) == 24


def test_cancel_keeps_what_is_finished(ready, qtbot, session):
    session.gate = threading.Semaphore(5)
    ready.run()
    qtbot.waitUntil(lambda: len(ready.results.pictures) == 5)
    QTest.mouseClick(ready.strip.button, Qt.MouseButton.LeftButton)
    assert not ready.modelling.running
    assert len(cells(ready, CellState.BLANK)) == 27
    qtbot.waitUntil(lambda: session.generators_closed == 1)
    session.gate.release(100)
    qtbot.wait(50)
    assert len(ready.results.pictures) == 5
    ready.run()
    finish(ready, qtbot)
    assert len(ready.results.pictures) == 24


def test_cancelling_a_search_does_not_leave_it_pending(window, qtbot, session):
    session.search_gate = threading.Semaphore(0)
    type_keyword(window, "dog")
    qtbot.waitUntil(lambda: "Looking for “dog”" in window.keyword_panel.caption.text())
    qtbot.waitUntil(window.actions_by_name["cancel"].isEnabled)
    window.actions_by_name["cancel"].trigger()
    assert "Looking" not in window.keyword_panel.caption.text()
    session.search_gate = None
    type_keyword(window, "s")
    qtbot.waitUntil(lambda: "60 icons" in window.keyword_panel.caption.text())


def test_a_cache_that_cannot_be_written_is_told_once(window, qtbot, session):
    session.trouble = "The disk is full. Make room."
    type_keyword(window, "dog")
    qtbot.waitUntil(window.notice.isVisible)
    assert window.notice.label.text() == session.trouble
    type_keyword(window, "s")
    qtbot.waitUntil(lambda: session.calls[-1][1] == "dogs" and not window.strip.bar.isVisible())
    assert not window.notice.isVisible()


def test_a_message_goes_with_the_next_edit(window):
    window.run()
    assert window.notice.isVisible()
    click(window, SQUARE[0])
    assert not window.notice.isVisible()


def test_pressing_remix_twice_does_not_begin_again(ready, qtbot, session):
    session.gate = threading.Semaphore(2)
    ready.run()
    qtbot.waitUntil(lambda: len(ready.results.pictures) == 2)
    ready.run()
    assert len(ready.results.pictures) == 2
    session.gate.release(100)
    finish(ready, qtbot)
    assert sum(call[0] == "model" for call in session.calls) == 1


def test_remix_after_an_edit_drops_the_run_under_way(ready, qtbot, session):
    session.gate = threading.Semaphore(2)
    ready.run()
    qtbot.waitUntil(lambda: len(ready.results.pictures) == 2)
    click(ready, (250, 110))
    assert "earlier sketch" in ready.results.note.text()
    session.gate.release(100)
    ready.run()
    finish(ready, qtbot)
    assert ready.results.note.text() == ""
    assert len(ready.results.pictures) == 24
    assert sum(call[0] == "model" for call in session.calls) == 2


def test_a_failure_on_the_way_is_told_and_the_window_goes_on(ready, qtbot, session, monkeypatch):
    def broken(sketch, settings):
        yield from ()
        raise MemoryError("no room")

    monkeypatch.setattr(session, "_model", broken)
    ready.run()
    finish(ready, qtbot)
    assert "MemoryError: no room" in ready.notice.label.text()
    assert not cells(ready, CellState.PENDING)
    monkeypatch.undo()
    ready.run()
    finish(ready, qtbot)
    assert len(ready.results.pictures) == 24
    assert not ready.notice.isVisible()


def test_picking_shows_the_icon_and_its_sources(ready, qtbot):
    ready.run()
    finish(ready, qtbot)
    assert ready.detail.picture is ready.results.cell("lightest", LAMBDAS[0]).picture
    target = ready.results.cell("medium", LAMBDAS[3])
    QTest.mouseClick(target, Qt.MouseButton.LeftButton)
    assert ready.detail.picture is target.picture
    rows = [ready.detail._rows.itemAt(i).widget() for i in range(ready.detail._rows.count())]
    assert [row.accessibleName() for row in rows] == [
        "shapes:ring-0, 50%",
        "shapes:frame-1, 30%",
        "shapes:cross-2, 20%",
    ]
    assert ready.detail._about.text() == "3 parts of 3 icons · fits the sketch by 87%"


def test_the_grid_is_walked_with_the_arrow_keys(ready, qtbot):
    ready.run()
    finish(ready, qtbot)
    ready.results.cell("lightest", LAMBDAS[0]).setFocus()
    for key in (Qt.Key.Key_Right, Qt.Key.Key_Right, Qt.Key.Key_Down):
        QTest.keyClick(ready.focusWidget(), key)
    picked = ready.detail.picture.result.composite
    assert (picked.style, picked.lambda_s) == ("light", LAMBDAS[2])
    for key in (Qt.Key.Key_Down, Qt.Key.Key_Down, Qt.Key.Key_Down):
        QTest.keyClick(ready.focusWidget(), key)
    assert ready.detail.picture.result.composite.style == "medium", "the row below was skipped"


def test_colour_code_and_icon_are_switched(ready, qtbot):
    ready.run()
    finish(ready, qtbot)
    cell = ready.results.cell("light", LAMBDAS[1])
    plain = cell.grab().toImage()
    ready.actions_by_name["coded"].trigger()
    coded = cell.grab().toImage()
    assert plain != coded
    assert any(coded.pixelColor(x, y).hsvSaturation() > 100 for x in range(70) for y in range(70))
    QTest.mouseClick(ready.results._icon_button, Qt.MouseButton.LeftButton)
    assert cell.grab().toImage() == plain
    assert not ready.actions_by_name["coded"].isChecked()


def test_an_icon_is_left_out_and_taken_back(ready, qtbot, session):
    thumbnails = ready.keyword_panel.thumbnails
    qtbot.waitUntil(lambda: thumbnails.sheet().rowCount() == 60)
    spot = thumbnails.visualRect(thumbnails.sheet().index(2)).center()
    QTest.mouseClick(thumbnails.viewport(), Qt.MouseButton.LeftButton, pos=spot)
    assert ready.document.sketch.exclude == {"shapes:cross-2"}
    assert "left out" in ready.keyword_panel.caption.text()
    qtbot.waitUntil(lambda: session.calls[-1][2] == {"shapes:cross-2"})
    qtbot.waitUntil(lambda: "59 icons" in ready.keyword_panel.caption.text())
    assert thumbnails.sheet().rowCount() == 60, "it stays in sight, struck out"
    assert thumbnails.sheet().index(2).data() == "shapes:cross-2, left out"
    ready.keyword_panel.caption.linkActivated.emit("#")
    assert not ready.document.sketch.exclude
    ready.document.undo_stack.undo()
    assert ready.document.sketch.exclude == {"shapes:cross-2"}


def test_undo_in_the_keyword_field_is_the_documents(window):
    trace(window)
    type_keyword(window, "dog")
    control = Qt.KeyboardModifier.ControlModifier
    QTest.keyClick(window.keyword_panel.field, Qt.Key.Key_Z, control)
    assert window.document.sketch.keyword == ""
    assert window.keyword_panel.field.text() == ""
    QTest.keyClick(window.keyword_panel.field, Qt.Key.Key_Z, control)
    assert not window.document.page.closed


def test_regions_are_shown_on_the_outline_they_belong_to(ready, qtbot):
    ready.run()
    finish(ready, qtbot)
    plain = ready.view.grab().toImage()
    ready.actions_by_name["regions"].trigger()
    assert ready.view.grab().toImage() != plain
    click(ready, (250, 110))
    assert not ready.view._regions


@pytest.mark.parametrize("stuck", [False, True])
def test_closing_the_window_while_it_works_leaves_no_thread(ready, qtbot, session, stuck):
    session.gate = threading.Semaphore(1)
    session.stuck = stuck
    ready.run()
    qtbot.waitUntil(lambda: any(call[0] == "model" for call in session.calls))
    ready.close()
    assert session.closed.is_set()
    assert session.generators_closed == 1
    assert not ready.threads_alive()


def test_the_window_stays_awake(ready, qtbot, record_property):
    """The longest time between two ticks of a timer during a run is recorded, with ample bound."""
    ticks = [time.perf_counter()]
    timer = QTimer(interval=2)
    timer.timeout.connect(lambda: ticks.append(time.perf_counter()))
    timer.start()
    ready.run()
    finish(ready, qtbot)
    timer.stop()
    longest = max(b - a for a, b in itertools.pairwise(ticks))
    record_property("longest gap between ticks in ms", round(1000 * longest, 1))
    assert longest < 2
