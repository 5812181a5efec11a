"""What a user's hands do to the window."""

from pathlib import Path

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from iconstudio.gui.main_window import MainWindow

SQUARE = [(100.0, 100.0), (400.0, 120.0), (380.0, 400.0), (90.0, 380.0)]
"""An outline on the empty page, which is 512 units wide."""


def at(window: MainWindow, point) -> QPoint:
    """Return where a page point is seen."""
    return window.view.camera.to_view(point).toPoint()


def click(window: MainWindow, point, button=Qt.MouseButton.LeftButton) -> None:
    QTest.mouseMove(window.view, at(window, point))
    QTest.mouseClick(window.view, button, pos=at(window, point))


def drag(window: MainWindow, start, end) -> None:
    left = Qt.MouseButton.LeftButton
    a, b = at(window, start), at(window, end)
    QTest.mouseMove(window.view, a)
    QTest.mousePress(window.view, left, pos=a)
    for step in range(1, 5):
        QTest.mouseMove(window.view, a + (b - a) * step / 4)
    QTest.mouseRelease(window.view, left, pos=b)


def trace(window: MainWindow, points=SQUARE) -> None:
    """Click all points, then the first again."""
    for point in (*points, points[0]):
        click(window, point)


def type_keyword(window: MainWindow, text: str) -> None:
    window.keyword_panel.field.setFocus()
    QTest.keyClicks(window.keyword_panel.field, text)


def press(window: MainWindow, key, modifier=Qt.KeyboardModifier.NoModifier) -> None:
    window.view.setFocus()
    QTest.keyClick(window.view, key, modifier)


def save_to(window: MainWindow, monkeypatch, path: Path | None) -> None:
    """Let the next save dialog answer ``path``."""
    monkeypatch.setattr(window.saver, "ask_path", lambda what, name, kind: path)
