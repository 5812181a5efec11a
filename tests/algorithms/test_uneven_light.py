"""Drawings on a board that mirrors a lamp, on paper in a shadow, or farther from a window."""

import io

import numpy as np
import pytest
from PIL import Image, ImageDraw
from scipy import ndimage

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised
from iconstudio.algorithms.scanning.uneven import uneven_light
from tests import scans
from tests.algorithms.test_printed_paper import SIZE, drawn
from tests.algorithms.test_tone import rgba

pytestmark = pytest.mark.thorough(but=1)


def mirrored(y: np.ndarray, x: np.ndarray) -> np.ndarray:
    return 0.72 + 0.28 * np.exp(-(((x - 480) / 90) ** 2) - ((y - 150) / 120) ** 2)


def shadowed(y: np.ndarray, x: np.ndarray) -> np.ndarray:
    return ndimage.gaussian_filter(np.where(x + 0.6 * y > 480, 0.6, 0.98), 1.2)


@pytest.mark.parametrize("light", [mirrored, shadowed])
@pytest.mark.parametrize("colour", [(200, 30, 40), (30, 40, 110)])
def test_lines_on_paper_in_uneven_light_are_the_drawing(light, colour):
    right = Image.new("L", SIZE)
    drawn(ImageDraw.Draw(right), 255)
    ink = np.asarray(right)[..., None] / 255
    picture = (np.array([245.0, 243, 236]) * (1 - ink) + np.array(colour) * ink) * light(
        *np.mgrid[: SIZE[1], : SIZE[0]]
    )[..., None]
    file = io.BytesIO()
    Image.fromarray(np.rint(picture).astype(np.uint8)).save(file, "JPEG", quality=80)
    scan = recognised(np.asarray(Image.open(file)))
    found = scans.fitted(ink_of(scan).astype(float))
    assert scans.iou(found, scans.fitted(ink[..., 0])) > 0.85


def photographed(picture: np.ndarray, light: np.ndarray) -> np.ndarray:
    """A photo of a picture, (h, w, 3) from 0 to 255: a little blurred, with grain, as JPEG."""
    grain = np.random.default_rng(3).normal(0, 4, light.shape)
    soft = ndimage.gaussian_filter(picture * light[..., None], (0.8, 0.8, 0)) + grain[..., None]
    file = io.BytesIO()
    Image.fromarray(np.clip(soft, 0, 255).astype(np.uint8)).save(file, "JPEG", quality=85)
    return np.asarray(Image.open(file))


def from_a_corner(y: np.ndarray, x: np.ndarray) -> np.ndarray:
    return 1 - 0.15 * (x / SIZE[0] + y / SIZE[1]) / 2


def less_at_corners(y: np.ndarray, x: np.ndarray) -> np.ndarray:
    return 1 - 0.15 * ((2 * x / SIZE[0] - 1) ** 2 + (2 * y / SIZE[1] - 1) ** 2) / 2


@pytest.mark.parametrize(
    ("light", "width", "note"),
    [
        (from_a_corner, 0, None),
        (less_at_corners, 0, None),
        (from_a_corner, 18, None),
        (less_at_corners, 0, (250, 228, 110)),
    ],
)
def test_paper_that_is_a_little_darker_on_one_side_is_no_colour(light, width, note):
    """Drawn with a pen, with a felt pen, or on a note that lies on a pale table."""
    page, right = Image.new("RGB", SIZE, (243, 241, 235)), Image.new("L", SIZE)
    if note is not None:
        ImageDraw.Draw(page).rectangle((130, 40, 580, 450), fill=note)
    for draw, colour in ((ImageDraw.Draw(page), (20, 20, 28)), (ImageDraw.Draw(right), 255)):
        drawn(draw, colour)
        if width:
            draw.ellipse((90, 60, 90 + 2 * width, 60 + 2 * width), fill=colour)
    photo = photographed(np.asarray(page, float), light(*np.mgrid[: SIZE[1], : SIZE[0]]))
    found = scans.fitted(ink_of(recognised(photo)).astype(float))
    assert scans.iou(found, scans.fitted(np.asarray(right) / 255)) > 0.8


def test_a_shade_from_a_computer_has_no_grain():
    page = Image.new("RGB", SIZE, (243, 241, 235))
    drawn(ImageDraw.Draw(page), (20, 20, 28))
    shaded = np.asarray(page) * from_a_corner(*np.mgrid[: SIZE[1], : SIZE[0]])[..., None]
    assert uneven_light(np.rint(shaded).astype(np.float32) / 255) is None


def test_a_drawing_with_grey_shades_is_not_lit_unevenly():
    face = '<circle cx="50" cy="50" r="40" fill="#d0cfce" stroke="#000" stroke-width="4"/>'
    picture = rgba(
        face + '<path d="M30 60h40" stroke="#000" stroke-width="4"/>', 256, "0 0 100 100"
    )
    page = Image.new("RGB", (256, 256), "white")
    page.paste(Image.fromarray(picture), (0, 0), Image.fromarray(picture))
    assert uneven_light(np.asarray(page, np.float32) / 255) is None
