"""Bitmaps in flat colours become what the same drawing becomes as SVG; scans and photos do not."""

import io
from functools import cache

import numpy as np
import pytest
from PIL import Image
from scipy import ndimage
from skimage.data import camera, chelsea, coffee

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised, scanned
from iconstudio.algorithms.scanning.flat import flat_drawing
from iconstudio.algorithms.scanning.free import SIDE
from iconstudio.algorithms.tones import tone
from iconstudio.algorithms.tones.alternation import Omission
from iconstudio.algorithms.tones.layers import flattened
from tests import scans
from tests.algorithms.test_scanning import house
from tests.algorithms.test_tone import as_svg, pictogram, rgba

pytestmark = pytest.mark.thorough(but=1)

FACE = '<circle cx="50" cy="50" r="45" fill="{}"/><g fill="{}"><circle cx="34" cy="40" r="8"/>'
SMILE = '<circle cx="66" cy="40" r="8"/><path d="M28 62a24 16 0 0 0 44 0z"/></g>'
WALLS = '<path d="M10 48L50 8l40 40v44H10z" fill="#fd8" stroke="#222" stroke-width="6"/>'
DRAWINGS = {
    "yellow face": FACE.format("#fc0", "#420") + SMILE,
    "blue face": FACE.format("#27d", "#fd0") + SMILE,
    "house": WALLS + '<path d="M40 60h20v32H40z" fill="#a24" stroke="#222" stroke-width="6"/>',
    "bars": '<path d="M8 50h24v42H8z" fill="#0bd"/><path d="M38 10h24v82H38z" fill="#e33"/>'
    '<path d="M68 30h24v62H68z" fill="#36a"/>',
    "button": '<rect x="5" y="5" width="90" height="90" rx="16" fill="#1a9"/>'
    '<path d="M36 28l36 22-36 22zM20 20h60v8H20z" fill="#fe9"/>',
}


def bitmap(drawing, side, kind):
    picture = Image.fromarray(rgba(drawing, 512, "0 0 100 100")).resize((side, side))
    if kind == "transparent":
        return np.asarray(picture)
    page = Image.new("RGB", (side + 12, side + 20), "white")
    page.paste(picture, (5, 9), picture)
    if kind == "white":
        return np.asarray(page)
    file = io.BytesIO()
    page.save(file, "JPEG", quality=80)
    return np.asarray(Image.open(file))


@pytest.mark.parametrize("name", DRAWINGS)
@pytest.mark.parametrize(("side", "kind"), [(48, "transparent"), (96, "white"), (200, "jpeg")])
def test_a_bitmap_becomes_what_the_drawing_becomes(name, side, kind):
    right = scans.fitted(as_svg(DRAWINGS[name]).coverage / 255)
    scan = recognised(bitmap(DRAWINGS[name], side, kind))
    assert scan.found and not scan.shaded and scan.coloured is not None
    assert scans.iou(scans.fitted(ink_of(scan).astype(float)), right) > 0.9
    by_hand = ink_of(scan, scan.threshold - 1)
    assert by_hand.shape == scan.darkness.shape


@pytest.mark.parametrize("kind", scans.KINDS, ids=lambda kind: kind.__name__)
def test_a_scan_is_no_drawing_in_flat_colours(kind):
    assert flat_drawing(scans.scan(house(), kind, 0)) is None


@pytest.mark.parametrize("photo", [camera, chelsea, coffee])
@pytest.mark.parametrize("step", [1, 3, 9])
def test_nor_is_a_photo(photo, step):
    pixels = photo()[::step, ::step]
    grey = pixels.ndim == 2
    assert flat_drawing(np.repeat(pixels[..., None], 3, axis=2) if grey else pixels) is None


def test_the_polarity_can_still_be_chosen():
    pixels = bitmap(DRAWINGS["yellow face"], 96, "white")
    for inverted in (False, True):
        scan = recognised(pixels, inverted)
        assert scan.coloured is None and scan.inverted == inverted


