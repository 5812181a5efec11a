"""A say in every part of the picked result, in the real window."""

from dataclasses import replace

import numpy as np
import pytest
from hands import shown, trace, type_keyword
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest

from iconstudio.algorithms.iconification.guidance import scribble
from iconstudio.gui.gallery import display
from iconstudio.gui.pictures.picture import Display
from iconstudio.gui.window.main_window import MainWindow
from iconstudio.gui.workspaces.sketching import alternatives as offering
from iconstudio.gui.workspaces.sketching.workspace import SketchWorkspace
from iconstudio.model import Axis, Layer, Stroke
from iconstudio.session import Session
from iconstudio.workflows import grid
from iconstudio.workflows.criteria import exclude_icons
from iconstudio.workflows.grid import GridSettings
from iconstudio.workflows.modelling import alternatives
from iconstudio.workflows.modelling.alternatives import Tried
from iconstudio.workflows.modelling.spec import MODELLING
from iconstudio.workflows.parts import Parts


@pytest.fixture
def place(window, qtbot):
    """A sketch with its results, one of them picked."""
    place = window.workspace
    trace(place)
    type_keyword(place, "dog")
    place.run()
    qtbot.waitUntil(lambda: place.picture is not None and not place.runner.running)
    return place


@pytest.fixture
def tried(monkeypatch):
    """How each alternative would look is not computed: it looks as the result does."""

    def trying(session, sketch, composite, choices):
        for number in range(len(choices)):
            yield Tried(number, tried["icon"])

    tried = {}
    monkeypatch.setattr(offering, "trying", trying)
    return tried


def on(large, x, y) -> QPoint:
    """Return where a point of the picked result is seen, in canvas units."""
    return large._placing.map(QPointF(x, y)).toPoint()


def click_part(place, tried, qtbot, *point):
    """Click a part, and wait for what is offered."""
    tried["icon"] = place.picture.icon
    large = place.detail.large
    QTest.mouseClick(large, Qt.MouseButton.LeftButton, pos=on(large, *point))
    assert place.alternatives.popup.isVisible()
    qtbot.waitUntil(lambda: not place.alternatives.runner.running)
    return place.alternatives.popup


def chosen(menu, text):
    (action,) = [one for one in menu.actions() if one.text() == text and one.isVisible()]
    action.trigger()


@pytest.mark.parametrize("how", [Display.PLAIN, Display.BOTH, Display.CODED])
def test_pointing_at_a_part_outlines_it_and_names_its_source(place, how):
    display.setting.choose(how)
    large = place.detail.large
    plain = large.grab().toImage()
    seen = []
    for point, label in (((60, 60), 0), ((200, 60), 1), ((128, 200), 2)):
        QTest.mouseMove(large, on(large, *point))
        assert large.part.label == label
        assert large.part.source is place.picture.icon.composite.sources[label]
        seen.append(large.grab().toImage())
        assert seen[-1] != plain
    assert seen[0] != seen[1] != seen[2]
    QTest.mouseMove(large, on(large, 8, 8))
    assert large.part is None
    assert large.grab().toImage() == plain


def test_a_chosen_alternative_is_pinned_remixed_and_undone(place, tried, qtbot, session):
    popup = click_part(place, tried, qtbot, 60, 60)
    assert not popup.unpin.isVisible()
    pictures = popup.sheet.pictures
    assert 1 < len(pictures) <= 8
    assert all(one.icon.path == place.picture.icon.path for one in pictures)
    assert "shapes:" in pictures[1].title
    runs = len([one for one in session.calls if one[0] == "model"])
    popup.sheet.chosen.emit(pictures[1])
    assert not popup.isVisible()
    (pin,) = place.page.sketch.pins
    assert pin.icon.name == pictures[1].title
    qtbot.waitUntil(lambda: len([one for one in session.calls if one[0] == "model"]) > runs)
    assert session.calls[-1][1].pins == (pin,)
    assert session.calls[-1][2].focus == place.browser.results.focus  # it comes first
    qtbot.waitUntil(lambda: not place.runner.running)
    place.document.undo_stack.undo()
    assert place.page.sketch.pins == ()


@pytest.mark.thorough
def test_a_pinned_part_is_marked_and_can_be_unpinned(place, tried, qtbot):
    large = place.detail.large
    before = large.grab().toImage()
    popup = click_part(place, tried, qtbot, 60, 60)
    popup.sheet.chosen.emit(popup.sheet.pictures[0])
    qtbot.waitUntil(lambda: not place.runner.running)
    assert large.grab().toImage() != before
    popup = click_part(place, tried, qtbot, 60, 60)
    assert popup.unpin.isVisible()
    popup.unpin.click()
    assert place.page.sketch.pins == ()
    assert not place.actions_by_name["unpin"].isEnabled()
    place.document.undo_stack.undo()
    place.actions_by_name["unpin"].trigger()
    assert place.page.sketch.pins == ()
    qtbot.waitUntil(lambda: not place.runner.running)


