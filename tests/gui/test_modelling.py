"""Name, remix, watch, pick and cancel, in the real window with the session that needs no icons."""

import itertools
import threading
import time
from dataclasses import replace

import pytest
from fake_session import RECOMMENDED, FakeSession, exemplar
from hands import SQUARE, click, press, threads_alive, trace, type_keyword
from images import blank
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtGui import QColor
from PySide6.QtTest import QTest

from iconstudio.gui.gallery.cell import CellState
from iconstudio.gui.gallery.detail import SourceRow
from iconstudio.gui.pictures.mipmap import Mipmap
from iconstudio.gui.pictures.picture import Display, SourcePicture
from iconstudio.gui.theme.elided import ElidedLabel
from iconstudio.gui.window.main_window import MainWindow
from iconstudio.model import Credit, Pictogram, Placement, Source
from iconstudio.workflows.events import Retrieved
from iconstudio.workflows.grid import GridSettings

STYLES = GridSettings().styles
LAMBDAS = GridSettings().lambdas


def cells(sketching, state):
    return [
        (style, value)
        for style in STYLES
        for value in LAMBDAS
        if sketching.browser.results.cell(style, value).state is state
    ]


@pytest.fixture
def ready(sketching, qtbot):
    """A window with a finished outline and a name."""
    trace(sketching)
    type_keyword(sketching, "motorcycle")
    return sketching


def finish(sketching, qtbot):
    qtbot.waitUntil(lambda: not sketching.runner.running, timeout=20000)


def test_icons_are_found_while_the_user_still_draws(sketching, qtbot, session):
    click(sketching, SQUARE[0])
    type_keyword(sketching, "motorcycle")
    sheet = sketching.keyword_panel.sheet.model()
    qtbot.waitUntil(lambda: sheet.rowCount() == 60)
    click(sketching, SQUARE[1])
    assert [call[1] for call in session.calls] == ["motorcycle"], "not once for each letter"
    assert threading.get_ident() not in session.thread_ids
    assert "60 icons found" in sketching.keyword_panel.caption.text()


def test_how_the_name_was_read_is_said_also_when_icons_are_left_out(sketching, qtbot):
    type_keyword(sketching, "doog")
    caption = sketching.keyword_panel.caption
    qtbot.waitUntil(lambda: "“doog” was read as “dog”. 60 icons found" in caption.text())
    excluded = sketching.keyword_panel.sheet.model().entries[0].id
    sketching.keyword_panel.set_sketch("doog", frozenset({excluded}))
    assert "“doog” was read as “dog”. 60 icons found · 1 left out" in caption.text()


def test_an_unknown_name_says_what_is_near(sketching, qtbot):
    type_keyword(sketching, "zzebra")
    qtbot.waitUntil(lambda: "zebra”, “zip" in sketching.keyword_panel.caption.text())
    assert sketching.keyword_panel.caption.property("error")


def test_a_run_fills_the_grid_cell_by_cell(ready, qtbot, session):
    session.gate = threading.Semaphore(0)
    press(ready, Qt.Key.Key_Return, Qt.KeyboardModifier.ControlModifier)
    assert ready.runner.running
    assert len(cells(ready, CellState.PENDING)) == 32
    for count in (1, 2, 3):
        session.gate.release()
        qtbot.waitUntil(lambda count=count: len(ready.browser.results.pictures) == count)
        assert ready.window().pane.status.button.isVisible()
    assert cells(ready, CellState.READY) == [("lightest", value) for value in LAMBDAS[:3]]
    said = ready.window().pane.status.label.text()
    assert f"{len(ready.browser.results.pictures)} finished" in said
    session.gate.release(100)
    finish(ready, qtbot)
    assert len(ready.browser.results.pictures) == 24
    assert not cells(ready, CellState.PENDING)
    assert not ready.window().pane.status.button.isVisible()


def test_a_style_that_is_skipped_says_why_in_its_row(ready, qtbot):
    ready.run()
    finish(ready, qtbot)
    reason = ready.browser.results.grid.reasons["dark"]
    assert reason.isVisible()
    assert reason.text() == "Only 4 icons are dark; at least 9 are needed."
    assert not ready.browser.results.cell("dark", LAMBDAS[0]).isVisible()