TILES = {
    "rounded": '<rect width="100" height="100" rx="22" {}/>',
    "superellipse": '<path d="M50 0C90 0 100 10 100 50S90 100 50 100 0 90 0 50 10 0 50 0z" {}/>',
    "circle": '<circle cx="50" cy="50" r="50" {}/>',
    "full": '<path d="M0 0h100v100H0z" {}/>',
}
GRADIENT = (
    '<linearGradient id="g" y2="1"><stop stop-color="#5ad"/><stop offset="1" stop-color="#52c"/>'
    "</linearGradient>"
)
CUP = '<path d="M24 30h42v8h6a10 10 0 0 1 0 24h-6v10H24zm42 16v8h5a4 4 0 0 0 0-8z" {}/>'
APPS = [
    ("rounded", "#17e", "#fff", (255, 255, 255), 64, 0),
    ("rounded", "#f90", "#fff", (0, 0, 0), 64, 0),
    ("rounded", "#000", "#fff", (255, 255, 255), 128, 80),
    ("rounded", "#fd1", "#111", (200, 60, 80), 128, 90),
    ("rounded", "url(#g)", "#fff", (255, 255, 255), 128, 85),
    ("rounded", "url(#g)", "#fff", None, 32, 0),
    ("superellipse", "url(#g)", "#fff", None, 256, 0),
    ("superellipse", "#0a6", "#fff", (0, 0, 0), 128, 75),
    ("circle", "#c25", "#fff", (0, 0, 0), 128, 80),
    ("circle", "url(#g)", "#fff", (255, 255, 255), 64, 0),
    ("full", "#f90", "#fff", None, 64, 0),
    ("full", "url(#g)", "#fff", None, 128, 70),
]


@pytest.mark.parametrize(("tile", "colour", "glyph", "corners", "side", "quality"), APPS)
def test_the_light_or_dark_drawing_on_an_app_icon_is_the_drawing(
    tile, colour, glyph, corners, side, quality
):
    """The tile reaches the edge of the picture; only its corners, if any, show what is behind."""
    drawing = GRADIENT + TILES[tile].format(f'fill="{colour}"')
    drawing += CUP.format(f'fill="{glyph}" fill-rule="evenodd"')
    right = scans.fitted(as_svg(drawing).coverage / 255)
    pixels = rgba(drawing, side, "0 0 100 100")
    if corners is not None:
        alpha = pixels[..., 3:] / 255
        pixels = (pixels[..., :3] * alpha + np.array(corners) * (1 - alpha) + 0.5).astype(np.uint8)
    elif tile == "full":
        pixels = pixels[..., :3]
    if quality:
        file = io.BytesIO()
        Image.fromarray(pixels).save(file, "JPEG", quality=quality)
        pixels = np.asarray(Image.open(file))
    assert scans.iou(scans.fitted(ink_of(recognised(pixels)).astype(float)), right) > 0.88


SHADOW = (
    '<filter id="f" x="-20%" y="-20%" width="150%" height="150%"><feDropShadow dx="0" dy="2" '
    'stdDeviation="3" flood-opacity=".3"/></filter>'
)
LAYERED = {
    "duotone": '<path d="M10 40h80v50H10z" opacity=".4"/><path d="M50 5l45 35H5z"/>',
    "faint fill": '<path d="M15 15h70v70H15z" opacity=".2"/><path d="M10 10h80v80H10zm6 6v68h68V'
    '16z" fill-rule="evenodd"/>',
    "pale emoji": '<g opacity=".9">' + FACE.format("#fc0", "#420") + SMILE + "</g>",
    "faint emoji": '<g opacity=".3">' + FACE.format("#27d", "#fd0") + SMILE + "</g>",
    "two colours": '<circle cx="50" cy="50" r="40" fill="#f00" opacity=".5"/>'
    '<path d="M38 38h24v24H38z"/>',
    "shadow": SHADOW + f'<g filter="url(#f)">{DRAWINGS["bars"]}</g>',
}


@cache
def layered(name):
    """What a drawing in layers becomes that is read as SVG."""
    return pictogram(flattened(rgba(LAYERED[name], 512, "0 0 100 100")))


@pytest.mark.thorough
@pytest.mark.parametrize("name", LAYERED)
@pytest.mark.parametrize("side", [64, 400])
def test_layers_are_as_in_the_same_drawing_as_svg(name, side):
    right = scans.fitted(layered(name) / 255)
    pixels = rgba(LAYERED[name], side, "0 0 100 100")
    found = scans.fitted(ink_of(recognised(pixels)).astype(float))
    assert scans.iou(found, right) > 0.9


