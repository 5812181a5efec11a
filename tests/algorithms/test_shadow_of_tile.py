"""An app icon that casts a soft shadow is its sign, as it is without one."""

import io

import numpy as np
import pytest
from PIL import Image
from scipy import ndimage

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised
from iconstudio.algorithms.scanning.shadow import without_shadow
from iconstudio.algorithms.tones.alternation import Omission
from tests import scans
from tests.algorithms.test_tone import rgba

pytestmark = pytest.mark.thorough(but=1)

GRADIENT = (
    '<linearGradient id="g" x2="0" y2="1"><stop stop-color="#f5553c"/><stop offset="1" '
    'stop-color="#c8145a"/></linearGradient>'
)
TILE = GRADIENT + '<rect x="15" y="15" width="70" height="70" rx="15" fill="{}"/>'
SIGN = '<path d="M28 54l6-6 11 11 22-24 6 6-28 30z" fill="#fff"/>'


def app_icon(colour: str, side: int, blur: float, opacity: int = 110) -> np.ndarray:
    """Return a tile with a sign, (side, side, 4), and its shadow, blurred over a part of that."""
    icon = rgba(TILE.format(colour) + SIGN, side, "0 0 100 100")
    shade = ndimage.gaussian_filter(icon[..., 3] / 255, blur * side)
    shadow = np.zeros_like(icon)
    shadow[..., 3] = opacity * ndimage.shift(shade, (0.025 * side, 0), order=1)
    page = Image.fromarray(shadow)
    page.alpha_composite(Image.fromarray(icon))
    return np.asarray(page)


def saved(icon: np.ndarray, kind: str) -> np.ndarray:
    picture = Image.fromarray(icon)
    page = Image.new("RGBA", picture.size, "white")
    page.alpha_composite(picture)
    if kind == "on nothing":
        return icon
    if kind == "on white":
        return np.asarray(page.convert("RGB"))
    file = io.BytesIO()
    page.convert("RGB").save(file, kind, quality=80)
    return np.asarray(Image.open(file).convert("RGB"))


@pytest.mark.parametrize("kind", ["on nothing", "on white", "JPEG", "WEBP"])
@pytest.mark.parametrize(
    ("colour", "side", "blur"),
    [("#2a6ee6", 128, 0.04), ("url(#g)", 256, 0.02), ("#222", 320, 0.07)],
)
def test_an_app_icon_with_a_shadow_is_its_sign(colour, side, blur, kind):
    scan = recognised(saved(app_icon(colour, side, blur), kind))
    assert scan.omissions == {Omission.TILE, Omission.SHADOW}
    right = scans.fitted(rgba(SIGN, 512, "0 0 100 100")[..., 3] / 255)
    assert scans.iou(scans.fitted(ink_of(scan).astype(float)), right) > 0.85


@pytest.mark.parametrize("kind", ["on white", "JPEG"])
@pytest.mark.parametrize("side", [200, 400])
def test_a_shadow_may_be_black_and_cut_off(side, kind):
    """As the filters of SVG cast one, and cut it off a tenth of the tile beside it."""
    icon = app_icon("#39f", side, 0.03, 255).copy()
    icon[-side // 12 :, :, 3] = icon[:, -side // 12 :, 3] = 0
    scan = recognised(saved(icon, kind))
    assert scan.omissions == {Omission.TILE, Omission.SHADOW}
    right = scans.fitted(rgba(SIGN, 512, "0 0 100 100")[..., 3] / 255)
    assert scans.iou(scans.fitted(ink_of(scan).astype(float)), right) > 0.85


@pytest.mark.parametrize(
    "shape", ['<circle cx="50" cy="50" r="35" fill="#28d"/>', TILE.format("#28d")]
)
def test_what_casts_no_shadow_on_nothing_is_as_it_is(shape):
    assert without_shadow(rgba(shape + SIGN, 200, "0 0 100 100")) is None


def test_what_is_drawn_beside_a_tile_is_no_shadow_of_it():
    icon = app_icon("#a22", 200, 0.03).copy()
    icon[4:14, 60:140] = 200, 30, 30, 255
    lit = without_shadow(saved(icon, "on white"))
    assert lit is not None and (lit[6:12, 62:138] == (200, 30, 30)).all()
