"""Tracing with the mouse and the keys, in the real window."""

import math

import pytest
from hands import SQUARE, at, click, drag, press, trace
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from iconstudio.gui.document import Page


def near(vertices, expected, tolerance=1.5):
    assert len(vertices) == len(expected)
    assert all(math.dist(a, b) < tolerance for a, b in zip(vertices, expected, strict=True))


def test_the_empty_canvas_says_what_to_do_first(window):
    assert window.document.page.empty
    assert window.canvas_panel._start.isVisible()
    click(window, SQUARE[0])
    assert not window.canvas_panel._start.isVisible()
    assert "next point" in window.tool.hint


def test_clicks_add_vertices_and_the_first_closes(window):
    for point in SQUARE:
        click(window, point)
    assert not window.document.page.closed
    near(window.document.page.vertices, SQUARE)
    click(window, SQUARE[0])
    assert window.document.page.closed
    near(window.document.page.vertices, SQUARE)


@pytest.mark.parametrize("key", [Qt.Key.Key_Return, Qt.Key.Key_Enter])
def test_enter_closes(window, key):
    for point in SQUARE[:3]:
        click(window, point)
    press(window, key)
    assert window.document.page.closed
    near(window.document.page.vertices, SQUARE[:3])


def test_two_points_cannot_be_closed(window):
    for point in SQUARE[:2]:
        click(window, point)
    press(window, Qt.Key.Key_Return)
    assert not window.document.page.closed


def test_a_double_click_puts_the_last_vertex_and_closes(window):
    for point in SQUARE[:3]:
        click(window, point)
    click(window, SQUARE[3])
    QTest.mouseDClick(window.view, Qt.MouseButton.LeftButton, pos=at(window, SQUARE[3]))
    assert window.document.page.closed
    near(window.document.page.vertices, SQUARE)


def test_escape_gives_up_the_outline_and_undo_brings_it_back(window):
    for point in SQUARE[:3]:
        click(window, point)
    before = window.document.page
    press(window, Qt.Key.Key_Escape)
    assert window.document.page.vertices == ()
    window.actions_by_name["undo"].trigger()
    assert window.document.page == before


def test_escape_leaves_a_closed_outline_alone(window):
    trace(window)
    before = window.document.page
    press(window, Qt.Key.Key_Escape)
    assert window.document.page == before


def test_a_vertex_is_dragged_and_one_undo_puts_it_back(window):
    trace(window)
    before = window.document.page
    drag(window, SQUARE[2], (300, 300))
    near(window.document.page.vertices, [*SQUARE[:2], (300, 300), SQUARE[3]])
    window.document.undo_stack.undo()
    assert window.document.page == before


def test_two_drags_are_two_steps(window):
    trace(window)
    drag(window, SQUARE[2], (300, 300))
    between = window.document.page
    drag(window, (300, 300), (350, 350))
    window.document.undo_stack.undo()
    assert window.document.page == between


def test_a_click_on_an_edge_inserts_a_vertex(window):
    trace(window)
    middle = (250, 110)
    click(window, middle)
    near(window.document.page.vertices, [SQUARE[0], middle, *SQUARE[1:]])
    assert window.document.page.closed


def test_the_closing_edge_is_an_edge_too(window):
    trace(window)
    click(window, (95, 240))
    near(window.document.page.vertices, [*SQUARE, (95, 240)])


def test_a_right_click_removes_a_vertex(window):
    trace(window)
    click(window, SQUARE[1], Qt.MouseButton.RightButton)
    near(window.document.page.vertices, [SQUARE[0], *SQUARE[2:]])
    assert window.document.page.closed
    click(window, SQUARE[2], Qt.MouseButton.RightButton)
    assert not window.document.page.closed, "two points are no outline"


def test_a_click_beside_a_closed_outline_does_nothing(window):
    trace(window)
    before = window.document.page
    click(window, (250, 250))
    click(window, (450, 450))
    assert window.document.page == before


def test_delete_removes_the_selected_vertex(window):
    trace(window)
    click(window, SQUARE[3])
    press(window, Qt.Key.Key_Delete)
    near(window.document.page.vertices, SQUARE[:3])


def test_backspace_takes_back_the_last_click(window):
    for point in SQUARE[:3]:
        click(window, point)
    press(window, Qt.Key.Key_Backspace)
    near(window.document.page.vertices, SQUARE[:2])


def test_vertices_are_chosen_and_moved_by_keys_alone(window):
    trace(window)
    before = window.document.page.vertices
    press(window, Qt.Key.Key_PageDown)
    press(window, Qt.Key.Key_PageDown)
    assert window.tool.selected == 1
    press(window, Qt.Key.Key_Left)
    press(window, Qt.Key.Key_Down, Qt.KeyboardModifier.ShiftModifier)
    x, y = before[1]
    assert window.document.page.vertices[1] == pytest.approx((x - 1, y + 10))
    press(window, Qt.Key.Key_PageUp)
    assert window.tool.selected == 0


def test_undo_and_redo_go_through_every_state(window):
    pages: list[Page] = [window.document.page]
    window.document.page_changed.connect(pages.append)
    trace(window)
    click(window, (250, 110))
    click(window, SQUARE[2], Qt.MouseButton.RightButton)
    window.document.page_changed.disconnect(pages.append)
    stack = window.document.undo_stack
    assert stack.count() == len(pages) - 1
    for page in reversed(pages[:-1]):
        stack.undo()
        assert window.document.page == page
    for page in pages[1:]:
        stack.redo()
        assert window.document.page == page


def test_the_first_vertex_invites_to_close(window):
    for point in SQUARE[:3]:
        click(window, point)
    view = window.view
    QTest.mouseMove(view, at(window, (200, 300)))
    away = view.grab().toImage()
    QTest.mouseMove(view, at(window, SQUARE[0]))
    assert view.cursor().shape() == Qt.CursorShape.PointingHandCursor
    assert view.grab().toImage() != away


def test_space_pans_and_tracing_goes_on_after_it(window):
    click(window, SQUARE[0])
    seen = window.view.camera.to_view(SQUARE[0])
    window.view.setFocus()
    QTest.keyPress(window.view, Qt.Key.Key_Space)
    drag(window, (200, 200), (240, 200))
    QTest.keyRelease(window.view, Qt.Key.Key_Space)
    moved = window.view.camera.to_view(SQUARE[0])
    assert moved.x() - seen.x() == pytest.approx(40 * window.view.camera.zoom, abs=1)
    assert len(window.document.page.vertices) == 1
    click(window, SQUARE[1])
    near(window.document.page.vertices, SQUARE[:2])


def test_the_wheel_zooms_about_the_pointer(window):
    view = window.view
    spot = QPointF(120, 90)
    below = view.camera.to_page(spot)
    zoom = view.camera.zoom
    event = QWheelEvent(
        spot,
        view.mapToGlobal(spot),
        QPoint(),
        QPoint(0, 240),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(view, event)
    assert view.camera.zoom > 1.2 * zoom
    assert view.camera.to_page(spot) == pytest.approx(below)
    window.actions_by_name["fit"].trigger()
    assert view.camera.zoom == pytest.approx(zoom)


def test_the_zoom_has_ends(window):
    for _ in range(100):
        window.view.zoom_in()
    inside = window.view.camera.zoom
    window.view.zoom_in()
    assert window.view.camera.zoom == inside
    for _ in range(200):
        window.view.zoom_out()
    assert 0 < window.view.camera.zoom < 0.05