@pytest.mark.parametrize("ink", ["#fff", "#123"])
@pytest.mark.parametrize("ground", ["#f90", "#fd0", "#f44", "#7c4"])
def test_a_drawing_on_a_bright_ground_is_found_whatever_the_ground(ground, ink):
    body = f'<path d="M0 0h100v100H0z" fill="{ground}"/>' + CUP.format(
        f'fill="{ink}" fill-rule="evenodd"'
    )
    scan = scanned(rgba(body, 96, "0 0 100 100")[..., :3])
    right = rgba(CUP.format('fill-rule="evenodd"'), 256, "0 0 100 100")[..., 3] / 255
    assert scan.found and scan.inverted == (ink == "#fff")
    assert scans.iou(scans.fitted(ink_of(scan).astype(float)), scans.fitted(right)) > 0.9


@pytest.mark.parametrize(("greys", "strays"), [(True, 0.05), (False, 0.17)])
@pytest.mark.parametrize("side", [16, 24])
def test_a_small_picture_gives_smooth_contours(side, greys, strays):
    """A ring two pixels wide stays whole, as wide, and round."""
    body = '<circle cx="50" cy="50" r="40" fill="none" stroke="#000" stroke-width="12"/>'
    pixels = rgba(body, side, "0 0 100 100")
    if not greys:
        pixels[..., 3] = np.where(pixels[..., 3] > 127, 255, 0)
    ink = ink_of(recognised(pixels))
    rows, columns = np.nonzero(ink ^ ndimage.binary_erosion(ink))
    away = np.hypot(rows - rows.mean(), columns - columns.mean())
    outer, inner = away[away > away.mean()], away[away <= away.mean()]
    pixel = outer.mean() / (0.46 * side)
    assert abs(inner.mean() / pixel - 0.34 * side) < 0.3
    assert max(outer.std(), inner.std()) / pixel < strays


@pytest.mark.parametrize("shape", [(1, 1, 3), (5, 90, 4), (40, 3, 3), (9, 9, 4)])
def test_what_is_tiny_is_looked_at(shape):
    pixels = np.random.default_rng(0).integers(0, 256, shape, np.uint8)
    flat = flat_drawing(pixels)
    assert flat is None or flat.shape == (SIDE, SIDE, 4)


CROPPED = {
    "letters": '<g fill="none" stroke="{0}" stroke-width="10"><circle cx="22" cy="30" r="17"/>'
    '<path d="M5 0v60M95 0L56 32M62 28l33 32M57 0v60"/></g>',
    "hourglass": '<path d="M0 0h100L60 30l40 30H0l40-30z" fill="{}"/>',
    "card": '<rect x="3" y="3" width="94" height="54" rx="12" fill="none" stroke="{0}" '
    'stroke-width="6"/><path d="M3 20h94" stroke="{0}" stroke-width="6"/>',
}


def on_page(drawing, side, quality=0, box="0 0 100 60"):
    """The drawing without a margin, (h, w, 3)."""
    width, height = (int(n) for n in box.split()[2:])
    square = rgba(drawing, side, f"0 {(height - width) // 2} {width} {width}")
    rows = side * (width - height) // width // 2
    picture = Image.fromarray(square[rows : side - rows])
    page = Image.new("RGB", picture.size, "white")
    page.paste(picture, (0, 0), picture)
    if not quality:
        return np.asarray(page)
    file = io.BytesIO()
    page.save(file, "JPEG", quality=quality)
    return np.asarray(Image.open(file))


@pytest.mark.parametrize("name", CROPPED)
@pytest.mark.parametrize(
    ("colour", "side", "quality"), [("#111", 200, 95), ("#8fbffa", 100, 0), ("#8fbffa", 200, 95)]
)
def test_what_touches_the_edge_of_a_tightly_cropped_page_is_drawn(name, colour, side, quality):
    drawing = CROPPED[name].format(colour)
    right = scans.fitted(rgba(drawing, 512, "0 -20 100 100")[..., 3] / 255)
    scan = recognised(on_page(drawing, side, quality))
    assert scan.found and not scan.shaded
    assert scans.iou(scans.fitted(ink_of(scan).astype(float)), right) > 0.93


