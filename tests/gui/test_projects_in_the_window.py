"""Projects: what is in the window, in one file, and back."""

import itertools
import json
import threading
import time
import zipfile
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from fake_session import exemplar
from hands import (
    SQUARE,
    action,
    click,
    shown,
    threads_alive,
    trace,
    type_keyword,
    workspaces,
)
from PySide6.QtCore import QMimeData, QUrl
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QMessageBox

from iconstudio.gui.pictures.photo import mipmap_of
from iconstudio.gui.project import files, questions, recents
from iconstudio.gui.project.questions import Answer
from iconstudio.gui.window.main_window import MainWindow
from iconstudio.gui.window.pane import WorkspacePane
from iconstudio.images.reading import Image
from iconstudio.model import Axis, Placement, Stroke
from iconstudio.output.filenames import suffixed
from iconstudio.project import archive
from iconstudio.project.archive import SUFFIX
from iconstudio.svg.reading import own_svg
from iconstudio.workflows.areas import Area, Kind
from iconstudio.workflows.editing.page import EditPage
from iconstudio.workflows.events import Progress
from iconstudio.workflows.hybrids.page import HybridsPage, Ingredient, PickRequest
from iconstudio.workflows.modelling.file import read_sketch
from iconstudio.workflows.montage.page import IconShape, MontagePage
from iconstudio.workflows.plain import WorkPage
from iconstudio.workflows.registry import registered
from tests.toy import MIRROR, Mirroring

OWN = own_svg(b'<svg viewBox="0 0 9 9"><path d="M1 1H8V5Z"/></svg>', "my: own.svg")


@pytest.fixture
def window(qtbot, session):
    with registered(MIRROR), shown(MainWindow(session), qtbot) as window:
        yield window


@pytest.fixture
def another(qtbot, session, window):
    """Makes one more window."""
    made = []

    def make():
        window = MainWindow(session)
        made.append(window)
        qtbot.addWidget(window)
        window.show()
        return window

    yield make
    for window in made:
        window.close()


def icon(number, pictogram=None):
    one = exemplar(number)
    return one if pictogram is None else replace(one, pictogram=pictogram)


def fill(window, qtbot, photo=None):
    """Put something unfinished on the page of every workflow."""
    sketching = window.workspace_of("Sketch")
    if photo is not None:
        data = QMimeData()
        data.setImageData(photo)
        sketching.opener.open_mime(data)
        qtbot.waitUntil(lambda: sketching.document.page.photo is not None)
    for point in SQUARE[:2]:
        click(sketching, point)
    type_keyword(sketching, "motorcycle")
    areas = (
        Area(Kind.ADD, ((1.0, 2.5), (9.0, 3.0), (5.0, 9.0))),
        Area(Kind.REMOVE, ((3.0, 4.0),), False),
    )
    edit = EditPage(icon(1, OWN), "camera", areas, Axis.HORIZONTAL, frozenset({"shapes:ring-0"}))
    window.workspace_of("Edit").document.change("edit", edit)
    page = MontagePage().with_icons([IconShape(icon(2)), IconShape(icon(1, OWN))]).ordered(1, 0)
    page = page.placed(0, Placement(1.25, True, 300, -7)).drawn(0, [Stroke(3.0, ((1.0, 2.0),))])
    window.workspace_of("Montage").document.change("montage", page.hidden(1, True))
    ask = PickRequest("lamp", 4, Axis.VERTICAL, 3)
    pinned, picked = Ingredient(icon(3), ((4.0, 5.0),)), Ingredient(icon(1, OWN), picked=True)
    mix = HybridsPage((pinned, picked), ask, 5, 6)
    window.workspace_of("Hybrids").document.change("mix", mix)
    mirrored = WorkPage(Mirroring((icon(5).pictogram, OWN)))
    window.workspace_of("Mirror").document.change("mirror", mirrored)


def plain(page):
    """A page as values that can be compared, but for its photo."""
    match page:
        case EditPage():
            return replace(page, icon=page.icon and page.icon.pictogram)
        case MontagePage():
            return page.chosen, [replace(one, icon=one.icon.pictogram) for one in page.layers]
        case HybridsPage():
            icons = [(one.exemplar.pictogram, one.pins, one.picked) for one in page.ingredients]
            return icons, replace(page, ingredients=(), favourites=())
    return replace(page, photo=None) if hasattr(page, "photo") else page


