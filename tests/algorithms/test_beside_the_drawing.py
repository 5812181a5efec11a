"""What is beside the drawing on a scan or photo is left out, and told: holes, fingers, a desk."""

import io

import numpy as np
import pytest
import scipy
from PIL import Image, ImageDraw, ImageFilter

from iconstudio.algorithms.scanning.binarisation import Scan, ink_of, recognised
from iconstudio.algorithms.scanning.doubts import writing
from iconstudio.algorithms.scanning.finger import finger
from iconstudio.algorithms.scanning.note import note_on_desk
from iconstudio.algorithms.scanning.punched import punch_holes
from iconstudio.algorithms.tones.alternation import Omission

pytestmark = pytest.mark.thorough

PEN = (30, 30, 35)


def house(draw: ImageDraw.ImageDraw, x: float, y: float, size: float, width: int) -> None:
    for line in (
        [(-1, 0), (0, -1), (1, 0)],
        [(-0.8, -0.2), (-0.8, 1), (0.8, 1), (0.8, -0.2)],
        [(-0.2, 1), (-0.2, 0.4), (0.2, 0.4), (0.2, 1)],
    ):
        points = [(x + size * across, y + size * down) for across, down in line]
        draw.line(points, PEN, width, joint="curve")


def face(draw: ImageDraw.ImageDraw, x: float, y: float, size: float, width: int) -> None:
    for across, down, radius in ((0, 0, 1), (-0.4, -0.2, 0.12), (0.4, -0.2, 0.12)):
        middle = x + size * across, y + size * down
        box = [one + sign * radius * size for sign in (-1, 1) for one in middle]
        draw.ellipse(box, outline=PEN, width=width)
    draw.arc([x - size / 2, y - size / 2, x + size / 2, y + size / 2], 30, 150, PEN, width)


SUBJECTS = {"house": house, "face": face}
PIECES = {"house": [1, 3], "face": [4, 4]}
"""Of how many separate pieces their lines are, and the paper between and around them."""


def photo(picture: Image.Image, light: float = 0.0, seed: int = 0) -> np.ndarray:
    """What a camera or scanner makes of it: blurred, unevenly lit, noisy, a JPEG."""
    levels = np.asarray(picture.filter(ImageFilter.GaussianBlur(1))).astype(float)
    noise = np.random.default_rng(seed).normal(0, 3, (*levels.shape[:2], 1))
    levels = levels * np.linspace(1, 1 - light, levels.shape[1])[:, None] + noise
    file = io.BytesIO()
    Image.fromarray(np.clip(levels, 0, 255).astype(np.uint8)).save(file, "JPEG", quality=88)
    return np.asarray(Image.open(file))


def sheet(size=(600, 800), paper=(248, 247, 244)) -> tuple[Image.Image, ImageDraw.ImageDraw]:
    picture = Image.new("RGB", size, paper)
    return picture, ImageDraw.Draw(picture)


def shows(found: Scan, subject: str) -> bool:
    """Whether the lines of a subject are there, alone: one piece and what it encloses, or dots."""
    ink = ink_of(found)
    areas = [
        int((np.bincount(scipy.ndimage.label(part)[0].ravel())[1:] > 60).sum())
        for part in (ink, ~np.pad(ink, 1))
    ]
    return areas == PIECES[subject] and bool(ink.mean() < 0.3)


@pytest.mark.thorough
@pytest.mark.parametrize("subject", SUBJECTS)
@pytest.mark.parametrize(
    ("side", "rows", "shade"),
    [("left", (290, 510), 15), ("right", (70, 290, 510, 730), 120)],
)
def test_punch_holes_are_left_out_and_told(subject, side, rows, shade):
    picture, draw = sheet()
    SUBJECTS[subject](draw, 310, 400, 190, 9)
    x = 35 if side == "left" else 565
    for y in rows:
        draw.ellipse([x - 14, y - 14, x + 14, y + 14], fill=(shade, shade, shade))
    found = recognised(photo(picture))
    assert Omission.HOLES in found.omissions
    assert shows(found, subject)