FLAGS = {
    "stripes": '<path d="M0 0h100v60H0z" fill="#fff"/><path d="M0 0h100v20H0z" fill="#a12"/>'
    '<path d="M0 40h100v20H0z" fill="#148"/>',
    "cross": '<path d="M0 0h100v60H0z" fill="#059"/>'
    '<path d="M30 0h12v24h58v12H42v24H30V36H0V24h30z" fill="#fc0"/>',
    "lozenge": '<path d="M0 0h100v60H0z" fill="#093"/><path d="M50 6l40 24-40 24-40-24z"'
    ' fill="#fd0"/><circle cx="50" cy="30" r="12" fill="#127"/>',
    "badge": '<path d="M0 0h100v60H0z" fill="#d22"/><path d="M44 12h12v12h12v12H56v12H44V36H32V24'
    'h12z" fill="#fff"/>',
}

BANNERS = {
    "two colours on navy": '<path d="M0 0h100v60H0z" fill="#0b1f3a"/>'
    '<path d="M6 50L22 10l16 40z" fill="#ffd400"/><g fill="none" stroke="#fff" stroke-width="5">'
    '<circle cx="54" cy="38" r="9"/><path d="M66 38a9 9 0 1 0 18 0a9 9 0 1 0-18 0M84 8v42"/></g>',
    "two colours on black": '<path d="M0 0h100v60H0z"/><path d="M6 50L22 10l16 40z" fill="#0af"/>'
    '<circle cx="68" cy="30" r="17" fill="none" stroke="#fff" stroke-width="9"/>',
}
"""Letters keep their counters."""
FLAGS |= BANNERS


@cache
def flag_as_svg(drawing):
    """What a flag with a little air around becomes that is read as SVG."""
    square = Image.new("RGBA", (512, 512))
    square.paste(Image.fromarray(rgba(drawing, 482, "0 -20 100 100")), (15, 15))
    return tone.pictogram(np.asarray(square))


@pytest.mark.parametrize("name", FLAGS)
@pytest.mark.parametrize(("side", "quality"), [(80, 0), (200, 80)])
def test_colours_that_reach_the_edge_are_no_page(name, side, quality):
    """What is left out is told, as of the same drawing as SVG."""
    right = flag_as_svg(FLAGS[name])
    scan = recognised(on_page(FLAGS[name], side, quality))
    assert scan.coloured is not None and scan.coloured.omissions == right.omissions
    found = scans.fitted(ink_of(scan).astype(float))
    assert scans.iou(found, scans.fitted(right.coverage / 255)) > 0.88


@pytest.mark.thorough
@pytest.mark.parametrize(("side", "quality"), [(32, 0), (48, 0), (200, 65)])
@pytest.mark.parametrize("corners", [True, False])
def test_a_ring_on_a_gradient_is_the_drawing_on_it(side, quality, corners):
    drawing = GRADIENT + TILES["rounded"].format('fill="url(#g)"')
    drawing += '<circle cx="50" cy="50" r="24" fill="none" stroke="#fff" stroke-width="10"/>'
    right = scans.fitted(as_svg(drawing).coverage / 255)
    pixels = on_page(drawing, side, quality, "0 0 100 100")
    if not corners and not quality:
        pixels = rgba(drawing, side, "0 0 100 100")
    assert scans.iou(scans.fitted(ink_of(recognised(pixels)).astype(float)), right) > 0.88


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("bright", "side", "quality"), [("#335", 64, 0), ("#335", 256, 0), ("#558", 200, 80)]
)
def test_the_glow_behind_a_sign_is_no_part_of_it(bright, side, quality):
    glow = (
        f'<radialGradient id="r"><stop stop-color="{bright}"/><stop offset="1" stop-color="#001"/>'
        '</radialGradient><path d="M0 0h100v100H0z" fill="url(#r)"/>'
    )
    sign = '<path d="M50 24a26 26 0 0 0 0 52 26 26 0 0 0 0-52zm-5 14h10v24H45z" fill="#fff"/>'
    right = scans.fitted(pictogram(rgba(glow + sign, 512, "0 0 100 100")) / 255)
    scan = recognised(on_page(glow + sign, side, quality, "0 0 100 100"))
    assert scan.omissions == {Omission.TILE}
    assert scans.iou(scans.fitted(ink_of(scan).astype(float)), right) > 0.9


