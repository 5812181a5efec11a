"""A say in every part of the picked result, in the real window with the session without icons."""

import pytest
from hands import trace, type_keyword


@pytest.fixture
def place(window, qtbot):
    """A sketch with its results, one of them picked."""
    place = window.workspace
    trace(place)
    type_keyword(place, "dog")
    place.run()
    qtbot.waitUntil(lambda: place.picture is not None and not place.runner.running)
    return place


def chosen(menu, text):
    (action,) = [one for one in menu.actions() if one.text() == text and one.isVisible()]
    action.trigger()


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
