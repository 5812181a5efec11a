"""Bitmaps in flat colours become what the same drawing becomes as SVG; scans and photos do not."""

import io

import numpy as np
import pytest
from PIL import Image
from skimage.data import camera, chelsea, coffee

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised
from iconstudio.algorithms.scanning.flat import SIDE, flat_drawing
from tests import scans
from tests.algorithms.test_scanning import house
from tests.algorithms.test_tone import pictogram, rgba

FACE = '<circle cx="50" cy="50" r="45" fill="{}"/><g fill="{}"><circle cx="34" cy="40" r="8"/>'
SMILE = '<circle cx="66" cy="40" r="8"/><path d="M28 62a24 16 0 0 0 44 0z"/></g>'
WALLS = '<path d="M10 48L50 8l40 40v44H10z" fill="#fd8" stroke="#222" stroke-width="6"/>'
DRAWINGS = {
    "yellow face": FACE.format("#fc0", "#420") + SMILE,
    "blue face": FACE.format("#27d", "#fd0") + SMILE,
    "house": WALLS + '<path d="M40 60h20v32H40z" fill="#a24" stroke="#222" stroke-width="6"/>',
    "bars": '<path d="M8 50h24v42H8z" fill="#0bd"/><path d="M38 10h24v82H38z" fill="#e33"/>'
    '<path d="M68 30h24v62H68z" fill="#36a"/>',
    "button": '<rect x="5" y="5" width="90" height="90" rx="16" fill="#1a9"/>'
    '<path d="M36 28l36 22-36 22zM20 20h60v8H20z" fill="#fe9"/>',
}


def bitmap(drawing, side, kind):
    picture = Image.fromarray(rgba(drawing, 512, "0 0 100 100")).resize((side, side))
    if kind == "transparent":
        return np.asarray(picture)
    page = Image.new("RGB", (side + 12, side + 20), "white")
    page.paste(picture, (5, 9), picture)
    if kind == "white":
        return np.asarray(page)
    file = io.BytesIO()
    page.save(file, "JPEG", quality=80)
    return np.asarray(Image.open(file))


@pytest.mark.parametrize("name", DRAWINGS)
@pytest.mark.parametrize(("side", "kind"), [(48, "transparent"), (96, "white"), (200, "jpeg")])
def test_a_bitmap_becomes_what_the_drawing_becomes(name, side, kind):
    right = scans.fitted(pictogram(rgba(DRAWINGS[name], 512, "0 0 100 100")) / 255)
    scan = recognised(bitmap(DRAWINGS[name], side, kind))
    assert scan.found and not scan.shaded and scan.coloured is not None
    assert scans.iou(scans.fitted(ink_of(scan).astype(float)), right) > 0.9
    by_hand = ink_of(scan, scan.threshold - 1)
    assert by_hand.shape == scan.darkness.shape


@pytest.mark.parametrize("kind", scans.KINDS, ids=lambda kind: kind.__name__)
def test_a_scan_is_no_drawing_in_flat_colours(kind):
    assert flat_drawing(scans.scan(house(), kind, 0)) is None


@pytest.mark.parametrize("photo", [camera, chelsea, coffee])
@pytest.mark.parametrize("step", [1, 3, 9])
def test_nor_is_a_photo(photo, step):
    pixels = photo()[::step, ::step]
    grey = pixels.ndim == 2
    assert flat_drawing(np.repeat(pixels[..., None], 3, axis=2) if grey else pixels) is None


def test_the_polarity_can_still_be_chosen():
    pixels = bitmap(DRAWINGS["yellow face"], 96, "white")
    for inverted in (False, True):
        scan = recognised(pixels, inverted)
        assert scan.coloured is None and scan.inverted == inverted


def test_what_is_half_transparent_is_left_to_thresholds():
    pixels = bitmap(DRAWINGS["bars"], 96, "transparent").copy()
    pixels[:40, :40] = 0, 0, 0, 120
    assert flat_drawing(pixels) is None


@pytest.mark.parametrize("shape", [(1, 1, 3), (5, 90, 4), (40, 3, 3), (9, 9, 4)])
def test_what_is_tiny_is_looked_at(shape):
    pixels = np.random.default_rng(0).integers(0, 256, shape, np.uint8)
    flat = flat_drawing(pixels)
    assert flat is None or flat.shape == (SIDE, SIDE, 4)
