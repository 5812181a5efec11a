"""Drawings found on scans that were made up, so that their true shape is known."""

import numpy as np
import pytest
from scipy import ndimage
from skimage.data import astronaut, camera, chelsea, coffee, coins, horse, rocket
from skimage.draw import disk, polygon

from iconstudio.algorithms.scanning.binarisation import SIDE, Scan, ink_of, scanned
from iconstudio.algorithms.tracing.potrace import traced
from iconstudio.model import IconstudioError
from tests import scans

pytestmark = pytest.mark.thorough(but=1)


def house() -> np.ndarray:
    """Walls, a roof, a door and a chimney that floats: (SIDE, SIDE) from 0 to 1."""
    ink = np.zeros((scans.SIDE, scans.SIDE))
    ink[polygon([60, 200, 200, 370, 370, 200, 200], [200, 40, 80, 80, 320, 320, 360])] = 1
    ink[240:370, 170:230] = 0
    ink[disk((290, 280), 25)] = 0
    ink[40:110, 300:340] = 1
    return ink


def found(pixels, **options) -> np.ndarray:
    return ink_of(scanned(pixels, **options)).astype(float)


@pytest.mark.parametrize("kind", scans.KINDS, ids=lambda kind: kind.__name__)
def test_a_drawing_is_found_on_every_kind_of_scan(kind):
    """Others than a house, each on another scan, are in ``test_scans``."""
    scan = scanned(scans.scan(house(), kind, scans.KINDS.index(kind)))
    assert scan.found and not scan.shaded
    ink = ink_of(scan).astype(float)
    assert max(ink.shape) == SIDE
    assert scans.iou(scans.fitted(ink), scans.fitted(house())) > 0.95


WOOD = (0.45, 0.3, 0.18)


@pytest.mark.parametrize("degrees", [8, -20])
@pytest.mark.parametrize("colour", [(0.24, 0.16, 0.12), WOOD, (0.15, 0.25, 0.55)])
def test_a_sheet_that_lies_askew_on_a_desk_is_cut_out(colour, degrees):
    pixels = scans.laid_on(np.pad(house(), 40)[::2, ::2], colour, degrees)
    turned = ndimage.rotate(house(), degrees, order=1)
    scan = scanned(pixels)
    assert not scan.inverted
    assert scans.iou(scans.fitted(ink_of(scan).astype(float)), scans.fitted(turned)) > 0.93


def test_a_sheet_on_veined_wood_is_cut_out():
    y, x = np.mgrid[:240, :240]
    veins = 0.1 * np.sin(y / 4 + 2 * np.sin(x / 40))[..., None]
    picture = np.broadcast_to(np.array(WOOD), (240, 240, 3)) * (1 + veins)
    picture[20:220, 30:230] = 1 - 0.9 * house()[::2, ::2, None]
    lit = picture * np.linspace(0.6, 1, 240)[:, None]
    ink = found((255 * lit).astype(np.uint8))
    assert scans.iou(scans.fitted(ink), scans.fitted(house())) > 0.93


@pytest.mark.parametrize("colour", [(0, 0, 0), (0.15, 0.25, 0.55)])
@pytest.mark.parametrize("degrees", [0, 10])
def test_a_white_card_that_shows_its_ground_is_no_sheet(colour, degrees):
    """Drawn by a computer: what is cut out of the card is of the ground's very colour."""
    card = np.pad(1 - house()[::2, ::2], 20, constant_values=1)
    turned = ndimage.rotate(np.pad(card, 20), degrees, order=1)
    pixels = (255 * (turned[..., None] + (1 - turned[..., None]) * colour)).astype(np.uint8)
    scan = scanned(pixels)
    assert scan.inverted
    assert scans.iou(scans.fitted(ink_of(scan).astype(float)), scans.fitted(turned)) > 0.95


ASLANT = {
    "from below": ("dark", [(120, 40), (530, 40), (620, 450), (20, 450)]),
    "from the left": ("wood", [(40, 20), (600, 90), (590, 400), (50, 465)]),
    "turned": ("striped", [(60, 150), (480, 30), (600, 330), (150, 450)]),
    "a corner past the photo": ("checked", [(60, 60), (680, 30), (600, 440), (30, 420)]),
    "a side past the photo": ("dark", [(40, 60), (600, 50), (660, 520), (-20, 510)]),
}


@pytest.mark.parametrize(("desk", "corners"), ASLANT.values(), ids=ASLANT)
def test_a_sheet_photographed_aslant_is_cut_out(desk, corners):
    sheet = np.pad(house(), ((60, 60), (120, 180)))
    pixels, truth = scans.photographed(sheet, corners, desk)
    scan = scanned(pixels)
    assert not scan.inverted and not scan.shaded
    assert scans.iou(scans.fitted(ink_of(scan).astype(float)), scans.fitted(truth)) > 0.9


