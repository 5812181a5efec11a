"""Results that follow the hand, in the real window. No test waits for time to pass: how long a run
is waited for is set to for ever, or to nothing, and what a run has shown is let through a gate."""

import threading
from dataclasses import replace

import numpy as np
import pytest
from fake_session import RECOMMENDED, FakeSession, exemplar
from hands import SQUARE, click, drag, press, threads_alive, trace, type_keyword, workspaces
from PySide6.QtCore import QMargins, QSettings, Qt
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest

from iconstudio.gui.gallery.cell import CellState
from iconstudio.gui.gallery.paling import PALE
from iconstudio.gui.pictures.picture import picture_of
from iconstudio.gui.preferences import preferred
from iconstudio.gui.window.main_window import MainWindow
from iconstudio.model import CANVAS, Axis, Polygon, Sketch
from iconstudio.output.colours import SIGNIFICANT
from iconstudio.workflows.events import Progress, Recommended, StyleSkipped
from iconstudio.workflows.grid import GridSettings
from iconstudio.workflows.modelling import page as edits
from iconstudio.workflows.remixing import FINE

STYLES = GridSettings().styles
LAMBDAS = GridSettings().lambdas
MIDDLE = "medium", LAMBDAS[4]
"""What comes first where nothing is picked yet."""
FOR_EVER = 10**6
CONTROL = Qt.KeyboardModifier.ControlModifier


def patient(place):
    """Switch live mode on; let each run show something, however long that takes."""
    place.actions_by_name["live"].trigger()
    assert place.runner.live
    place.runner.live_runner.timer.setInterval(FOR_EVER)
    return place


@pytest.fixture
def live(sketching):
    return patient(sketching)


@pytest.fixture
def drawn(live, qtbot, session):
    """A window in which all results of a first sketch are there."""
    trace(live)
    type_keyword(live, "motorcycle")
    rest(live, qtbot, session)
    assert len(live.browser.results.pictures) == 24
    session.gate = threading.Semaphore(0)
    return live


def runs(session):
    """What the runs were started with, in their order."""
    return [call[1:] for call in session.calls if call[0] in ("model", "edit")]


def rest(place, qtbot, session):
    """Wait until the last run that was wanted is over."""
    qtbot.waitUntil(
        lambda: not (place.runner.running or place.runner.ran is None or place.runner.stale),
        timeout=20000,
    )


def begun(session, count):
    return lambda: len(runs(session)) == count


def states(place):
    cells = {(s, v): place.browser.results.cell(s, v) for s in STYLES for v in LAMBDAS}
    return {
        key: cell.state for key, cell in cells.items() if not place.browser.results.skipped(key[0])
    }


def picked(place):
    composite = place.browser.detail.picture.icon.composite
    return composite.style, composite.lambda_s


def pick(place, style, value):
    QTest.mouseClick(place.browser.results.cell(style, value), Qt.MouseButton.LeftButton)


def add_point(place):
    """One edit: click on the outline."""
    click(place, (245, 110))


def move(place, number=0, by=8.0):
    """Some edits, of which all but the first wait: drag a point."""
    x, y = place.document.page.vertices[number]
    drag(place, (x, y), (x + by, y + by))


def age(cells):
    """Let results that are out of date have stood for long enough to turn pale."""
    for cell in cells:
        if cell.paling.timer.isActive():
            cell.paling.timer.timeout.emit()


def darkest(widget):
    """Return how light the darkest pixel of a widget is, its corners apart."""
    image = widget.grab(widget.rect().marginsRemoved(QMargins(16, 16, 16, 16))).toImage()
    grey = image.convertToFormat(QImage.Format.Format_Grayscale8)
    return int(np.frombuffer(grey.constBits(), np.uint8).min())


def strip(place):
    return place.window().pane.status


# -- the switch --------------------------------------------------------------------------------


def test_it_is_on_until_it_is_switched_off_for_good(qtbot, tmp_path):
    scope = QSettings.Scope.UserScope
    QSettings.setPath(QSettings.Format.IniFormat, scope, str(tmp_path))
    for expected in (True, False):
        window = MainWindow(FakeSession())
        qtbot.addWidget(window)
        for title in ("Sketch", "Edit"):
            place = window.workspace_of(title)
            assert place.runner.live is expected
            assert place.actions_by_name["live"].isChecked() is expected
        window.workspace.actions_by_name["live"].trigger()
        window.show_workspace(1)
        assert window.workspace.runner.live is not expected, "the mode is the same everywhere"
        if not expected:
            window.workspace.actions_by_name["live"].trigger()
        window.close()


