"""Montages by mouse, pen and keys, in the real window with the session that needs no icons."""

import json
import math
import re
import threading
from itertools import pairwise

import pytest
from fake_session import exemplar
from hands import at, drag, drop, press, save_to, search, threads_alive, workspaces
from PySide6.QtCore import QEvent, QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import (
    QImage,
    QInputDevice,
    QPainter,
    QPointingDevice,
    QTabletEvent,
)
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog

from iconstudio.algorithms.iconification.guidance import scribble
from iconstudio.gui.exchange.dragging import packed
from iconstudio.gui.pictures.picture import Display
from iconstudio.gui.theme import theme
from iconstudio.gui.window.main_window import MainWindow
from iconstudio.gui.workspaces.montage import pictures as montage_pictures
from iconstudio.gui.workspaces.montage.appearance import color_of, rect_of
from iconstudio.gui.workspaces.montage.pictures import LayerPainter
from iconstudio.gui.workspaces.montage.scene import MontageScene
from iconstudio.model import Placement
from iconstudio.output.colours import source_colours
from iconstudio.session import Session
from iconstudio.svg.reading import own_svg
from iconstudio.workflows.montage.file import read_montage
from iconstudio.workflows.montage.snapping import centre, corners
from iconstudio.workflows.montage.spec import MONTAGE

LEFT, RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton
ALT, CTRL, SHIFT = (
    Qt.KeyboardModifier.AltModifier,
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.ShiftModifier,
)
RING, FRAME, CROSS, TRIANGLE = (exemplar(number).pictogram for number in range(4))
OWN = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'><path d='M1 1h7v7z'/></svg>"


@pytest.fixture
def place(window, qtbot):
    window.show_workspace([one.workflow.title for one in workspaces(window)].index("Montage"))
    return window.workspace


@pytest.fixture
def two(place, qtbot):
    """A ring with a triangle upon it, the triangle chosen."""
    bring(place, qtbot, RING, TRIANGLE)
    return place


def bring(place, qtbot, *pictograms):
    for pictogram in pictograms:
        count = len(place.document.page.layers)
        place.take(pictogram)
        qtbot.waitUntil(lambda count=count: len(place.document.page.layers) > count)


def layer(place, number):
    return next(one for one in place.document.page.layers if one.number == number)


def stroke(place, *points, modifiers=Qt.KeyboardModifier.NoModifier):
    """Drag with the left button held, from point to point of the page, in small steps."""
    view = place.view
    QTest.mouseMove(view, at(place, points[0]))
    QTest.mousePress(view, LEFT, modifiers, at(place, points[0]))
    for (x0, y0), (x1, y1) in pairwise(points):
        for step in range(1, 9):
            spot = (x0 + (x1 - x0) * step / 8, y0 + (y1 - y0) * step / 8)
            event_move(view, at(place, spot), modifiers)
    QTest.mouseRelease(view, LEFT, modifiers, at(place, points[-1]))


def event_move(view, spot, modifiers):
    """Move the mouse; ``QTest.mouseMove`` knows no modifiers."""
    from PySide6.QtGui import QMouseEvent

    event = QMouseEvent(
        QEvent.Type.MouseMove,
        QPointF(spot),
        QPointF(view.mapToGlobal(spot)),
        Qt.MouseButton.NoButton,
        LEFT,
        modifiers,
    )
    QApplication.sendEvent(view, event)


def settled(place, qtbot):
    qtbot.waitUntil(lambda: not place.live.running, timeout=10000)


def montages(session):
    return [call[1] for call in session.calls if call[0] == "montage"]


# -- icons ---------------------------------------------------------------------------------------


def test_an_empty_canvas_says_what_to_do_and_offers_it(place):
    assert place.scene.empty
    assert place.start_buttons.isVisible()
    assert not place.actions_by_name["svg"].isEnabled()
    press(place, Qt.Key.Key_Left)
    stroke(place, (50, 50), (90, 90))
    assert place.document.undo_stack.count() == 0


def test_icons_are_found_and_added_by_a_click(place, qtbot):
    assert place.chooser.field.hasFocus()
    search(place.chooser, "ring")
    sheet = place.chooser.sheet
    qtbot.waitUntil(lambda: sheet.model().rowCount() == 60)
    spot = sheet.visualRect(sheet.model().index(1, 0)).center()
    QTest.mouseClick(sheet.viewport(), LEFT, pos=spot)
    qtbot.waitUntil(lambda: len(place.document.page.layers) == 1)
    assert place.document.page.current.icon.pictogram == FRAME
    assert place.document.page.current.placement == Placement()
    assert not place.start_buttons.isVisible()


