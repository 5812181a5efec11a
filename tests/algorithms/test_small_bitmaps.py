"""Bitmaps of 16 to 48 pixels become what the same drawing becomes as SVG."""

import io

import numpy as np
import pytest
from PIL import Image
from scipy import ndimage
from skimage import measure

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised
from iconstudio.algorithms.scanning.blending import unblended
from iconstudio.algorithms.scanning.palette import evenly_painted
from iconstudio.algorithms.scanning.resampling import reconstructed
from tests import scans
from tests.algorithms.test_tone import as_svg, rgba

pytestmark = pytest.mark.thorough(but=1)

VIEW = "0 0 100 100"
LINES = {"outlined house"}
"""Drawings that become lines of about a pixel."""
RADIAL = (
    '<radialGradient id="r" cx="{0}" cy="{0}"><stop stop-color="{1}"/><stop offset="1" '
    'stop-color="{2}"/></radialGradient>'
)
DRAWINGS = {
    "target": '<circle cx="50" cy="50" r="45" fill="#d00"/><circle cx="50" cy="50" r="35" '
    'fill="#fff"/><circle cx="50" cy="50" r="25" fill="#d00"/><circle cx="50" cy="50" r="15" '
    'fill="#fff"/><circle cx="50" cy="50" r="7" fill="#d00"/>',
    "panda": '<circle cx="25" cy="25" r="15"/><circle cx="75" cy="25" r="15"/>'
    '<circle cx="50" cy="55" r="37" fill="#fff" stroke="#000" stroke-width="5"/>'
    '<ellipse cx="35" cy="50" rx="9" ry="12"/><ellipse cx="65" cy="50" rx="9" ry="12"/>',
    "outlined house": '<g stroke="#222" stroke-width="5" stroke-linejoin="round">'
    '<path fill="#e74c3c" d="M10 50 50 15 90 50z"/><path d="M20 50h60v40H20z" fill="#f1c40f"/>'
    '<path d="M40 62h20v28H40z" fill="#8e5"/></g>',
    "chart": '<path d="M8 8h8v76h76v8H8z" fill="#555"/><path d="M24 50h14v28H24z" fill="#4a5"/>'
    '<path d="M46 30h14v48H46z" fill="#28f"/><path d="M68 14h14v64H68z" fill="#e43"/>',
    "star": RADIAL.format(0.5, "#fffbe0", "#f5a400") + '<path fill="url(#r)" '
    'd="M50 6 62 38h33L68 58l10 33-28-20-28 20 10-33L5 38h33z"/>',
    "globe": RADIAL.format(0.3, "#e8f6ff", "#0b63b0")
    + '<circle cx="50" cy="50" r="44" fill="url(#r)"/><path fill="#3a3" '
    'd="M30 25q15-10 25 0t-5 20-20 5zM60 55q20 0 18 15t-20 10z"/>',
    "three stripes": '<path d="M2 20h32v60H2z" fill="#00f"/><path d="M34 20h32v60H34z" '
    'fill="#fff"/><path d="M66 20h32v60H66z" fill="#f00"/>',
    "cross": '<path d="M2 20h96v60H2z" fill="#059"/>'
    '<path d="M30 20h14v22h54v14H44v24H30V56H2V42h28z" fill="#fc0"/>',
}


def bitmap(drawing, side, white):
    pixels = rgba(drawing, side, VIEW)
    if not white:
        return pixels
    alpha = pixels[..., 3:] / 255
    return np.rint(pixels[..., :3] * alpha + 255 * (1 - alpha)).astype(np.uint8)


def found(pixels):
    return scans.fitted(ink_of(recognised(pixels)).astype(float))


@pytest.mark.parametrize(
    ("side", "white"),
    [(32, False), (32, True), (48, True)],
    ids=["32, transparent", "32, white", "48, white"],
)
@pytest.mark.parametrize("name", DRAWINGS)
def test_a_small_coloured_drawing_becomes_what_its_svg_becomes(name, side, white):
    right = as_svg(DRAWINGS[name])
    scan = recognised(bitmap(DRAWINGS[name], side, white))
    assert (scan.coloured.omissions if scan.coloured else set()) == right.omissions
    ink = scans.fitted(ink_of(scan).astype(float))
    least = 0.7 if name in LINES else 0.85
    assert scans.iou(ink, scans.fitted(right.coverage / 255)) > least


