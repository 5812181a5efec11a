"""Holes, lines and fine details of a sketch, drawn and set in the window."""

import pytest
from hands import SQUARE, click, drag, press, trace, type_keyword
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QToolButton

from iconstudio.algorithms.iconification.matching import LARGER_SCALES, SCALES
from iconstudio.workflows.events import Remark

HOLE = [(150.0, 150.0), (250.0, 150.0), (250.0, 250.0)]
LINE = [(300.0, 200.0), (350.0, 300.0), (300.0, 350.0)]


@pytest.fixture
def traced(sketching):
    trace(sketching)
    return sketching


def near(points, others):
    return len(points) == len(others) and all(
        abs(a - b) < 2
        for one, other in zip(points, others, strict=True)
        for a, b in zip(one, other, strict=True)
    )


def draw_hole(place):
    place.actions_by_name["hole"].trigger()
    trace(place, HOLE)


def draw_line(place):
    place.actions_by_name["line"].trigger()
    for point in LINE:
        click(place, point)
    press(place, Qt.Key.Key_Return)


def test_a_hole_is_clicked_corner_by_corner_and_undone(traced):
    draw_hole(traced)
    (hole,) = traced.page.sketch.inner.holes
    assert near(hole.vertices, HOLE)
    assert near(traced.page.vertices, SQUARE)
    for _ in range(4):
        traced.document.undo_stack.undo()
    assert not traced.page.areas


def test_a_hole_is_seen_as_paper(traced):
    middle = traced.view.camera.to_view((220.0, 180.0)).toPoint()
    before = traced.view.grab().toImage().pixelColor(middle)
    draw_hole(traced)
    traced.inner.select(None)
    after = traced.view.grab().toImage().pixelColor(middle)
    paper = QColor("#ffffff").lightness()
    assert abs(after.lightness() - paper) < abs(before.lightness() - paper)


def test_a_line_ends_with_enter_and_joins_nothing(traced):
    draw_line(traced)
    (line,) = traced.page.sketch.inner.lines
    assert near(line, LINE)
    assert traced.page.draft is None


def test_a_line_is_dragged_in_one_go(traced):
    traced.actions_by_name["line"].trigger()
    drag(traced, LINE[0], LINE[1])
    (line,) = traced.page.sketch.inner.lines
    assert near((line[0], line[-1]), LINE[:2])


def test_a_line_under_way_is_no_part_of_the_sketch_and_given_up_with_escape(traced):
    before = traced.page.sketch
    traced.actions_by_name["line"].trigger()
    click(traced, LINE[0])
    click(traced, LINE[1])
    assert traced.page.draft is not None
    assert traced.page.sketch == before
    press(traced, Qt.Key.Key_Escape)
    assert traced.page.areas == ()


def test_points_of_a_hole_are_moved_and_the_line_is_selected_and_removed(traced):
    draw_line(traced)
    draw_hole(traced)
    traced.actions_by_name["select"].trigger()
    click(traced, (220.0, 180.0))
    drag(traced, HOLE[2], (200.0, 230.0))
    (hole,) = traced.page.sketch.inner.holes
    assert near(hole.vertices, [*HOLE[:2], (200.0, 230.0)])
    click(traced, (325.0, 250.0))
    press(traced, Qt.Key.Key_Backspace)
    assert traced.page.sketch.inner.lines == ()
    assert len(traced.page.sketch.inner.holes) == 1


def test_what_lies_outside_is_told_and_stays(traced):
    type_keyword(traced, "dog")
    traced.actions_by_name["hole"].trigger()
    trace(traced, [(420.0, 420.0), (480.0, 420.0), (480.0, 480.0)])
    said = []
    traced.hinted.connect(said.append)
    traced.run()
    assert said == ["Hole 1 lies outside the outline. Move it inside, or remove it."]
    assert len(traced.page.sketch.inner.holes) == 1


def test_it_is_told_that_no_result_shows_what_is_inside(traced):
    said = []
    traced.hinted.connect(said.append)
    traced.show_event(Remark("Nothing shows it."))
    assert said == ["Nothing shows it."]


def test_without_an_outline_there_is_nothing_inside(traced):
    draw_hole(traced)
    traced.actions_by_name["clear"].trigger()
    assert traced.page == traced.blank
    traced.document.undo_stack.undo()
    assert len(traced.page.sketch.inner.holes) == 1


def test_the_slider_weights_details_in_one_step_a_drag(traced):
    slider = traced.options.detail.slider
    slider.sliderPressed.emit()
    for value in (20, 50, 80):
        slider.setValue(value)
    slider.sliderReleased.emit()
    assert traced.page.sketch.detail == 0.8
    assert "80%" in traced.options.toolTip()
    traced.document.undo_stack.undo()
    assert (traced.page.sketch.detail, slider.value()) == (0.0, 0)


def test_the_box_tries_larger_scales(traced, session, qtbot):
    type_keyword(traced, "dog")
    box = traced.options.larger
    assert not box.isChecked()
    traced.run()
    qtbot.waitUntil(lambda: not traced.runner.running)
    box.click()
    assert traced.actions_by_name["scales"].isChecked()
    assert traced.runner.stale
    traced.run()
    qtbot.waitUntil(lambda: not traced.runner.running)
    models = [call for call in session.calls if call[0] == "model"]
    assert [call[2].scales for call in models] == [SCALES, LARGER_SCALES]
    traced.actions_by_name["scales"].trigger()
    assert not box.isChecked()


def test_one_button_holds_the_tools_for_what_is_inside(traced):
    (button,) = (
        one
        for one in traced.canvas_panel.findChildren(QToolButton)
        if one.defaultAction() is traced.actions_by_name["hole"]
    )
    traced.actions_by_name["select"].trigger()
    assert button.defaultAction() is traced.actions_by_name["select"]
    assert traced.actions_by_name["select"].isChecked()