def test_a_shadow_with_a_sharp_edge_across_a_sheet_is_no_ink():
    sheet = np.pad(house(), ((60, 60), (120, 180)))
    pixels, truth = scans.photographed(sheet, ASLANT["from below"][1], "dark")
    y, x = np.mgrid[: pixels.shape[0], : pixels.shape[1]]
    shadow = 1 - 0.35 / (1 + np.exp(-(x + y / 2 - 430) / 5))
    ink = found((pixels * shadow[..., None]).astype(np.uint8))
    assert scans.iou(scans.fitted(ink), scans.fitted(truth)) > 0.9


@pytest.mark.parametrize("light", [0.6, 0.3])
@pytest.mark.parametrize(("sharpness", "across"), [(1.5, 0.35), (5, 0.55), (12, 0.55)])
def test_half_of_a_drawing_may_lie_in_a_shadow(light, sharpness, across):
    """Its edge, from the right to the lower left, runs through the drawing or close to it."""
    sheet = np.pad(house(), ((60, 60), (160, 160)))[::2, ::2]
    y, x = np.mgrid[: sheet.shape[0], : sheet.shape[1]]
    edge = 1 / (1 + np.exp((across * sheet.shape[1] - x - 0.3 * y) / sharpness * 2))
    lit = (1 - 0.8 * sheet) * (1 - (1 - light) * edge)
    noise = np.random.default_rng(0).normal(0, 5, (*sheet.shape, 3))
    ink = found(np.clip(255 * lit[..., None] + noise, 0, 255).astype(np.uint8))
    assert scans.iou(scans.fitted(ink), scans.fitted(house())) > 0.93


def test_ink_along_the_edge_of_a_sheet_is_no_shadow():
    pixels = np.full((300, 400, 3), 250, np.uint8)
    pixels[200:] = 60
    pixels[100:200, 150:250] = 60
    assert 0.4 < found(pixels).mean() < 0.8


def test_another_sheet_beside_is_no_part_of_the_drawing():
    sheet = np.pad(house(), ((60, 60), (120, 180)))
    pixels, truth = scans.photographed(sheet, ASLANT["from below"][1], "dark")
    pixels = pixels.copy()
    pixels[:200, 560:] = 210
    assert scans.iou(scans.fitted(found(pixels)), scans.fitted(truth)) > 0.9


def test_a_drawing_out_of_focus_is_no_photo_of_something_else():
    sheet = np.pad(house(), ((60, 60), (120, 180)))
    pixels, _ = scans.photographed(sheet, ASLANT["from below"][1], "dark", blur=4, noise=8)
    scan = scanned(pixels)
    assert scan.found and not scan.shaded


def test_what_is_too_faint_to_be_told_can_be_chosen_by_hand():
    pixels = np.repeat(250 - 20 * house()[..., None], 3, axis=2).astype(np.uint8)
    scan = scanned(pixels)
    assert not scan.found
    with pytest.raises(IconstudioError, match="No drawing"):
        ink_of(scan)
    ink = ink_of(scan, scan.threshold).astype(float)
    assert scans.iou(scans.fitted(ink), scans.fitted(house())) > 0.95


def ruled(sheet: np.ndarray) -> np.ndarray:
    """Paper with pale blue rules and a red margin below the drawing."""
    paper = np.full((*sheet.shape, 3), (250.0, 248.0, 240.0))
    paper[12::40] = paper[13::40] = paper[14::40] = 170, 190, 230
    paper[:, 60:62] = 230, 120, 120
    return paper * (1 - 0.8 * sheet[..., None])


def stained(sheet: np.ndarray) -> np.ndarray:
    """Brown paper with the ring of a cup across the drawing."""
    y, x = np.mgrid[: sheet.shape[0], : sheet.shape[1]]
    ring = abs(np.hypot(y - 130, x - 380) - 110) < 5
    paper = np.where(ring[..., None], (210.0, 185.0, 135.0), (235.0, 220.0, 180.0))
    return paper * (1 - 0.85 * sheet[..., None])


@pytest.mark.parametrize("paper", [ruled, stained])
def test_rules_and_stains_on_the_paper_make_no_photo_of_a_drawing(paper):
    walls = house()
    walls[ndimage.binary_erosion(walls > 0, iterations=9)] = 0
    sheet = np.pad(walls, ((40, 40), (150, 80)))
    picture = ndimage.gaussian_filter(paper(sheet), (1, 1, 0))
    noise = np.random.default_rng(0).normal(0, 4, picture.shape)
    scan = scanned(np.clip(picture + noise, 0, 255).astype(np.uint8))
    assert scan.found and not scan.shaded
    assert scans.iou(scans.fitted(ink_of(scan).astype(float)), scans.fitted(walls)) > 0.85


@pytest.mark.parametrize("photo", [astronaut, camera, chelsea, coffee, coins, rocket])
def test_a_photo_is_told_from_a_drawing(photo):
    pixels = photo()[::2, ::2]
    scan = scanned(np.repeat(pixels[..., None], 3, axis=2) if pixels.ndim == 2 else pixels)
    assert scan.shaded


