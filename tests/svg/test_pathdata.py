"""Outlines with a mistake: they are drawn as far as renderers draw them, and it is told."""

import xml.etree.ElementTree as ET

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.model import Frame
from iconstudio.svg.pathdata import BROKEN, cut_off_mistakes
from iconstudio.svg.resvg import render_coverage
from tests.svg.pictures import PATH, assert_shows, svg

SOUND = [
    "M20 20h60v60H20z",
    "M10,10L50-20.5.5 80 30 90zm5 5 10 0 0 10z",
    "M10 50c10-20 30 20 40 0s20-20 40 0q5 30-20 30t-20-5-20 5z",
    "M20 20a5 5 0 0110 10A20 30 45 1,0 80 80h-60 5 6z",
    "m 1e1 2.5e+1 l 50 0 -.5.5 20 20 z M 60 60 V 90 H 30 Z",
    "M 10,10, L 80,10, 80,80, z\n",
]
BROKEN_PATHS = [
    ("M20 20h60v60H20zM30 xx 30 70", "M20 20h60v60H20z"),
    ("M20 20h60v60z M10 10 a5 5 0 2 1 5 5", "M20 20h60v60zM10 10"),
    ("M20 20h60v60z{{x}}", "M20 20h60v60z"),
    ("M20 20h60 v NaN z", "M20 20h60"),
    ("M20 20L80 20L80 80L20 80Z L 5", "M20 20L80 20L80 80L20 80Z"),
    ("20 20 80 80", ""),
]


def cut(data, name="d"):
    element = ET.Element("path", {name: data})
    return element, cut_off_mistakes([element])


@pytest.mark.parametrize("data", [*SOUND, "", " ", "none"])
def test_sound_outlines_stay_as_they_are(data):
    element, said = cut(data)
    assert (element.get("d"), said) == (data, [])


@pytest.mark.parametrize(("data", "right"), BROKEN_PATHS)
def test_an_outline_ends_at_its_mistake(data, right):
    element, said = cut(data)
    assert element.get("d").replace(" ", "") == right.replace(" ", "")
    assert said == [BROKEN]


@pytest.mark.parametrize("points", ["0 0 9 0 9 9 5", "0 0 9 0 9 9 x 5 5"])
def test_a_polygon_ends_at_its_mistake(points):
    element, said = cut(points, "points")
    assert (element.get("points").strip(), said) == ("0 0 9 0 9 9", [BROKEN])


@settings(max_examples=60)
@given(st.sampled_from(SOUND), st.integers(0, 50), st.sampled_from("x .,-MZal{;+N"), st.booleans())
def test_the_renderer_draws_as_far(data, place, letter, instead):
    data = data[:place] + letter + data[place + instead :]
    element, _ = cut(data)
    drawn = [
        render_coverage(svg(f'<path stroke="#000" d="{one}"/>', 'viewBox="0 0 99 99"'), FRAME, 48)
        for one in (data, element.get("d"))
    ]
    assert np.abs(np.subtract(*drawn, dtype=int)).max() < 40


FRAME = Frame(0, 0, 99)


def test_a_broken_outline_is_told():
    broken = '<path d="M5 5 L 10 foo"/>'
    assert_shows(svg(PATH + broken), PATH, remarks=["mistake"])
    hidden = f"<defs>{broken}</defs>"
    assert_shows(svg(PATH + hidden), PATH)