@pytest.mark.thorough
def test_a_ball_with_a_highlight_of_the_colour_of_the_page_is_whole():
    ball = (
        '<radialGradient id="r" cx=".35" cy=".35"><stop stop-color="#fff"/><stop offset=".5" '
        'stop-color="#39f"/><stop offset="1" stop-color="#036"/></radialGradient>'
        '<circle cx="50" cy="50" r="44" fill="url(#r)"/>'
    )
    found = scans.fitted(ink_of(recognised(on_page(ball, 160, 85, "0 0 100 100"))).astype(float))
    right = scans.fitted(as_svg(ball).coverage / 255)
    assert scans.iou(found, right) > 0.95


@pytest.mark.parametrize("side", [16, 20, 24])
def test_a_small_drawing_in_one_colour_is_not_judged_by_tones(side):
    body = '<path d="M3 12l9-8 9 8M6 10v10h12V10" fill="none" stroke="#000" stroke-width="2"/>'
    scan = recognised(rgba(body, side))
    assert scan.coloured is None and ndimage.label(ink_of(scan))[1] == 1


@pytest.mark.parametrize("frame", [4, 6])
def test_the_windows_of_a_black_card_without_a_margin_are_neither_sheets_nor_the_drawing(frame):
    inner = 100 - 2 * frame
    body = (
        f'<path d="M0 0h100v100H0z" fill="#fff"/><rect y="15" width="100" height="70" rx="8"/>'
        f'<path d="M{frame} 29h{inner}v10H{frame}zm0 20h{inner}v30H{frame}z" fill="#fff"/>'
        '<path d="M12 65h20v6H12z"/>'
    )
    pixels = rgba(body, 400, "0 0 100 100")[60:340, :, :3]
    ink = scans.fitted(ink_of(recognised(pixels)).astype(float))
    assert scans.iou(ink, scans.fitted(pixels[..., 0] < 128)) > 0.9


@pytest.mark.parametrize("side", [200, 480])
@pytest.mark.parametrize("page", ["#191a1c", "#1e3a2b"])
def test_the_pale_part_of_a_drawing_on_a_dark_page_is_no_sheet(page, side):
    calendar = (
        '<rect x="20" y="24" width="60" height="56" rx="6" fill="#e3f2fd"/>'
        '<path d="M26 24h48a6 6 0 0 1 6 6v10H20V30a6 6 0 0 1 6-6z" fill="#1e88e5"/>'
        '<path d="M38 58l8 8 16-16" fill="none" stroke="#43a047" stroke-width="6"/>'
    )
    pixels = rgba(f'<path d="M0 0h100v100H0z" fill="{page}"/>{calendar}', side, "0 0 100 100")
    scan = recognised(np.ascontiguousarray(pixels[..., :3]))
    right = scans.fitted(rgba(calendar, 256, "0 0 100 100")[..., 3] / 255)
    assert Omission.DESK not in scan.omissions
    outline = ndimage.binary_fill_holes(ink_of(scan))
    assert scans.iou(scans.fitted(outline.astype(float)), right) > 0.9


FADING = {
    "cloud": '<linearGradient id="w" y2="1"><stop stop-color="#fff"/><stop offset="1" '
    'stop-color="#c9c2ea"/></linearGradient><circle cx="32" cy="34" r="24" fill="#fa3"/>'
    '<path d="M28 86a22 22 0 0 1 0-44 28 28 0 0 1 50 6 19 19 0 0 1 0 38z" fill="url(#w)"/>',
    "button": '<linearGradient id="b" y2="1"><stop stop-color="#fff"/><stop offset="1" '
    'stop-color="#48c"/></linearGradient><rect x="8" y="30" width="84" height="40" rx="20" '
    'fill="url(#b)"/>',
    "pale disc": '<circle cx="50" cy="50" r="48" fill="#e0eeff"/>'
    '<path d="M40 20h20v40H40zM30 64h40v8H30z" fill="#23c"/>',
    "pale handle": '<path d="M10 40h50v50H10z" fill="#8c4"/>'
    '<path d="M66 30l24-24v60H66z" fill="#e4e4e4"/>',
}