def test_it_is_switched_with_a_key(sketching):
    for expected in (True, False):
        press(sketching, Qt.Key.Key_L, CONTROL)
        assert sketching.runner.live is expected


def test_the_switch_says_in_the_tool_tip_what_it_does(sketching):
    assert "results follow while you draw" in sketching.actions_by_name["live"].toolTip()


def test_when_off_nothing_runs_but_what_is_asked_for(drawn, qtbot, session):
    drawn.actions_by_name["live"].trigger()
    session.gate = None
    move(drawn)
    assert "press Remix to renew" in drawn.browser.results.note.text()
    qtbot.waitUntil(lambda: not drawn.preparation.runner.running)
    assert len(runs(session)) == 1
    drawn.run()
    rest(drawn, qtbot, session)
    assert runs(session)[-1] == (drawn.document.page.sketch, GridSettings())
    drawn.document.undo_stack.undo()
    move(drawn, number=1)
    assert len(runs(session)) == 2
    drawn.actions_by_name["live"].trigger()
    qtbot.waitUntil(begun(session, 3))
    assert drawn.browser.results.note.text() == ""


def test_fine_quality_begins_anew_and_is_remembered(drawn, qtbot, session):
    session.gate, before = None, drawn.browser.results.pictures
    drawn.actions_by_name["fine"].trigger()
    qtbot.waitUntil(begun(session, 2))
    rest(drawn, qtbot, session)
    assert runs(session)[-1][1].side == FINE
    assert preferred("fine", False)
    drawn.actions_by_name["fine"].trigger()
    assert drawn.browser.results.pictures == before, "they are still known"
    move(drawn)
    qtbot.waitUntil(begun(session, 3))
    rest(drawn, qtbot, session)
    assert runs(session)[-1][1].side == CANVAS


def test_fine_quality_alone_waits_to_be_asked_for(sketching, qtbot, session):
    trace(sketching)
    type_keyword(sketching, "motorcycle")
    sketching.run()
    rest(sketching, qtbot, session)
    sketching.actions_by_name["fine"].trigger()
    assert len(runs(session)) == 1
    assert "press Remix to renew" in sketching.browser.results.note.text()


def test_the_icons_of_a_sketch_that_is_opened_again_are_shown_while_it_runs(drawn, qtbot, session):
    """New lets go of the keyword; once it is back, the run keeps the thread from looking it up."""
    page, caption = drawn.document.page, drawn.keyword_panel.caption
    drawn.actions_by_name["new"].trigger()
    qtbot.waitUntil(lambda: "60 icons" not in caption.text())
    drawn.document.change("open", page.with_outline(page.vertices[:3], True))
    qtbot.waitUntil(begun(session, 2))
    qtbot.waitUntil(lambda: "60 icons" in caption.text())
    assert drawn.runner.running
    assert drawn.keyword_panel.sheet.model().rowCount() == 60
    session.gate.release(100)
    rest(drawn, qtbot, session)


# -- when it runs ------------------------------------------------------------------------------


def test_it_begins_as_soon_as_the_page_is_complete(live, qtbot, session):
    type_keyword(live, "motorcycle")
    qtbot.waitUntil(lambda: live.preparation.ready)
    for point in SQUARE:
        click(live, point)
    assert not runs(session)
    click(live, SQUARE[0])
    rest(live, qtbot, session)
    ((sketch, settings),) = runs(session)
    assert sketch == live.document.page.sketch
    assert settings == GridSettings(focus=MIDDLE, previews=True)
    assert [call[0] for call in session.calls] == ["prepare", "model"], (
        "the icons are made ready once"
    )
    assert live.browser.results.finished == 24


def test_a_name_that_is_typed_last_starts_one_run(live, qtbot, session):
    trace(live)
    type_keyword(live, "motorcycle")
    rest(live, qtbot, session)
    assert [sketch.keyword for sketch, _ in runs(session)] == ["motorcycle"]