def test_a_run_closes_an_open_outline(sketching, qtbot, session):
    for point in SQUARE:
        click(sketching, point)
    type_keyword(sketching, "dog")
    QTest.keyClick(sketching.keyword_panel.field, Qt.Key.Key_Return)
    assert sketching.document.page.closed
    finish(sketching, qtbot)
    assert [call[0] for call in session.calls] == ["prepare", "model"]
    assert session.calls[1][1] == sketching.document.page.sketch


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
def test_what_is_missing_is_said_in_the_window(sketching, session, points, keyword, part):
    for point in points:
        click(sketching, point)
    type_keyword(sketching, keyword)
    QTest.mouseClick(sketching.keyword_panel.button, Qt.MouseButton.LeftButton)
    assert sketching.window().pane.notice.isVisible()
    assert part in sketching.window().pane.notice.label.text()
    assert not sketching.runner.running
    assert not [call for call in session.calls if call[0] == "model"]


def test_messages_move_nothing_and_hints_do_not_look_like_errors(sketching):
    click(sketching, SQUARE[0])
    pane, before = sketching.window().pane, sketching.view.mapToGlobal(QPoint(0, 0))
    size = sketching.view.size()
    sketching.run()
    notice = pane.notice
    assert notice.isVisible() and notice.property("hint")
    assert sketching.view.mapToGlobal(QPoint(0, 0)) == before
    assert sketching.view.size() == size
    assert pane.rect().contains(notice.geometry())
    assert notice.geometry().right() < pane.status.bar.mapTo(pane, QPoint()).x()
    sketching.failed.emit("The disk is full. " * 40)
    assert not notice.property("hint")
    assert pane.rect().contains(notice.geometry())
    assert sketching.view.size() == size


def test_an_outline_that_crosses_itself_is_taken_and_told(sketching, qtbot):
    trace(sketching, [(100, 100), (400, 400), (400, 100), (100, 380)])
    type_keyword(sketching, "dog")
    sketching.run()
    assert "crosses itself" in sketching.window().pane.notice.label.text()
    finish(sketching, qtbot)
    assert len(sketching.browser.results.pictures) == 24


def test_cancel_keeps_what_is_finished(ready, qtbot, session):
    session.gate = threading.Semaphore(5)
    ready.run()
    qtbot.waitUntil(lambda: len(ready.browser.results.pictures) == 5)
    QTest.mouseClick(ready.window().pane.status.button, Qt.MouseButton.LeftButton)
    assert not ready.runner.running
    assert len(cells(ready, CellState.BLANK)) == 27
    qtbot.waitUntil(lambda: session.generators_closed == 1)
    session.gate.release(100)
    qtbot.wait(50)
    assert len(ready.browser.results.pictures) == 5
    ready.run()
    finish(ready, qtbot)
    assert len(ready.browser.results.pictures) == 24


def test_cancelling_a_search_does_not_leave_it_pending(sketching, qtbot, session):
    session.search_gate = threading.Semaphore(0)
    type_keyword(sketching, "dog")
    qtbot.waitUntil(lambda: "Looking for “dog”" in sketching.keyword_panel.caption.text())
    qtbot.waitUntil(sketching.actions_by_name["cancel"].isEnabled)
    sketching.actions_by_name["cancel"].trigger()
    assert "Looking" not in sketching.keyword_panel.caption.text()
    session.search_gate = None
    type_keyword(sketching, "s")
    qtbot.waitUntil(lambda: "60 icons" in sketching.keyword_panel.caption.text())


def test_a_cache_that_cannot_be_written_is_told_once(sketching, qtbot, session):
    session.trouble = "The disk is full. Make room."
    type_keyword(sketching, "dog")
    qtbot.waitUntil(sketching.window().pane.notice.isVisible)
    assert sketching.window().pane.notice.label.text() == session.trouble
    type_keyword(sketching, "s")
    qtbot.waitUntil(
        lambda: (
            session.calls[-1][1] == "dogs" and not sketching.window().pane.status.bar.isVisible()
        )
    )
    assert not sketching.window().pane.notice.isVisible()


def test_a_message_goes_with_the_next_edit(sketching):
    sketching.run()
    assert sketching.window().pane.notice.isVisible()
    click(sketching, SQUARE[0])
    assert not sketching.window().pane.notice.isVisible()


