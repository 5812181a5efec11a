"""The contour of a small coloured bitmap is smooth, whatever colours meet along it."""

import io

import numpy as np
import pytest
from PIL import Image
from scipy import ndimage
from skimage import measure

from iconstudio.algorithms.scanning.cutting import cut_out
from tests import scans
from tests.algorithms.test_small_bitmaps import bitmap, found
from tests.algorithms.test_tone import rgba

pytestmark = pytest.mark.thorough

DOOR = (
    '<path d="M21.5 3h57v94h-57z" fill="#c1694f"/>'
    '<path d="M29 10h42v6H35v20h-6zM29 56h42v5H35v9h-6zM29 77h42v5H35v9h-6z" fill="#854836"/>'
    '<circle cx="28" cy="48" r="3" fill="#ffac33"/>'
)
SHADED = (
    '<circle cx="50" cy="50" r="45" fill="#f44336"/><circle cx="30" cy="30" r="8" fill="#ff9090"/>'
    '<path d="M50 {0}a{1} {1} 0 0 1 0 {2}" fill="none" stroke="#c33" stroke-width="{3}"/>'
)
PALE = (
    '<linearGradient id="p" x2="0" y2="1"><stop stop-color="#9ac6ff"/><stop offset="1" '
    'stop-color="#80b4f8"/></linearGradient>'
    '<circle cx="50" cy="50" r="44" fill="url(#p)"/>'
    '<path d="M20 34h28v12H20zM66 40h14v14H66z" fill="#2859c5"/>'
)


def contour(ink):
    return ndimage.binary_fill_holes(ink)


@pytest.mark.parametrize("side", [24, 32])
def test_what_is_cut_out_is_opaque_beside_its_edges_whatever_is_drawn_on_it(side):
    free, on_white = (bitmap(DOOR, side, white) for white in (False, True))
    cut = cut_out(on_white, np.array([255.0, 255, 255]), free[..., 3] == 0)
    amiss = abs(cut[1:-1, :, 3].astype(float) - free[1:-1, :, 3])
    assert amiss.max() < 32 and (amiss > 8).mean() < 0.01


@pytest.mark.parametrize("width", [4, 8])
def test_a_round_side_along_which_colours_meet_is_round(width):
    shaded = SHADED.format(5 + width / 2, 45 - width / 2, 90 - width, width)
    disc = contour(found(bitmap(shaded, 32, False)))
    right = scans.fitted(rgba(shaded, 512, "0 0 100 100")[..., 3] / 255)
    assert scans.iou(disc, right) > 0.98


def test_the_pale_body_of_a_small_lossy_picture_is_drawn():
    file = io.BytesIO()
    Image.fromarray(bitmap(PALE, 24, True)).save(file, "JPEG", quality=80)
    disc = contour(found(np.asarray(Image.open(file))))
    right = scans.fitted(rgba('<circle cx="50" cy="50" r="45"/>', 512, "0 0 100 100")[..., 3] / 255)
    assert scans.iou(disc, right) > 0.93


FACE = (
    '<path d="M10 8l24 18q16-5 32 0L90 8v48q-6 34-40 38Q16 90 10 56z" fill="#f5a340"/>'
    '<path d="M16 20l14 10-12 10zM84 20L70 30l12 10z" fill="#f9c79f"/>'
    '<circle cx="34" cy="52" r="7" fill="#2d3436"/><circle cx="66" cy="52" r="7" fill="#2d3436"/>'
    '<path d="M40 74q10 8 20 0" fill="none" stroke="#2d3436" stroke-width="3"/>'
)


@pytest.mark.parametrize(
    ("side", "quality", "alike"), [(48, 85, 0.96), (64, 60, 0.92), (100, 60, 0.97), (128, 75, 0.97)]
)
def test_a_small_lossy_picture_in_colours_is_as_clean_as_one_that_lost_nothing(
    side, quality, alike
):
    """Such files keep colours at half the resolution, so that they bleed beyond their edges."""
    file, page = io.BytesIO(), bitmap(FACE, side, True)
    Image.fromarray(page).save(file, "JPEG", quality=quality)
    lossy, exact = (found(np.asarray(one)) for one in (Image.open(file), page))
    assert scans.iou(lossy, exact) > alike
    assert measure.perimeter(contour(lossy)) < 1.015 * measure.perimeter(contour(exact))
