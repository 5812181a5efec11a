"""Holding a sketch to symmetry, and the pen, in the real window."""

import pytest
from hands import SQUARE, trace
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QInputDevice, QPointingDevice, QTabletEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from iconstudio.gui.canvas import painters
from iconstudio.gui.canvas.tools.base import Tool
from iconstudio.gui.panels.symmetry import WORDS
from iconstudio.model import Axis

HOUSE = [(150.0, 250.0), (250.0, 150.0), (350.0, 250.0), (350.0, 400.0), (150.0, 400.0)]


def axis_of(place):
    return place.document.page.sketch.symmetry


@pytest.mark.parametrize("axis", [*Axis])
def test_an_axis_is_chosen_drawn_and_undone(sketching, axis):
    trace(sketching)
    before = sketching.view.grab().toImage()
    action = next(a for a in sketching.symmetry.menu().actions() if a.text() == WORDS[axis])
    action.trigger()
    assert axis_of(sketching) is axis
    assert action.isChecked()
    assert WORDS[axis].lower() in sketching.symmetry.accessibleName()
    assert sketching.view.grab().toImage() != before
    sketching.actions_by_name["undo"].trigger()
    assert axis_of(sketching) is None
    assert sketching.symmetry.accessibleName() == "Symmetry: no symmetry"
    assert not action.isChecked()


def test_choosing_the_same_again_is_no_step(sketching):
    trace(sketching)
    count = sketching.document.undo_stack.count()
    sketching.symmetry.chosen.emit(None)
    assert sketching.document.undo_stack.count() == count


def test_every_axis_has_an_icon_of_its_own(sketching):
    icons = [action.icon().pixmap(20).toImage() for action in sketching.symmetry.menu().actions()]
    assert len(icons) == 5
    assert all(a != b for i, a in enumerate(icons) for b in icons[:i])


def test_symmetry_is_offered_for_what_is_nearly_symmetric(sketching, qtbot):
    trace(sketching, HOUSE)
    qtbot.waitUntil(sketching.symmetry_hint.isVisible)
    assert sketching.symmetry_hint.geometry().bottom() < painters.OFFER_ROOM
    QTest.mouseClick(sketching.symmetry_hint, Qt.MouseButton.LeftButton)
    assert axis_of(sketching) is Axis.HORIZONTAL
    assert not sketching.symmetry_hint.isVisible()
    sketching.actions_by_name["undo"].trigger()
    assert sketching.symmetry_hint.isVisible()
    sketching.actions_by_name["clear"].trigger()
    assert not sketching.symmetry_hint.isVisible()


def test_nothing_is_offered_for_what_is_not(sketching, qtbot):
    with qtbot.waitSignals([sketching.symmetry_detection.found] * 2):
        trace(sketching, [(100, 100), (420, 130), (300, 200), (180, 420)])
    qtbot.wait(400)
    assert not sketching.symmetry_hint.isVisible()


class Listener(Tool):
    def __init__(self):
        self.heard = []

    def press(self, pointer):
        self.heard.append(("press", pointer))

    def move(self, pointer):
        self.heard.append(("move", pointer))

    def release(self, pointer):
        self.heard.append(("release", pointer))


@pytest.mark.parametrize("turned", [False, True])
def test_a_pen_comes_with_its_pressure_and_once(sketching, turned):
    tool = Listener()
    view = sketching.view
    view.set_tool(tool)
    kind = QPointingDevice.PointerType
    pen = QPointingDevice(
        "pen",
        1,
        QInputDevice.DeviceType.Stylus,
        kind.Eraser if turned else kind.Pen,
        QInputDevice.Capability.Position | QInputDevice.Capability.Pressure,
        1,
        1,
    )
    left = Qt.MouseButton.LeftButton
    spot = QPointF(100, 80)
    for moment, pressure, button in (
        (QEvent.Type.TabletPress, 0.25, left),
        (QEvent.Type.TabletMove, 0.5, Qt.MouseButton.NoButton),
        (QEvent.Type.TabletRelease, 0.0, left),
    ):
        event = QTabletEvent(
            moment, pen, spot, view.mapToGlobal(spot), pressure, 0, 0, 0, 0, 0,
            Qt.KeyboardModifier.NoModifier, button, left,
        )  # fmt: skip
        QApplication.sendEvent(view, event)
        assert event.isAccepted(), "so that Qt makes no mouse events of it"
    assert [name for name, _ in tool.heard] == ["press", "move", "release"]
    assert [pointer.pressure for _, pointer in tool.heard] == pytest.approx([0.25, 0.5, 0.0])
    assert all(pointer.eraser is turned for _, pointer in tool.heard)
    assert tool.heard[0][1].page == pytest.approx(view.camera.to_page(spot))
    assert view.hasFocus()


def test_a_mouse_presses_with_all_its_might(sketching):
    tool = Listener()
    sketching.view.set_tool(tool)
    QTest.mousePress(
        sketching.view,
        Qt.MouseButton.LeftButton,
        pos=sketching.view.camera.to_view(SQUARE[0]).toPoint(),
    )
    assert tool.heard[-1][1].pressure == 1.0