@pytest.mark.parametrize(
    ("points", "closed", "keyword"),
    [
        ([], False, "dog"),
        (SQUARE, False, "dog"),
        ([(10, 10), (100, 100), (300, 300)], True, "dog"),
        (SQUARE, True, ""),
        (SQUARE, True, "  "),
        (SQUARE, True, "zzebra"),
    ],
)
def test_a_page_that_is_no_good_yet_says_nothing(live, qtbot, session, points, closed, keyword):
    type_keyword(live, keyword)
    qtbot.waitUntil(lambda: "…" not in live.keyword_panel.caption.text())
    if keyword.startswith("zz"):
        qtbot.waitUntil(lambda: "zebra”, “zip" in live.keyword_panel.caption.text())
    elif keyword.strip():
        qtbot.waitUntil(lambda: live.preparation.ready)
    for point in points:
        click(live, point)
    if closed:
        click(live, points[0])
    assert not live.runner.running
    assert not runs(session)
    assert not live.window().pane.notice.isVisible()


@pytest.mark.thorough
def test_every_kind_of_change_starts_again(drawn, qtbot, session):
    session.gate = None
    for change in (
        lambda: move(drawn),
        lambda: add_point(drawn),
        lambda: drawn.hold_to(Axis.HORIZONTAL),
        lambda: drawn.keyword_panel.sheet.chosen.emit(exemplar(2)),
        lambda: type_keyword(drawn, "s"),
    ):
        count = len(runs(session))
        change()
        rest(drawn, qtbot, session)
        assert len(runs(session)) > count
        assert len(drawn.browser.results.pictures) == 24


def in_sight(place):
    """The results, those that are stale apart, and what stands beside them."""
    results = place.browser.results
    cells = [results.cell(*key) for key in states(place)]
    assert all(not cell._stale and cell.paling.opacity == 1 for cell in cells)
    return results.pictures, states(place), [cell.recommended for cell in cells]


@pytest.mark.parametrize("live_mode", [True, False])
def test_undo_and_redo_show_the_results_that_were_there_at_once(drawn, qtbot, session, live_mode):
    session.gate = None
    first = in_sight(drawn)
    move(drawn)
    rest(drawn, qtbot, session)
    second = in_sight(drawn)
    assert first[0] != second[0]
    if not live_mode:
        drawn.actions_by_name["live"].trigger()
    count, stack = len(runs(session)), drawn.document.undo_stack
    session.gate = threading.Semaphore(0)
    for step, expected in ((stack.undo, first), (stack.redo, second), (stack.undo, first)):
        step()
        assert in_sight(drawn) == expected, "before any event has been waited for"
        assert not drawn.runner.running and not drawn.runner.stale
        assert drawn.browser.detail.picture in expected[0]
        assert "24 icons" in strip(drawn).label.text()
    assert len(runs(session)) == count


def test_undo_puts_an_end_to_a_run_if_its_results_are_known(drawn, qtbot, session):
    before = drawn.browser.results.pictures
    add_point(drawn)
    qtbot.waitUntil(begun(session, 2))
    drawn.document.undo_stack.undo()
    assert not drawn.runner.running
    assert drawn.browser.results.pictures == before
    assert set(states(drawn).values()) == {CellState.READY}
    qtbot.waitUntil(lambda: session.generators_closed == 2)
    assert len(runs(session)) == 2


def test_what_was_left_comes_back_with_undo(drawn, qtbot, session):
    before = drawn.browser.results.pictures
    drawn.document.change("new", drawn.blank)
    assert not drawn.browser.results.pictures
    drawn.document.undo_stack.undo()
    assert drawn.browser.results.pictures == before


def test_nothing_is_added_to_what_can_be_undone(drawn, qtbot, session):
    count = drawn.document.undo_stack.count()
    session.gate = None
    move(drawn)
    rest(drawn, qtbot, session)
    assert drawn.document.undo_stack.count() == count + 1


def test_what_does_not_count_does_not_start_again(drawn, qtbot, session):
    drawn.dim.slider.setValue(90)
    drawn.view.zoom_in()
    pick(drawn, "light", LAMBDAS[1])
    assert not drawn.runner.running and not drawn.runner.live_runner.pending


# -- while the hand moves ----------------------------------------------------------------------


def test_of_fast_edits_the_first_is_shown_and_then_the_last(drawn, qtbot, session):
    for _ in range(3):
        move(drawn)
    qtbot.waitUntil(begun(session, 2))
    last = drawn.document.page.sketch
    session.gate.release()
    qtbot.waitUntil(begun(session, 3))
    assert session.generators_closed == 2, "one run after the other"
    assert [sketch == last for sketch, _ in runs(session)] == [False, False, True]
    assert list(states(drawn).values()).count(CellState.OLD) == 24
    session.gate.release(100)
    rest(drawn, qtbot, session)
    assert len(runs(session)) == 3


