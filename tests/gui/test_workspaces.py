"""Several workspaces in one window: each keeps its page and its work; icons go between them."""

import threading
from dataclasses import replace

import pytest
from fake_session import RECOMMENDED
from hands import SQUARE, click, shown, threads_alive, trace, type_keyword, workspaces
from PySide6.QtCore import Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QPushButton, QToolButton

from iconstudio.gui.exchange.dragging import unpacked
from iconstudio.gui.gallery import recent
from iconstudio.gui.window.main_window import MainWindow
from iconstudio.gui.workspaces.actions import Entry
from iconstudio.gui.workspaces.base import Workspace
from iconstudio.gui.workspaces.sketching.workspace import SketchWorkspace
from iconstudio.workflows.criteria import set_keyword
from iconstudio.workflows.grid import GridSettings
from iconstudio.workflows.modelling.page import SketchPage
from iconstudio.workflows.modelling.spec import MODELLING

LAMBDAS = GridSettings().lambdas
LEFT = Qt.MouseButton.LeftButton


class Pad(Workspace):
    """A workspace that takes icons and does nothing with them."""

    page_type = SketchPage
    entries = (Entry("dip", "Dip the pen", keys="D", do=lambda pad: pad.dip(), menu="&View"),)

    def build(self):
        self.taken = []
        self.make_actions()
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def dip(self):
        self.remarked.emit("dipped")

    def enter(self):
        self.setFocus()

    def take(self, pictogram):
        self.taken.append(pictogram)


PAD = replace(
    MODELLING, name="pad", title="Pad", invitation="Add to pad", workspace=f"{__name__}:Pad"
)


@pytest.fixture
def house(qtbot, session):
    """A window with two workspaces."""
    with shown(MainWindow(session, (MODELLING, PAD)), qtbot) as window:
        yield window


@pytest.fixture
def sketch(house):
    trace(house.workspace)
    type_keyword(house.workspace, "motorcycle")
    return house.workspace


@pytest.fixture
def done(sketch, qtbot):
    """The workspace of the sketch, with a finished run."""
    sketch.run()
    qtbot.waitUntil(lambda: not sketch.runner.running, timeout=20000)
    return sketch


def switch(house, number):
    QTest.keyClick(house, Qt.Key.Key_1 + number, Qt.KeyboardModifier.ControlModifier)


def items(menu):
    return {action.text(): action for action in menu.actions() if action.text()}


def entry(house, number):
    """Return the middle of an entry of the recent strip."""
    return house.recent.visualRect(house.recent.model().index(number, 0)).center()


def choose(house, number, text):
    """Click an entry of the recent strip and choose an item of its menu."""
    QTest.mouseClick(house.recent.viewport(), LEFT, pos=entry(house, number))
    menu = house.recent.menu
    assert menu.isVisible()
    QTest.mouseClick(menu, LEFT, pos=menu.actionGeometry(items(menu)[text]).center())


def test_the_switch_and_its_keys_lead_from_workspace_to_workspace(house):
    assert isinstance(house.workspace, SketchWorkspace)
    switch(house, 1)
    assert isinstance(house.workspace, Pad)
    assert house.workspace.isVisible()
    buttons = {button.accessibleName(): button for button in house.modes.findChildren(QToolButton)}
    assert buttons["Pad"].isChecked()
    QTest.mouseClick(buttons["Sketch"], LEFT)
    assert isinstance(house.workspace, SketchWorkspace)
    assert house.workspace.view.hasFocus()


def test_undo_is_that_of_the_workspace_in_sight(house):
    sketch, pad = workspaces(house)
    click(sketch, SQUARE[0])
    switch(house, 1)
    set_keyword(pad.document, "cat")
    control = Qt.KeyboardModifier.ControlModifier
    QTest.keyClick(pad, Qt.Key.Key_Z, control)
    assert pad.document.page.sketch.keyword == ""
    assert len(sketch.document.page.vertices) == 1
    QTest.keyClick(pad, Qt.Key.Key_Z, control)
    assert len(sketch.document.page.vertices) == 1
    switch(house, 0)
    QTest.keyClick(sketch.view, Qt.Key.Key_Z, control)
    assert sketch.document.page.empty


