"""What was not saved outlives the window, however it ends."""

import json
import os
import random
import subprocess
import sys
import time
from pathlib import Path

import pytest
from fake_session import FakeSession
from hands import SQUARE, action, click, trace, type_keyword
from PySide6.QtWidgets import QApplication

from iconstudio.gui.project import questions
from iconstudio.gui.project.questions import Answer
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.window.main_window import MainWindow
from iconstudio.project.journal import LeftBehind, journals_folder

ROOT = Path(__file__).parents[2]
MOMENTS = 3
"""Of all twenty, in tests/benchmarks, those that are tried each time."""


@pytest.fixture
def started(qtbot):
    """Starts windows one after the other, as the program is started."""
    made = []

    def start():
        window = MainWindow(FakeSession())
        made.append(window)
        qtbot.addWidget(window)
        window.show()
        return window

    yield start
    for window in made:
        window.close()


def killed_after(seconds):
    """Let a window edit itself for a while, kill it, and return how many edits it had made."""
    paths = os.pathsep.join([str(ROOT), str(ROOT / "tests/gui")])
    process = subprocess.Popen(
        [sys.executable, str(ROOT / "tests/gui/edited_window.py")],
        stdout=subprocess.PIPE,
        env=os.environ | {"PYTHONPATH": paths},
    )
    assert process.stdout.readline() == b"ready\n"
    time.sleep(seconds)
    process.kill()
    rest, _ = process.communicate()
    return int(rest.split()[-1]) if rest.split() else 0


def offered(window, qtbot):
    qtbot.waitUntil(window.recovery.isVisible)
    return window.recovery._offers


def edits_in(window):
    """The number of edits that are there, and that none before them is missing."""
    points = window.workspace_of("Sketch").document.page.vertices
    areas = window.workspace_of("Edit").document.page.areas
    numbers = [int(x) for x, _ in points] + [int(one.vertices[0][0]) for one in areas]
    assert sorted(numbers) == list(range(1, len(numbers) + 1))
    return len(numbers)


def check_a_kill(seconds, started, qtbot):
    made = killed_after(seconds)
    window = started()
    offered(window, qtbot)
    window.recovery.restore_button.click()
    qtbot.waitUntil(lambda: not window.recovery.isVisible())
    assert made - 1 <= edits_in(window) <= made + 1  # one may be made and not told yet
    assert window.project.modified
    # Until it is saved, it is kept: by the one that was killed, or by this one.
    assert list(journals_folder().glob("*/project.json"))
    window.close()
    assert not list(journals_folder().glob("*"))


@pytest.mark.thorough(but=1)
@pytest.mark.parametrize("number", range(MOMENTS))
def test_a_window_that_is_killed_loses_at_most_one_edit(started, qtbot, number):
    check_a_kill(random.Random(number).uniform(0.3, 2.0), started, qtbot)


# -- without killing: a window that lets go of its journal as if it were ------------------------


def crash(window):
    """Let a window end without a word: what it kept stays, and nobody holds it."""
    journaling = window.project.journaling
    journaling._worker.close()
    journaling._journal._lock.release()
    journaling._journal = type(journaling._journal)(Path(os.devnull) / "nowhere")
    window.close()


def journalled(qtbot, keyword="", points=0):
    """Wait until a sketch with so much is in the only journal."""

    def there():
        journals = list(journals_folder().glob("*/project.json"))
        pages = [json.loads(one.read_text("utf-8"))["pages"] for one in journals]
        found = [(one["model"].get("keyword", ""), len(one["model"]["polygon"])) for one in pages]
        return len(found) == 1 and found[0][0] == keyword and found[0][1] >= points

    qtbot.waitUntil(there)


def test_what_is_offered_is_kept_until_it_is_dismissed(started, qtbot):
    window = started()
    trace(window.workspace)
    journalled(qtbot)
    crash(window)
    for _ in range(2):
        window = started()
        (found,) = offered(window, qtbot)
        assert "Unsaved work in Sketch" in window.recovery.label.text()
        assert "today" in window.recovery.label.text()
        window.close()  # without an answer
    window = started()
    offered(window, qtbot)
    window.recovery.dismiss_button.click()
    assert not window.recovery.isVisible()
    qtbot.waitUntil(lambda: not list(journals_folder().glob("*")))
    assert not window.project.modified
    assert not found.folder.exists()


def test_an_offer_cuts_nothing_short(started, qtbot):
    window = started()
    window.resize(1280, 720)
    before = laid_out(window)
    window.recovery.offer(LeftBehind(Path("gone"), time.time(), lock=None))
    assert window.recovery.isVisible()
    assert before - laid_out(window) < UNIT


def laid_out(window):
    """Return the height of the page in a window."""
    QApplication.processEvents()
    window.centralWidget().layout().activate()
    return window.panes.height()