def test_a_picture_that_changes_gradually_is_no_drawing():
    y, x = np.mgrid[:200, :300]
    waves = np.sin(x / 20) * np.cos(y / 30), 0.8 * np.sin(y / 15), x / 150 - 1
    scan = scanned((128 + 100 * np.stack(waves, axis=-1)).astype(np.uint8))
    assert scan.shaded or not scan.found


def test_the_horse():
    picture = horse()  # black on white
    shape = ~picture
    pixels = np.repeat(np.where(picture, 255, 0).astype(np.uint8)[..., None], 3, axis=2)
    assert scans.iou(scans.fitted(found(pixels)), scans.fitted(shape.astype(float))) > 0.97
    assert scans.iou(scans.fitted(found(255 - pixels)), scans.fitted(shape.astype(float))) > 0.97


def test_the_polarity_can_be_chosen():
    pixels = scans.scan(house(), scans.plain, 0)
    assert not scanned(pixels).inverted and scanned(255 - pixels).inverted
    clear = scans.scan(house(), scans.transparent, 0)
    full = scanned(clear, inverted=True)
    assert full.inverted
    assert ink_of(full).mean() > 0.5 > ink_of(scanned(clear)).mean()


def test_bright_colours_are_ink_on_white_and_on_nothing_but_near_white_is_not():
    """A yellow disc with a black ring and a pale highlight on it."""
    picture = np.zeros((300, 300, 4), np.uint8)
    disc = np.zeros((300, 300), bool)
    disc[disk((150, 150), 120)] = True
    picture[disc] = 250, 210, 40, 255
    ring = np.zeros_like(disc)
    ring[disk((150, 150), 70)] = True
    ring[disk((150, 150), 50)] = False
    picture[ring] = 0, 0, 0, 255
    light = np.zeros_like(disc)
    light[disk((150, 150), 25)] = True
    picture[light] = 255, 252, 245, 255
    on_white = np.where(disc[..., None], picture[..., :3], 255).astype(np.uint8)
    for pixels in (picture, on_white):
        scan = scanned(pixels)
        expected = scans.fitted((disc & ~light).astype(float))
        assert scans.iou(scans.fitted(ink_of(scan).astype(float)), expected) > 0.95
        black = scans.fitted(ink_of(scan, 235).astype(float))
        assert scans.iou(black, scans.fitted(ring.astype(float))) > 0.85


def test_a_higher_threshold_leaves_less_ink():
    scan = scanned(scans.scan(house(), scans.blurred, 0))
    amounts = [ink_of(scan, threshold).sum() for threshold in (40, 90, scan.threshold, 170, 220)]
    assert amounts == sorted(amounts, reverse=True) and amounts[0] > 1.05 * amounts[-1]


@pytest.mark.parametrize(
    "pixels",
    [
        np.full((50, 40, 3), 255, np.uint8),
        np.zeros((1, 1, 3), np.uint8),
        np.zeros((1, 900, 3), np.uint8),
        np.full((1200, 3, 3), 255, np.uint8),
        np.full((50, 40, 4), (255, 0, 0, 0), np.uint8),
        np.random.default_rng(0).normal(128, 4, (300, 300, 3)).astype(np.uint8),
    ],
    ids=["blank", "a pixel", "a row", "a column", "transparent", "noise"],
)
def test_where_there_is_no_drawing_it_is_told(pixels):
    with pytest.raises(IconstudioError, match=r"No drawing|transparent all over|Nothing is"):
        ink_of(scanned(pixels))


def test_a_threshold_that_nothing_exceeds_is_told():
    with pytest.raises(IconstudioError, match="Lower the threshold"):
        ink_of(Scan(np.full((9, 9), 100, np.uint8), 50, False), 200)


def test_what_is_traced_is_the_ink_not_the_paper():
    """Filled with the even-odd rule by scikit-image, the polygons are the bitmap again."""
    ink = np.zeros((64, 80), bool)
    ink[10:50, 20:60] = True
    ink[20:30, 30:40] = False
    filled = np.zeros_like(ink)
    for contour in traced(ink).contours:
        points = np.array(list(contour.points))
        inside = np.zeros_like(ink)
        inside[polygon(points[:, 1] - 0.5, points[:, 0] - 0.5, ink.shape)] = True
        filled ^= inside
    assert scans.iou(filled, ink) > 0.93


@pytest.mark.parametrize(
    ("hidden", "opacity"),
    [
        *(((0, 0, 0), opacity) for opacity in (0, 20, 100, 160, 230)),
        *(((255, 255, 255), opacity) for opacity in (20, 230)),
        *(((90, 30, 200), opacity) for opacity in (0, 100, 230)),
    ],
)
def test_paper_that_is_partly_transparent_is_paper_whatever_it_hides(opacity, hidden):
    shape = house() > 0.5
    picture = np.full((*shape.shape, 4), 255, np.uint8)
    picture[:, 180:] = *hidden, opacity
    picture[shape] = 20, 20, 160, 255
    assert scans.iou(scans.fitted(found(picture)), scans.fitted(house())) > 0.95