@pytest.mark.thorough
@pytest.mark.parametrize("name", FADING)
@pytest.mark.parametrize(("side", "quality"), [(128, 0), (300, 80)])
def test_what_is_nearly_as_pale_as_the_page_is_a_part_of_the_drawing(name, side, quality):
    """Even where it fades into it on one side."""
    scan = recognised(on_page(FADING[name], side, quality, "0 0 100 100"))
    right = scans.fitted(as_svg(FADING[name]).coverage / 255)
    assert scan.coloured is not None
    assert scans.iou(scans.fitted(ink_of(scan).astype(float)), right) > 0.9


WHITE = '<path d="M0 0h100v60H0z" fill="#fff"/>'
BARE = {
    "half": WHITE + '<path d="M0 30h100v30H0z" fill="#d13"/>',
    "triangle": WHITE + '<path d="M0 0l50 30h50V0z" fill="#d22"/>'
    '<path d="M0 60l50-30h50v30z" fill="#148"/><circle cx="14" cy="30" r="7" fill="#d22"/>',
    "serrated": WHITE + '<path d="M30 0l12 10-12 10 12 10-12 10 12 10-12 10h70V0z" fill="#924"/>',
}


@pytest.mark.thorough
@pytest.mark.parametrize("name", BARE)
@pytest.mark.parametrize(("side", "quality"), [(120, 0), (320, 75)])
def test_white_all_along_one_side_of_a_flag_is_no_page(name, side, quality):
    right = scans.fitted(flag_as_svg(BARE[name]).coverage / 255)
    found = scans.fitted(ink_of(recognised(on_page(BARE[name], side, quality))).astype(float))
    assert scans.iou(found, right) > 0.88


STRIPES = (
    '<path d="M0 0h100v20H0z"/><path d="M0 20h100v20H0z" fill="#d00"/>'
    '<path d="M0 40h100v20H0z" fill="#fc0"/>'
)


@pytest.mark.parametrize("quality", [0, 80])
def test_lines_of_pixels_that_are_dark_for_want_of_a_ground_are_no_frame(quality):
    pixels = on_page(STRIPES, 300).copy()
    pixels[-1] //= 8
    pixels[:, -1] //= 8
    if quality:
        file = io.BytesIO()
        Image.fromarray(pixels).save(file, "JPEG", quality=quality)
        pixels = np.asarray(Image.open(file))
    ink = scans.fitted(ink_of(recognised(pixels)).astype(float))
    assert ndimage.label(ink)[1] == 3 and ink.sum() > 0.9 * 240 * 144


@pytest.mark.parametrize("upright", [True, False])
def test_three_stripes_in_three_colours_are_three(upright):
    pixels = on_page(STRIPES, 200)
    if upright:
        pixels = pixels[:, :180].swapaxes(0, 1)
    assert ndimage.label(ink_of(recognised(pixels)))[1] == 3


BAR = '<path d="M0 0h100v8H0z" fill="{}"/><path d="M30 34h40v40H30z" fill="{}"/>'
LIGHTS = "".join(
    f'<circle cx="{4 * n + 5}" cy="4" r="1.1" fill="{colour}"/>'
    for n, colour in enumerate(["#ff5f57", "#28c840", "#a0f"])
)


@pytest.mark.thorough
@pytest.mark.parametrize("kind", ["PNG", "JPEG"])
@pytest.mark.parametrize("colours", [("#ddd", "#06f"), ("#455a64", "#fb0"), ("#fff", "#0a7")])
def test_small_dots_in_other_colours_do_not_vanish(colours, kind):
    page = Image.new("RGB", (800, 800), "#f3f3f3")
    picture = Image.fromarray(rgba(BAR.format(*colours) + LIGHTS, 800, "0 0 100 100"))
    page.paste(picture, (0, 0), picture)
    file = io.BytesIO()
    page.save(file, kind, quality=92)
    ink = ink_of(recognised(np.asarray(Image.open(file))))
    sizes = np.concatenate([np.bincount(ndimage.label(one)[0].ravel())[1:] for one in (ink, ~ink)])
    assert (sizes < 200).sum() == 3