def test_a_run_that_has_shown_its_preview_is_dropped_at_once(drawn, qtbot, session):
    add_point(drawn)
    qtbot.waitUntil(begun(session, 2))
    session.gate.release(3)
    qtbot.waitUntil(lambda: CellState.READY in states(drawn).values())
    assert not drawn.runner.live_runner.holding
    move(drawn)
    qtbot.waitUntil(begun(session, 3))
    assert session.generators_closed == 2
    assert set(states(drawn).values()) == {CellState.OLD}


def test_what_is_not_looked_at_is_not_enough(drawn, qtbot, session):
    """The newest edit waits for the picked result, unless its style is skipped."""
    pick(drawn, "medium", LAMBDAS[3])
    light = drawn.browser.results.cell("light", LAMBDAS[0]).picture
    add_point(drawn)
    qtbot.waitUntil(begun(session, 2))
    drawn.runner.live_runner.event.emit(light)
    assert drawn.runner.live_runner.holding
    drawn.runner.live_runner.event.emit(StyleSkipped("dark", 1, "Too few."))
    drawn.runner.live_runner.event.emit(light)
    assert drawn.runner.live_runner.holding
    drawn.runner.live_runner.event.emit(StyleSkipped("medium", 1, "Too few."))
    drawn.runner.live_runner.event.emit(light)
    assert not drawn.runner.live_runner.holding


def test_a_run_that_shows_nothing_gives_way_after_a_while(drawn, qtbot, session):
    move(drawn)
    qtbot.waitUntil(begun(session, 2))
    move(drawn)
    assert drawn.runner.live_runner.pending
    drawn.runner.live_runner.timer.timeout.emit()
    qtbot.waitUntil(begun(session, 3))
    assert runs(session)[-1][0] == drawn.document.page.sketch


def test_going_back_to_what_runs_lets_it_go_on(drawn, qtbot, session):
    drawn.hold_to(Axis.HORIZONTAL)
    qtbot.waitUntil(begun(session, 2))
    drawn.hold_to(Axis.VERTICAL)
    assert drawn.runner.live_runner.pending
    drawn.document.undo_stack.undo()
    assert not drawn.runner.live_runner.pending
    session.gate.release(100)
    rest(drawn, qtbot, session)
    assert len(runs(session)) == 2


def test_results_of_a_run_that_a_misspelt_word_ends_are_pale(drawn, qtbot, session):
    move(drawn)
    qtbot.waitUntil(begun(session, 2))
    drawn.keyword_panel.field.selectAll()
    type_keyword(drawn, "zzebra")
    qtbot.waitUntil(lambda: not drawn.runner.running)
    cells = [drawn.browser.results.cell(*place) for place in states(drawn)]
    assert all("before the last change" in cell.accessibleName() for cell in cells)
    age(cells)
    assert all(cell.paling.opacity == PALE for cell in cells)
    drawn.keyword_panel.field.selectAll()
    type_keyword(drawn, "motorcycle")
    session.gate.release(100)
    rest(drawn, qtbot, session)
    in_sight(drawn)


def test_the_large_picture_is_as_pale_as_the_picked_result(drawn, qtbot, session):
    large, results = drawn.browser.detail.large, drawn.browser.results
    cell, other = results.picked_cell, results.cell("light", LAMBDAS[1])
    fresh = darkest(large)
    move(drawn)
    qtbot.waitUntil(begun(session, 2))
    assert darkest(large) == fresh, "one that is soon replaced does not flicker"
    age([cell])
    pale = darkest(large)
    assert pale > fresh + 100
    drawn.keyword_panel.field.selectAll()
    type_keyword(drawn, "zzebra")
    qtbot.waitUntil(lambda: not drawn.runner.running)
    assert darkest(large) == pale
    age([other])
    pick(drawn, "light", LAMBDAS[1])
    assert darkest(large) == pale, "another one is out of date, too"
    drawn.keyword_panel.field.selectAll()
    type_keyword(drawn, "motorcycle")
    session.gate.release(100)
    rest(drawn, qtbot, session)
    assert darkest(large) == fresh


def test_with_live_mode_off_results_of_something_else_are_pale(drawn, qtbot, session):
    drawn.actions_by_name["live"].trigger()
    large, cell = drawn.browser.detail.large, drawn.browser.results.picked_cell
    fresh = large.grab().toImage()
    move(drawn)
    age([cell])
    assert large.paling.opacity == cell.paling.opacity == PALE
    drawn.document.undo_stack.undo()
    assert large.paling.opacity == cell.paling.opacity == 1
    assert large.grab().toImage() == fresh