def pages(window):
    return {one.workflow.name: plain(one.document.page) for one in workspaces(window)}


def save(window, qtbot, path, monkeypatch):
    monkeypatch.setattr(questions, "ask_where", lambda *_: path)
    action(window, "save_project").trigger()
    qtbot.waitUntil(lambda: not window.project.modified)


def open_project(window, qtbot, path):
    window.project.open(path)
    qtbot.waitUntil(lambda: window.project.path == path)


def icons_of(recent):
    return [one.icon for one in recent.pictures]


def no_question(*_):
    raise AssertionError("nothing is lost, and yet there is a question")


def test_reading_a_project_shows_its_share_and_can_be_cancelled(window, qtbot, monkeypatch):
    def slowly(*_):
        for step in itertools.count():
            time.sleep(0.005)
            yield Progress("open", step / (step + 1), "Opening the project")

    monkeypatch.setattr(files, "opening", slowly)
    status = window.pane.status
    window.project.open(Path("large.iconstudio"))
    qtbot.waitUntil(lambda: status.bar.isVisible() and 500 <= status.bar.value() < 1000)
    status.button.click()
    assert not status.bar.isVisible()
    assert not status.button.isVisible()
    assert not window.workspace.actions_by_name["cancel"].isEnabled()
    assert window.project.path is None


def test_the_pages_of_all_workflows_are_read_back(window, another, qtbot, tmp_path, monkeypatch):
    photo = QImage(30, 20, QImage.Format.Format_RGB32)
    photo.fill(0x336699)
    fill(window, qtbot, photo)
    path = tmp_path / "dog.iconstudio"
    save(window, qtbot, path, monkeypatch)
    assert window.windowTitle() == "dog.iconstudio[*] – Iconstudio"
    other = another()
    open_project(other, qtbot, path)
    assert pages(other) == pages(window)
    there = other.workspace_of("Sketch").document.page.photo
    assert (there.width, there.height) == (30, 20)
    assert mipmap_of(there).levels[0].pixelColor(3, 3).name() == "#336699"
    assert not other.project.modified
    assert not other.isWindowModified()
    assert all(one.document.undo_stack.count() == 0 for one in workspaces(other))
    # Once more, it is the same file.
    again = tmp_path / "again.iconstudio"
    monkeypatch.setattr(questions, "ask_where", lambda *_: again)
    action(other, "save_project_as").trigger()
    qtbot.waitUntil(lambda: other.project.path == again)
    one, two = (zipfile.ZipFile(file) for file in (path, again))
    assert sorted(one.namelist()) == sorted(two.namelist())
    for name in one.namelist():
        if name != "project.json":
            assert one.read(name) == two.read(name), name
    first, second = (json.loads(file.read("project.json")) for file in (one, two))
    assert first["pages"] == second["pages"]


@pytest.mark.thorough
def test_picked_results_and_favourites_are_read_back(window, another, qtbot, tmp_path, monkeypatch):
    sketching = window.workspace
    trace(sketching)
    type_keyword(sketching, "motorcycle")
    sketching.run()
    qtbot.waitUntil(lambda: not sketching.runner.running, timeout=20000)
    window.show_workspace(2)
    hybrids = window.workspace
    mix = HybridsPage((Ingredient(icon(3)), Ingredient(icon(4))))
    hybrids.document.change("mix", mix)
    hybrids.run()
    qtbot.waitUntil(lambda: not hybrids.draws.runner.running, timeout=20000)
    hybrids.keep(hybrids.sections.pictures[0])
    path = tmp_path / "dog.iconstudio"
    save(window, qtbot, path, monkeypatch)
    other = another()
    open_project(other, qtbot, path)
    assert len(window.recent.pictures) == 2
    kept = other.workspace_of("Hybrids").document.page.favourites
    assert len(kept) == 1
    found = [*kept, *icons_of(other.recent)]
    for one, copy in zip(
        [*hybrids.document.page.favourites, *icons_of(window.recent)], found, strict=True
    ):
        assert copy.path == one.path
        assert copy.title == one.title
        assert [p.credit for p in copy.credits] == [p.credit for p in one.credits]
        assert copy.composite.shares[:1] == one.composite.shares[:1]
        assert copy.score == one.score
        assert copy.seeds == one.seeds
    assert other.workspace is other.workspace_of("Hybrids")
    other.workspace.run()
    other.workspace.draw_like(other.workspace.favourites_panel.pictures[0])
    qtbot.waitUntil(lambda: not other.workspace.draws.runner.running, timeout=20000)


