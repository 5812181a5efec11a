"""A workflow without a workspace of its own: on the switch, in the menus, and in Send to."""

import json
from dataclasses import replace

import pytest
from fake_session import FakeSession, exemplar
from hands import go_to, shown, trace, type_keyword
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QFileDialog, QPushButton

from iconstudio.gui.pictures.picture import Display, picture_of
from iconstudio.gui.window.main_window import MainWindow
from iconstudio.model import Icon, Polygon, Sketch
from iconstudio.workflows.events import Result
from iconstudio.workflows.grid import GridSettings
from iconstudio.workflows.modelling.spec import MODELLING
from iconstudio.workflows.registry import registered, workflows
from tests.shapes import outline
from tests.toy import MIRROR


@pytest.fixture
def window(qtbot, session):
    with registered(MIRROR), shown(MainWindow(session), qtbot) as window:
        yield window


@pytest.fixture
def mirror(window):
    return go_to(window, "Mirror")


def chosen(place):
    return [one.id for one in place.work_icons.sheet.model().entries]


def with_remark(icon, text):
    return replace(icon, pictogram=replace(icon.pictogram, remarks=(text,)))


def json_of(place):
    return [one.id for one in place.page.work.icons]


def titles(place):
    return [one.title for one in place.results.pictures]


def menu(window, title):
    return [one.text().replace("&", "") for one in window._menus[title].actions()]


def test_it_is_on_the_switch_and_in_the_menus(window):
    names = [one.title for one in workflows()]
    assert menu(window, "&View")[: len(names)] == names and "Mirror" in names
    assert go_to(window, "Mirror").workflow is MIRROR
    assert {"New mirror image", "Import mirror image…", "Export mirror image as JSON…"} <= set(
        menu(window, "&File")
    )
    assert "Mirror" in menu(window, "&Edit")


def test_a_chosen_icon_is_mirrored_at_once(mirror, qtbot):
    mirror.work_icons.chooser.chosen.emit(exemplar(1))
    qtbot.waitUntil(lambda: titles(mirror) == ["mirrored frame 1"])
    assert mirror.picture is mirror.results.pictures[0]
    assert mirror.picture.icon.credits == (exemplar(1).pictogram,)
    mirror.document.undo_stack.undo()
    qtbot.waitUntil(lambda: titles(mirror) == [])
    assert mirror.picture is None
    mirror.document.undo_stack.redo()
    assert titles(mirror) == ["mirrored frame 1"], "at once, as it was there"


def test_of_an_empty_page_it_is_told_what_to_do_first(window, mirror):
    mirror.actions_by_name["run"].trigger()
    assert window.pane.notice.label.text() == "There is nothing to run yet. Choose icons first."


def test_results_of_others_are_sent_to_it_and_its_own_to_others(window, qtbot):
    sketching = window.workspace
    trace(sketching)
    type_keyword(sketching, "motorcycle")
    sketching.run()
    qtbot.waitUntil(lambda: not sketching.runner.running, timeout=20000)
    sketching.send_picture(sketching.picture, "Mirror")
    mirror = window.workspace
    assert mirror.workflow is MIRROR
    qtbot.waitUntil(lambda: len(titles(mirror)) == 1)
    icon = mirror.picture.icon
    assert icon.credits == sketching.picture.icon.credits
    mirror.send_picture(mirror.picture, "Edit")
    assert window.workspace.workflow.title == "Edit"
    qtbot.waitUntil(lambda: not window.workspace.document.page.empty)
    assert window.workspace.document.page.icon.pictogram.credit.title == icon.title


def test_its_files_are_saved_and_opened(mirror, qtbot, tmp_path, monkeypatch):
    path = tmp_path / "mirror.json"
    monkeypatch.setattr(mirror.saver, "ask_path", lambda *_: path)
    for number in (1, 2):
        mirror.work_icons.chooser.chosen.emit(exemplar(number))
    mirror.actions_by_name["save"].trigger()
    qtbot.waitUntil(path.exists)
    assert json.loads(path.read_text()) == {
        "mirrored": ["shapes:frame-1", "shapes:cross-2"],
        "workflow": "mirror",
    }
    mirror.actions_by_name["new"].trigger()
    qtbot.waitUntil(lambda: titles(mirror) == [])
    mirror.opener.open_work(str(path))
    qtbot.waitUntil(lambda: len(titles(mirror)) == 2)


def test_a_chosen_icon_is_taken_out_again(mirror, qtbot):
    one, other = exemplar(1), exemplar(2)
    for icon in (one, other, one):  # what is there already stays as it is
        mirror.work_icons.chooser.chosen.emit(icon)
    qtbot.waitUntil(lambda: chosen(mirror) == [one.id, other.id])
    qtbot.waitUntil(lambda: len(titles(mirror)) == 2)
    sheet = mirror.work_icons.sheet
    sheet.setCurrentIndex(sheet.model().index(0))
    QTest.keyClick(sheet, Qt.Key.Key_Delete)
    qtbot.waitUntil(lambda: chosen(mirror) == [other.id])
    qtbot.waitUntil(lambda: titles(mirror) == ["mirrored cross 2"])
    assert json_of(mirror) == ["shapes:cross-2"]
    sheet.chosen.emit(other)
    qtbot.waitUntil(lambda: (chosen(mirror), titles(mirror)) == ([], []))
    mirror.document.undo_stack.undo()
    qtbot.waitUntil(lambda: titles(mirror) == ["mirrored cross 2"])
    mirror.work_icons.chooser.released.emit(other)
    qtbot.waitUntil(lambda: titles(mirror) == [])