def test_pressing_remix_twice_does_not_begin_again(ready, qtbot, session):
    session.gate = threading.Semaphore(2)
    ready.run()
    qtbot.waitUntil(lambda: len(ready.browser.results.pictures) == 2)
    ready.run()
    assert len(ready.browser.results.pictures) == 2
    session.gate.release(100)
    finish(ready, qtbot)
    assert sum(call[0] == "model" for call in session.calls) == 1


def test_remix_after_an_edit_drops_the_run_under_way(ready, qtbot, session):
    session.gate = threading.Semaphore(2)
    ready.run()
    qtbot.waitUntil(lambda: len(ready.browser.results.pictures) == 2)
    click(ready, (250, 110))
    assert "earlier sketch" in ready.browser.results.note.text()
    session.gate.release(100)
    ready.run()
    finish(ready, qtbot)
    assert ready.browser.results.note.text() == ""
    assert len(ready.browser.results.pictures) == 24
    assert sum(call[0] == "model" for call in session.calls) == 2


def test_a_failure_on_the_way_is_told_and_the_window_goes_on(ready, qtbot, session, monkeypatch):
    def broken(sketch, settings):
        yield from ()
        raise MemoryError("no room")

    monkeypatch.setattr(session, "_model", broken)
    ready.run()
    finish(ready, qtbot)
    assert "MemoryError: no room" in ready.window().pane.notice.label.text()
    assert not cells(ready, CellState.PENDING)
    monkeypatch.undo()
    ready.run()
    finish(ready, qtbot)
    assert len(ready.browser.results.pictures) == 24
    assert not ready.window().pane.notice.isVisible()


def stacked(scale, *cells):
    """Whether square cells lie one below the other, and the first below the scale."""
    boxes = [one.geometry() for one in (scale, *cells)]
    gaps = [two.top() - one.bottom() - 1 for one, two in itertools.pairwise(boxes)]
    square = all(abs(one.width() - one.height()) <= 2 for one in boxes[1:])
    return square and all(0 <= gap <= 1 for gap in gaps)


def test_cells_are_no_higher_than_wide_and_begin_at_the_top(ready, qtbot):
    """Also after a run of fewer styles than before."""
    results, window = ready.browser.results, ready.window()
    window.resize(1280, 1400)
    for styles in (STYLES, STYLES[:2], STYLES[:1]):
        results.begin(styles, LAMBDAS)
        column = [results.cell(style, LAMBDAS[0]) for style in styles]
        qtbot.waitUntil(lambda column=column: stacked(results.grid.scale, *column))
    window.resize(1280, 720)
    results.begin(STYLES, LAMBDAS)
    cell = results.cell(STYLES[-1], LAMBDAS[-1])
    qtbot.waitUntil(lambda: cell.mapTo(results, cell.rect().bottomRight()).y() < results.height())
    assert 48 <= cell.height() <= cell.width()


def test_an_icon_that_was_made_thanks_all_that_it_was_made_of(sketching, qtbot):
    made = replace(
        exemplar(1),
        pictogram=Pictogram(
            "made:new-1",
            "",
            Credit("new", "you, with Iconstudio", "CC-BY-4.0", "", ""),
            tuple(exemplar(number).pictogram for number in (2, 3)),
        ),
    )
    rows = [
        SourceRow(SourcePicture(Source(one, Placement()), 0.4, QColor("red"), Mipmap.of(image, 8)))
        for one, image in ((made, blank(9, 9)), (exemplar(2), blank(9, 9)))
    ]
    for row in rows:
        qtbot.addWidget(row)
    of_made, of_other = ([*row.findChildren(ElidedLabel)] for row in rows)
    assert [label.openExternalLinks() for label in of_made] == [False, False]
    assert "open" not in of_made[0].toolTip()
    assert of_made[1].accessibleName() == "made of 2 icons · CC-BY-4.0"
    assert of_made[1].toolTip().splitlines() == [
        "cross 2, by Ada Example, CC-BY-4.0",
        "triangle 3, by Ada Example, CC-BY-4.0",
    ]
    assert of_other[0].openExternalLinks()
    assert "open https://example.org/cross-2" in of_other[0].toolTip()
    assert of_other[1].toolTip() == "cross 2, by Ada Example, CC-BY-4.0"


