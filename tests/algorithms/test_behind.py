"""What is left out with the ground of a bitmap is told as of the same drawing on a rectangle."""

import io

import numpy as np
import pytest
from PIL import Image
from scipy import ndimage

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised
from iconstudio.algorithms.scanning.doubts import SPECK, has_fainter_lines
from iconstudio.algorithms.scanning.noise import without_noise
from iconstudio.algorithms.scanning.shadow import without_shadow
from iconstudio.algorithms.tones import tone
from tests import scans
from tests.algorithms.test_flat import CUP
from tests.algorithms.test_tone import rgba

pytestmark = pytest.mark.thorough

FULL = '<path d="M0 0h100v100H0z" fill="{}"/>'
ROUND = '<rect width="100" height="100" rx="22" fill="{}"/>'
PALE = (
    '<linearGradient id="p" x2="1" y2="1"><stop stop-color="#ffe0e8"/><stop offset="1" '
    'stop-color="#dfe8ff"/></linearGradient>'
)
DISC = '<circle cx="50" cy="50" r="30" fill="{}"/>'
SIGN = '<path d="M30 30h40v40H30zm14 14v12h12V44z" fill="#fff" fill-rule="evenodd"/>'
DRAWINGS = {
    "a red disc on white, as on a flag": FULL.format("#fff") + DISC.format("#c02"),
    "a black disc on white": FULL.format("#fff") + DISC.format("#000"),
    "a dark cup on pale grey": FULL.format("#f0f0f3")
    + CUP.format('fill="#333" fill-rule="evenodd"'),
    "a blue cup on pale grey": FULL.format("#f0f0f3")
    + CUP.format('fill="#05c" fill-rule="evenodd"'),
    "a white cup on blue": FULL.format("#17e") + CUP.format('fill="#fff" fill-rule="evenodd"'),
    "a white cup on black": FULL.format("#111") + CUP.format('fill="#fff" fill-rule="evenodd"'),
    "a dark cup on yellow": FULL.format("#fd1") + CUP.format('fill="#222" fill-rule="evenodd"'),
    "a dark cup on a pale tile": ROUND.format("#f0f0f3")
    + CUP.format('fill="#333" fill-rule="evenodd"'),
    "a blue cup on a white tile": ROUND.format("#fff")
    + CUP.format('fill="#05c" fill-rule="evenodd"'),
    "a dark cup on a pale gradient": PALE
    + FULL.format("url(#p)")
    + CUP.format('fill="#333" fill-rule="evenodd"'),
    "a white sign on blue": FULL.format("#17e") + SIGN,
}


def saved(pixels: np.ndarray, quality: int, mode: str = "RGB") -> np.ndarray:
    """Return a picture (h, w, 4) on white, (h, w, 3), as files of a quality keep it."""
    page = Image.new("RGBA", pixels.shape[1::-1], "white")
    page.alpha_composite(Image.fromarray(pixels))
    page = page.convert("RGB")
    if not quality:
        return np.asarray(page)
    file = io.BytesIO()
    page.convert(mode).save(file, "JPEG", quality=quality)
    return np.asarray(Image.open(file).convert("RGB"))


@pytest.mark.parametrize("name", DRAWINGS)
@pytest.mark.parametrize(("side", "quality"), [(48, 0), (120, 80), (240, 0)])
def test_what_is_left_out_is_told_whatever_the_file(name, side, quality):
    right = tone.pictogram(rgba(DRAWINGS[name], 512, "0 0 100 100"))
    scan = recognised(saved(rgba(DRAWINGS[name], side, "0 0 100 100"), quality))
    assert scan.omissions == right.omissions
    ink = scans.fitted(ink_of(scan).astype(float))
    assert scans.iou(ink, scans.fitted(right.coverage / 255)) > 0.88


@pytest.mark.parametrize("colour", ["#c02", "#000"])
def test_nothing_is_left_out_of_what_lies_on_nothing(colour):
    assert not recognised(rgba(DISC.format(colour), 96, "0 0 100 100")).omissions


def test_paper_goes_without_saying():
    """It is no ground that a computer painted: it has grain."""
    paper = rgba(FULL.format("#fff") + DISC.format("#c02"), 300, "0 0 100 100")[..., :3]
    paper = np.random.default_rng(0).normal(paper * 0.92, 8)
    assert not recognised(np.clip(paper, 0, 255).astype(np.uint8)).omissions


BLACK = {
    "arch": '<path d="M20 88V50a30 30 0 0 1 60 0v38" fill="none" stroke="#000" stroke-width="9"/>',
    "arrow": '<path d="M50 10l36 40H64v38H36V50H14z"/>',
    "thin lines": '<path d="M12 80L40 20l20 50 28-56" fill="none" stroke="#000" stroke-width="5"/>',
}


