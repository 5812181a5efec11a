"""Tracing with the mouse and the keys, in the real sketching."""

import math

import pytest
from hands import SQUARE, at, click, drag, press, trace
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from iconstudio.workflows.modelling.page import SketchPage


def near(vertices, expected, tolerance=1.5):
    assert len(vertices) == len(expected)
    assert all(math.dist(a, b) < tolerance for a, b in zip(vertices, expected, strict=True))


def test_the_empty_canvas_says_what_to_do_first(sketching):
    assert sketching.document.page.empty
    assert sketching.start_buttons.isVisible()
    click(sketching, SQUARE[0])
    assert not sketching.start_buttons.isVisible()
    assert "next point" in sketching.tool.hint


def test_clicks_add_vertices_and_the_first_closes(sketching):
    for point in SQUARE:
        click(sketching, point)
    assert not sketching.document.page.closed
    near(sketching.document.page.vertices, SQUARE)
    click(sketching, SQUARE[0])
    assert sketching.document.page.closed
    near(sketching.document.page.vertices, SQUARE)


@pytest.mark.parametrize("key", [Qt.Key.Key_Return, Qt.Key.Key_Enter])
def test_enter_closes(sketching, key):
    for point in SQUARE[:3]:
        click(sketching, point)
    press(sketching, key)
    assert sketching.document.page.closed
    near(sketching.document.page.vertices, SQUARE[:3])


def test_two_points_cannot_be_closed(sketching):
    for point in SQUARE[:2]:
        click(sketching, point)
    press(sketching, Qt.Key.Key_Return)
    assert not sketching.document.page.closed


def test_a_double_click_puts_the_last_vertex_and_closes(sketching):
    for point in SQUARE[:3]:
        click(sketching, point)
    click(sketching, SQUARE[3])
    QTest.mouseDClick(sketching.view, Qt.MouseButton.LeftButton, pos=at(sketching, SQUARE[3]))
    assert sketching.document.page.closed
    near(sketching.document.page.vertices, SQUARE)


def test_escape_gives_up_the_outline_and_undo_brings_it_back(sketching):
    for point in SQUARE[:3]:
        click(sketching, point)
    before = sketching.document.page
    press(sketching, Qt.Key.Key_Escape)
    assert sketching.document.page.vertices == ()
    sketching.actions_by_name["undo"].trigger()
    assert sketching.document.page == before


def test_escape_leaves_a_closed_outline_alone(sketching):
    trace(sketching)
    before = sketching.document.page
    press(sketching, Qt.Key.Key_Escape)
    assert sketching.document.page == before


def test_a_vertex_is_dragged_and_one_undo_puts_it_back(sketching):
    trace(sketching)
    before = sketching.document.page
    drag(sketching, SQUARE[2], (300, 300))
    near(sketching.document.page.vertices, [*SQUARE[:2], (300, 300), SQUARE[3]])
    sketching.document.undo_stack.undo()
    assert sketching.document.page == before


def test_two_drags_are_two_steps(sketching):
    trace(sketching)
    drag(sketching, SQUARE[2], (300, 300))
    between = sketching.document.page
    drag(sketching, (300, 300), (350, 350))
    sketching.document.undo_stack.undo()
    assert sketching.document.page == between


def test_a_click_on_an_edge_inserts_a_vertex(sketching):
    trace(sketching)
    middle = (250, 110)
    click(sketching, middle)
    near(sketching.document.page.vertices, [SQUARE[0], middle, *SQUARE[1:]])
    assert sketching.document.page.closed


def test_the_closing_edge_is_an_edge_too(sketching):
    trace(sketching)
    click(sketching, (95, 240))
    near(sketching.document.page.vertices, [*SQUARE, (95, 240)])


def test_a_right_click_removes_a_vertex(sketching):
    trace(sketching)
    click(sketching, SQUARE[1], Qt.MouseButton.RightButton)
    near(sketching.document.page.vertices, [SQUARE[0], *SQUARE[2:]])
    assert sketching.document.page.closed
    click(sketching, SQUARE[2], Qt.MouseButton.RightButton)
    assert not sketching.document.page.closed, "two points are no outline"


