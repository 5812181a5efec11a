"""Edges of a drawing that its pictogram lacks are told, and none are told that nobody sees."""

import io

import numpy as np
import pytest
from PIL import Image

from iconstudio.algorithms.scanning.binarisation import recognised
from iconstudio.algorithms.tones import tone
from iconstudio.algorithms.tones.alternation import Omission
from tests.algorithms.test_tone import rgba

pytestmark = pytest.mark.thorough(but=1)

PIN = '<path d="M12 8a3 3 0 0 1 3 3c0 2-3 5-3 5s-3-3-3-5a3 3 0 0 1 3-3z" fill="{}"/>'
MAP = '<path d="M2 6l7-3v15l-7 3z" fill="{0}"/><path d="M9 3l6 3v15l-6-3z" fill="{1}"/>'
MAP += '<path d="M15 6l7-3v15l-7 3z" fill="{0}"/>'
EYES = '<path d="M7 9h2v3H7zM15 9h2v3h-2z" fill="#333"/>'
HALVES = '<circle cx="12" cy="12" r="10" fill="{}"/><path d="M12 2a10 10 0 0 1 0 20z" fill="{}"/>'
GLASS = '<path d="M2 2h20v20H2z" fill="#8d6e63"/><path d="M5 5h14v14H5z" fill="{}"/>'
GLASS += '<path d="M5 19L19 5v14z" fill="{}"/>'
LINED = '<path d="M4 4h16v16H4z" fill="{}" stroke="#212121" stroke-width="1.5"/>'
LINED += '<path d="M13 4.7h6.3v14.6H13z" fill="{}"/>'
FRUIT = '<circle cx="12" cy="13" r="9" fill="{0}"/><path d="M6.5 12a6 6 0 0 1 5-6" fill="none" '
FRUIT += (
    'stroke="{1}" stroke-width="2.2"/><path d="M12 5c0-2 1-4 4-4 0 2-1 4-4 4z" fill="#43a047"/>'
)
KINDS = {
    "folds of a map": (MAP + PIN.format("#e53935"), "#81c784", "#66bb6a"),
    "folds of an old map": (MAP + PIN.format("#d84315"), "#f5deb3", "#e8cfa0"),
    "the darker half of a face": (HALVES + EYES, "#ffb300", "#ffa000"),
    "the darker half of a disc": (HALVES, "#e53935", "#c62828"),
    "light on glass": (GLASS, "#81d4fa", "#4fc3f7"),
    "a shade within lines": (LINED, "#ffcc80", "#ffb74d"),
    "gloss on a fruit": (FRUIT, "#e53935", "#ef7370"),
}


def saved(drawing: np.ndarray, kind: str) -> np.ndarray:
    page = Image.new("RGB", (288, 288), "white")
    free = Image.fromarray(drawing)
    page.paste(free, (16, 16), free)
    file = io.BytesIO()
    page.save(file, kind, quality=85)
    return np.asarray(Image.open(file).convert("RGB"))


@pytest.mark.parametrize("kind", KINDS)
def test_an_edge_that_is_lost_is_told(kind):
    drawing, one, other = KINDS[kind]
    assert Omission.SHADES in tone.pictogram(rgba(drawing.format(one, other), tone.SIDE)).omissions
    plain = drawing.format(one, one)
    assert Omission.SHADES not in tone.pictogram(rgba(plain, tone.SIDE)).omissions


@pytest.mark.thorough
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("file", ["PNG", "JPEG"])
def test_an_edge_that_is_lost_of_a_bitmap_is_told(kind, file):
    drawing, one, other = KINDS[kind]
    shaded, plain = (rgba(drawing.format(one, second), 256) for second in (other, one))
    assert Omission.SHADES in recognised(saved(shaded, file)).omissions
    assert Omission.SHADES not in recognised(saved(plain, file)).omissions


@pytest.mark.parametrize("stops", [(0, 1), (0.45, 0.55)])
def test_colours_that_flow_into_each_other_have_no_edge(stops):
    flowing = '<linearGradient id="a"><stop offset="{}" stop-color="#ff9800"/>'
    flowing += '<stop offset="{}" stop-color="#f44336"/></linearGradient>'
    drawing = flowing.format(*stops) + '<circle cx="12" cy="12" r="10" fill="url(#a)"/>' + EYES
    assert not tone.pictogram(rgba(drawing, tone.SIDE)).omissions


def test_gloss_goes_with_its_tile():
    tile = '<rect x="1" y="1" width="22" height="22" rx="4" fill="#1e88e5"/>'
    gloss = '<path d="M1 5a4 4 0 0 1 4-4h14a4 4 0 0 1 4 4v7H1z" fill="#2a92ec"/>'
    letter = '<path d="M7 7h10v3H13v8h-2v-8H7z" fill="#fff"/>'
    told = tone.pictogram(rgba(tile + gloss + letter, tone.SIDE)).omissions
    assert told == {Omission.TILE}


STRIPES = '<path d="M7.500 10h9M7.500 12.500h9M7.500 15h9" stroke="{}"/>'
NET = '<path d="M12 1v4M12 19v4M4 8v8M20 8v8M4 8l8-4 8 4M4 16l8 4 8-4" fill="none" stroke="{}"/>'
LINES = {
    "stripes on a box": (
        '<circle cx="12" cy="12" r="11" fill="#32bea6"/><path d="M6 8h12v9H6z" fill="#ffe05a"/>',
        STRIPES.format("#f5b400"),
    ),
    "a net behind a letter": (
        '<circle cx="12" cy="12" r="11" fill="#4b235a"/><path d="M9 8h6v8H9z" fill="#fff"/>',
        NET.format("#6f4f7b"),
    ),
}


@pytest.mark.parametrize("kind", LINES)
def test_lines_that_are_lost_on_an_even_ground_are_told(kind):
    ground, lines = LINES[kind]
    assert Omission.SHADES in tone.pictogram(rgba(ground + lines, tone.SIDE)).omissions
    assert Omission.SHADES not in tone.pictogram(rgba(ground, tone.SIDE)).omissions