def test_menus_and_keys_are_those_of_the_workspace_in_sight(house):
    view = house._menus["&View"]
    assert "&Trace outline" in items(view)
    switch(house, 1)
    assert "&Trace outline" not in items(view)
    assert "Dip the pen" in items(view)
    QTest.keyClick(house.workspace, Qt.Key.Key_D)
    assert house.pane.status.label.text() == "dipped"
    switch(house, 0)
    assert "Dip the pen" not in items(view)
    QTest.keyClick(house.workspace.view, Qt.Key.Key_D)
    assert house.pane.status.label.text() != "dipped"


def test_a_run_goes_on_while_the_user_is_elsewhere(house, sketch, qtbot, session):
    session.gate = threading.Semaphore(1)
    sketch.run()
    qtbot.waitUntil(lambda: len(sketch.browser.results.pictures) == 1)
    switch(house, 1)
    assert not house.pane.status.button.isVisible(), "the progress is that of the other workspace"
    session.gate.release(100)
    qtbot.waitUntil(lambda: not sketch.runner.running, timeout=20000)
    switch(house, 0)
    assert len(sketch.browser.results.pictures) == 24
    assert house.pane.status.label.text() == "24 icons"


def test_what_went_wrong_elsewhere_is_told_there(house, sketch, qtbot, session, monkeypatch):
    def broken(sketch, settings):
        yield from ()
        raise MemoryError("no room")

    monkeypatch.setattr(session, "_model", broken)
    sketch.run()
    switch(house, 1)
    qtbot.waitUntil(lambda: not sketch.runner.running)
    assert not house.pane.notice.isVisible()
    switch(house, 0)
    assert "no room" in house.pane.notice.label.text()
    assert house.pane.notice.isVisible()


def test_a_picked_result_is_sent_from_the_details(house, done):
    send = next(b for b in done.browser.detail.findChildren(QPushButton) if b.text() == "Send to")
    assert send.isVisible()
    items(send.menu())["Add to pad"].trigger()
    pad = house.workspace
    assert isinstance(pad, Pad)
    (icon,) = pad.taken
    assert icon == done.picture.pictogram()
    assert icon.id.startswith("made:motorcycle")
    assert icon.made_of[0].id == "shapes:ring-0"
    assert house.recent.pictures[0] is done.picture


def test_any_result_is_sent_from_its_context_menu(house, done):
    cell = done.browser.results.cell("medium", LAMBDAS[5])
    spot = cell.rect().center()
    reason = QContextMenuEvent.Reason.Mouse
    QApplication.sendEvent(cell, QContextMenuEvent(reason, spot, cell.mapToGlobal(spot)))
    items(done.menu)["Add to pad"].trigger()
    assert workspaces(house)[1].taken == [cell.picture.pictogram()]
    assert house.recent.pictures[0] is cell.picture


def test_alone_there_is_nowhere_to_send_to(window, qtbot):
    send = [b for b in window.findChildren(QPushButton) if b.text() == "Send to"]
    assert not any(button.isVisible() for button in send)


def test_the_strip_keeps_the_recommended_result_and_what_the_user_picks(house, done):
    recommended = done.browser.results.cell("lightest", LAMBDAS[RECOMMENDED]).picture
    assert list(house.recent.pictures) == [recommended]
    other = done.browser.results.cell("medium", LAMBDAS[0])
    QTest.mouseClick(other, LEFT)
    assert list(house.recent.pictures) == [other.picture, recommended]
    QTest.mouseClick(done.browser.results.cell("lightest", LAMBDAS[RECOMMENDED]), LEFT)
    assert list(house.recent.pictures) == [recommended, other.picture], (
        "each once, the latest in front"
    )