def test_restoring_is_shown_while_it_lasts_and_can_be_called_off(started, qtbot, monkeypatch):
    window = started()
    trace(window.workspace)
    journalled(qtbot, points=len(SQUARE))
    crash(window)
    window = started()
    offered(window, qtbot)
    click(window.workspace, SQUARE[0])  # so that it is asked whether this may go
    bar = window.recovery
    for answer in (Answer.CANCEL, Answer.DISCARD):
        monkeypatch.setattr(questions, "ask_about_unsaved", lambda *_, answer=answer: answer)
        bar.restore_button.click()
        assert not bar.restore_button.isEnabled()
        assert "Restoring" in bar.label.text()
        qtbot.waitUntil(lambda: "Restoring" not in bar.label.text() or not bar.isVisible())
        assert bar.isVisible() is (answer is Answer.CANCEL)
        assert bar.restore_button.isEnabled() or not bar.isVisible()
    assert len(window.workspace.page.vertices) == len(SQUARE)


def test_what_was_restored_is_of_the_same_file(started, qtbot, tmp_path, monkeypatch):
    path = tmp_path / "dog.iconstudio"
    monkeypatch.setattr(questions, "ask_where", lambda *_: path)
    window = started()
    trace(window.workspace)
    action(window, "save_project").trigger()
    qtbot.waitUntil(path.exists)
    qtbot.waitUntil(lambda: not list(journals_folder().glob("*")))
    type_keyword(window.workspace, "dog")
    journalled(qtbot, "dog")
    crash(window)
    window = started()
    offered(window, qtbot)
    assert "on “dog.iconstudio”" in window.recovery.label.text()
    window.recovery.restore_button.click()
    qtbot.waitUntil(lambda: window.project.path == path)
    assert window.project.modified
    assert window.workspace.document.page.sketch.keyword == "dog"
    action(window, "save_project").trigger()
    qtbot.waitUntil(lambda: not window.project.modified)
    qtbot.waitUntil(lambda: not list(journals_folder().glob("*")))


def test_what_was_left_behind_is_not_lost_in_a_second_crash(started, qtbot):
    window = started()
    for number in range(2):
        click(window.workspace, SQUARE[number])
        journalled(qtbot, points=number + 1)
        crash(window)
        window = started()
        offered(window, qtbot)
        window.recovery.restore_button.click()
        qtbot.waitUntil(window.recovery.isHidden)
        assert len(window.workspace.document.page.vertices) == number + 1


def test_the_work_in_sight_is_asked_about_before_other_work_is_restored(
    started, qtbot, monkeypatch
):
    window = started()
    trace(window.workspace)
    journalled(qtbot)
    crash(window)
    window = started()
    offered(window, qtbot)
    type_keyword(window.workspace, "cat")
    asked = []
    monkeypatch.setattr(questions, "ask_about_unsaved", lambda *_: asked.append(1) or Answer.CANCEL)
    window.recovery.restore_button.click()
    qtbot.waitUntil(lambda: asked == [1])
    assert window.recovery.isVisible()
    assert window.workspace.document.page.sketch.keyword == "cat"
    monkeypatch.setattr(questions, "ask_about_unsaved", lambda *_: Answer.DISCARD)


def test_the_journal_of_a_window_that_lives_is_not_offered(started, qtbot):
    window = started()
    trace(window.workspace)
    journalled(qtbot)
    other = started()
    other.project.journaling.look()
    qtbot.wait(500)
    assert not other.recovery.isVisible()
    window.close()
    other.project.journaling.look()
    qtbot.wait(100)
    assert not other.recovery.isVisible()


def test_work_that_is_undone_again_leaves_no_journal(started, qtbot):
    window = started()
    click(window.workspace, SQUARE[0])
    journalled(qtbot)
    action(window, "undo").trigger()
    qtbot.waitUntil(lambda: not list(journals_folder().glob("*")))


def test_a_disk_that_is_full_is_told_once(started, qtbot, monkeypatch):
    journals_folder().parent.mkdir(parents=True, exist_ok=True)
    journals_folder().touch()
    window = started()
    click(window.workspace, SQUARE[0])
    qtbot.waitUntil(window.pane.notice.isVisible)
    assert "cannot be kept" in window.pane.notice.label.text()
    click(window.workspace, SQUARE[1])
    qtbot.wait(200)
    assert not window.pane.notice.isVisible()


def test_an_edit_is_journalled_within_a_second_while_files_are_read(started, qtbot, monkeypatch):
    window = started()

    def slow():
        time.sleep(1.5)
        yield

    window._files.submit(slow)
    began = time.monotonic()
    click(window.workspace, SQUARE[0])
    journalled(qtbot)
    assert time.monotonic() - began < 1
