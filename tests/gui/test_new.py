"""What stands beside a page that was begun anew: nothing of the one before."""

import pytest
from hands import trace, type_keyword

from iconstudio.gui.gallery.cell import CellState


@pytest.fixture
def drawn(sketching, qtbot):
    trace(sketching)
    type_keyword(sketching, "motorcycle")
    sketching.run()
    qtbot.waitUntil(lambda: not sketching.runner.running and shown(sketching) == 24, timeout=20000)
    return sketching


def shown(place):
    return len(place.browser.results.pictures)


@pytest.mark.parametrize("live", [False, True])
def test_a_new_sketch_has_no_results(drawn, live):
    if live:
        drawn.actions_by_name["live"].trigger()
    drawn.actions_by_name["new"].trigger()
    assert shown(drawn) == 0
    assert drawn.picture is None
    assert not drawn.actions_by_name["svg"].isEnabled()
    assert not drawn.browser.results._welcome.isHidden()
    assert "24" not in drawn.window().pane.status.label.text()


def test_what_was_undone_is_remixed_again(drawn, qtbot):
    drawn.actions_by_name["live"].trigger()
    drawn.actions_by_name["new"].trigger()
    drawn.actions_by_name["undo"].trigger()
    qtbot.waitUntil(lambda: shown(drawn) == 24, timeout=20000)


def test_results_of_a_name_that_was_taken_away_are_pale_until_it_is_back(drawn, qtbot):
    drawn.actions_by_name["live"].trigger()
    cell = next(iter(drawn.browser.results.grid.cells.values()))
    assert cell.state is CellState.READY
    drawn.document.change("take the name away", drawn.document.page.with_criteria(keyword=""))
    assert shown(drawn) == 24
    assert "from before the last change" in cell.accessibleName()
    assert "24" not in drawn.window().pane.status.label.text()
    drawn.actions_by_name["undo"].trigger()
    assert "before" not in cell.accessibleName()
