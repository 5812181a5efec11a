"""What a user's hands do to the window; ``place`` is the workspace where."""

from contextlib import contextmanager
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QEvent, QPoint, Qt
from PySide6.QtGui import QAction, QDragEnterEvent, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.panels.chooser import IconChooser
from iconstudio.gui.window.main_window import MainWindow
from iconstudio.gui.workspaces.base import Workspace
from iconstudio.gui.workspaces.sketching.workspace import SketchWorkspace
from iconstudio.workflows.registry import workflows

SQUARE = [(100.0, 100.0), (400.0, 120.0), (380.0, 400.0), (90.0, 380.0)]
"""An outline on the empty page, which is 512 units wide."""


def go_to(window, title: str):
    """Switch to the workspace of that title, and return it."""
    window.show_workspace([one.title for one in workflows()].index(title))
    return window.workspace


def at(place: SketchWorkspace, point) -> QPoint:
    """Return where a page point is seen."""
    return place.view.camera.to_view(point).toPoint()


def click(place: SketchWorkspace, point, button=Qt.MouseButton.LeftButton) -> None:
    QTest.mouseMove(place.view, at(place, point))
    QTest.mouseClick(place.view, button, pos=at(place, point))


def drag(place: SketchWorkspace, start, end) -> None:
    left = Qt.MouseButton.LeftButton
    a, b = at(place, start), at(place, end)
    QTest.mouseMove(place.view, a)
    QTest.mousePress(place.view, left, pos=a)
    for step in range(1, 5):
        QTest.mouseMove(place.view, a + (b - a) * step / 4)
    QTest.mouseRelease(place.view, left, pos=b)


def trace(place: SketchWorkspace, points=SQUARE) -> None:
    """Click all points, then the first again."""
    for point in (*points, points[0]):
        click(place, point)


def type_keyword(place: SketchWorkspace, text: str) -> None:
    place.keyword_panel.field.setFocus()
    QTest.keyClicks(place.keyword_panel.field, text)


def press(place: SketchWorkspace, key, modifier=Qt.KeyboardModifier.NoModifier) -> None:
    place.view.setFocus()
    QTest.keyClick(place.view, key, modifier)


def save_to(place: SketchWorkspace, monkeypatch, path: Path | None) -> None:
    """Let the next save dialog answer ``path``."""
    monkeypatch.setattr(place.saver, "ask_path", lambda what, name, kind: path)


@contextmanager
def shown(window, qtbot):
    """Show a window of the usual size; in the end close it, and see that nothing of it is left."""
    window.resize(1280, 720)
    window.show()
    qtbot.waitExposed(window)
    yield window
    window.close()
    assert not threads_alive(window)
    # At once: windows of earlier tests would slow down whatever concerns all widgets.
    window.deleteLater()
    QCoreApplication.sendPostedEvents(window, QEvent.Type.DeferredDelete)


def drop(widget, data, action=Qt.DropAction.CopyAction):
    """Drop something as the window system does: whoever accepts it around ``widget`` gets it."""
    spot = widget.rect().center()
    both = Qt.DropAction.CopyAction | Qt.DropAction.MoveAction
    hand = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    enter = QDragEnterEvent(spot, both, data, *hand)
    enter.setDropAction(action)
    enter.ignore()
    QApplication.sendEvent(widget, enter)
    if not enter.isAccepted():
        return None
    event = QDropEvent(spot, both, data, *hand)
    event.setDropAction(action)
    QApplication.sendEvent(widget, event)
    return event.dropAction()


def search(chooser: IconChooser, keyword: str) -> None:
    """Look icons up: type a word, and press Enter."""
    chooser.field.setText(keyword)
    chooser.field.returnPressed.emit()


def action(window: MainWindow, name: str) -> QAction:
    """Return an action of the workspace in use, or of the window itself."""
    return window.workspace.actions_by_name.get(name) or window.actions_by_name[name]


def workspaces(window: MainWindow) -> tuple[Workspace, ...]:
    """Return all workspaces, as they stand on the switch."""
    return tuple(window.workspace_of(one.text()) for one in window.modes.actions_in_order)


def threads_alive(window: MainWindow) -> bool:
    """Return whether a thread of the window still runs; none should once it is closed."""
    return any(worker.alive for worker in window.findChildren(Worker))