def test_delete_leaves_its_results_alone(mirror, qtbot):
    mirror.work_icons.chooser.chosen.emit(exemplar(1))
    qtbot.waitUntil(lambda: len(titles(mirror)) == 1)
    mirror.results.setCurrentIndex(mirror.results.model().index(0))
    QTest.keyClick(mirror.results, Qt.Key.Key_Delete)
    assert len(titles(mirror)) == 1


def test_remarks_on_its_icons_are_told(mirror, window, qtbot):
    text = "Text was left out; turn it into shapes."
    mirror.importer.add_icons([with_remark(exemplar(1), text)])
    assert text in window.pane.notice.label.text()
    qtbot.waitUntil(lambda: len(titles(mirror)) == 1)


def test_one_that_takes_no_icons_offers_to_open_a_file(qtbot, monkeypatch):
    bare = replace(MIRROR, name="bare", title="Bare", invitation="", with_icons=None)
    with registered(bare), shown(MainWindow(FakeSession()), qtbot) as window:
        place = go_to(window, "Bare")
        assert place.work_icons is None
        (button,) = (one for one in place.findChildren(QPushButton) if "Open" in one.text())
        assert button.isVisible()
        asked = []
        monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *a: (asked.append(a) or "", ""))
        QTest.mouseClick(button, Qt.MouseButton.LeftButton)
        assert len(asked) == 1
        told = []
        place.failed.connect(told.append)
        place.take(exemplar(1).pictogram)
        qtbot.waitUntil(lambda: bool(told))
        assert told == ["“Bare” takes no icons. Open a file instead."]


def test_its_results_are_saved_as_svg(mirror, qtbot, tmp_path, monkeypatch):
    mirror.work_icons.chooser.chosen.emit(exemplar(1))
    qtbot.waitUntil(lambda: len(titles(mirror)) == 1)
    path = tmp_path / "icon.svg"
    monkeypatch.setattr(mirror.saver, "ask_path", lambda *_: path)
    mirror.actions_by_name["svg"].trigger()
    qtbot.waitUntil(path.exists)
    assert "frame 1" in path.read_text("utf-8")
    assert mirror.picture.icon.path.svg() in path.read_text("utf-8")


def test_what_has_no_sources_has_no_colour_code_to_save(mirror, window, qtbot):
    mirror.work_icons.chooser.chosen.emit(exemplar(1))
    qtbot.waitUntil(lambda: len(titles(mirror)) == 1)
    assert mirror.actions_by_name["png"].isEnabled()
    assert not mirror.actions_by_name["code_png"].isEnabled()
    window.recent.keep(mirror.picture)
    window.recent.chosen.emit(mirror.picture)
    items = {action.text(): action.isEnabled() for action in window.recent.menu.actions()}
    assert items["Save PNG…"] and not items["Save colour code as PNG…"]
    window.recent.menu.close()


def test_the_colour_code_is_offered_where_results_have_one(mirror, window, qtbot):
    mirror.work_icons.chooser.chosen.emit(exemplar(1))
    qtbot.waitUntil(lambda: len(titles(mirror)) == 1)
    assert not mirror.switch.isVisible()
    sketch = Sketch(Polygon(((0, 0), (9, 0), (9, 9))), "dog")
    events = FakeSession().run(MODELLING, sketch, GridSettings())
    remix = next(one for one in events if isinstance(one, Result))
    mirror._show(picture_of(remix.icon))
    assert mirror.switch.isVisible()
    seen = set()
    for display in Display:
        QTest.mouseClick(mirror.switch.segments[display], Qt.MouseButton.LeftButton)
        seen.add(bytes(mirror.results.viewport().grab().toImage().constBits()))
    assert len(seen) == 3


def test_what_is_cut_off_at_the_edge_of_the_canvas_is_told(mirror, window, qtbot):
    inside, outside = outline([(9, 9), (90, 9), (9, 90)]), outline([(9, 9), (300, 9), (9, 90)])
    for path, told in ((inside, False), (outside, True)):
        mirror.send_picture(picture_of(Icon(path, "wide", (exemplar(1).pictogram,))), "Montage")
        qtbot.waitUntil(lambda: len(window.workspace.page.layers) == 1)
        assert window.pane.notice.isVisible() is told
        window.workspace.document.undo_stack.undo()
        go_to(window, "Mirror")
    go_to(window, "Montage").document.undo_stack.redo()
    assert "reached out of its canvas" in window.pane.notice.label.text()