def test_icons_and_files_can_be_dropped_on_the_canvas(place, qtbot, tmp_path):
    file = tmp_path / "mine.svg"
    file.write_text(OWN)
    urls = QMimeData()
    urls.setUrls([QUrl.fromLocalFile(str(file))])
    for count, data in enumerate((packed(CROSS), urls), start=1):
        drop(place.view, data)
        qtbot.waitUntil(lambda count=count: len(place.document.page.layers) == count)
    assert [one.icon.pictogram.id[:6] for one in place.document.page.layers] == ["shapes", "own:mi"]


def test_a_file_that_is_no_good_is_told_in_a_sentence(place, qtbot, tmp_path, window):
    file = tmp_path / "empty.svg"
    file.write_text("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'/>")
    place.opener.open_file(str(file))
    qtbot.waitUntil(window.pane.notice.isVisible)
    assert "nothing to be seen" in window.pane.notice.label.text()
    assert place.document.page.layers == ()


def painted(place, scene):
    """Return what a scene looks like in the view."""
    image = QImage(place.view.size(), QImage.Format.Format_ARGB32_Premultiplied)
    image.fill(Qt.GlobalColor.white)
    with QPainter(image) as painter:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        scene.paint(painter, place.view.camera, 1.0, theme.current())
    return image


@pytest.mark.parametrize("budget", [0.0, math.inf])
def test_icons_kept_as_pictures_look_as_if_they_were_painted_anew(
    place, qtbot, monkeypatch, budget
):
    monkeypatch.setattr(montage_pictures, "BUDGET", budget)
    bring(place, qtbot, RING, FRAME, CROSS, TRIANGLE)
    view, stack = place.view, place.document.undo_stack
    qtbot.waitUntil(
        lambda: all(place.outlines.outline(one.icon.exemplar) for one in place.document.page.layers)
    )

    def settled_picture(scene):
        while painted(place, scene) and scene.icons._begun:
            qtbot.wait(5)
        return painted(place, scene)

    seen = [settled_picture(place.scene)]
    place.layers.chosen.emit(1)
    steps = [
        lambda: press(place, Qt.Key.Key_V),
        lambda: press(place, Qt.Key.Key_Right),
        lambda: place.layers.chosen.emit(2),
        lambda: view.pan(QPointF(30, -7)),
        lambda: view.zoom_by(1.3),
        lambda: view.zoom_by(9),
        lambda: view.pan(QPointF(0.4, 60)),
        view.fit,
        lambda: place.actions_by_name["mirror"].trigger(),
        lambda: place.layers.hid.emit(0, True),
        lambda: place.layers.moved.emit(3, 0),
        lambda: place.actions_by_name["delete"].trigger(),
        lambda: place.layers.hid.emit(0, False),
        stack.undo,
        stack.undo,
    ]
    for step in steps:
        step()
        seen.append(settled_picture(place.scene))
        assert seen[-1] == settled_picture(MontageScene(place.document, place.outlines))
    assert sum(one != other for one, other in pairwise(seen)) > len(steps) - 4


def test_while_zooming_the_last_picture_stands_in_until_the_hand_rests(place, qtbot, monkeypatch):
    monkeypatch.setattr(montage_pictures, "BUDGET", 0.0)
    bring(place, qtbot, RING, FRAME, CROSS, TRIANGLE)
    icons, outlines = place.scene.icons, []
    qtbot.waitUntil(lambda: painted(place, place.scene) and not icons._begun)
    monkeypatch.setattr(
        LayerPainter, "paint", lambda self, painter, layer, *_: outlines.append(layer.number)
    )
    for _ in range(5):
        place.view.zoom_by(1.1)
        painted(place, place.scene)
    assert set(outlines) == {place.document.page.current.number}, "the others were only scaled"
    assert icons._begun
    qtbot.waitUntil(lambda: not icons._begun)
    assert set(outlines) == {0, 1, 2, 3}


def test_the_thirty_first_icon_is_refused_in_a_sentence(place, qtbot, window):
    icon = exemplar(0).pictogram
    bring(place, qtbot, icon)
    page = place.document.page
    place.document.change("many", page.with_icons([page.current.icon] * 29))
    place.take(icon)
    qtbot.waitUntil(window.pane.notice.isVisible)
    assert "at most 30 icons" in window.pane.notice.label.text()
    assert len(place.document.page.layers) == 30


