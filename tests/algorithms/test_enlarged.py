"""Small coloured bitmaps that were enlarged softly become what their drawings become."""

import numpy as np
import pytest
from PIL import Image, ImageFilter
from skimage.measure import perimeter

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised
from iconstudio.algorithms.scanning.enlarged import at_own_resolution
from iconstudio.algorithms.scanning.resampling import premultiplied
from tests import scans
from tests.algorithms.test_tone import as_svg, rgba

pytestmark = pytest.mark.thorough

BADGE = (
    '<circle cx="12" cy="12" r="11.5" fill="#1d9bf0"/>'
    '<path d="M6 12.5l4 4 8-8.5" fill="none" stroke="#fff" stroke-width="2.4"/>'
)


def enlarged(times: float, white: bool, way: Image.Resampling) -> np.ndarray:
    small = Image.fromarray(rgba(BADGE, 24, "0 0 24 24"))
    if white:
        page = Image.new("RGB", small.size, "white")
        page.paste(small, (0, 0), small)
        small = page
    return np.asarray(small.resize((round(24 * times), round(24 * times)), way))


@pytest.mark.thorough(but=1)
@pytest.mark.parametrize("white", [False, True])
@pytest.mark.parametrize(
    ("times", "way"),
    [(4, Image.Resampling.BICUBIC), (10, Image.Resampling.BICUBIC), (8, Image.Resampling.BILINEAR)],
)
def test_what_was_enlarged_softly_is_as_the_drawing(times, way, white):
    right = scans.fitted(as_svg(BADGE, "0 0 24 24").coverage / 255)
    pixels = enlarged(times, white, way)
    assert at_own_resolution(pixels).shape[:2] == (24, 24)
    found = scans.fitted(ink_of(recognised(pixels)).astype(float))
    assert scans.iou(found, right) > 0.9


@pytest.mark.parametrize("white", [False, True])
@pytest.mark.parametrize(
    ("times", "way"),
    [
        (1.5, Image.Resampling.BICUBIC),
        (2, Image.Resampling.BICUBIC),
        (2.5, Image.Resampling.BILINEAR),
        (3.7, Image.Resampling.LANCZOS),
    ],
)
def test_it_may_be_enlarged_by_any_factor(times, way, white):
    pixels = enlarged(times, white, way)
    own = at_own_resolution(pixels)
    assert own.shape == (24, 24, 3 if white else 4)
    own, right = (premultiplied(one.astype(np.float32)) for one in (own, enlarged(1, white, way)))
    assert np.percentile(abs(own - right), 95) < 6


def test_what_was_enlarged_twice_has_no_comb_for_an_edge():
    right = scans.fitted(as_svg(BADGE, "0 0 24 24").coverage / 255)
    for times in (2, 2.5):
        pixels = enlarged(times, white=False, way=Image.Resampling.BICUBIC)
        found = scans.fitted(ink_of(recognised(pixels)).astype(float))
        assert perimeter(found) < 1.02 * perimeter(right > 0.5)


@pytest.mark.parametrize("side", [36, 48, 96, 240, 480])
def test_what_is_sharp_has_its_own_resolution(side):
    pixels = rgba(BADGE, side, "0 0 24 24")
    assert at_own_resolution(pixels) is pixels


@pytest.mark.parametrize("sigma", [1, 2, 3])
def test_what_is_blurred_was_not_enlarged(sigma):
    pixels = np.asarray(
        Image.fromarray(rgba(BADGE, 128, "0 0 24 24")).filter(ImageFilter.GaussianBlur(sigma))
    )
    assert at_own_resolution(pixels) is pixels
