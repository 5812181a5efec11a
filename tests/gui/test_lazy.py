"""The window opens fast: what is not needed to draw it comes later."""

import subprocess
import sys
from types import SimpleNamespace

from hands import go_to
from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import QApplication, QWidget

from iconstudio.gui.window import main_window
from iconstudio.gui.workspaces.base import Workspace
from iconstudio.workflows.registry import workflows

_LOADED = """
import sys
import iconstudio.gui.app
from iconstudio.workflows.registry import workflows
from iconstudio.workflows.workflow import load_object
load_object(workflows()[0].workspace)  # the one that the window shows first
print(*sys.modules)
"""

LATER = {
    "PIL", "numba", "skimage", "scipy.ndimage", "scipy.spatial", "scipy.special", "filelock",
    "pathops", "shapely", "tinycss2",
}  # fmt: skip
"""Slow to load, and needed only once something is drawn or cut."""

_FILLING = """
import sys
from iconstudio.session import Session
from iconstudio.algorithms.raster import fill_polygon
from iconstudio.model import Polygon
if __name__ == "__main__":
    with Session() as session:
        for _ in session.get_ready():
            pass
    before = set(sys.modules)
    fill_polygon(Polygon.of([(10, 10), (200, 10), (10, 200), (200, 200)]))
    print(*set(sys.modules) - before)
"""


def test_slow_libraries_are_loaded_later():
    command = [sys.executable, "-c", _LOADED]
    loaded = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()
    assert "PySide6.QtWidgets" in loaded
    assert not LATER & set(loaded)


def test_what_fills_an_outline_is_loaded_while_the_window_idles(tmp_path):
    script = tmp_path / "fill.py"
    script.write_text(_FILLING)
    command = [sys.executable, str(script)]
    loaded = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    assert len(loaded.split()) < 5  # of hundreds


def test_what_makes_workspaces_is_loaded_while_the_window_idles(window, qtbot, monkeypatch):
    loaded, ready = [], []

    def load(name):
        loaded.append(name)
        return SimpleNamespace(get_ready=lambda: ready.append(name))

    monkeypatch.setattr(main_window, "load_object", load)
    qtbot.waitUntil(lambda: loaded == ready == [one.workspace for one in workflows()])
    assert len(window.findChildren(Workspace)) == 1


def test_a_workspace_is_made_when_it_is_first_used(window):
    first, *_, last = (one.title for one in workflows())
    assert [one.workflow.title for one in window.findChildren(Workspace)] == [first]
    for title in (last, first, last):
        go_to(window, title)
    assert [one.workflow.title for one in window.findChildren(Workspace)] == [first, last]


def test_making_a_workspace_opens_no_window_and_keeps_the_keys(window, qtbot):
    opened = []

    class Watch(QObject):
        def eventFilter(self, watched, event):
            if event.type() == QEvent.Type.Show and isinstance(watched, QWidget):
                opened.extend([watched] if watched.isWindow() else [])
            return False

    watch = Watch()
    QApplication.instance().installEventFilter(watch)
    for workflow in workflows()[1:]:
        go_to(window, workflow.title)
        qtbot.wait(1)
        assert window.isActiveWindow()
        assert window.workspace.isAncestorOf(QApplication.focusWidget())
    QApplication.instance().removeEventFilter(watch)
    assert opened == []
