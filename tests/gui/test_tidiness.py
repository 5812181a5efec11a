"""Results tidied, and as they were before, in the real window."""

from dataclasses import replace

import numpy as np
import pytest
from hands import press, search, trace, type_keyword, workspaces
from PySide6.QtCore import Qt

from iconstudio.gui.gallery import tidiness
from iconstudio.gui.pictures.picture import picture_of
from iconstudio.gui.preferences import preferred
from iconstudio.model import Axis


@pytest.fixture
def results(sketching, qtbot):
    """A window whose grid is full."""
    trace(sketching)
    type_keyword(sketching, "motorcycle")
    press(sketching, Qt.Key.Key_Return, Qt.KeyboardModifier.ControlModifier)
    qtbot.waitUntil(lambda: sketching.browser.results.finished == 24, timeout=20000)
    qtbot.waitUntil(lambda: not sketching.runner.running, timeout=20000)
    yield sketching
    tidiness.setting.choose(True)


def test_the_switch_shows_what_was_before_and_back(results, qtbot, session):
    panel, detail = results.browser.results, results.detail
    calls, tidy = list(session.calls), {id(one): one for one in panel.pictures}
    large = detail.picture
    qtbot.mouseClick(panel.tidy_switch.button, Qt.MouseButton.LeftButton)
    assert detail.picture.icon.path == large.icon.drawing.untidied != large.icon.path
    assert {one.icon.path for one in panel.pictures} == {
        one.icon.drawing.untidied for one in tidy.values()
    }
    assert not preferred("tidy", True), "remembered"
    assert session.calls == calls, "nothing is solved again"
    assert panel.finished == 24
    qtbot.mouseClick(panel.tidy_switch.button, Qt.MouseButton.LeftButton)
    assert {id(one) for one in panel.pictures} == set(tidy)
    assert detail.picture is large


def test_what_is_shown_is_what_is_picked_kept_and_saved(results, qtbot):
    panel = results.browser.results
    panel.tidy_switch.button.click()
    kept = []
    results.browser.kept.connect(kept.append)
    cell = panel.cell("light", panel.grid.lambdas[2])
    qtbot.mouseClick(cell, Qt.MouseButton.LeftButton)
    (one,) = kept
    assert one.icon.path == cell.picture.tidied.icon.drawing.untidied
    assert results.picture is one
    assert one.icon.drawing.path == one.icon.path
    drawn = one.icon.drawing.coverage > 127
    hole = ~drawn[128]
    wide = ~(cell.picture.tidied.icon.drawing.coverage > 127)[128]
    assert drawn.shape == cell.picture.tidied.icon.drawing.coverage.shape
    assert np.flatnonzero(hole).size != np.flatnonzero(wide).size


def test_results_that_come_while_it_is_off_are_not_tidied(results, qtbot):
    panel = results.browser.results
    panel.tidy_switch.button.click()
    type_keyword(results, "car")
    press(results, Qt.Key.Key_Return, Qt.KeyboardModifier.ControlModifier)
    qtbot.waitUntil(lambda: not results.runner.running, timeout=20000)
    qtbot.waitUntil(lambda: panel.finished == 24, timeout=20000)
    assert all(one.tidied is not None for one in panel.pictures)


def test_symmetric_results_follow_the_switch_too(results):
    """Whichever stands in a place, and whenever the switch was turned."""
    panel = results.browser.results
    before = panel.pictures[0]
    symmetric = replace(before.icon.composite, symmetry=Axis.HORIZONTAL)
    results.browser.show_event(picture_of(replace(before.icon, composite=symmetric)))
    cell = panel.cell(symmetric.style, symmetric.lambda_s)
    for button in (panel.tidy_switch.button, *2 * [panel.symmetric_switch.button]):
        button.click()
        assert cell.picture.tidied is not None, "shown as it was joined"


@pytest.fixture
def hybrids(window, qtbot):
    """The workspace of hybrids with its first batch, the best of which is picked."""
    place = window.workspace_of("Hybrids")
    window.show_workspace(workspaces(window).index(place))
    search(place.column.chooser, "lamp")
    place.column.count.setValue(4)
    place.column.pick.click()
    qtbot.waitUntil(lambda: not place.opener.runner.running, timeout=20000)
    place.column.run.click()
    qtbot.waitUntil(lambda: not place.draws.runner.running, timeout=20000)
    place.sheet.setCurrentIndex(place.sheet.model().index(0))
    yield place
    tidiness.setting.choose(True)


@pytest.mark.thorough
def test_hybrids_are_shown_and_saved_as_the_switch_says(hybrids, qtbot):
    tidy, many = hybrids.picture, hybrids.sections.pictures
    hybrids.keep(tidy)
    qtbot.mouseClick(hybrids.panel.tidy_switch.button, Qt.MouseButton.LeftButton)
    shown = hybrids.picture
    assert shown.tidied is tidy
    assert hybrids.detail.picture is shown
    assert shown.icon.path == tidy.icon.drawing.untidied != tidy.icon.path
    assert hybrids.sections.pictures == many, "nothing is drawn again"
    model = hybrids.sheet.model()
    assert model.is_marked(model.entry(model.index(0))), "it is a favourite either way"
    hybrids.draw_like(shown)
    qtbot.waitUntil(lambda: not hybrids.draws.runner.running, timeout=20000)
    hybrids.keep(shown)
    assert not hybrids.page.favourites
    qtbot.mouseClick(hybrids.panel.tidy_switch.button, Qt.MouseButton.LeftButton)
    assert hybrids.picture is tidy
