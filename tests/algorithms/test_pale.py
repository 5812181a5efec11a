"""Pale drawings in one colour are read as the same drawing in black, whatever file they are in."""

import io

import numpy as np
import pytest
from PIL import Image
from scipy import ndimage

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised
from iconstudio.algorithms.scanning.pale import darkened
from iconstudio.algorithms.tones.alternation import Omission
from tests import scans
from tests.algorithms.test_tone import rgba

pytestmark = pytest.mark.thorough(but=1)

SHAPES = {
    "ring": '<circle cx="12" cy="12" r="9" fill="none" stroke="{}" stroke-width="3"/>',
    "disc": '<circle cx="12" cy="12" r="10" fill="{}"/>',
    "frame": '<rect x="3" y="3" width="18" height="18" rx="3" fill="none" stroke="{0}" '
    'stroke-width="2"/><circle cx="12" cy="12" r="3" fill="{0}"/>',
    "house": '<path d="M3 21V10L12 2l9 8v11zM9 12h6v9H9z" fill="{}" fill-rule="evenodd"/>',
}


def saved(drawing: np.ndarray, quality: int) -> np.ndarray:
    """The drawing on white as JPEG of a quality, or as PNG if that is 0: (h, w, 3)."""
    free = Image.fromarray(drawing)
    page = Image.new("RGB", free.size, "white")
    page.paste(free, (0, 0), free)
    file = io.BytesIO()
    page.save(file, "JPEG" if quality else "PNG", quality=quality)
    return np.asarray(Image.open(file))


@pytest.mark.parametrize("name", SHAPES)
@pytest.mark.parametrize(
    ("colour", "side", "quality"),
    [
        *[("#ccc", 200, 60), ("#ddd", 256, 0), ("#ddd", 256, 75), ("#ddd", 120, 60)],
        *[("#e8e8e8", 200, 85), ("#bbb", 256, 85), ("#cfe8ff", 256, 75), ("#ffe0b2", 200, 60)],
    ],
)
def test_a_pale_drawing_in_one_colour_is_the_same_in_black(name, colour, side, quality):
    right = rgba(SHAPES[name].format("#000"), 512)[..., 3] / 255
    scan = recognised(saved(rgba(SHAPES[name].format(colour), side), quality))
    assert scan.found and not scan.shaded
    assert scan.omissions <= {Omission.PAGE}
    found = scans.fitted(ink_of(scan).astype(float))
    assert scans.iou(found, scans.fitted(right)) > 0.92


def test_a_stain_with_soft_edges_is_no_pale_drawing():
    disc = rgba(SHAPES["disc"].format("#ddd"), 256)[..., 3] / 255
    stain = 255 - 34 * ndimage.gaussian_filter(disc, 6)
    page = np.repeat(np.rint(stain).astype(np.uint8)[..., None], 3, axis=2)
    assert darkened(page) is page


def test_a_drawing_that_is_pale_only_in_part_is_as_it_is():
    both = SHAPES["ring"].format("#ddd") + '<circle cx="12" cy="12" r="4"/>'
    for quality in (0, 80):
        page = saved(rgba(both, 200), quality)
        assert darkened(page) is page


def test_two_pale_colours_are_not_made_one():
    two = SHAPES["ring"].format("#cdf") + '<circle cx="12" cy="12" r="4" fill="#fdc"/>'
    page = saved(rgba(two, 200), 0)
    assert darkened(page) is page


def test_a_pale_ring_with_the_noise_of_a_file_is_no_shadow_of_its_hole():
    """Too large a picture to be looked at for pale drawings, or not white, it is none either."""
    ring = rgba(SHAPES["ring"].format("#b4b4b4"), 256)
    free = Image.fromarray(ring)
    page = Image.new("RGB", free.size, "#d8d8d8")
    page.paste(free, (0, 0), free)
    file = io.BytesIO()
    page.save(file, "JPEG", quality=75)
    scan = recognised(np.asarray(Image.open(file)))
    assert Omission.SHADOW not in scan.omissions and scan.found
    right = scans.fitted(ring[..., 3] / 255)
    assert scans.iou(scans.fitted(ink_of(scan).astype(float)), right) > 0.9