# -- scribbling ----------------------------------------------------------------------------------


def test_a_scribble_marks_the_chosen_icon_and_the_montage_appears(two, qtbot, session):
    assert two.picture is None
    stroke(two, (100, 150), (150, 150))
    assert len(layer(two, 1).strokes) == 1
    assert layer(two, 0).strokes == ()
    assert two.document.undo_stack.undoText() == "scribble"
    qtbot.waitUntil(lambda: two.picture is not None)
    assert montages(session)[-1].layers[1].strokes == layer(two, 1).strokes
    assert two.actions_by_name["svg"].isEnabled()
    assert threading.get_ident() not in session.thread_ids


def test_undo_and_redo_of_a_scribble_show_the_montages_that_were_there_at_once(two, qtbot, session):
    made, stack = [], two.document.undo_stack
    for y in (150, 180):
        stroke(two, (100, y), (150, y))
        settled(two, qtbot)
        made.append(two.picture)
    count = len(montages(session))
    stack.undo()
    assert two.picture is made[0]
    stack.undo()
    assert two.picture is None
    for each in made:
        stack.redo()
        assert two.picture is each
    assert len(montages(session)) == count


def test_the_colour_of_the_strokes_is_that_of_the_part(two, qtbot):
    two.actions_by_name["delete"].trigger()  # the triangle, so that colours do not go by order
    bring(two, qtbot, CROSS)
    two.layers.chosen.emit(0)
    stroke(two, (60, 60), (60, 90))
    two.layers.deleted.emit(0)
    two.document.undo_stack.undo()
    settled(two, qtbot)
    two.layers.chosen.emit(1)
    stroke(two, (160, 160), (160, 190))
    settled(two, qtbot)
    composite = two.picture.icon.composite
    colours = source_colours(composite, two.picture.colours)
    for source, colour in zip(composite.sources, colours, strict=True):
        (same,) = (
            one
            for one in two.document.page.layers
            if one.icon.pictogram == source.exemplar.pictogram
        )
        assert color_of(same).getRgb()[:3] == tuple(colour)
    code = two.picture.coded.at(1000)
    opaque = max(
        (code.pixelColor(x, y) for x in range(0, 128, 4) for y in range(0, 128, 4)),
        key=lambda color: color.alpha(),
    )
    last = color_of(layer(two, 1))
    assert abs(opaque.red() - last.red()) + abs(opaque.blue() - last.blue()) < 6


def test_a_click_leaves_a_dot_and_two_quick_ones_two(two):
    spot = at(two, (120, 150))
    QTest.mouseClick(two.view, LEFT, pos=spot)
    assert len(layer(two, 1).strokes[0].points) == 1
    QTest.mouseDClick(two.view, LEFT, pos=at(two, (60, 60)))
    QTest.mouseRelease(two.view, LEFT, pos=at(two, (60, 60)))
    assert [len(one.points) for one in layer(two, 1).strokes] == [1, 1]


def test_a_right_click_leaves_nothing(two):
    QTest.mouseClick(two.view, RIGHT, pos=at(two, (120, 150)))
    assert layer(two, 1).strokes == ()


def test_painting_over_another_icons_scribble_takes_it_away_there(two, qtbot):
    two.layers.chosen.emit(0)
    stroke(two, (60, 128), (200, 128))
    two.layers.chosen.emit(1)
    stroke(two, (128, 80), (128, 180))
    assert len(layer(two, 0).strokes) == 2, "cut in two"
    first, second = (scribble(layer(two, number).strokes) for number in (0, 1))
    assert not (first & second).any()
    assert second[128, 128] and first[128, 70] and first[128, 190]
    two.document.undo_stack.undo()
    assert len(layer(two, 0).strokes) == 1


def test_what_a_stroke_will_do_is_seen_while_it_is_drawn(two):
    view = two.view
    QTest.mousePress(view, LEFT, pos=at(two, (60, 60)))
    QTest.mouseMove(view, at(two, (90, 90)))
    assert two.scene.page.layers[1].strokes
    assert two.document.page.layers[1].strokes == ()
    press(two, Qt.Key.Key_Escape)
    assert two.scene.page.layers[1].strokes == ()
    QTest.mouseRelease(view, LEFT, pos=at(two, (90, 90)))
    assert two.document.page.layers[1].strokes == ()


