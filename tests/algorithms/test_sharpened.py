"""Bands that sharpening leaves along edges become no lines."""

import io

import numpy as np
import pytest
from PIL import Image, ImageFilter

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised
from iconstudio.algorithms.scanning.sharpened import unsharpened
from tests import scans
from tests.algorithms.test_tone import rgba

pytestmark = pytest.mark.thorough

GEAR = (
    '<path d="M10 2h4v4l4-2 2 4-4 2v4l4 2-2 4-4-2v4h-4v-4l-4 2-2-4 4-2v-4l-4-2 2-4 4 2z'
    'M12 9a3 3 0 1 0 0 6 3 3 0 1 0 0-6z" fill="{}" fill-rule="evenodd"/>'
)
HEART = '<path d="M12 21L3 12a5.5 5.5 0 0 1 9-6 5.5 5.5 0 0 1 9 6z" fill="{}"/>'
CAMERA = (
    '<path d="M3 7h5l2-3h4l2 3h5v13H3z" fill="{}"/><circle cx="12" cy="13" r="4" fill="#d1c4e9"/>'
)
KINDS = {
    "gear": (GEAR.format("#888"), "#fff"),
    "gear on grey": (GEAR.format("#888"), "#ccc"),
    "heart": (HEART.format("#e53935"), "#ddd"),
    "camera": (CAMERA.format("#5e35b1"), "#eef"),
}


def on_page(kind: str, side: int) -> Image.Image:
    drawing, page = KINDS[kind]
    picture = Image.new("RGB", (side, side), page)
    free = Image.fromarray(rgba(drawing, side - side // 8))
    picture.paste(free, (side // 16, side // 16), free)
    return picture


def saved(picture: Image.Image, quality: int) -> np.ndarray:
    if not quality:
        return np.asarray(picture)
    file = io.BytesIO()
    picture.save(file, "JPEG", quality=quality)
    return np.asarray(Image.open(file))


@pytest.mark.parametrize(
    ("kind", "side", "quality"),
    [
        *[("gear", 96, 0), ("gear", 200, 0), ("heart", 96, 0), ("heart", 200, 90)],
        *[("gear on grey", 96, 0), ("gear on grey", 200, 90), ("camera", 96, 0)],
        *[("camera", 200, 90), ("gear on grey", 64, 75)],
    ],
)
def test_what_was_sharpened_is_read_as_it_was(kind, side, quality):
    plain = on_page(kind, side)
    sharp = saved(plain.filter(ImageFilter.UnsharpMask(2, 150, 0)), quality)
    assert unsharpened(sharp) is not sharp
    inks = (ink_of(recognised(one)).astype(float) for one in (np.asarray(plain), sharp))
    assert scans.iou(*map(scans.fitted, inks)) > 0.9


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("quality", [0, 60, 75, 90])
def test_what_was_not_sharpened_is_as_it_is(kind, quality):
    for side in (64, 200):
        picture = saved(on_page(kind, side), quality)
        assert unsharpened(picture) is picture


def test_thin_black_lines_that_were_sharpened_stay_whole():
    house = '<path d="M4 10l8-7 8 7v11H4zM9 21v-8h6v8" fill="none" stroke="#000" stroke-width="2"/>'
    picture = Image.new("RGB", (64, 64), "white")
    free = Image.fromarray(rgba(house, 56))
    picture.paste(free, (4, 4), free)
    inks = (
        ink_of(recognised(np.asarray(one))).astype(float)
        for one in (picture, picture.filter(ImageFilter.UnsharpMask(2, 150, 0)))
    )
    assert scans.iou(*map(scans.fitted, inks)) > 0.85


@pytest.mark.parametrize("quality", [0, 75])
def test_shading_along_pale_edges_makes_no_difference(quality):
    """As on a hand in three dimensions, which may look as if it had been sharpened."""
    shaded = (
        '<radialGradient id="r"><stop offset=".7" stop-color="#fbd3c0"/><stop offset="1" '
        'stop-color="#d9a08f"/></radialGradient><circle cx="9" cy="15" r="7" fill="url(#r)"/>'
        '<circle cx="17" cy="8" r="5" fill="url(#r)"/>'
    )
    picture = Image.new("RGB", (128, 128), "white")
    free = Image.fromarray(rgba(shaded, 128))
    picture.paste(free, (0, 0), free)
    pixels = saved(picture, quality)
    ink = scans.fitted(ink_of(recognised(pixels)).astype(float))
    assert scans.iou(ink, scans.fitted(rgba(shaded, 512)[..., 3] / 255)) > 0.97


def test_a_line_along_all_edges_is_none_that_sharpening_left():
    lined = HEART.replace('"/>', '" stroke="#a3211e" stroke-width="1"/>').format("#e57373")
    picture = Image.new("RGB", (128, 128), "#ddd")
    free = Image.fromarray(rgba(lined, 128))
    picture.paste(free, (0, 0), free)
    for quality in (0, 85):
        pixels = saved(picture, quality)
        assert unsharpened(pixels) is pixels