def test_a_click_beside_a_closed_outline_does_nothing(sketching):
    trace(sketching)
    before = sketching.document.page
    click(sketching, (250, 250))
    click(sketching, (450, 450))
    assert sketching.document.page == before


def test_delete_removes_the_selected_vertex(sketching):
    trace(sketching)
    click(sketching, SQUARE[3])
    press(sketching, Qt.Key.Key_Delete)
    near(sketching.document.page.vertices, SQUARE[:3])


def test_backspace_takes_back_the_last_click(sketching):
    for point in SQUARE[:3]:
        click(sketching, point)
    press(sketching, Qt.Key.Key_Backspace)
    near(sketching.document.page.vertices, SQUARE[:2])


def test_vertices_are_chosen_and_moved_by_keys_alone(sketching):
    trace(sketching)
    before = sketching.document.page.vertices
    press(sketching, Qt.Key.Key_PageDown)
    press(sketching, Qt.Key.Key_PageDown)
    assert sketching.tool.selected == 1
    press(sketching, Qt.Key.Key_Left)
    press(sketching, Qt.Key.Key_Down, Qt.KeyboardModifier.ShiftModifier)
    x, y = before[1]
    assert sketching.document.page.vertices[1] == pytest.approx((x - 1, y + 10))
    press(sketching, Qt.Key.Key_PageUp)
    assert sketching.tool.selected == 0


def test_undo_and_redo_go_through_every_state(sketching):
    pages: list[SketchPage] = [sketching.document.page]
    sketching.document.page_changed.connect(pages.append)
    trace(sketching)
    click(sketching, (250, 110))
    click(sketching, SQUARE[2], Qt.MouseButton.RightButton)
    sketching.document.page_changed.disconnect(pages.append)
    stack = sketching.document.undo_stack
    assert stack.count() == len(pages) - 1
    for page in reversed(pages[:-1]):
        stack.undo()
        assert sketching.document.page == page
    for page in pages[1:]:
        stack.redo()
        assert sketching.document.page == page


def test_the_first_vertex_invites_to_close(sketching):
    for point in SQUARE[:3]:
        click(sketching, point)
    view = sketching.view
    QTest.mouseMove(view, at(sketching, (200, 300)))
    away = view.grab().toImage()
    QTest.mouseMove(view, at(sketching, SQUARE[0]))
    assert view.cursor().shape() == Qt.CursorShape.PointingHandCursor
    assert view.grab().toImage() != away


def test_space_pans_and_tracing_goes_on_after_it(sketching):
    click(sketching, SQUARE[0])
    seen = sketching.view.camera.to_view(SQUARE[0])
    sketching.view.setFocus()
    QTest.keyPress(sketching.view, Qt.Key.Key_Space)
    drag(sketching, (200, 200), (240, 200))
    QTest.keyRelease(sketching.view, Qt.Key.Key_Space)
    moved = sketching.view.camera.to_view(SQUARE[0])
    assert moved.x() - seen.x() == pytest.approx(40 * sketching.view.camera.zoom, abs=1)
    assert len(sketching.document.page.vertices) == 1
    click(sketching, SQUARE[1])
    near(sketching.document.page.vertices, SQUARE[:2])


def test_the_wheel_zooms_about_the_pointer(sketching):
    view = sketching.view
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
    sketching.actions_by_name["fit"].trigger()
    assert view.camera.zoom == pytest.approx(zoom)


def test_the_zoom_has_ends(sketching):
    for _ in range(100):
        sketching.view.zoom_in()
    inside = sketching.view.camera.zoom
    sketching.view.zoom_in()
    assert sketching.view.camera.zoom == inside
    for _ in range(200):
        sketching.view.zoom_out()
    assert 0 < sketching.view.camera.zoom < 0.05


def test_an_empty_page_is_traced_on_whatever_was_drawn_last(sketching):
    trace(sketching)
    sketching.actions_by_name["hole"].trigger()
    assert sketching.tool is sketching.tools["hole"]
    sketching.actions_by_name["clear"].trigger()
    assert sketching.tool is sketching.tools["trace"]
    assert sketching.actions_by_name["trace"].isChecked()