def test_a_popup_that_is_left_stops_looking(place, qtbot, monkeypatch):
    def trying(session, sketch, composite, choices):
        while True:
            yield None

    monkeypatch.setattr(offering, "trying", trying)
    large, popup = place.detail.large, place.alternatives.popup
    QTest.mouseClick(large, Qt.MouseButton.LeftButton, pos=on(large, 60, 60))
    qtbot.waitUntil(lambda: popup.sheet.pictures != ())
    assert place.alternatives.runner.running
    popup.hide()
    assert not place.alternatives.runner.running
    assert place.page.sketch.pins == ()


def test_a_part_without_alternatives_says_so(place, qtbot, monkeypatch):
    monkeypatch.setattr(offering, "alternatives", lambda part: ())
    large, popup = place.detail.large, place.alternatives.popup
    QTest.mouseClick(large, Qt.MouseButton.LeftButton, pos=on(large, 60, 60))
    qtbot.waitUntil(lambda: "No other icon" in popup.sheet.accessibleDescription())
    popup.hide()


def test_a_pin_whose_icon_is_left_out_is_told_as_long_as_that_is_so(window, place):
    icon = place.picture.icon.composite.sources[0].exemplar.pictogram
    pin = Layer(icon, strokes=(Stroke(9.0, ((60.0, 60.0),)),))
    page = place.page
    place.document.change("pin part", replace(page, sketch=replace(page.sketch, pins=(pin,))))
    assert not window.pane.notice.isVisible()
    exclude_icons(place.document, frozenset({icon.id}))
    assert window.pane.notice.isVisible()
    assert icon.name in window.pane.notice.label.text()
    assert place.page.sketch.pins == (pin,)
    exclude_icons(place.document, frozenset())
    assert not window.pane.notice.isVisible()


def test_a_result_is_opened_in_montage_as_its_sources(window, place, qtbot):
    menu = place.detail._send.menu()
    menu.aboutToShow.emit()
    chosen(menu, "Open in Montage")
    montage = window.workspace
    assert montage.workflow.title == "Montage"
    qtbot.waitUntil(lambda: len(montage.page.layers) > 0)
    sources = place.picture.icon.composite.sources
    assert {(one.icon.exemplar.id, one.placement) for one in montage.page.layers} == {
        (one.exemplar.id, one.placement) for one in sources[:3]
    }
    assert all(one.strokes for one in montage.page.layers)
    montage.document.undo_stack.undo()
    assert montage.page.layers == ()


@pytest.mark.thorough
def test_what_is_chosen_for_a_symmetric_result_opens_in_montage(window, place, tried, qtbot):
    icon = place.picture.icon
    icon = replace(icon, composite=replace(icon.composite, symmetry=Axis.HORIZONTAL))
    tried["icon"] = icon
    popup = place.alternatives.popup
    place.alternatives.offer(Parts(icon).at((60, 60)), place.mapToGlobal(QPoint(0, 0)))
    assert "opens in Montage" in popup._note.text() and popup._note.isVisible()
    assert popup.sheet.pictures == ()  # what is not tried cannot be opened
    qtbot.waitUntil(lambda: not place.alternatives.runner.running)
    assert len(popup.sheet.pictures) > 1
    popup.sheet.chosen.emit(popup.sheet.pictures[1])
    assert place.page.sketch.pins == ()
    assert window.workspace.workflow.title == "Montage"
    qtbot.waitUntil(lambda: len(window.workspace.page.layers) > 0)


@pytest.mark.thorough
def test_a_part_is_pinned_with_the_real_session(qtbot, monkeypatch):
    few = GridSettings(styles=("dark",), lambdas=(0.1,))
    monkeypatch.setattr(SketchWorkspace, "settings", lambda self: few)
    monkeypatch.setattr(grid, "LAMBDAS", (0.1,))  # no others are searched beside it
    monkeypatch.setattr(alternatives, "MOST", 2)
    with shown(MainWindow(Session(), (MODELLING,)), qtbot) as window:
        place = window.workspace
        trace(place)
        type_keyword(place, "anvil")
        place.run()
        qtbot.waitUntil(lambda: place.picture is not None, timeout=60000)
        qtbot.waitUntil(lambda: not place.runner.running, timeout=60000)  # a symmetric one, too
        before, large = place.picture, place.detail.large
        parts = large._parts
        ys, xs = np.nonzero(parts._pieces)
        middle = len(xs) // 2
        unit = 256 / len(parts._pieces)
        spot = on(large, (xs[middle] + 0.5) * unit, (ys[middle] + 0.5) * unit)
        QTest.mouseClick(large, Qt.MouseButton.LeftButton, pos=spot)
        popup = place.alternatives.popup
        qtbot.waitUntil(lambda: len(popup.sheet.pictures) > 0, timeout=60000)
        qtbot.waitUntil(lambda: not place.alternatives.runner.running, timeout=60000)
        popup.sheet.chosen.emit(popup.sheet.pictures[0])
        qtbot.waitUntil(lambda: place.picture is not before, timeout=60000)
        (pin,) = place.page.sketch.pins
        composite = place.picture.icon.composite
        owners = composite.labels[scribble(pin.strokes)]
        assert {composite.sources[one].exemplar.id for one in owners} == {pin.icon.id}