def test_an_undo_in_the_middle_of_a_stroke_gives_it_up(two):
    QTest.mousePress(two.view, LEFT, pos=at(two, (60, 60)))
    two.document.undo_stack.undo()
    two.document.undo_stack.undo()
    QTest.mouseMove(two.view, at(two, (90, 90)))
    QTest.mouseRelease(two.view, LEFT, pos=at(two, (90, 90)))
    assert two.document.page.layers == ()


@pytest.mark.parametrize("everywhere", [False, True])
def test_the_eraser_rubs_out_of_the_chosen_icon_or_with_alt_of_all(two, everywhere):
    stroke(two, (60, 60), (200, 60))
    two.layers.chosen.emit(0)
    stroke(two, (60, 120), (200, 120))
    press(two, Qt.Key.Key_E)
    assert two.actions_by_name["eraser"].isChecked()
    stroke(two, (128, 40), (128, 140), modifiers=ALT if everywhere else Qt.KeyboardModifier(0))
    assert len(layer(two, 0).strokes) == 2
    assert len(layer(two, 1).strokes) == (2 if everywhere else 1)
    assert two.document.undo_stack.undoText() == "erase"


def test_the_eraser_on_nothing_is_no_step(two):
    press(two, Qt.Key.Key_E)
    count = two.document.undo_stack.count()
    stroke(two, (60, 60), (100, 60))
    assert two.document.undo_stack.count() == count


def test_brackets_and_slider_change_the_brush(two):
    usual = two.brush.width
    press(two, Qt.Key.Key_BracketRight)
    assert two.brush.width > usual
    assert two.slider.slider.value() == two.brush.width
    press(two, Qt.Key.Key_BracketLeft)
    press(two, Qt.Key.Key_BracketLeft)
    assert two.brush.width < usual
    two.slider.slider.setValue(40)
    stroke(two, (60, 60), (100, 60))
    assert layer(two, 1).strokes[0].width == 40
    for _ in range(50):
        press(two, Qt.Key.Key_BracketRight)
    assert two.brush.width == two.slider.slider.maximum()


def pen(place, points, pressures, kind=QPointingDevice.PointerType.Pen):
    """Draw with a pen, or with its other end."""
    device = QPointingDevice(
        "pen",
        1,
        QInputDevice.DeviceType.Stylus,
        kind,
        QInputDevice.Capability.Position | QInputDevice.Capability.Pressure,
        1,
        1,
    )
    kinds = [QEvent.Type.TabletPress, *[QEvent.Type.TabletMove] * (len(points) - 2)]
    for event_type, point, pressure in zip(
        [*kinds, QEvent.Type.TabletRelease], points, pressures, strict=True
    ):
        spot = QPointF(at(place, point))
        button = Qt.MouseButton.NoButton if event_type == QEvent.Type.TabletMove else LEFT
        event = QTabletEvent(
            event_type,
            device,
            spot,
            QPointF(place.view.mapToGlobal(spot)),
            pressure,
            0,
            0,
            0,
            0,
            0,
            Qt.KeyboardModifier.NoModifier,
            button,
            LEFT,
        )
        QApplication.sendEvent(place.view, event)


def test_a_pen_that_presses_harder_draws_wider(two):
    points = [(60 + 5 * n, 60) for n in range(20)]
    pen(two, points, [n / 20 for n in range(20)])
    widths = [one.width for one in layer(two, 1).strokes]
    assert len(widths) > 1
    assert widths == sorted(widths)
    assert widths[-1] <= two.brush.width


def test_the_other_end_of_the_pen_erases(two):
    stroke(two, (60, 60), (200, 60))
    pen(two, [(128, 30), (128, 60), (128, 90)], [0.5] * 3, QPointingDevice.PointerType.Eraser)
    assert len(layer(two, 1).strokes) == 2


def test_ctrl_and_page_keys_choose_another_icon_with_the_brush(two):
    assert two.document.page.current.number == 1
    event = at(two, (128 + 45, 128 - 22))  # the ring's ink, beside the triangle
    QTest.mouseClick(two.view, LEFT, CTRL, event)
    assert two.document.page.current.number == 0
    assert layer(two, 0).strokes == ()
    press(two, Qt.Key.Key_PageUp)
    assert two.document.page.current.number == 1
    press(two, Qt.Key.Key_PageUp)
    assert two.document.page.current.number == 0


# -- arranging -----------------------------------------------------------------------------------


@pytest.fixture
def arranging(two):
    press(two, Qt.Key.Key_V)
    assert two.actions_by_name["arrange"].isChecked()
    return two