def test_a_run_that_recommends_nothing_leaves_its_first_result(house, sketch, qtbot, session):
    session.gate = threading.Semaphore(3)
    sketch.run()
    qtbot.waitUntil(lambda: len(sketch.browser.results.pictures) == 3)
    assert list(house.recent.pictures) == []
    sketch.cancel()
    assert list(house.recent.pictures) == [
        sketch.browser.results.cell("lightest", LAMBDAS[0]).picture
    ]


def test_the_strip_keeps_so_many_and_no_more(house, done, monkeypatch):
    monkeypatch.setattr(recent, "MOST", 5)
    empty = house.recent.grab().toImage()
    for picture in done.browser.results.pictures:
        house.recent.keep(picture)
    assert len(house.recent.pictures) == 5
    assert house.recent.grab().toImage() != empty
    newest = house.recent.pictures[0]
    assert newest is done.browser.results.pictures[-1]
    assert house.recent.model().index(0, 0).data() == newest.name == "motorcycle, medium"


def test_an_empty_strip_says_what_it_is_for(house):
    assert house.recent.accessibleDescription() == recent.EMPTY
    shown = house.recent.grab().toImage()
    colours = {shown.pixelColor(x, shown.height() // 2).name() for x in range(shown.width() // 2)}
    assert len(colours) > 3


def test_a_recent_result_is_sent_saved_and_removed(house, done, qtbot, tmp_path, monkeypatch):
    picture = house.recent.pictures[0]
    path = tmp_path / "icon.svg"
    monkeypatch.setattr(house.saver, "ask_path", lambda *words: path)
    choose(house, 0, "Save SVG…")
    qtbot.waitUntil(path.exists)
    assert picture.icon.path.svg() in path.read_text("utf-8")
    choose(house, 0, "Add to pad")
    assert workspaces(house)[1].taken == [picture.pictogram()]
    choose(house, 0, "Copy SVG")
    assert picture.icon.path.svg() in QApplication.clipboard().text()
    choose(house, 0, "Remove")
    assert list(house.recent.pictures) == []


def test_the_strip_is_worked_by_keys(house, done):
    QTest.mouseClick(done.browser.results.cell("medium", LAMBDAS[0]), LEFT)
    first, second = house.recent.pictures
    house.recent.setFocus()
    house.recent.setCurrentIndex(house.recent.model().index(0, 0))
    QTest.keyClick(house.recent, Qt.Key.Key_Right)
    QTest.keyClick(house.recent, Qt.Key.Key_Return)
    items(house.recent.menu)["Add to pad"].trigger()
    assert workspaces(house)[1].taken == [second.pictogram()]
    assert list(house.recent.pictures) == [second, first]
    house.recent.menu.close()
    house.recent.setCurrentIndex(house.recent.model().index(0, 0))
    QTest.keyClick(house.recent, Qt.Key.Key_Delete)
    assert list(house.recent.pictures) == [first]


def test_a_recent_result_is_dragged_as_an_icon_and_as_svg(house, done):
    data = house.recent.model().mimeData([house.recent.model().index(0, 0)])
    icon = house.recent.pictures[0].pictogram()
    assert unpacked(data) == icon
    assert data.data("image/svg+xml").data().decode() == icon.svg


def test_the_bar_above_is_slim(house):
    assert house.recent.height() <= 48
    assert house.modes.height() <= 48
    assert house.panes.y() + house.panes.parentWidget().y() <= 28 + 48


def test_closing_stops_the_work_of_every_workspace(house, sketch, qtbot, session):
    session.stuck = True
    sketch.run()
    qtbot.waitUntil(lambda: any(call[0] == "model" for call in session.calls))
    switch(house, 1)
    house.close()
    assert not threads_alive(house)
    assert session.generators_closed == 1
