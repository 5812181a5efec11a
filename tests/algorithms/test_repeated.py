"""Small bitmaps that were enlarged sharply become what they become unenlarged."""

import io

import numpy as np
import pytest
from PIL import Image

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised
from iconstudio.algorithms.scanning.repeated import unrepeated
from tests.algorithms.test_tone import rgba

pytestmark = pytest.mark.thorough

VIEW = "0 0 24 24"
BLACK = '<circle cx="12" cy="12" r="9" fill="none" stroke="#000" stroke-width="2"/>'
COLOURED = (
    '<circle cx="12" cy="12" r="11.5" fill="#1d9bf0"/>'
    '<path d="M4 9l7 9 9-12z" fill="#fc0"/><circle cx="11" cy="11" r="3" fill="#c22"/>'
)
WHITE = BLACK.replace("#000", "#fff")


def enlarged(pixels, times):
    return pixels.repeat(times, axis=0).repeat(times, axis=1)


def on(ground, drawing):
    pixels = rgba(drawing, 24, VIEW)
    if ground is None:
        return pixels
    alpha = pixels[..., 3:] / 255
    return np.rint(pixels[..., :3] * alpha + np.array(ground) * (1 - alpha)).astype(np.uint8)


DRAWINGS = {
    "black on nothing": on(None, BLACK),
    "black on white": on((255, 255, 255), BLACK),
    "white on dark": on((20, 30, 60), WHITE),
    "colours on nothing": on(None, COLOURED),
    "colours on white": on((255, 255, 255), COLOURED),
}


@pytest.mark.parametrize("times", [2, 3, 4, 8, 16, 32])
@pytest.mark.parametrize("name", DRAWINGS)
def test_what_was_enlarged_sharply_is_as_it_was(name, times):
    pixels = DRAWINGS[name]
    assert np.array_equal(unrepeated(enlarged(pixels, times)), pixels)
    assert unrepeated(pixels) is pixels


def test_it_may_be_cropped():
    pixels = DRAWINGS["black on white"]
    assert np.array_equal(unrepeated(enlarged(pixels, 8)[3:-2, 5:]), pixels)


def test_it_may_have_a_palette():
    file = io.BytesIO()
    small = Image.fromarray(DRAWINGS["colours on white"]).quantize(32)
    small.resize((384, 384), Image.Resampling.NEAREST).save(file, "GIF")
    pixels = np.asarray(Image.open(file).convert("RGB"))
    assert np.array_equal(unrepeated(pixels), np.asarray(small.convert("RGB")))


@pytest.mark.parametrize("name", ["black on white", "colours on nothing"])
def test_its_greys_are_no_lines(name):
    pixels = DRAWINGS[name]
    assert np.array_equal(ink_of(recognised(enlarged(pixels, 8))), ink_of(recognised(pixels)))


@pytest.mark.parametrize("shaded", [False, True])
def test_hard_edges_stay(shaded):
    """So they do where a shade of the drawing happens to lie between two others."""
    levels = np.array([[255, 255, 255], [55, 15, 35], [155, 135, 145]], np.uint8)
    y, x = np.mgrid[-8:8, -8:8] + 0.5
    away = np.hypot(y, x)
    art = (away < 7).astype(int)
    if shaded:
        art[(away < 7) & ((away > 6) | (y > 0))] = 2
    pixels = enlarged(levels[art], 8)
    assert unrepeated(pixels) is pixels