def test_a_click_chooses_the_topmost_ink(arranging):
    spot = (128 + 45, 128 - 22)
    QTest.mouseClick(arranging.view, LEFT, pos=at(arranging, spot))
    assert arranging.document.page.current.icon.pictogram == RING
    QTest.mouseClick(arranging.view, LEFT, pos=at(arranging, (128, 150)))
    assert arranging.document.page.current.icon.pictogram == TRIANGLE


def test_dragging_moves_an_icon_with_its_strokes_by_one_step(arranging, qtbot, session):
    press(arranging, Qt.Key.Key_B)
    stroke(arranging, (110, 160), (140, 160))
    press(arranging, Qt.Key.Key_V)
    settled(arranging, qtbot)
    count, runs = arranging.document.undo_stack.count(), len(montages(session))
    stroke(arranging, (128, 150), (149, 163), modifiers=SHIFT)
    moved = layer(arranging, 1)
    assert (moved.placement.dx, moved.placement.dy) == pytest.approx((21, 13), abs=1)
    assert moved.strokes[0].points[0] == pytest.approx((131, 173), abs=2)
    assert arranging.document.undo_stack.count() == count + 1
    settled(arranging, qtbot)
    assert len(montages(session)) == runs + 1, "one run a gesture"
    arranging.document.undo_stack.undo()
    assert layer(arranging, 1).placement == Placement()


def test_moving_a_marked_icon_over_anothers_scribble_cuts_that(arranging):
    page = arranging.document.page
    press(arranging, Qt.Key.Key_B)
    arranging.layers.chosen.emit(0)
    stroke(arranging, (190, 100), (190, 200))
    arranging.layers.chosen.emit(1)
    stroke(arranging, (120, 150), (130, 150))
    press(arranging, Qt.Key.Key_V)
    stroke(arranging, (128, 150), (193, 150), modifiers=SHIFT)
    assert len(layer(arranging, 0).strokes) == 2
    arranging.document.undo_stack.undo()
    assert len(layer(arranging, 0).strokes) == 1
    assert page.layers[0].strokes == ()


def test_a_dragged_icon_snaps_to_the_centre_unless_shift_is_held(arranging):
    icon = layer(arranging, 1)
    arranging.document.change(
        "away", arranging.document.page.placed(icon.number, Placement(1.0, False, 30, 0))
    )
    stroke(arranging, (158, 150), (130, 150))
    centre = rect_of(layer(arranging, 1).box).center()
    assert centre.x() == pytest.approx(128, abs=0.5)
    stroke(arranging, (128, 150), (126, 150))
    assert rect_of(layer(arranging, 1).box).center().x() == pytest.approx(128, abs=0.5)
    stroke(arranging, (128, 150), (122, 150), modifiers=SHIFT)
    stroke(arranging, (122, 150), (126, 150), modifiers=CTRL)
    assert rect_of(layer(arranging, 1).box).center().x() == pytest.approx(126, abs=1)


def test_guides_are_drawn_while_an_icon_snaps(arranging):
    view = arranging.view
    QTest.mousePress(view, LEFT, pos=at(arranging, (128, 150)))
    QTest.mouseMove(view, at(arranging, (129, 170)))
    guides = arranging.tools["arrange"]._snapped.guides
    assert 128 in guides.xs
    with_guides = view.grab().toImage()
    event_move(view, at(arranging, (129, 170)), SHIFT)
    assert view.grab().toImage() != with_guides
    press(arranging, Qt.Key.Key_Escape)
    QTest.mouseRelease(view, LEFT, pos=at(arranging, (129, 170)))
    assert layer(arranging, 1).placement == Placement()


@pytest.mark.thorough(but=1)
@pytest.mark.parametrize("centred", [False, True])
@pytest.mark.parametrize("corner", range(4))
def test_a_corner_scales_about_the_opposite_one_or_the_centre(arranging, corner, centred):
    before = layer(arranging, 1).box
    handle = corners(before)[corner]
    fixed = centre(before) if centred else corners(before)[(corner + 2) % 4]
    to = tuple(f + (h - f) * 0.6 for f, h in zip(fixed, handle, strict=True))
    stroke(arranging, handle, to, modifiers=SHIFT | ALT if centred else SHIFT)
    after = layer(arranging, 1)
    assert after.placement.scale == pytest.approx(0.6, abs=0.02)
    still = centre(after.box) if centred else corners(after.box)[(corner + 2) % 4]
    assert still == pytest.approx(fixed, abs=1.01)
    assert arranging.document.undo_stack.undoText() == "scale icon"


