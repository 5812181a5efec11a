"""What paper is printed with, to write on, is no part of what is drawn upon it."""

import io

import numpy as np
import pytest
from PIL import Image, ImageDraw

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised
from iconstudio.algorithms.scanning.printed import without_print
from iconstudio.algorithms.tones.alternation import Omission
from tests import scans

pytestmark = pytest.mark.thorough(but=1)

SIZE = (640, 500)
PAPER, BLUE, RED = (245, 242, 230), (180, 200, 235), (232, 150, 150)
INKS = {"pen": (40, 50, 110), "pencil": (120, 118, 116)}


def ruled(draw: ImageDraw.ImageDraw) -> None:
    for y in range(30, SIZE[1], 28):
        draw.line((0, y, SIZE[0], y), fill=BLUE, width=2)
    draw.line((64, 0, 64, SIZE[1]), fill=RED, width=2)


def squared(draw: ImageDraw.ImageDraw) -> None:
    for x in range(9, SIZE[0], 22):
        draw.line((x, 0, x, SIZE[1]), fill=BLUE)
    for y in range(5, SIZE[1], 22):
        draw.line((0, y, SIZE[0], y), fill=BLUE)


def dotted(draw: ImageDraw.ImageDraw) -> None:
    for x in range(12, SIZE[0], 22):
        for y in range(12, SIZE[1], 22):
            draw.ellipse((x - 1, y - 1, x + 1, y + 1), fill=(150, 150, 160))


def drawn(draw: ImageDraw.ImageDraw, colour: object) -> None:
    draw.line([(180, 220), (300, 110), (430, 215)], fill=colour, width=7, joint="curve")
    draw.line([(200, 205), (204, 395), (408, 390), (411, 200)], fill=colour, width=7)
    draw.rectangle((270, 300, 330, 393), outline=colour, width=7)
    draw.ellipse((470, 70, 540, 140), outline=colour, width=7)


def picture(printed, ink: str, degrees: float, quality: int | None) -> np.ndarray:
    sheet = Image.new("RGB", SIZE, PAPER)
    printed(ImageDraw.Draw(sheet))
    drawn(ImageDraw.Draw(sheet), INKS[ink])
    turned = sheet.rotate(degrees, Image.Resampling.BICUBIC, fillcolor=PAPER)
    sheet = turned.crop((12, 12, SIZE[0] - 12, SIZE[1] - 12))
    if quality is None:
        return np.asarray(sheet)
    file = io.BytesIO()
    sheet.save(file, "JPEG", quality=quality)
    return np.asarray(Image.open(file))


@pytest.mark.parametrize("printed", [ruled, squared, dotted])
@pytest.mark.parametrize(
    ("ink", "degrees", "quality"), [("pen", 0, None), ("pen", 0.6, 80), ("pencil", 0, 80)]
)
def test_a_clean_scan_of_printed_paper_shows_the_drawing_alone(printed, ink, degrees, quality):
    right = Image.new("L", SIZE)
    drawn(ImageDraw.Draw(right), 255)
    right = np.asarray(right.rotate(degrees, Image.Resampling.BICUBIC)) / 255
    scan = recognised(picture(printed, ink, degrees, quality))
    assert scan.omissions == {Omission.PRINT}
    found = scans.fitted(ink_of(scan).astype(float))
    assert scans.iou(found, scans.fitted(right)) > 0.85


@pytest.mark.parametrize("stripes", ["half of all", "cut on one side"])
def test_stripes_are_no_print(stripes):
    pixels = np.full((240, 320, 3), 250, np.uint8)
    for y in range(0, 240, 24):
        thick, end = (12, 320) if stripes == "half of all" else (3, 200)
        pixels[y : y + thick, :end] = 180, 200, 235
    pixels[80:160, 120:200] = 30
    assert without_print(pixels) is None


def test_dots_along_a_contour_are_no_print():
    pixels = np.full((400, 400, 3), 250, np.uint8)
    for n in range(0, 170, 17):
        for y, x in ((30 + n, 200 + n), (200 + n, 370 - n), (370 - n, 200 - n), (200 - n, 30 + n)):
            pixels[y - 1 : y + 2, x - 1 : x + 2] = 150
    assert without_print(pixels) is None
