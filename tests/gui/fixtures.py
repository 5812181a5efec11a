"""What the window's tests share: the real window with a session that needs no collection."""

import gc
import threading

import pytest
from fake_session import FakeSession
from hands import shown
from PySide6.QtCore import QSettings, QtMsgType
from PySide6.QtWidgets import QApplication

from iconstudio.gui.app import application, leave_clipboard
from iconstudio.gui.gallery import display
from iconstudio.gui.pictures import picture
from iconstudio.gui.preferences import prefer
from iconstudio.gui.project import questions
from iconstudio.gui.project.questions import Answer
from iconstudio.gui.window.main_window import MainWindow
from iconstudio.gui.workspaces.grid_runner import LIVE

_HARMLESS = tuple(
    f"This plugin does not support {what}"
    for what in ("propagateSizeHints()", "raise()", "grabbing the keyboard")
)


@pytest.fixture(scope="session")
def qapp_cls():
    return QApplication


@pytest.fixture(scope="session", autouse=True)
def look(qapp):
    application()
    yield
    leave_clipboard()


@pytest.fixture(autouse=True)
def own_preferences(tmp_path_factory):
    """Nobody's preferences are read or changed; live mode is off unless a test is about it."""
    folder = str(tmp_path_factory.mktemp("preferences"))
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, folder)
    prefer(LIVE, False)
    display.setting.recall()


@pytest.fixture(autouse=True)
def own_journals(tmp_path_factory):
    """Nothing is found of other tests; and their windows close without a question."""
    with pytest.MonkeyPatch.context() as patch:  # of its own: a test may undo those of others
        patch.setenv("ICONSTUDIO_DATA", str(tmp_path_factory.mktemp("data")))
        patch.setattr(questions, "ask_about_unsaved", lambda *_: Answer.DISCARD)
        patch.setattr(questions, "ask_about_opening", lambda *_: True)
        yield


@pytest.fixture(autouse=True)
def no_warnings_of_qt(qtlog):
    yield
    bad = [
        record.message
        for record in qtlog.records
        if record.type != QtMsgType.QtDebugMsg and record.message not in _HARMLESS
    ]
    assert not bad, bad


@pytest.fixture(autouse=True)
def no_thread_is_left():
    before = set(threading.enumerate())
    yield
    gc.collect()
    gc.freeze()  # what is still there stays, and is not searched after each test
    # A QThread that has ended may still be listed as a dummy; it has no life of its own.
    left = [
        thread
        for thread in set(threading.enumerate()) - before
        if thread.is_alive() and not isinstance(thread, threading._DummyThread)
    ]
    assert not left, left


@pytest.fixture
def session(monkeypatch):
    # Small colour-coded pictures: quicker, and as good to look for colours.
    monkeypatch.setattr(picture, "COLOUR_CODE_SIZE", 128)
    return FakeSession()


@pytest.fixture
def window(qtbot, session, monkeypatch):
    with shown(MainWindow(session), qtbot) as window:
        yield window
    assert session.closed.is_set()


@pytest.fixture
def sketching(window):
    """The workspace that the window begins with."""
    return window.workspace
