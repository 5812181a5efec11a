"""Open the window."""

import gc
import sys
from pathlib import Path

from PySide6.QtWidgets import QApplication
from shiboken6.Shiboken import createdByPython

from iconstudio.gui.theme import theme
from iconstudio.gui.window.main_window import MainWindow
from iconstudio.session import Session
from iconstudio.workflows.modelling.file import example as read_example
from iconstudio.workflows.modelling.spec import MODELLING

_TURN = 0.001
"""Seconds after which a busy thread lets the window's go on. Each call of Qt gives the interpreter
lock away, so that painting has to wait for it many times."""


def application() -> QApplication:
    """Return the application, with the program's look, which follows the system's colour scheme."""
    app = QApplication.instance() or QApplication(sys.argv[:1])
    app.setApplicationName("iconstudio")
    app.setApplicationDisplayName("Iconstudio")
    theme.prepare(app)
    theme.apply(app, theme.current())
    app.styleHints().colorSchemeChanged.connect(lambda _: theme.change(app, theme.current()))
    app.aboutToQuit.connect(leave_clipboard)
    return app


def leave_clipboard() -> None:
    """Leave on the clipboard what needs no Python, which ends before Qt does, with a crash."""
    clipboard = QApplication.clipboard()
    data = clipboard.mimeData()
    if data is not None and createdByPython(data):
        clipboard.setText(clipboard.text())


def run(
    example: str | None = None, session: Session | None = None, project: str | None = None
) -> int:
    """Open the window and return the exit code once it is closed.

    Parameters
    ----------
    example
        File name, without ``.json``, of an example sketch to load and remix at once.
    session
        The session to work with; by default one of its own.
    project
        The path of a project to open.

    Raises
    ------
    IconstudioError
        If there is no such example.
    """
    app = application()
    window = MainWindow(session or Session())
    if example is not None:
        start(window, example)
    if project is not None:
        window.project.open(Path(project))
    window.show()
    keep_going()
    return app.exec()


def keep_going() -> None:
    """Keep busy threads and the garbage collector from stopping a window that is made."""
    sys.setswitchinterval(_TURN)
    gc.freeze()  # What is there now stays: it need not be looked through for garbage.
    gc.enable()


def start(window: MainWindow, example: str) -> None:
    """Load an example and remix it as soon as it is there."""
    sketching = window.workspace_of(MODELLING.title)
    sketching.demonstrate(read_example(example))
