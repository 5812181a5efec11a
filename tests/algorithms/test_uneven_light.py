"""A clean picture of lines on a board that mirrors a lamp, or on paper half in the shadow."""

import io

import numpy as np
import pytest
from PIL import Image, ImageDraw
from scipy import ndimage

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised
from iconstudio.algorithms.scanning.uneven import is_unevenly_lit
from tests import scans
from tests.algorithms.test_printed_paper import SIZE, drawn
from tests.algorithms.test_tone import rgba


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


def test_a_drawing_with_grey_shades_is_not_lit_unevenly():
    face = '<circle cx="50" cy="50" r="40" fill="#d0cfce" stroke="#000" stroke-width="4"/>'
    picture = rgba(
        face + '<path d="M30 60h40" stroke="#000" stroke-width="4"/>', 256, "0 0 100 100"
    )
    page = Image.new("RGB", (256, 256), "white")
    page.paste(Image.fromarray(picture), (0, 0), Image.fromarray(picture))
    assert not is_unevenly_lit(np.asarray(page, np.float32) / 255)