def test_a_star_stands_for_what_is_not_saved(window, qtbot, tmp_path, monkeypatch):
    assert window.windowTitle() == "Iconstudio[*]"
    assert not window.isWindowModified()
    click(window.workspace, SQUARE[0])
    assert window.isWindowModified()
    assert "Untitled" in window.windowTitle()
    action(window, "undo").trigger()
    assert not window.isWindowModified()
    action(window, "redo").trigger()
    save(window, qtbot, tmp_path / "dog.iconstudio", monkeypatch)
    assert not window.isWindowModified()
    action(window, "undo").trigger()
    assert window.isWindowModified()


def test_to_choose_a_layer_is_no_change(window, qtbot, tmp_path, monkeypatch):
    fill(window, qtbot)
    save(window, qtbot, tmp_path / "dog.iconstudio", monkeypatch)
    window.workspace_of("Montage").layers.chosen.emit(0)
    assert not window.project.modified


@pytest.mark.parametrize("answer", Answer)
def test_closing_asks_about_what_is_not_saved(window, qtbot, tmp_path, monkeypatch, answer):
    path = tmp_path / "dog.iconstudio"
    monkeypatch.setattr(questions, "ask_where", lambda *_: path)
    asked = []
    monkeypatch.setattr(questions, "ask_about_unsaved", lambda *_: asked.append(1) or answer)
    trace(window.workspace)
    action(window, "quit").trigger()
    assert asked == [1]
    if answer is Answer.SAVE:
        qtbot.waitUntil(lambda: not window.isVisible())
        assert path.exists()
    assert window.isVisible() == (answer is Answer.CANCEL)
    assert threads_alive(window) == (answer is Answer.CANCEL)
    monkeypatch.setattr(questions, "ask_about_unsaved", lambda *_: Answer.DISCARD)


def test_nothing_is_asked_where_nothing_is_lost(window, qtbot, tmp_path, monkeypatch):
    monkeypatch.setattr(questions, "ask_about_unsaved", no_question)
    action(window, "new_project").trigger()
    trace(window.workspace)
    save(window, qtbot, tmp_path / "dog.iconstudio", monkeypatch)
    action(window, "new_project").trigger()
    assert window.project.path is None
    assert window.workspace.document.page.empty


def test_a_project_that_is_opened_asks_about_the_one_before(window, qtbot, tmp_path, monkeypatch):
    trace(window.workspace)
    path = tmp_path / "dog.iconstudio"
    save(window, qtbot, path, monkeypatch)
    action(window, "new_project").trigger()
    type_keyword(window.workspace, "cat")
    asked = []
    monkeypatch.setattr(questions, "ask_about_unsaved", lambda *_: asked.append(1) or Answer.CANCEL)
    window.project.open(path)
    qtbot.waitUntil(lambda: asked == [1])
    assert window.workspace.document.page.sketch.keyword == "cat"
    monkeypatch.setattr(questions, "ask_about_unsaved", lambda *_: Answer.DISCARD)
    open_project(window, qtbot, path)
    assert window.workspace.document.page.closed


def test_what_is_still_being_opened_is_not_left_out_without_a_question(window, qtbot, monkeypatch):
    """Nothing is on a page yet, so nothing is modified."""
    sketching, gate, asked = window.workspace_of("Sketch"), threading.Event(), []

    def slowly(source):
        while not gate.is_set():
            yield
            time.sleep(0.005)
        return Image(np.zeros((9, 9, 4), np.uint8), 9, 9)

    monkeypatch.setattr(sketching.session, "image", slowly)
    monkeypatch.setattr(questions, "ask_about_opening", lambda *_: asked.append(1))
    data = QMimeData()
    data.setImageData(QImage(9, 9, QImage.Format.Format_RGB32))
    sketching.opener.open_mime(data)
    assert window.work.opening and not window.project.modified
    window.close()
    assert asked and window.isVisible()
    gate.set()
    qtbot.waitUntil(lambda: window.project.modified)
    assert not window.work.opening
    window.close()
    assert len(asked) == 1, "it is work like any other now"