def test_a_page_that_becomes_incomplete_stops_the_run_and_keeps_what_is_there(
    drawn, qtbot, session
):
    move(drawn)
    qtbot.waitUntil(begun(session, 2))
    drawn.actions_by_name["clear"].trigger()
    assert not drawn.runner.running
    assert len(drawn.browser.results.pictures) == 24
    assert not drawn.window().pane.notice.isVisible()
    drawn.document.undo_stack.undo()
    qtbot.waitUntil(begun(session, 3))


# -- what is seen ------------------------------------------------------------------------------


def test_old_results_stay_until_they_are_replaced(drawn, qtbot, session):
    before = drawn.browser.results.pictures
    shown = drawn.browser.detail.picture
    cell = drawn.browser.results.cell(*picked(drawn))
    fresh = cell.grab().toImage()
    add_point(drawn)
    qtbot.waitUntil(begun(session, 2))
    assert drawn.browser.results.pictures == before
    assert drawn.browser.detail.picture is shown
    assert set(states(drawn).values()) == {CellState.OLD}
    assert "before the last change" in cell.accessibleName()
    assert cell.isEnabled()
    assert cell.grab().toImage() == fresh, "one that is soon replaced does not flicker"
    cell.paling.timer.timeout.emit()
    assert cell.grab().toImage() != fresh
    session.gate.release(2)
    qtbot.waitUntil(lambda: cell.state is CellState.READY)
    assert list(states(drawn).values()).count(CellState.OLD) == 23
    assert len(drawn.browser.results.pictures) == 24


def test_the_grid_is_built_once(drawn, qtbot, session):
    cells = [drawn.browser.results.cell(style, value) for style in STYLES for value in LAMBDAS]
    session.gate = None
    move(drawn)
    rest(drawn, qtbot, session)
    assert cells == [drawn.browser.results.cell(s, v) for s in STYLES for v in LAMBDAS]


def test_a_preview_comes_first_and_the_finished_result_takes_its_place(drawn, qtbot, session):
    pick(drawn, "medium", LAMBDAS[3])
    cell = drawn.browser.results.cell("medium", LAMBDAS[3])
    rows = drawn.browser.detail._rows
    add_point(drawn)
    qtbot.waitUntil(begun(session, 2))
    assert runs(session)[-1][1].focus == ("medium", LAMBDAS[3])
    session.gate.release()
    qtbot.waitUntil(lambda: cell.state is CellState.PREVIEW)
    preview = cell.picture
    assert preview.preview
    assert drawn.browser.detail.picture is preview
    assert "preview · fits the sketch" in drawn.browser.detail._about.text()
    composite = preview.icon.composite
    named = [
        f"{composite.sources[k].exemplar.id}, {composite.shares[k]:.0%}"
        for k in composite.owners(SIGNIFICANT)
    ]
    shown = [rows.itemAt(number).widget().accessibleName() for number in range(rows.count())]
    assert shown == named, "the sources are those of the preview"
    assert "preview" in cell.accessibleName()
    assert drawn.browser.results.finished == 0
    looks = cell.grab().toImage()
    session.gate.release()
    qtbot.waitUntil(lambda: cell.state is CellState.READY)
    assert not cell.picture.preview
    assert drawn.browser.detail.picture is cell.picture
    assert "3 parts of 3 icons" in drawn.browser.detail._about.text()
    assert drawn.browser.results.finished == 1
    assert cell.grab().toImage() != looks, "that it was a preview could be seen"
    drawn.browser.show_event(preview)
    assert cell.state is CellState.READY
    assert cell.picture is not preview, "a preview never replaces a finished one"
    assert drawn.browser.detail.picture is cell.picture


def test_only_the_first_run_of_a_sketch_picks_the_best(drawn, qtbot, session):
    first = picked(drawn)
    assert first == ("medium", LAMBDAS[RECOMMENDED])
    session.gate = None
    session.fits = {"medium": 0.99}
    move(drawn)
    rest(drawn, qtbot, session)
    assert picked(drawn) == first
    assert drawn.browser.detail.picture is drawn.browser.results.cell(*first).picture
    stars = [key for key in states(drawn) if drawn.browser.results.cell(*key).recommended]
    assert stars == [(style, LAMBDAS[RECOMMENDED]) for style in STYLES if style != "dark"]


def test_the_focus_follows_what_the_user_picks(drawn, qtbot, session):
    session.gate = None
    for target in (("light", LAMBDAS[5]), ("medium", LAMBDAS[0])):
        pick(drawn, *target)
        move(drawn)
        rest(drawn, qtbot, session)
        assert runs(session)[-1][1].focus == target
        assert picked(drawn) == target


