"""What is around a drawing on a bitmap and no part of it: a shadow, and noise of lossy files."""

import io

import numpy as np
import pytest
from PIL import Image
from scipy import ndimage

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised
from iconstudio.algorithms.scanning.noise import without_noise
from iconstudio.algorithms.scanning.shadow import without_shadow
from iconstudio.algorithms.tones.alternation import Omission
from tests import scans

pytestmark = pytest.mark.thorough

SIDE = 128


def heart() -> np.ndarray:
    y, x = np.mgrid[-1.4 : 1.4 : SIDE * 1j, -1.4 : 1.4 : SIDE * 1j]
    return np.asarray((x**2 + y**2 - 0.6) ** 3 < -(x**2) * y**3 * 0.8)


def painted(shadow: np.ndarray, colour: tuple[int, ...], ground: tuple[int, ...]) -> np.ndarray:
    """Return a heart of a colour that casts a shadow, (SIDE, SIDE) from 0 to 1, on its ground."""
    lit = np.array(ground) * (1 - shadow[..., None])
    return np.where(heart()[..., None], colour, lit).astype(np.uint8)


def saved(pixels: np.ndarray, quality: int) -> np.ndarray:
    file = io.BytesIO()
    Image.fromarray(pixels).save(file, "JPEG", quality=quality)
    return np.asarray(Image.open(file))


def shape(pixels: np.ndarray) -> np.ndarray:
    return scans.fitted(ink_of(recognised(pixels)).astype(float))


@pytest.mark.parametrize("colour", [(0, 0, 0), (200, 30, 30)])
@pytest.mark.parametrize("blur", [1, 2, 3])
def test_a_blurred_drawing_is_not_its_own_shadow(colour, blur):
    solid = np.kron(heart(), np.ones((4, 4)))
    ring = solid * (ndimage.distance_transform_edt(solid) < 24)
    soft = ndimage.gaussian_filter(ring, blur)[..., None]
    found = recognised((255 + soft * (np.array(colour) - 255)).astype(np.uint8))
    told = found.omissions | (found.coloured.omissions if found.coloured else set())
    assert Omission.SHADOW not in told
    assert scans.iou(scans.fitted(ink_of(found).astype(float)), scans.fitted(ring)) > 0.95


@pytest.mark.parametrize("quality", [0, 75])
@pytest.mark.parametrize("ground", [(255, 255, 255), (204, 221, 238)])
@pytest.mark.parametrize("cast", ["soft", "hard"])
def test_a_shadow_is_left_out_and_told(cast, ground, quality):
    solid = heart().astype(float)
    shadow = 0.5 * ndimage.gaussian_filter(solid, 7)
    if cast == "hard":
        shadow = 0.3 * ndimage.shift(solid, (5, 5), order=0)
    pixels = painted(shadow, (225, 40, 40), ground)
    scan = recognised(saved(pixels, quality) if quality else pixels)
    assert Omission.SHADOW in scan.omissions
    assert scans.iou(scans.fitted(ink_of(scan).astype(float)), scans.fitted(solid)) > 0.9


@pytest.mark.parametrize("quality", [0, 85])
@pytest.mark.parametrize(
    ("colour", "blur", "shift", "dense"),
    [((225, 40, 40), 2, 6, 0.6), ((225, 40, 40), 9, 0, 0.3), ((40, 40, 40), 4, 9, 0.5)],
)
def test_of_a_soft_shadow_nothing_is_left_wherever_it_falls(colour, blur, shift, dense, quality):
    """Far beside what casts it, it is even; around a hole, it falls through that."""
    solid = heart() & (np.hypot(*(np.indices((SIDE, SIDE)) - 60)) > 11)
    shadow = dense * ndimage.shift(ndimage.gaussian_filter(solid.astype(float), blur), shift)
    lit = 255 * (1 - shadow[..., None])
    pixels = np.where(solid[..., None], colour, lit).astype(np.uint8)
    scan = recognised(saved(pixels, quality) if quality else pixels)
    assert Omission.SHADOW in scan.omissions
    assert scans.iou(scans.fitted(ink_of(scan).astype(float)), scans.fitted(solid)) > 0.95


def test_even_greys_are_no_shadow():
    """However like one they lie around what is painted in colour."""
    pixels = painted(
        ndimage.binary_dilation(heart(), iterations=9) * 0.1, (225, 40, 40), (255,) * 3
    )
    assert without_shadow(pixels) is None


@pytest.mark.parametrize("quality", [0, 60, 90])
@pytest.mark.parametrize("colour", [(0, 0, 0), (225, 40, 40), (215, 215, 215)])
def test_what_casts_no_shadow_has_none_and_noise_is_not_told(colour, quality):
    pixels = painted(np.zeros((SIDE, SIDE)), colour, (255, 255, 255))
    pixels = saved(pixels, quality) if quality else pixels
    assert without_shadow(without_noise(pixels)) is None
    assert recognised(pixels).omissions == ({Omission.PAGE} if colour == (225, 40, 40) else set())
    assert scans.iou(shape(pixels), scans.fitted(heart().astype(float))) > 0.93


def test_what_lost_nothing_has_no_noise():
    pixels = painted(np.zeros((SIDE, SIDE)), (225, 40, 40), (255, 255, 255))
    assert without_noise(pixels) is pixels
    assert without_noise(saved(pixels, 75)) is not pixels
    blank = np.full((64, 64, 3), 255, np.uint8)
    blank[::9, ::7] = 253
    assert without_noise(blank) is blank


@pytest.mark.parametrize("quality", [0, 75])
def test_stripes_on_white_are_no_page(quality):
    """As on the flags of Israel and of Finland."""
    striped = np.full((120, 160, 3), 255, np.uint8)
    crossed = striped.copy()
    striped[15:33] = striped[87:105] = crossed[45:75] = crossed[:, 45:75] = (0, 56, 184)
    striped[50:70, 70:90] = (0, 56, 184)
    for flag, pieces in ((striped, 3), (crossed, 1)):
        ink = shape(saved(flag, quality) if quality else flag)
        assert ndimage.label(ink)[1] == pieces
        assert ink.any(axis=0).sum() > 230


@pytest.mark.parametrize("channels", [1, 3, 4])
@pytest.mark.parametrize("side", [24, 128, 300])
def test_noise_is_no_drawing(side, channels):
    noise = np.random.default_rng(side).integers(0, 256, (side, side, channels), dtype=np.uint8)
    noise = np.repeat(noise, 3, axis=2) if channels == 1 else noise
    assert not recognised(noise).found
    if channels < 4:
        assert not recognised(saved(noise, 80)).found


def test_what_is_drawn_upon_noise_is_found():
    random = np.random.default_rng(0)
    pixels = 200 - 60 * heart()[..., None] + random.normal(0, 35, (SIDE, SIDE, 3))
    assert recognised(np.clip(pixels, 0, 255).astype(np.uint8)).found