def test_a_dropped_project_is_opened(window, qtbot, tmp_path, monkeypatch):
    trace(window.workspace)
    path = tmp_path / "dog.iconstudio"
    save(window, qtbot, path, monkeypatch)
    action(window, "new_project").trigger()
    for number in range(5):
        window.show_workspace(number)
        data = QMimeData()
        data.setUrls([QUrl.fromLocalFile(str(path))])
        window.workspace.open_mime(data)
        qtbot.waitUntil(lambda: window.project.path == path)
        assert window.workspace.workflow.name == "model"
        action(window, "new_project").trigger()


def test_files_of_work_are_opened_where_they_belong(window, qtbot, tmp_path):
    path = tmp_path / "mirror.json"
    path.write_text(json.dumps({"mirrored": ["shapes:frame-1"]}))
    window.project.open(path)
    qtbot.waitUntil(lambda: window.workspace.workflow is MIRROR)
    qtbot.waitUntil(lambda: len(window.workspace.document.page.work.icons) == 1)
    assert window.project.path is None
    assert window.project.modified


def test_recent_projects_are_offered_and_opened(window, qtbot, tmp_path, monkeypatch):
    trace(window.workspace)
    for name in ("a&b", "cat"):
        path = tmp_path / f"{name}.iconstudio"
        monkeypatch.setattr(questions, "ask_where", lambda *_, path=path: path)
        action(window, "save_project_as").trigger()
        qtbot.waitUntil(lambda path=path: window.project.path == path)
    menu = action(window, "recent").menu()
    menu.aboutToShow.emit()
    texts = [one.text() for one in menu.actions()]
    assert texts[0].startswith("&1  cat – ")
    assert texts[1].startswith("&2  a&&b – ")
    menu.actions()[1].trigger()
    qtbot.waitUntil(lambda: window.project.name == "a&b.iconstudio")
    (tmp_path / "cat.iconstudio").unlink()
    menu.aboutToShow.emit()
    menu.actions()[1].trigger()
    qtbot.waitUntil(window.pane.notice.isVisible)
    assert "There is no such file" in window.pane.notice.label.text()
    assert not any("cat" in one for one in recents.recents())
    menu.aboutToShow.emit()
    menu.actions()[-1].trigger()
    assert recents.recents() == []


def test_a_page_that_cannot_be_read_is_told_and_the_file_is_safe(
    window, another, qtbot, tmp_path, monkeypatch
):
    fill(window, qtbot)
    path = tmp_path / "dog.iconstudio"
    save(window, qtbot, path, monkeypatch)
    with zipfile.ZipFile(path) as archive:
        parts = {name: archive.read(name) for name in archive.namelist()}
    index = json.loads(parts["project.json"])
    index["pages"]["montage"]["layers"][0]["icon"] = "/etc/passwd"
    index["pages"]["unheard-of"] = {"icon": "own:unheard"}
    index["icons"]["own:unheard"] = {"part": "icons/unheard-of.svg"}
    parts["icons/unheard-of.svg"] = b"<svg/>"
    parts["project.json"] = json.dumps(index).encode()
    with zipfile.ZipFile(path, "w") as archive:
        for name, data in parts.items():
            archive.writestr(name, data)
    other = another()
    other.project.open(path)
    qtbot.waitUntil(other.pane.notice.isVisible)
    told = other.pane.notice.label.text()
    assert "The page of Montage could not be read" in told
    assert "no workflow “unheard-of”" in told
    assert pages(other)["edit"] == pages(window)["edit"]
    assert other.project.path is None
    assert other.project.modified
    again = tmp_path / "again.iconstudio"
    other.workspace_of("Hybrids").take(OWN)
    qtbot.waitUntil(lambda: OWN.id in other.workspace_of("Hybrids").page.ids)
    save(other, qtbot, again, monkeypatch)
    with zipfile.ZipFile(again) as archive:
        stored = json.loads(archive.read("project.json"))
        assert archive.read("icons/unheard-of.svg") == b"<svg/>"
    assert stored["pages"]["unheard-of"] == index["pages"]["unheard-of"]
    assert stored["pages"]["montage"] == index["pages"]["montage"]
    assert stored["icons"] | index["icons"] == stored["icons"]