def test_picking_shows_the_icon_and_its_sources(ready, qtbot):
    ready.run()
    finish(ready, qtbot)
    target = ready.browser.results.cell("medium", LAMBDAS[3])
    QTest.mouseClick(target, Qt.MouseButton.LeftButton)
    assert ready.browser.detail.picture is target.picture
    rows = [
        ready.browser.detail._rows.itemAt(i).widget()
        for i in range(ready.browser.detail._rows.count())
    ]
    assert [row.accessibleName() for row in rows] == [
        "shapes:ring-0, 50%",
        "shapes:frame-1, 30%",
        "shapes:cross-2, 20%",
    ]
    assert ready.browser.detail._about.text() == (
        f"λ {LAMBDAS[3]:.2f} · 3 parts of 3 icons · fits the sketch by 87%"
    )


def picked(place):
    composite = place.browser.detail.picture.icon.composite
    return composite.style, composite.lambda_s


def test_the_first_recommended_result_takes_the_place_of_the_very_first(ready, qtbot, session):
    session.gate = threading.Semaphore(1)
    ready.run()
    qtbot.waitUntil(lambda: ready.browser.detail.picture is not None)
    assert picked(ready) == ("lightest", LAMBDAS[0])
    session.gate.release(100)
    finish(ready, qtbot)
    assert picked(ready) == ("lightest", LAMBDAS[RECOMMENDED])
    cell = ready.browser.results.cell("medium", LAMBDAS[RECOMMENDED])
    assert "Look here first" in cell.toolTip()
    assert "recommended" in cell.accessibleName()
    unmarked = ready.browser.results.cell("medium", LAMBDAS[RECOMMENDED + 1])
    assert "Look here" not in unmarked.toolTip()
    plain = cell.grab().toImage()
    cell.recommended = False
    assert cell.grab().toImage() != plain, "the mark can be seen"


def test_the_best_of_the_recommended_results_is_picked_in_the_end(ready, qtbot, session, window):
    session.fits = {"lightest": 0.5, "light": 0.9, "medium": 0.7}
    ready.run()
    finish(ready, qtbot)
    assert picked(ready) == ("light", LAMBDAS[RECOMMENDED])
    assert list(window.recent.pictures) == [ready.browser.detail.picture]


def test_a_recommendation_does_not_take_away_what_the_user_picked(ready, qtbot, session):
    session.gate = threading.Semaphore(2)
    ready.run()
    qtbot.waitUntil(lambda: len(ready.browser.results.pictures) == 2)
    target = ready.browser.results.cell("lightest", LAMBDAS[1])
    QTest.mouseClick(target, Qt.MouseButton.LeftButton)
    session.gate.release(100)
    finish(ready, qtbot)
    assert picked(ready) == ("lightest", LAMBDAS[1])


def test_the_grid_is_walked_with_the_arrow_keys(ready, qtbot):
    ready.run()
    finish(ready, qtbot)
    ready.browser.results.cell("lightest", LAMBDAS[0]).setFocus()
    for key in (Qt.Key.Key_Right, Qt.Key.Key_Right, Qt.Key.Key_Down):
        QTest.keyClick(ready.window().focusWidget(), key)
    picked = ready.browser.detail.picture.icon.composite
    assert (picked.style, picked.lambda_s) == ("light", LAMBDAS[2])
    for key in (Qt.Key.Key_Down, Qt.Key.Key_Down, Qt.Key.Key_Down):
        QTest.keyClick(ready.window().focusWidget(), key)
    picked = ready.browser.detail.picture.icon.composite
    assert picked.style == "medium", "the row below was skipped"


def test_colour_code_and_icon_are_switched(ready, qtbot):
    ready.run()
    finish(ready, qtbot)
    cell = ready.browser.results.cell("light", LAMBDAS[1])
    ready.actions_by_name["plain"].trigger()
    plain = cell.grab().toImage()
    ready.actions_by_name["coded"].trigger()
    coded = cell.grab().toImage()
    assert plain != coded
    assert any(coded.pixelColor(x, y).hsvSaturation() > 100 for x in range(70) for y in range(70))
    plainly = ready.browser.results.switch.segments[Display.PLAIN]
    QTest.mouseClick(plainly, Qt.MouseButton.LeftButton)
    assert cell.grab().toImage() == plain
    assert not ready.actions_by_name["coded"].isChecked()