def test_another_sketch_begins_afresh(drawn, qtbot, session):
    pick(drawn, "medium", LAMBDAS[4])
    drawn.actions_by_name["new"].trigger()
    assert not drawn.browser.results.pictures
    session.gate = None
    type_keyword(drawn, "dog")
    trace(drawn, [(50, 60), (300, 70), (200, 300)])
    rest(drawn, qtbot, session)
    assert runs(session)[-1][1].focus == MIDDLE
    assert picked(drawn) == ("medium", LAMBDAS[RECOMMENDED])


def test_a_skipped_style_says_why_and_comes_back(drawn, qtbot, session):
    session.gate, session.skip = None, "light"
    results = drawn.browser.results
    pick(drawn, "light", LAMBDAS[2])
    move(drawn)
    rest(drawn, qtbot, session)
    assert results.skipped("light") and not results.skipped("dark")
    assert results.grid.reasons["light"].isVisible()
    assert not results.cell("light", LAMBDAS[2]).isVisible()
    assert results.cell("dark", LAMBDAS[2]).isVisible()
    assert len(results.pictures) == 24
    assert picked(drawn)[0] != "light", "what is not there cannot be looked at"
    session.skip = "dark"
    move(drawn)
    rest(drawn, qtbot, session)
    assert not results.skipped("light")
    assert results.cell("light", LAMBDAS[2]).isVisible()
    assert results.cell("light", LAMBDAS[2]).state is CellState.READY


def test_salient_regions_stay_until_the_new_ones_come(drawn, qtbot, session):
    drawn.actions_by_name["regions"].trigger()
    assert len(drawn.scene._regions) == 9
    move(drawn)
    assert len(drawn.scene._regions) == 9
    drawn.actions_by_name["clear"].trigger()
    assert not drawn.scene._regions


def test_only_what_the_user_picks_or_asks_for_is_kept(drawn, qtbot, session, window):
    session.gate = None
    assert not window.recent.pictures, "not what came by itself"
    pick(drawn, "light", LAMBDAS[1])
    move(drawn)
    rest(drawn, qtbot, session)
    assert len(window.recent.pictures) == 1
    session.gate = threading.Semaphore(0)
    move(drawn)
    session.gate.release(100)
    drawn.run()
    rest(drawn, qtbot, session)
    qtbot.waitUntil(lambda: len(window.recent.pictures) == 2)


def test_of_a_preview_that_is_picked_the_finished_result_is_kept(drawn, qtbot, session, window):
    add_point(drawn)
    qtbot.waitUntil(begun(session, 2))
    cell = drawn.browser.results.cell(*picked(drawn))
    session.gate.release()
    qtbot.waitUntil(lambda: cell.state is CellState.PREVIEW)
    pick(drawn, *picked(drawn))
    assert not window.recent.pictures
    session.gate.release()
    qtbot.waitUntil(lambda: cell.state is CellState.READY)
    assert list(window.recent.pictures) == [cell.picture]
    session.gate.release(100)
    rest(drawn, qtbot, session)
    assert len(window.recent.pictures) == 1


def test_remix_takes_over_what_runs_already(drawn, qtbot, session, window):
    add_point(drawn)
    qtbot.waitUntil(begun(session, 2))
    drawn.run()
    session.gate.release(100)
    rest(drawn, qtbot, session)
    assert len(runs(session)) == 2
    (kept,) = window.recent.pictures
    assert kept.icon.composite.lambda_s == LAMBDAS[RECOMMENDED]


# -- progress and cancel -----------------------------------------------------------------------


def test_a_short_run_shows_no_progress_but_can_be_cancelled(drawn, qtbot, session):
    drawn.runner.live_runner._calm.setInterval(FOR_EVER)
    assert strip(drawn).label.text() == "Live · 24 icons"
    add_point(drawn)
    qtbot.waitUntil(begun(session, 2))
    told = []
    drawn.runner.live_runner._job.event.connect(told.append)
    qtbot.waitUntil(lambda: sum(isinstance(one, Progress) for one in told) > 3)
    assert not strip(drawn).bar.isVisible()
    assert strip(drawn).label.text() == "Live"
    drawn.runner.live_runner._calm.stop()
    qtbot.waitUntil(strip(drawn).bar.isVisible)
    press(drawn, Qt.Key.Key_Period, CONTROL)
    assert not drawn.runner.running
    assert not strip(drawn).bar.isVisible()


