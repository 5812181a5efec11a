"""A checkerboard that stands for nothing is nothing; other squares stay."""

import io

import numpy as np
import pytest
import scipy
from PIL import Image

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised
from iconstudio.algorithms.scanning.checkerboard import without_checkerboard
from tests import scans
from tests.algorithms.test_flat import FACE, SMILE
from tests.algorithms.test_tone import as_svg, rgba

pytestmark = pytest.mark.thorough

RING = (
    '<circle cx="50" cy="50" r="32" fill="none" stroke="#06c" stroke-width="26"/>'
    '<circle cx="50" cy="18" r="8" fill="#fc0"/>'
)


def board(side, square, greys):
    """The checkerboard (side, side, 3), its squares not always of whole pixels."""
    fine = 4 * np.arange(4 * side) // (16 * square)
    odd = ((fine[:, None] + fine) % 2).astype(bool)
    picture = Image.fromarray(np.where(odd, *greys).astype(np.uint8))
    return picture.resize((side, side), Image.Resampling.BOX).convert("RGB")


@pytest.mark.parametrize("drawing", [FACE.format("#fc0", "#420") + SMILE, RING])
@pytest.mark.parametrize(
    ("side", "square", "greys", "quality"),
    [
        (64, 8, (255, 204), 0),
        (200, 10, (204, 255), 80),
        (300, 12.5, (255, 230), 75),
        (256, 8, (102, 153), 0),
    ],
)
def test_a_drawing_on_a_checkerboard_is_free(drawing, side, square, greys, quality):
    page = board(side, square, greys)
    picture = Image.fromarray(rgba(drawing, side, "0 0 100 100"))
    page.paste(picture, (0, 0), picture)
    if quality:
        file = io.BytesIO()
        page.save(file, "JPEG", quality=quality)
        page = Image.open(file)
    pixels = np.asarray(page)
    alpha = without_checkerboard(pixels)[..., 3] / 255
    assert abs(alpha - np.asarray(picture)[..., 3] / 255).mean() < 0.02
    right = scans.fitted(as_svg(drawing).coverage / 255)
    assert scans.iou(scans.fitted(ink_of(recognised(pixels)).astype(float)), right) > 0.9


@pytest.mark.parametrize("seed", range(3))
def test_other_pictures_stay_as_they_are(seed):
    generator = np.random.default_rng(seed)
    noise = generator.integers(0, 256, (60, 60, 3), np.uint8)
    stripes = np.repeat(np.where(np.arange(60) // 6 % 2, 255, 200)[None, :, None], 60, 0)
    stripes = np.repeat(stripes, 3, 2).astype(np.uint8)
    chess, bare = np.asarray(board(64, 8, (250, 30))), np.asarray(board(64, 8, (255, 204)))
    for pixels in (noise, stripes, np.full((40, 40, 3), 255, np.uint8), chess, bare):
        assert without_checkerboard(pixels) is pixels


@pytest.mark.parametrize(("colour", "quality"), [("#393", 75), ("#e1e", 60), ("#fe3", 80)])
def test_no_specks_are_left_of_a_lossy_checkerboard(colour, quality):
    page = board(400, 20, (204, 255))
    picture = Image.fromarray(
        rgba(f'<circle cx="50" cy="50" r="28" fill="{colour}"/>', 400, "0 0 100 100")
    )
    page.paste(picture, (0, 0), picture)
    file = io.BytesIO()
    page.save(file, "JPEG", quality=quality)
    ink = ink_of(recognised(np.asarray(Image.open(file))))
    assert scipy.ndimage.label(ink)[1] == 1
    right = scans.fitted(np.asarray(picture)[..., 3] / 255)
    assert scans.iou(scans.fitted(ink.astype(float)), right) > 0.98
