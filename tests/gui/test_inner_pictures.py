"""The paper's inner pictures, beside the page that they are of."""

from dataclasses import replace

import numpy as np
import pytest
from fake_session import exemplar
from hands import action, go_to, trace

from iconstudio.gui.gallery.inner_pictures import InnerPicturesWindow
from iconstudio.gui.workspaces.inner_pictures import NOTHING
from iconstudio.model import CANVAS, Placement, Stroke
from iconstudio.workflows.editing.page import Area, Kind
from iconstudio.workflows.montage.page import IconShape, MontagePage, PlacedIcon


@pytest.fixture
def opened(window, qtbot):
    """Returns the window of the inner pictures of a workspace."""

    def open_in(title):
        place = go_to(window, title)
        action(window, "inner_pictures").trigger()
        inner = place.findChild(InnerPicturesWindow)
        assert inner.isVisible()
        return place, inner

    return open_in


def pictures(inner):
    inner.grab()
    return inner.pictures


def test_the_regions_of_a_sketch_as_they_are_weighted(opened, qtbot):
    place, inner = opened("Sketch")
    assert inner.note.text() == NOTHING
    trace(place)
    qtbot.waitUntil(lambda: len(pictures(inner)) == 3)
    distance, _, regions = pictures(inner)
    middle = distance.values[CANVAS // 2, CANVAS // 2]
    assert middle != distance.values[0, 0]
    assert 1 < len(regions.positions) <= 9
    for x, y in regions.positions:
        assert regions.values[int(y), int(x)] > 0.9


def test_the_change_of_an_edit(opened, qtbot):
    place, inner = opened("Edit")
    place.take(exemplar(5).pictogram)
    qtbot.waitUntil(lambda: place.page.icon is not None)
    corner = ((20.0, 20.0), (90.0, 20.0), (90.0, 90.0), (20.0, 90.0))
    place.document.change("x", place.page.with_areas((Area(Kind.REMOVE, corner),)))
    _, distance, gives_way = pictures(inner)
    assert distance.values[50, 50] == 0
    assert distance.values[200, 200] == 1
    assert gives_way.values[50, 50] == 1
    assert gives_way.values[50, 94] == 0  # beside what is only taken off
    beside = ((1.0, 1.0), (3.0, 1.0), (3.0, 3.0))
    place.document.change("x", place.page.with_areas((Area(Kind.REMOVE, beside),)))
    assert not pictures(inner)
    assert "beside the icon" in inner.note.text()
    inner.close()
    place.document.change("x", place.blank)  # nothing follows any more


def test_the_scribbles_of_a_montage(opened, qtbot):
    place, inner = opened("Montage")
    stroke = Stroke(10, ((100.0, 100.0), (150.0, 100.0)))
    layers = tuple(
        PlacedIcon(number, IconShape(exemplar(number)), Placement(), strokes)
        for number, strokes in enumerate(((stroke,), ()), 1)
    )
    place.document.change("x", MontagePage(layers, 1))
    (only,) = pictures(inner)
    assert only.values[100, 120] == 0
    assert only.values[140, 120] == 1


def test_the_seeds_of_a_hybrid(opened, qtbot):
    place, inner = opened("Hybrids")
    place.column.count.setValue(3)
    place.column.chooser.field.setText("lamp")
    place.pick()
    qtbot.waitUntil(lambda: len(place.page.ids) == 3)
    place.run()
    qtbot.waitUntil(lambda: bool(place.sections.in_sight), timeout=20000)
    shown = place.sections.in_sight[0]
    seeds = tuple(((40.0 * n + 20, 100.0),) for n in range(len(shown.icon.composite.sources)))
    place.look_at(replace(shown, icon=replace(shown.icon, seeds=seeds)))
    found = pictures(inner)
    assert [one.positions for one in found] == list(seeds)
    for one, ((x, y),) in zip(found, seeds, strict=True):
        assert one.values[int(y), int(x)] == 0
    assert np.ptp([one.values.min() for one in found]) == 0