def test_only_the_workspace_in_sight_is_made_and_the_other_pages_wait(
    window, another, qtbot, tmp_path, monkeypatch
):
    fill(window, qtbot)
    window.show_workspace(1)
    path = tmp_path / "dog.iconstudio"
    save(window, qtbot, path, monkeypatch)
    first, other = archive.read(path), another()
    other.project.open(path)
    qtbot.waitUntil(lambda: other.workspace.workflow.title == "Edit")
    made = [one.workspace.workflow.title for one in other.findChildren(WorkspacePane)]
    assert sorted(made) == ["Edit", "Sketch"] and not other.project.modified
    other.workspace.document.change("name it", replace(other.workspace.page, keyword="lamp"))
    save(other, qtbot, path, monkeypatch)
    again = archive.read(path)
    changed = {**first.index.pages["edit"], "keyword": "lamp"}
    assert again.index.pages == {**first.index.pages, "edit": changed}
    assert again.parts == first.parts
    assert {**pages(other), "edit": None} == {**pages(window), "edit": None}
    assert not other.project.modified


def test_a_page_that_waits_gives_way_to_that_of_another_project(
    window, another, qtbot, tmp_path, monkeypatch
):
    fill(window, qtbot)
    window.show_workspace(0)
    save(window, qtbot, tmp_path / "dog.iconstudio", monkeypatch)
    other = another()
    other.project.open(tmp_path / "dog.iconstudio")
    qtbot.waitUntil(lambda: other.project.name == "dog.iconstudio")
    other.project.new()
    assert not other.workspace_of("Montage").page.layers and not other.project.modified


def test_what_later_versions_add_is_told_and_the_file_is_safe(window, qtbot, tmp_path):
    path = tmp_path / "dog.iconstudio"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("project.json", '{"version": 1, "pages": {"edit": {"mood": "merry"}}}')
    window.project.open(path)
    qtbot.waitUntil(window.pane.notice.isVisible)
    assert "On the page of Edit, “mood” was passed over" in window.pane.notice.label.text()
    assert window.project.path is None


def test_what_cannot_be_saved_is_told_and_stays(window, qtbot, tmp_path, monkeypatch):
    trace(window.workspace)
    monkeypatch.setattr(questions, "ask_where", lambda *_: tmp_path / "gone" / "dog.iconstudio")
    action(window, "save_project").trigger()
    qtbot.waitUntil(window.pane.notice.isVisible)
    assert "cannot be written" in window.pane.notice.label.text()
    assert window.project.modified
    assert window.project.path is None


def test_the_name_of_another_kind_gets_the_right_ending(tmp_path):
    assert suffixed(tmp_path / "dog 1.2", SUFFIX) == tmp_path / "dog 1.2.iconstudio"
    assert suffixed(tmp_path / "DOG.IconStudio", SUFFIX) == tmp_path / "DOG.IconStudio"
    (tmp_path / "dog 1.2.iconstudio").touch()
    with pytest.raises(Exception, match="is there already"):
        suffixed(tmp_path / "dog 1.2", SUFFIX)


def test_the_question_has_three_answers(window):
    for name in ("", "dog.iconstudio"):
        box = questions.unsaved_box(window, name)
        words = [one.text().replace("&", "") for one in box.buttons()]
        assert sorted(words) == sorted(["Save" if name else "Save…", "Don’t save", "Cancel"])
        assert box.defaultButton().text().startswith("&Save")
        assert box.escapeButton() is not None
        assert name in box.text()
        assert isinstance(box, QMessageBox)
        box.deleteLater()