@pytest.mark.parametrize("name", BLACK)
@pytest.mark.parametrize("side", [64, 128])
def test_the_fringes_of_black_in_a_lossy_file_are_no_colours(name, side):
    """Files for printing keep the four inks apart, some of them coarsely."""
    drawing = rgba(BLACK[name], side, "0 0 100 100")
    scan = recognised(saved(drawing, 75, "CMYK"))
    assert not scan.omissions and not scan.faint and not scan.shaded
    right = scans.fitted(rgba(BLACK[name], 512, "0 0 100 100")[..., 3] / 255)
    assert scans.iou(scans.fitted(ink_of(scan).astype(float)), right) > 0.88


PANES = "".join(f"M{x} {y}h20v20h-20z" for x in (18, 41, 64) for y in (18, 41, 64))
CHESS = "".join(
    f"M{16 + 17 * x} {16 + 17 * y}h17v17h-17z" for x in range(4) for y in range(4) if (x + y) % 2
)


@pytest.mark.parametrize("panes", [PANES, CHESS])
@pytest.mark.parametrize(("side", "quality"), [(64, 80), (128, 0)])
def test_a_frame_is_drawn_with_its_windows(panes, side, quality):
    """They span most of it, as no sign on a tile does; and nothing is left out."""
    frame = f'<path d="M8 8h84v84H8z{panes}" fill-rule="evenodd"/>'
    scan = recognised(saved(rgba(frame, side, "0 0 100 100"), quality))
    assert not scan.omissions and not scan.shaded
    right = scans.fitted(rgba(frame, 512, "0 0 100 100")[..., 3] / 255)
    assert scans.iou(scans.fitted(ink_of(scan).astype(float)), right) > 0.9


@pytest.mark.parametrize("quality", [0, 80])
def test_a_frame_that_reaches_the_edge_is_no_photo(quality):
    frame = f'<rect width="100" height="100" rx="12"/><path d="{PANES}" fill="#fff"/>'
    assert not recognised(saved(rgba(frame, 64, "0 0 100 100"), quality)).shaded


def test_noise_is_no_fainter_line():
    """Specks that would be taken for dirt, were they ink, are not told as lines."""
    dark = np.zeros((512, 512), np.float32)
    dark[200:300, 100:400] = 1
    for n in range(40):
        dark[20 + 8 * (n % 5) :, 20 + 12 * n :][:6, :6] = 0.3
    assert SPECK > 36 and not has_fainter_lines(dark, 1 - dark[..., None], 0.5)
    dark[400:406, 50:450] = 0.3
    assert has_fainter_lines(dark, 1 - dark[..., None], 0.5)


def test_the_edge_of_a_shadow_is_no_fainter_line():
    light = np.full((512, 512, 3), 0.9, np.float32)
    light[200:300, 100:400] = 0.1
    light[400:] = 0.6
    dark = np.zeros((512, 512), np.float32)
    dark[200:300, 100:400] = 1
    dark[400:406] = 0.2  # where the light is not divided out
    assert not has_fainter_lines(dark, light, 0.5)
    light[406:] = 0.9
    assert has_fainter_lines(dark, light, 0.5)


PALE = (
    '<path d="M20 46l30-26 30 26v42H20z" fill="#e8eaf6"/><path d="M20 80h60v8H20z" fill="#c5cae9"/>'
    '<path d="M12 50L50 14l38 36-5 6-33-31-33 31z" fill="#b71c1c"/>'
    '<path d="M42 56h16v32H42z" fill="#d84315"/>'
)


@pytest.mark.parametrize("quality", [0, 75])
def test_pale_walls_are_no_shadow(quality):
    shadow = '<filter id="f" x="-.3" y="-.3" width="1.6" height="1.6"><feDropShadow dx="0" dy="0" '
    shadow += f'stdDeviation="6" flood-opacity=".6"/></filter><g filter="url(#f)">{PALE}</g>'
    page = saved(rgba(shadow, 173, "-20 -20 140 140"), quality)
    house = saved(rgba(PALE, 173, "-20 -20 140 140"), 0).astype(int)
    lit = without_shadow(without_noise(page))
    walls = ndimage.binary_erosion((house == (232, 234, 246)).all(axis=2), iterations=2)
    white = (house == 255).all(axis=2)
    assert lit is not None and (lit[white] > 230).all(axis=1).mean() > 0.99
    assert (abs(lit - house)[walls] < 12).all(axis=1).mean() > 0.9


def test_paper_that_is_lit_from_one_side_is_no_tile():
    """As a camera without grain sees it: a drawing on beige paper, brighter at the left."""
    drawn = rgba(DISC.format("#000"), 300, "0 0 100 100")[..., 3:] / 255
    paper = np.array([225, 218, 200]) * (1 - drawn) + np.array([40, 45, 90]) * drawn
    lit = paper * np.linspace(1, 0.7, 300)[None, :, None]
    scan = recognised(lit.astype(np.uint8))
    assert scan.found and not scan.omissions
    tinted = paper * np.linspace((1, 0.75, 0.9), (0.8, 1, 0.7), 300)[None]
    assert recognised(np.clip(tinted, 0, 255).astype(np.uint8)).omissions
