"""Dithered drawings in few colours become what they show."""

import tracemalloc

import numpy as np
import pytest
from PIL import Image

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised
from iconstudio.algorithms.scanning.dithering import without_dithering
from tests import scans
from tests.algorithms.test_tone import rgba

pytestmark = pytest.mark.thorough

FACE = (
    '<circle cx="16" cy="16" r="14" fill="#ffe8b8"/>'
    '<path d="M16 2a14 14 0 0 1 0 28z" fill="#e8a33c"/>'
    '<circle cx="10" cy="13" r="2.5" fill="#3a2a20"/>'
    '<circle cx="22" cy="13" r="2.5" fill="#3a2a20"/>'
    '<path d="M8 20q8 9 16 0" fill="none" stroke="#3a2a20" stroke-width="2.5"/>'
)
CUBE = (
    '<path d="M16 2 29 9 16 16 3 9z" fill="#c9c9c9"/><path d="M3 9 16 16V30L3 23z" fill="#777"/>'
    '<path d="M29 9 16 16V30L29 23z" fill="#333"/>'
)
ORDERED = np.array([[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]]) / 16 - 0.47


def drawn(svg: str, side: int) -> Image.Image:
    drawing = Image.fromarray(rgba(svg, side, "0 0 32 32"))
    page = Image.new("RGB", drawing.size, "white")
    page.paste(drawing, (0, 0), drawing)
    return page


def diffused(page: Image.Image, colours: int) -> Image.Image:
    few = page.quantize(colours, dither=Image.Dither.NONE)
    return page.quantize(palette=few, dither=Image.Dither.FLOYDSTEINBERG).convert("RGB")


def ordered(page: Image.Image, levels: int) -> Image.Image:
    pixels = np.asarray(page) * ((levels - 1) / 255)
    times = -(-max(page.size) // 4)
    pattern = np.tile(ORDERED, (times, times))[: page.height, : page.width, None]
    few = np.clip(np.rint(pixels + pattern), 0, levels - 1) * (255 / (levels - 1))
    return Image.fromarray(np.rint(few).astype(np.uint8))


def ink(pixels: np.ndarray) -> np.ndarray:
    found = recognised(pixels)
    assert found.found and not found.shaded
    return scans.fitted(ink_of(found).astype(float))


@pytest.mark.parametrize(
    ("svg", "side", "dithered"),
    [
        (FACE, 96, lambda page: ordered(page, 3)),
        (FACE, 128, lambda page: diffused(page, 4)),
        (CUBE, 128, lambda page: page.convert("1").convert("RGB")),
    ],
)
def test_a_dithered_drawing_is_as_what_it_shows(svg, side, dithered):
    page = drawn(svg, side)
    assert scans.iou(ink(np.asarray(dithered(page))), ink(np.asarray(page))) > 0.9


@pytest.mark.thorough
def test_it_may_be_transparent_or_large():
    page = drawn(FACE, 520)
    alpha = rgba(FACE, 520, "0 0 32 32")[..., 3] // 128 * 255
    free = np.dstack([np.asarray(ordered(page, 3)), alpha]) * (alpha > 0)[..., None]
    whole = np.dstack([np.asarray(page), alpha])
    assert scans.iou(ink(free), ink(whole)) > 0.9


@pytest.mark.parametrize("side", [64, 128])
def test_what_is_not_dithered_is_as_it_is(side):
    for svg in (FACE, CUBE):
        for page in (drawn(svg, side), drawn(svg, side).quantize(8, dither=0).convert("RGB")):
            pixels = np.asarray(page)
            assert without_dithering(pixels) is pixels


def test_a_code_of_squares_is_not_dithered():
    code = np.random.default_rng(1).integers(0, 2, (33, 33, 1), np.uint8).repeat(3, axis=2) * 255
    assert without_dithering(code) is code


def test_a_large_picture_takes_little_memory():
    large = np.full((3000, 3000, 4), 255, np.uint8)
    large[500:2500, 500:2500, :3] = 0
    tracemalloc.start()
    without_dithering(large)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert most < 4 * large.nbytes