HOUSE = '<path d="M8 50L50 10l42 40M20 44v46h60V44M40 90V60h20v30" fill="none" stroke="#000" {}/>'


@pytest.mark.parametrize("white", [False, True], ids=["transparent", "white"])
@pytest.mark.parametrize("side", [16, 20, 24])
def test_lines_of_a_pixel_are_whole_and_as_wide(side, white):
    drawing = HOUSE.format('stroke-width="8"')
    ink = found(bitmap(drawing, side, white))
    right = scans.fitted(rgba(drawing, 512, VIEW)[..., 3] / 255)
    assert ndimage.label(ink)[1] == 1 and ndimage.label(~ink)[1] == ndimage.label(~right)[1]
    assert scans.iou(ink, right) > 0.8


@pytest.mark.parametrize("side", [16, 20])
def test_a_frame_on_white_paper_is_neither_a_sheet_nor_a_desk(side):
    drawing = '<rect x="12" y="12" width="76" height="76" rx="8" fill="none" stroke="#000" {}/>'
    drawing = drawing.format('stroke-width="8"')
    right = scans.fitted(rgba(drawing, 512, VIEW)[..., 3] / 255)
    assert scans.iou(found(bitmap(drawing, side, True)), right) > 0.65


HEART = [".RR.RR.", "RWRRRRR", "WRRRRRR", ".RRRRR.", "..RRR..", "...R..."]


@pytest.mark.parametrize("white", [False, True], ids=["transparent", "white"])
def test_the_squares_of_pixel_art_stay_squares(white):
    colours = {".": (255, 255, 255, 0), "R": (220, 30, 50, 255), "W": (255, 255, 255, 255)}
    pixels = np.array([[colours[one] for one in row] for row in HEART], np.uint8)
    pixels = np.pad(pixels, [(5, 5), (5, 4), (0, 0)])
    if white:
        pixels = np.where(pixels[..., 3:] > 0, pixels[..., :3], 255).astype(np.uint8)
    squares = np.array([[one == "R" for one in row] for row in HEART], float)
    right = scans.fitted(np.kron(squares, np.ones((40, 40))))
    assert scans.iou(found(pixels), right) > 0.95


TINY = {
    "heart": [".RR.RR", "RRRRRR", "RRRRRR", ".RRRR.", "..RR.."],
    "smile": ["..RRRR..", ".RRRRRR.", "RR.RR.RR", "RRRRRRRR", "RR....RR", ".RR..RR.", "..RRRR.."],
}


@pytest.mark.parametrize("margin", [0, 1])
@pytest.mark.parametrize("name", TINY)
def test_the_squares_of_tiny_pixel_art_stay_squares(name, margin):
    squares = np.pad([[one == "R" for one in row] for row in TINY[name]], margin)
    pixels = np.where(squares[..., None], (220, 30, 50), 255).astype(np.uint8)
    right = scans.fitted(np.kron(squares.astype(float), np.ones((40, 40))))
    assert scans.iou(found(pixels), right) > 0.95


def test_what_three_colours_blend_is_told():
    random = np.random.default_rng(0)
    colours = random.uniform(0, 255, (3, 4)).astype(np.float32)
    for size in (1, 2, 3):
        shares = random.dirichlet(np.ones(size), 20).astype(np.float32)
        told, away = unblended(shares @ colours[:size], [one[None] for one in colours[:size]])
        assert np.allclose(told, shares.T, atol=1e-3) and (away < 1e-2).all()
    outside = (colours[:1] * 2 - colours[1:2]).astype(np.float32)
    assert np.isinf(unblended(outside, [one[None] for one in colours])[1]).all()