def test_cancel_stops_until_the_next_change(drawn, qtbot, session):
    add_point(drawn)
    qtbot.waitUntil(begun(session, 2))
    session.gate.release(2)
    qtbot.waitUntil(lambda: drawn.browser.results.finished == 1)
    press(drawn, Qt.Key.Key_Period, CONTROL)
    qtbot.waitUntil(lambda: session.generators_closed == 2)
    assert not drawn.runner.running and not drawn.runner.live_runner.pending
    assert len(drawn.browser.results.pictures) == 24
    assert drawn.browser.results.finished == 1
    drawn.runner.renew()
    assert not drawn.runner.running
    move(drawn)
    qtbot.waitUntil(begun(session, 3))


def test_a_failure_is_told_and_the_next_change_tries_again(drawn, qtbot, session, monkeypatch):
    def broken(sketch, settings):
        yield from ()
        raise MemoryError("no room")

    session.gate = None
    with monkeypatch.context() as patch:
        patch.setattr(session, "_model", broken)
        add_point(drawn)
        qtbot.waitUntil(drawn.window().pane.notice.isVisible)
    assert "no room" in drawn.window().pane.notice.label.text()
    assert len(drawn.browser.results.pictures) == 24
    move(drawn)
    rest(drawn, qtbot, session)
    assert not drawn.window().pane.notice.isVisible()
    assert drawn.browser.results.finished == 24


@pytest.mark.parametrize("stuck", [False, True])
def test_closing_the_window_leaves_nothing_behind(drawn, qtbot, session, stuck):
    session.stuck = stuck
    move(drawn)
    qtbot.waitUntil(lambda: len(runs(session)) > 1)
    count = len(runs(session))
    drawn.window().close()
    assert session.closed.is_set()
    assert session.generators_closed == count
    assert not threads_alive(drawn.window())


# -- editing -----------------------------------------------------------------------------------


@pytest.fixture
def editing(window, qtbot):
    """An icon on the canvas of the Edit workspace, in live mode."""
    place = window.workspace_of("Edit")
    window.show_workspace(workspaces(window).index(place))
    patient(place)
    place.take(exemplar(5).pictogram)
    qtbot.waitUntil(lambda: place.document.page.icon is not None)
    qtbot.waitUntil(lambda: place.preparation.ready)
    return place


def test_an_edit_follows_its_areas_and_the_styles(editing, qtbot, session):
    assert not runs(session), "nothing is marked yet"
    points = [(40.0, 40.0), (120.0, 45.0), (115.0, 120.0), (45.0, 110.0)]
    for point in points:
        click(editing, point)
    assert not runs(session)
    click(editing, points[0])
    rest(editing, qtbot, session)
    ((edit, settings),) = runs(session)
    assert edit == editing.document.page.edit()
    assert settings == GridSettings(
        styles=("medium", "dark"), focus=("dark", LAMBDAS[4]), previews=True
    )
    assert not editing.window().pane.notice.isVisible()
    drag(editing, points[2], (100, 100))
    rest(editing, qtbot, session)
    assert runs(session)[-1][0] == editing.document.page.edit()
    assert runs(session)[-1][1].focus == ("medium", LAMBDAS[RECOMMENDED])
    before = editing.browser.results.pictures
    session.gate = threading.Semaphore(0)
    count = len(runs(session))
    editing.actions_by_name["styles"].trigger()
    qtbot.waitUntil(begun(session, count + 1))
    assert runs(session)[-1][1].styles == STYLES
    assert editing.browser.results.pictures == before, "those of the same styles stay in sight"
    assert picked(editing) == ("medium", LAMBDAS[RECOMMENDED])
    session.gate.release(100)
    rest(editing, qtbot, session)
    editing.actions_by_name["clear"].trigger()
    assert not editing.runner.running
    assert not editing.window().pane.notice.isVisible()


def test_the_pick_stays_while_a_run_goes_on_and_is_the_best_in_the_end(drawn, qtbot):
    """Rows come one after another, each with a better star; the pick moves once, at the end."""
    from iconstudio.gui.gallery.browser import ResultsBrowser

    board, results = ResultsBrowser("Welcome", "Closer"), drawn.browser.results.pictures
    qtbot.addWidget(board)
    settings = GridSettings()
    scored = [
        replace(one, preview=False, icon=replace(one.icon, score=replace(
            one.icon.score, seam=0.1 + 0.8 * number / len(results))))
        for number, one in enumerate(results)
    ]  # fmt: skip
    picks = []
    board.results.picked.connect(lambda one: picks.append(one and one.icon.composite))
    board.begin(settings)
    picks.clear()
    for one in scored:
        board.show_event(one)
        board.show_event(Recommended(one.icon.composite.style, one.icon.composite.lambda_s))
    assert {(c.style, c.lambda_s) for c in picks} == {
        (scored[0].icon.composite.style, scored[0].icon.composite.lambda_s)
    }
    board.end()
    assert board.detail.picture is scored[-1]