def test_a_pasted_photo_is_saved_beside_an_exported_sketch(window, qtbot, tmp_path, monkeypatch):
    photo = QImage(30, 20, QImage.Format.Format_RGB32)
    photo.fill(0x336699)
    data = QMimeData()
    data.setImageData(photo)
    sketching = window.workspace
    sketching.opener.open_mime(data)
    qtbot.waitUntil(lambda: sketching.document.page.photo is not None)
    for point in ((2, 2), (20, 3), (15, 15)):
        click(sketching, point)
    click(sketching, (2, 2))
    path = tmp_path / "dog.json"
    monkeypatch.setattr(sketching.saver, "ask_path", lambda *_: path)
    sketching.actions_by_name["save"].trigger()
    qtbot.waitUntil(path.exists)
    file = read_sketch(path)
    assert file.photo == (tmp_path / "dog-photo.png").resolve()
    assert QImage(str(file.photo)).pixelColor(3, 3).name() == "#336699"
    sketching.actions_by_name["new"].trigger()
    sketching.opener.open_work(str(path))
    qtbot.waitUntil(lambda: sketching.document.page.photo is not None)
    assert sketching.document.page.photo.width == 30


# -- what happens while it is saved ----------------------------------------------------------------


@pytest.fixture
def slowly(monkeypatch):
    """Saving waits until it is let go."""
    gate, save = threading.Semaphore(0), archive.save

    def slow(path, project):
        gate.acquire(timeout=10)
        save(path, project)

    monkeypatch.setattr(archive, "save", slow)
    return gate


def test_what_is_done_while_the_work_is_saved_is_asked_about_again(
    window, qtbot, tmp_path, monkeypatch, slowly
):
    answers, asked = [Answer.SAVE, Answer.CANCEL], []
    monkeypatch.setattr(
        questions, "ask_about_unsaved", lambda *_: asked.append(1) or answers.pop(0)
    )
    monkeypatch.setattr(questions, "ask_where", lambda *_: tmp_path / "a.iconstudio")
    type_keyword(window.workspace, "dog")
    window.project.new()
    type_keyword(window.workspace, "house")
    slowly.release()
    qtbot.waitUntil(lambda: len(asked) == 2)
    assert window.workspace.document.page.sketch.keyword == "doghouse"
    assert window.project.modified
    answers.append(Answer.DISCARD)


def test_a_save_that_ends_when_another_project_is_there_gives_it_no_name(
    window, qtbot, tmp_path, monkeypatch, slowly
):
    monkeypatch.setattr(questions, "ask_where", lambda *_: tmp_path / "a.iconstudio")
    type_keyword(window.workspace, "dog")
    window.project.save()
    window.project.new()  # the question is answered with “Don't save”
    slowly.release()
    qtbot.waitUntil((tmp_path / "a.iconstudio").exists)
    qtbot.wait(100)
    assert window.project.path is None
    assert not window.project.modified


def test_a_file_that_another_window_saved_meanwhile_is_not_overwritten(
    window, another, qtbot, tmp_path, monkeypatch
):
    path = tmp_path / "a.iconstudio"
    monkeypatch.setattr(questions, "ask_where", lambda *_: path)
    type_keyword(window.workspace, "dog")
    window.project.save()
    qtbot.waitUntil(lambda: not window.project.modified)
    other = another()
    other.project.open(path)
    qtbot.waitUntil(lambda: other.project.path == path)
    type_keyword(other.workspace, "house")
    other.project.save()
    qtbot.waitUntil(lambda: not other.project.modified)
    there = path.read_bytes()
    type_keyword(window.workspace, "s")
    window.project.save()
    notice = window.pane.notice
    qtbot.waitUntil(lambda: "has changed since" in notice.label.text())
    assert path.read_bytes() == there
    assert window.project.modified
    window.project.save_as()  # and its dialog has asked
    qtbot.waitUntil(lambda: not window.project.modified)
    assert path.read_bytes() != there


@pytest.mark.parametrize("number", [1, 3])
def test_what_is_being_opened_does_not_come_onto_the_next_project(
    window, qtbot, tmp_path, session, monkeypatch, number
):
    window.show_workspace(number)
    place, gate, real = window.workspace, threading.Event(), session.icon
    monkeypatch.setattr(session, "icon", lambda name: gate.wait(10) and real(name))
    path = tmp_path / "own.svg"
    path.write_text('<svg viewBox="0 0 9 9"><path d="M1 1H8V5Z"/></svg>')
    place.opener.open_file(str(path))
    window.project.new()
    gate.set()
    qtbot.wait(200)
    assert place.icons == ()
    assert not window.project.modified
    place.opener.open_file(str(path))
    qtbot.waitUntil(lambda: len(place.icons) == 1)