def test_how_results_are_shown_is_remembered_in_all_workspaces(ready):
    window = ready.window()
    assert ready.actions_by_name["both"].isChecked()
    ready.actions_by_name["coded"].trigger()
    window.show_workspace(3)
    assert window.workspace.detail.switch.segments[Display.CODED].isChecked()
    window.workspace.actions_by_name["plain"].trigger()
    window.show_workspace(0)
    assert ready.browser.results.switch.segments[Display.PLAIN].isChecked()
    again = MainWindow(FakeSession())
    again.show()
    assert again.workspace.actions_by_name["plain"].isChecked()
    again.close()


def test_an_icon_is_left_out_and_taken_back(ready, qtbot, session):
    thumbnails = ready.keyword_panel.sheet
    qtbot.waitUntil(lambda: thumbnails.model().rowCount() == 60)
    spot = thumbnails.visualRect(thumbnails.model().index(2)).center()
    QTest.mouseClick(thumbnails.viewport(), Qt.MouseButton.LeftButton, pos=spot)
    assert ready.document.page.sketch.exclude == {"shapes:cross-2"}
    assert "left out" in ready.keyword_panel.caption.text()
    qtbot.waitUntil(lambda: session.calls[-1][2] == {"shapes:cross-2"})
    qtbot.waitUntil(lambda: "59 icons" in ready.keyword_panel.caption.text())
    assert thumbnails.model().rowCount() == 60, "it stays in sight, struck out"
    assert thumbnails.model().index(2).data() == "shapes:cross-2, left out"
    ready.keyword_panel.caption.linkActivated.emit("#")
    assert not ready.document.page.sketch.exclude
    ready.document.undo_stack.undo()
    assert ready.document.page.sketch.exclude == {"shapes:cross-2"}


def test_an_icon_that_is_less_alike_is_brought_in_by_a_click(ready, qtbot):
    panel, thumbnails = ready.keyword_panel, ready.keyword_panel.sheet
    qtbot.waitUntil(lambda: thumbnails.model().rowCount() == 60)
    icons = tuple(thumbnails.model().entries[:6])
    less = [icon.id for icon in icons[4:]]
    panel.show_retrieved(Retrieved("dog", icons, strangers=frozenset(less)))
    rule = thumbnails.model().entries[4]
    assert thumbnails.model().index(4).data() == rule.text == "Less alike: click one to bring it in"
    assert thumbnails.model().index(6).data() == f"{less[1]}, less alike"
    thumbnails.chosen.emit(icons[5])
    assert ready.document.page.sketch.include == {less[1]}
    assert thumbnails.model().entries == [*icons[:4], icons[5], rule, icons[4]]
    assert not ready.document.page.sketch.exclude
    ready.document.undo_stack.undo()
    assert thumbnails.model().entries == [*icons[:4], rule, *icons[4:]]
    assert ready.document.undo_stack.redoText() == "bring icon in"
    for _ in range(2):
        thumbnails.chosen.emit(icons[4])
    assert not ready.document.page.sketch.include
    assert ready.document.undo_stack.undoText() == "leave icon out"


def test_undo_in_the_keyword_field_is_the_documents(sketching):
    trace(sketching)
    type_keyword(sketching, "dog")
    control = Qt.KeyboardModifier.ControlModifier
    QTest.keyClick(sketching.keyword_panel.field, Qt.Key.Key_Z, control)
    assert sketching.document.page.sketch.keyword == ""
    assert sketching.keyword_panel.field.text() == ""
    QTest.keyClick(sketching.keyword_panel.field, Qt.Key.Key_Z, control)
    assert not sketching.document.page.closed


def test_regions_are_shown_on_the_outline_they_belong_to(ready, qtbot):
    ready.run()
    finish(ready, qtbot)
    plain = ready.view.grab().toImage()
    ready.actions_by_name["regions"].trigger()
    assert ready.view.grab().toImage() != plain
    click(ready, (250, 110))
    assert not ready.scene._regions


@pytest.mark.parametrize("stuck", [False, True])
def test_closing_the_window_while_it_works_leaves_no_thread(ready, qtbot, session, stuck):
    session.gate = threading.Semaphore(1)
    session.stuck = stuck
    ready.run()
    qtbot.waitUntil(lambda: any(call[0] == "model" for call in session.calls))
    ready.window().close()
    assert session.closed.is_set()
    assert session.generators_closed == 1
    assert not threads_alive(ready.window())


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
