"""What is brought onto pages, without a window."""

from types import SimpleNamespace

import pytest

from iconstudio.importing.edits import EditImporter
from iconstudio.importing.importer import Opened
from iconstudio.importing.mixes import MixImporter
from iconstudio.importing.montages import MontageImporter
from iconstudio.importing.patterns import PatternImporter
from iconstudio.importing.sketches import SketchImporter
from iconstudio.inputs.items import File, Image, Reference
from iconstudio.inputs.together import ReadTogether
from iconstudio.model import IconstudioError
from iconstudio.workflows.hybrids.hybrids import MOST
from iconstudio.workflows.hybrids.page import HybridsPage, PickRequest, next_pick
from iconstudio.workflows.montage.montage import MOST as MOST_LAYERS
from iconstudio.workflows.montage.page import IconShape, MontagePage
from tests.gui.fake_session import exemplar


class Held:
    """A document that keeps no way back."""

    def __init__(self, page):
        self.page = page
        self.steps = []

    def change(self, text, after, gesture=None):
        self.steps.append(text)
        self.page = after


def read(icons):
    return ReadTogether(tuple(one.name for one in icons), tuple(icons))


def test_icons_to_mix_that_find_no_room_are_told():
    document = Held(HybridsPage())
    importer = MixImporter(SimpleNamespace(), document)
    said, left = importer.put(read([exemplar(number) for number in range(MOST + 2)]))
    assert len(document.page.ingredients) == MOST
    assert document.steps == ["add icons"]
    assert said.startswith("Added “ring 0”")
    assert "were not added: at most 12 icons can be mixed." in left
    (again,) = importer.put(read([exemplar(3)]))
    assert again == "“triangle 3” is among the icons already."
    with pytest.raises(IconstudioError, match="Remove one first"):
        importer.put(read([exemplar(40)]))


def test_layers_that_find_no_room_are_told():
    document = Held(MontagePage())
    icons = [exemplar(number % 8) for number in range(MOST_LAYERS + 1)]
    shapes = tuple(map(IconShape, icons))
    gathered = ReadTogether(tuple(one.name for one in icons), shapes)
    said, left = MontageImporter(SimpleNamespace(), document).put(gathered)
    assert len(document.page.layers) == MOST_LAYERS
    assert said.startswith("Added")
    assert "was not added" in left


def test_an_image_becomes_what_the_page_is_made_of():
    image, drawing, icon = File("cat.PNG"), File("cat.svg"), Reference("mdi:cat")
    document = Held(None)
    sketch, edit = SketchImporter(None, document), EditImporter(None, document)
    assert not sketch.becomes_icon(image)
    assert edit.becomes_icon(image)
    assert edit.becomes_icon(Image(b""))
    assert not edit.becomes_icon(drawing)
    pattern = PatternImporter(None, document)
    assert pattern.alone(image) is not None
    assert pattern.alone(drawing) is pattern.alone(icon) is None
    pattern.wants_shape = lambda: True
    assert pattern.alone(image) is None


def test_the_program_picks_the_next_best_icons_when_asked_once_more():
    first = next_pick(HybridsPage(), "lamp", 4)
    assert first == PickRequest("lamp", 4, None)
    again = next_pick(HybridsPage(ask=first), "lamp", 4)
    assert again == PickRequest("lamp", 4, None, group=1)
    assert next_pick(HybridsPage(ask=again), "lamp", 5).group == 0


def test_a_file_is_one_step_on_the_page(tmp_path):
    path = tmp_path / "two.json"
    path.write_text('{"icons": ["shapes:ring-0", "shapes:frame-1"]}')
    known = {one.id: one for one in map(exemplar, range(2))}
    session = SimpleNamespace(
        icon=lambda name: known[name].pictogram, exemplar=lambda icon: known[icon.id]
    )
    document = Held(HybridsPage(favourites=("kept",)))
    *_, opened = MixImporter(session, document).opening(path)
    assert isinstance(opened, Opened)
    assert document.steps == []
    opened.put(document)
    assert document.steps == ["open mix"]
    assert document.page.ids == known.keys()
    assert document.page.favourites == ("kept",)