@pytest.mark.parametrize("side", [16, 24, 40])
def test_shapes_cover_as_much_of_each_pixel_as_is_given(side):
    body = '<circle cx="50" cy="50" r="40"/><path d="M20 45h60v20H20z" fill="#fff"/>'
    pixels = rgba(body, side, VIEW).astype(np.float32) / 255
    ink = pixels[..., 3] * (1 - pixels[..., 0])
    parts = np.stack([ink, 1 - ink])
    finer = 480 // side
    fine = reconstructed(parts, (finer * side, finer * side))
    sharp = (fine.argmax(axis=0) == 0).reshape(side, finer, side, finer).mean(axis=(1, 3))
    assert abs(sharp - ink).mean() < 0.02 and abs(sharp.sum() - ink.sum()) < 0.02 * ink.sum()


def test_what_is_evenly_painted_lies_in_an_even_square():
    random = np.random.default_rng(3)
    pixels = np.repeat(random.choice([0, 255], (12, 12, 1)), 4, axis=2).astype(np.float32)
    pixels[..., 3] = 255
    right = np.zeros((12, 12), bool)
    for y in range(11):
        for x in range(11):
            square = pixels[y : y + 2, x : x + 2]
            right[y : y + 2, x : x + 2] |= (square == square[0, 0]).all()
    assert 0 < right.sum() < right.size and (evenly_painted(pixels, 2) == right).all()


@pytest.mark.parametrize("quality", [70, 80])
@pytest.mark.parametrize("side", [16, 24])
def test_the_noise_of_lossy_files_leaves_no_specks(side, quality):
    drawing = '<path d="M28 14 80 50 28 86z"/>'
    file = io.BytesIO()
    Image.fromarray(bitmap(drawing, side, True)).save(file, "JPEG", quality=quality)
    ink = found(np.asarray(Image.open(file)))
    right = scans.fitted(rgba(drawing, 512, VIEW)[..., 3] / 255)
    assert ndimage.label(ink)[1] == 1 and scans.iou(ink, right) > 0.75


@pytest.mark.parametrize("side", [16, 20])
def test_of_shades_on_nothing_the_palest_are_no_holes(side):
    right = rgba(DRAWINGS["star"], 512, VIEW)[..., 3] / 255
    ink = found(bitmap(DRAWINGS["star"], side, False))
    assert ndimage.label(~ink)[1] == 1 and scans.iou(ink, scans.fitted(right)) > 0.8


@pytest.mark.parametrize("side", [16, 32, 128])
def test_white_behind_the_corners_of_a_pale_tile_is_no_ink(side):
    tile = '<rect width="100" height="100" rx="24" fill="#f4f2ed"/>'
    drawing = '<path d="M50 22 82 76H18z"/>'
    right = scans.fitted(rgba(drawing, 512, VIEW)[..., 3] / 255)
    assert scans.iou(found(bitmap(tile + drawing, side, True)), right) > 0.85


@pytest.mark.parametrize(("side", "most"), [(16, 0.55), (24, 0.3), (32, 0.24)])
@pytest.mark.parametrize("white", [True, False])
def test_a_small_disc_is_round(side, most, white):
    """Within so many units of the canvas of 256, in the mean; a pixel is 13 units at 24 pixels."""
    away = []
    for middle, radius in ((50, 38), (51.3, 41), (50.7, 35)):
        disc = f'<circle cx="{middle}" cy="{100 - middle}" r="{radius}"/>'
        away.append(straying(ink_of(recognised(bitmap(disc, side, white)))))
    assert np.mean(away) < most


def straying(ink):
    """Return by how much the outline of a disc strays from a circle, in units of the canvas."""
    (contour,) = measure.find_contours(
        ndimage.gaussian_filter(np.pad(ink, 4).astype(float), 1), 0.5
    )
    terms = np.c_[2 * contour, np.ones(len(contour))]
    y, x, rest = np.linalg.lstsq(terms, (contour**2).sum(axis=1), rcond=None)[0]
    radius = np.sqrt(rest + y**2 + x**2)
    away = np.hypot(*(contour - (y, x)).T) - radius
    return 120 / radius * np.sqrt((away**2).mean())