def test_arrow_keys_nudge_and_m_mirrors(arranging):
    press(arranging, Qt.Key.Key_Right)
    press(arranging, Qt.Key.Key_Up, SHIFT)
    assert layer(arranging, 1).placement == Placement(1.0, False, 1, -10)
    press(arranging, Qt.Key.Key_M)
    assert layer(arranging, 1).placement == Placement(1.0, True, 1, -10)
    assert arranging.document.undo_stack.undoText() == "mirror icon"


def test_delete_takes_the_chosen_icon_out(arranging):
    press(arranging, Qt.Key.Key_Delete)
    assert [one.number for one in arranging.document.page.layers] == [0]
    press(arranging, Qt.Key.Key_Backspace)
    assert arranging.scene.empty
    press(arranging, Qt.Key.Key_Delete)
    arranging.document.undo_stack.undo()
    arranging.document.undo_stack.undo()
    assert [one.number for one in arranging.document.page.layers] == [0, 1]


def test_an_icon_cannot_be_pushed_off_the_canvas(arranging):
    for _ in range(60):
        press(arranging, Qt.Key.Key_Left, SHIFT)
    assert rect_of(layer(arranging, 1).box).right() >= 7


# -- the list ------------------------------------------------------------------------------------


def test_rows_choose_hide_and_delete(two, qtbot):
    top, below = two.layers.rows
    assert (top.number, below.number) == (1, 0)
    QTest.mouseClick(below, LEFT, pos=below.rect().center())
    assert two.document.page.current.number == 0
    seen = two.view.grab().toImage()
    QTest.mouseClick(below.eye, LEFT)
    assert layer(two, 0).hidden
    assert two.view.grab().toImage() != seen
    QTest.mouseClick(top.bin, LEFT)
    assert [one.number for one in two.document.page.layers] == [0]
    two.document.undo_stack.undo()
    assert len(two.layers.rows) == 2


def test_rows_say_how_much_is_marked(two):
    assert two.layers.rows[0].count.text() == "not marked yet"
    stroke(two, (60, 60), (90, 60))
    assert two.layers.rows[0].count.text() == "1 stroke"


def test_rows_are_reordered_by_mouse_and_keys_without_another_run(two, qtbot, session):
    stroke(two, (100, 150), (150, 150))
    settled(two, qtbot)
    runs = len(montages(session))
    top, below = two.layers.rows
    QTest.mousePress(top, LEFT, pos=top.rect().center())
    QTest.mouseMove(top, below.rect().center() + (below.pos() - top.pos()) * 1.5)
    QTest.mouseRelease(top, LEFT, pos=top.rect().center())
    assert [one.number for one in two.document.page.layers] == [1, 0]
    assert [row.number for row in two.layers.rows] == [0, 1]
    two.layers.setFocus()
    QTest.keyClick(two.layers, Qt.Key.Key_Up, ALT)
    assert [one.number for one in two.document.page.layers] == [0, 1]
    QTest.keyClick(two.layers, Qt.Key.Key_Down)
    assert two.document.page.current.number == 0
    QTest.keyClick(two.layers, Qt.Key.Key_Delete)
    assert [one.number for one in two.document.page.layers] == [1]
    two.document.undo_stack.undo()
    settled(two, qtbot)
    assert len(montages(session)) <= runs + 2, "only taking out and putting back makes it anew"


# -- the result ----------------------------------------------------------------------------------


def test_of_many_strokes_only_the_newest_is_made_and_the_old_result_stays(two, qtbot, session):
    stroke(two, (60, 60), (90, 60))
    settled(two, qtbot)
    first = two.picture
    session.gate = threading.Semaphore(0)
    for y in (80, 100, 120, 140):
        stroke(two, (60, y), (90, y))
    assert two.picture is first
    session.gate.release(9)
    settled(two, qtbot)
    made = [len(one.layers[1].strokes) for one in montages(session)]
    assert made == [1, 2, 5]
    assert two.picture is not first
    assert session.generators_closed == 3


def test_a_run_that_hangs_gives_way_to_a_newer_one(two, qtbot, session):
    two.live.timer.setInterval(50)
    session.gate = threading.Semaphore(0)
    stroke(two, (60, 60), (90, 60))
    stroke(two, (60, 80), (90, 80))
    qtbot.waitUntil(lambda: len(montages(session)) == 2)
    session.gate.release()
    settled(two, qtbot)
    assert len(montages(session)[-1].layers[1].strokes) == 2
    assert two.picture is not None