def test_what_differs_waits_for_the_place_of_what_is_picked(drawn):
    results = drawn.browser.results
    picked, other = results.pictures[:2]
    results.pick(picked.icon.composite.style, picked.icon.composite.lambda_s)
    for before in (picked, other):
        composite = replace(before.icon.composite, without=("set:name",))
        drawn.show_event(picture_of(replace(before.icon, composite=composite)))
    assert drawn.detail.picture is picked
    assert results.pictures[0] is picked
    assert results.pictures[1].icon.composite.without == ("set:name",)
    results.pick(other.icon.composite.style, other.icon.composite.lambda_s)
    assert "for variety" in drawn.detail._about.text()
    assert results.pictures[0].icon.composite.without == ("set:name",)


def test_a_symmetric_result_comes_before_what_waits_for_its_place(drawn):
    results = drawn.browser.results
    picked, other = results.pictures[:2]
    results.pick(picked.icon.composite.style, picked.icon.composite.lambda_s)
    waiting = replace(picked.icon.composite, without=("set:name",))
    mirrored = replace(picked.icon.composite, symmetry=Axis.HORIZONTAL)
    for composite in (waiting, mirrored):
        drawn.show_event(picture_of(replace(picked.icon, composite=composite)))
    results.pick(other.icon.composite.style, other.icon.composite.lambda_s)
    assert results.pictures[0].icon.composite.symmetry is Axis.HORIZONTAL
    results.symmetric_switch.button.click()
    own = results.pictures[0].icon.composite
    assert (own.symmetry, own.without) == (None, waiting.without)
    results.symmetric_switch.button.click()


def test_the_best_that_waits_is_picked_in_the_end(drawn, qtbot):
    from iconstudio.gui.gallery.browser import ResultsBrowser

    board, (first, *_) = ResultsBrowser("Welcome", "Closer"), drawn.browser.results.pictures
    qtbot.addWidget(board)
    board.begin(GridSettings())
    board.show_event(replace(first, preview=False))
    composite = replace(first.icon.composite, without=("set:name",))
    other = picture_of(replace(first.icon, composite=composite))
    board.show_event(other)
    assert board.detail.picture.icon.composite.without == ()
    board.show_event(Recommended(composite.style, composite.lambda_s))
    board.end()
    assert board.detail.picture.icon.composite.without == ("set:name",)


def test_a_switch_says_whether_symmetric_results_stand_in_the_places_of_others(drawn):
    results = drawn.browser.results
    button, before = results.symmetric_switch.button, results.pictures[0]
    assert not button.isVisible()
    one = replace(before.icon.composite, symmetry=Axis.HORIZONTAL)
    symmetric = picture_of(replace(before.icon, composite=one))
    cell = results.cell(one.style, one.lambda_s)
    cell.click()
    drawn.show_event(symmetric)
    assert button.isVisible()
    for _ in range(2):
        assert cell.picture is drawn.detail.picture is symmetric
        assert "symmetric" in cell.accessibleName()
        button.click()
        assert cell.picture is drawn.detail.picture is before
        assert "symmetric" not in cell.accessibleName()
        assert preferred("symmetric", True) is False
        button.click()
    drawn.browser.clear()
    assert not button.isVisible()


def test_nothing_is_starred_where_nothing_was_made(drawn):
    style = drawn.browser.results.pictures[0].icon.composite.style
    drawn.browser.show_event(Recommended(style, None))
    assert not any(drawn.browser.results.cell(style, value).recommended for value in LAMBDAS)


def test_what_cannot_be_remixed_says_why_without_being_asked(live, qtbot):
    slim = Sketch(Polygon.of([(0, 0), (200, 0), (200, 1), (0, 1)]), "pencil")
    edits.load_sketch(live.document, slim)
    assert "too slim" in live.browser.results.note.text()
    edits.load_sketch(live.document, Sketch(Polygon.of(SQUARE), "box"))
    assert live.browser.results.note.text() == ""