def test_dots_of_a_drawing_are_no_holes():
    picture, draw = sheet()
    for x, y in ((40, 300), (40, 400), (560, 300), (300, 760)):  # bullets, and single dots
        draw.ellipse([x - 14, y - 14, x + 14, y + 14], fill=PEN)
    house(draw, 310, 400, 190, 9)
    assert punch_holes(np.asarray(picture) / np.float32(255)) is None


@pytest.mark.parametrize("subject", SUBJECTS)
@pytest.mark.parametrize(
    "skin", [(224, 172, 140), (150, 100, 75), (238, 196, 170), (95, 62, 48), (58, 37, 29)]
)
def test_a_finger_is_left_out_and_told(subject, skin):
    picture, draw = sheet((800, 800), (240, 238, 232))
    SUBJECTS[subject](draw, 400, 350, 190, 9)
    thumb = Image.new("L", (110, 240), 0)
    ImageDraw.Draw(thumb).rounded_rectangle([0, 0, 109, 400], 54, fill=255)
    shade = 1 - 0.35 * abs(np.linspace(-1, 1, 110)) ** 1.5
    flesh = Image.fromarray(
        (shade[None, :, None] * np.full((240, 1, 1), 1) * skin).astype(np.uint8)
    )
    picture.paste(flesh, (560, 620), thumb.filter(ImageFilter.GaussianBlur(2)))
    found = recognised(photo(picture, light=0.15))
    assert Omission.FINGER in found.omissions
    assert shows(found, subject)


@pytest.mark.parametrize("ink", [(30, 30, 32), (36, 32, 30), (20, 17, 15)])
def test_black_ink_at_the_edge_is_no_finger_even_in_warm_light(ink):
    picture, draw = sheet((400, 400), (240, 232, 218))
    draw.rounded_rectangle([150, 260, 250, 500], 50, fill=ink)
    assert finger(photo(picture) / np.float32(255)) is None


def test_what_a_computer_painted_in_the_colour_of_skin_is_no_finger():
    picture, draw = sheet((400, 400), (255, 255, 255))
    draw.rounded_rectangle([150, 200, 250, 500], 50, fill=(224, 172, 140))
    assert finger(np.asarray(picture) / np.float32(255)) is None


@pytest.mark.parametrize("subject", SUBJECTS)
@pytest.mark.parametrize(
    ("paper", "table", "degrees"),
    [
        ((250, 228, 90), (232, 228, 220), 9),
        ((248, 160, 180), (236, 236, 238), -14),
        ((170, 215, 240), (240, 236, 228), 20),
        ((205, 170, 125), (235, 232, 226), 0),
    ],
)
def test_a_coloured_note_on_a_pale_table_is_paper(subject, paper, table, degrees):
    note, draw = sheet((430, 430), paper)
    SUBJECTS[subject](draw, 215, 220, 120, 7)
    picture, _ = sheet((800, 700), table)
    picture.paste(note, (185, 135))
    picture = picture.rotate(degrees, Image.Resampling.BICUBIC, fillcolor=table)
    found = recognised(photo(picture, light=0.12))
    assert Omission.DESK in found.omissions
    assert shows(found, subject)


def test_a_box_that_is_drawn_is_no_note():
    picture, draw = sheet((600, 600))
    draw.rectangle([120, 120, 480, 480], fill=(250, 228, 90), outline=PEN, width=8)
    house(draw, 300, 300, 90, 8)
    assert note_on_desk(np.asarray(picture) / np.float32(255)) is None


def test_several_small_parts_side_by_side_are_writing():
    shape = np.zeros((60, 120), bool)
    for x in range(10, 60, 8):
        shape[30:34, x : x + 3] = True
    assert (writing(shape) == shape).all()
    apart = np.zeros_like(shape)
    apart[[5, 30, 50], [10, 60, 110]] = apart[[6, 31, 51], [10, 60, 110]] = True
    assert not writing(apart).any()