def test_without_a_mark_the_result_goes_and_comes_back_with_undo(two, qtbot):
    stroke(two, (60, 60), (90, 60))
    settled(two, qtbot)
    two.actions_by_name["clear"].trigger()
    assert two.picture is None
    assert not two.actions_by_name["svg"].isEnabled()
    assert not two.window().pane.notice.isVisible()
    two.document.undo_stack.undo()
    qtbot.waitUntil(lambda: two.picture is not None)


def test_a_failure_is_told_and_the_next_stroke_tries_again(two, qtbot, session, monkeypatch):
    from iconstudio.model import IconstudioError

    def fail(montage):
        raise IconstudioError("It cannot be done. Try again.")
        yield

    with monkeypatch.context() as patch:
        patch.setattr(session, "montage", fail)
        stroke(two, (60, 60), (90, 60))
        qtbot.waitUntil(two.window().pane.notice.isVisible)
    assert "cannot be done" in two.window().pane.notice.label.text()
    stroke(two, (60, 80), (90, 80))
    qtbot.waitUntil(lambda: two.picture is not None)
    assert not two.window().pane.notice.isVisible()


def test_long_work_can_be_cancelled(two, qtbot, session):
    two.live.timer.setInterval(50)
    session.gate = threading.Semaphore(0)
    stroke(two, (60, 60), (90, 60))
    strip = two.window().pane.status
    qtbot.waitUntil(strip.button.isVisible)
    QTest.mouseClick(strip.button, LEFT)
    assert not two.live.running
    assert not strip.button.isVisible()
    session.gate = None
    stroke(two, (60, 80), (90, 80))
    qtbot.waitUntil(lambda: two.picture is not None)


def test_a_result_is_kept_when_it_is_used_or_left_but_not_at_every_stroke(two, qtbot, window):
    for y in (60, 80, 100):
        stroke(two, (60, y), (90, y))
        settled(two, qtbot)
    assert window.recent.pictures == () or list(window.recent.pictures) == []
    two.actions_by_name["copy"].trigger()
    assert len(window.recent.pictures) == 1
    window.show_workspace(0)
    assert len(window.recent.pictures) == 1, "it is there already"
    window.show_workspace(workspaces(window).index(two))
    stroke(two, (60, 120), (90, 120))
    settled(two, qtbot)
    window.show_workspace(0)
    assert len(window.recent.pictures) == 2


def test_the_colour_code_is_switched_by_button_and_key(two, qtbot):
    stroke(two, (60, 60), (90, 60))
    settled(two, qtbot)
    two.actions_by_name["plain"].trigger()
    plain = two.detail.large.grab().toImage()
    QTest.mouseClick(two.detail.switch.segments[Display.CODED], LEFT)
    assert two.actions_by_name["coded"].isChecked()
    assert two.detail.large.grab().toImage() != plain
    two.actions_by_name["plain"].trigger()
    assert two.detail.switch.segments[Display.PLAIN].isChecked()
    assert two.detail.large.grab().toImage() == plain


# -- files ---------------------------------------------------------------------------------------


def test_a_montage_is_saved_with_foreign_icons_beside_it_and_opened_again(
    two, qtbot, tmp_path, monkeypatch
):
    own = tmp_path / "elsewhere" / "my drawing.svg"
    own.parent.mkdir()
    own.write_text(OWN)
    two.opener.open_file(str(own))
    qtbot.waitUntil(lambda: len(two.document.page.layers) == 3)
    stroke(two, (60, 60), (90, 60))
    two.layers.chosen.emit(1)
    stroke(two, (160, 160), (190, 160))
    press(two, Qt.Key.Key_V)
    press(two, Qt.Key.Key_Right)
    path = tmp_path / "work" / "scene.json"
    path.parent.mkdir()
    save_to(two, monkeypatch, path)
    two.actions_by_name["save"].trigger()
    qtbot.waitUntil(path.exists)
    own.unlink()
    layers = json.loads(path.read_text())["layers"]
    assert [one["icon"] for one in layers][:2] == [RING.id, TRIANGLE.id]
    assert len(read_montage(path).layers) == 3
    before = two.document.page
    saved = (path.parent / layers[2]["icon"]).read_text()
    assert "<dc:title>my drawing.svg</dc:title>" in saved
    assert "M1 1h7v7z" in saved
    two.actions_by_name["new"].trigger()
    assert two.document.page.layers == ()
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *args: (str(path), ""))
    two.actions_by_name["open"].trigger()
    qtbot.waitUntil(lambda: len(two.document.page.layers) == 3)
    for one, other in zip(before.layers, two.document.page.layers, strict=True):
        assert one.placement == other.placement
        drawn, opened = (re.findall(" d=.*?/>", x.icon.pictogram.svg) for x in (one, other))
        assert drawn == opened
        assert (scribble(one.strokes) == scribble(other.strokes)).mean() > 0.999
    qtbot.waitUntil(lambda: two.picture is not None)


def test_a_montage_with_overlapping_strokes_opens_without_the_overlap(place, qtbot, tmp_path):
    strokes = [{"width": 10, "points": [[50, 50], [150, 50]]}]
    layers = [{"icon": one.id, "strokes": strokes} for one in (RING, TRIANGLE)]
    path = tmp_path / "overlap.json"
    path.write_text(json.dumps({"layers": layers}))
    place.opener.open_work(str(path))
    qtbot.waitUntil(lambda: place.picture is not None)
    assert [len(one.strokes) for one in place.document.page.layers] == [0, 1]
    notice = place.window().pane.notice
    qtbot.waitUntil(notice.isVisible)
    assert "those of the upper icon were kept" in notice.label.text()


def test_every_example_of_the_menu_opens_as_it_is(place, qtbot, session, monkeypatch):
    known = {}
    monkeypatch.setattr(
        session, "icon", lambda name: known.setdefault(name, exemplar(len(known)).pictogram)
    )
    menu = place.actions_by_name["examples"].menu().actions()
    assert [action.text() for action in menu] == [
        "A mug with a cat",
        "A palace with spires",
        "Two robots in one",
    ]
    for action in menu:
        before = place.document.page
        action.trigger()
        qtbot.waitUntil(lambda before=before: place.document.page is not before)
        settled(place, qtbot)
        assert place.picture is not None
        assert f"“{action.text()}”" in place.window().pane.status.label.text()
        assert not place.window().pane.notice.isVisible()


def test_a_montage_is_drawn_of_outlines_once_they_are_traced(place, qtbot, session, monkeypatch):
    real, gate = session.drawing, threading.Event()
    monkeypatch.setattr(session, "drawing", lambda icon: gate.wait(9) and real(icon))
    bring(place, qtbot, RING)
    ring = place.document.page.current.icon.exemplar
    pixels = place.view.grab().toImage()
    gate.set()
    qtbot.waitUntil(lambda: place.outlines.outline(ring) is not None)
    assert place.view.grab().toImage() != pixels, "the drawing of the test is the icon's box"


def test_a_file_that_is_no_montage_leaves_the_page_as_it_is(two, qtbot, tmp_path, window):
    path = tmp_path / "none.json"
    path.write_text('{"layers": 3}')
    before = two.document.page
    two.opener.open_work(str(path))
    qtbot.waitUntil(window.pane.notice.isVisible)
    assert "none.json" in window.pane.notice.label.text()
    assert two.document.page is before


def test_undo_gives_back_every_page(two, qtbot):
    stack, pages = two.document.undo_stack, [two.document.page]
    stroke(two, (60, 60), (90, 60))
    pages.append(two.document.page)
    press(two, Qt.Key.Key_V)
    drag(two, (128, 150), (160, 170))
    pages.append(two.document.page)
    for name in ("mirror", "clear", "delete"):
        two.actions_by_name[name].trigger()
        pages.append(two.document.page)
    for page in reversed(pages[:-1]):
        stack.undo()
        assert two.document.page == page
    for page in pages[1:]:
        stack.redo()
        assert two.document.page == page


@pytest.mark.thorough
def test_from_an_empty_start_to_a_saved_icon_with_the_real_session(qtbot, tmp_path, monkeypatch):
    window = MainWindow(Session(), (MONTAGE,))
    qtbot.addWidget(window)
    window.resize(1280, 720)
    window.show()
    place = window.workspace
    example = place.examples.actions()[0]
    example.trigger()
    qtbot.waitUntil(lambda: place.picture is not None, timeout=60000)
    first, icons = place.picture, place.document.page.layers
    stroke(place, (128, 100), (140, 120))
    qtbot.waitUntil(lambda: place.picture is not first, timeout=60000)
    path = tmp_path / "icon.svg"
    save_to(place, monkeypatch, path)
    place.actions_by_name["svg"].trigger()
    qtbot.waitUntil(path.exists)
    contributors = [one.id for one in own_svg(path.read_bytes(), str(path)).origins]
    assert contributors
    assert set(contributors) <= {one.icon.pictogram.id for one in icons}
    window.close()
    assert not threads_alive(window)
