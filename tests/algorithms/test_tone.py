"""Pictograms of coloured drawings against the same drawings in black, as one would draw them."""

import io
import re
from functools import cache

import numpy as np
import pytest
import scipy
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image
from resvg_py import svg_to_bytes
from skimage.transform import resize

from iconstudio.algorithms.tones import tone
from iconstudio.algorithms.tones.alternation import Omission
from iconstudio.algorithms.tones.paints import Paints, near_white, paints
from iconstudio.algorithms.tones.resolution import SIDE
from iconstudio.algorithms.tones.separation import LINE
from iconstudio.algorithms.tracing.vectorize import trace

pytestmark = pytest.mark.thorough(but=1)

N = SIDE
HOUSE = "M3 21V10L12 2l9 8v11zM9 12h6v5H9zM17 2h4v3h-4z"
ROOF_AND_CHIMNEY = "M3 21V10L12 2l9 8v11zM17 2h4v3h-4z"
DOOR = "M9 12h6v5H9z"


def rgba(body: str, n: int = N, box: str = "0 0 24 24") -> np.ndarray:
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}">{body}</svg>'
    png = svg_to_bytes(svg_string=svg, width=n, height=n, skip_system_fonts=True)
    return np.array(Image.open(io.BytesIO(png)).convert("RGBA"))


def pictogram(drawing: np.ndarray) -> np.ndarray:
    return tone.pictogram(drawing).coverage


@cache
def as_svg(body: str, box: str = "0 0 100 100") -> tone.Inked:
    """What a drawing becomes that is read as SVG: made once, and compared with its bitmaps."""
    return tone.pictogram(rgba(body, SIDE, box))


def path(d: str, fill: str = "#000", more: str = "") -> str:
    return f'<path d="{d}" fill="{fill}" fill-rule="evenodd" {more}/>'


def ink(body: str, n: int = N) -> np.ndarray:
    """The alpha of a drawing: all that is painted is ink."""
    return rgba(body, n)[..., 3]


def amiss(coverage: np.ndarray, right: np.ndarray) -> float:
    """The area, relative to the right ink, between the contours of two coverages."""
    return ((coverage > 127) != (right > 127)).sum() / (right > 127).sum()


def assert_alike(coverage: np.ndarray, right: np.ndarray, tolerance: float = 0.015) -> None:
    assert amiss(coverage, right) < tolerance


PLAIN = ink(path(HOUSE))
colours = st.tuples(*[st.integers(0, 255)] * 3).map(lambda c: "#{:02x}{:02x}{:02x}".format(*c))


@settings(max_examples=12)
@given(colours, st.floats(0.1, 1))
def test_one_tone_is_ink_whatever_its_colour_and_opacity(colour, opacity):
    drawing = rgba(f'<g opacity="{opacity}">{path(HOUSE, colour)}</g>')
    coverage = pictogram(drawing)
    assert_alike(coverage, PLAIN)
    assert ((coverage > 127) == (PLAIN > 127)).mean() > 0.9999
    assert paints(drawing, coverage) is Paints.ALL


def test_a_gradient_is_one_tone():
    stops = '<stop stop-color="#ffd54f"/><stop offset="1" stop-color="#bf360c"/>'
    for kind in ("linearGradient", "radialGradient"):
        fill = f'<defs><{kind} id="g">{stops}</{kind}></defs>' + path(HOUSE, "url(#g)")
        drawing = rgba(fill)
        coverage = pictogram(drawing)
        assert_alike(coverage, PLAIN)
        assert paints(drawing, coverage) is Paints.ALL


@pytest.mark.parametrize("colour", ["#000", "#f4b400", "#0f4c81", "#9e9e9e"])
@pytest.mark.parametrize("white", ["#fff", "#fafafa"])
def test_near_white_on_a_colour_is_paper(colour, white):
    drawing = rgba(path(ROOF_AND_CHIMNEY, colour) + path(DOOR, white))
    coverage = pictogram(drawing)
    assert_alike(coverage, PLAIN)
    assert paints(drawing, coverage) is Paints.DARK


def test_separate_pieces_may_have_colours_of_their_own():
    roof, chimney = "M3 21V10L12 2l9 8v11z", "M17 2h4v3h-4z"
    drawing = path(roof, "#f4b400") + path(chimney, "#0f4c81") + path(DOOR, "#fff")
    assert_alike(pictogram(rgba(drawing)), PLAIN)


def test_a_white_band_around_a_drawing_is_paper():
    band = path(HOUSE, "#fff", 'stroke="#fff" stroke-width="3" stroke-linejoin="round"')
    drawing = rgba(band + path(HOUSE, "#1976d2"))
    coverage = pictogram(drawing)
    assert_alike(coverage, PLAIN)
    assert paints(drawing, coverage) is Paints.DARK


def test_white_beside_a_colour_is_ink():
    """As the lettering of a logo for dark backgrounds."""
    letters = path("M17 2h4v3h-4z", "#fff")
    drawing = rgba(path("M3 21V10L12 2l9 8v11zM9 12h6v5H9z", "#1976d2") + letters)
    coverage = pictogram(drawing)
    assert_alike(coverage, PLAIN)
    assert paints(drawing, coverage) is Paints.ALL


@pytest.mark.parametrize("opacity", [0.2, 0.35, 0.49])
def test_the_pale_layer_of_a_duotone_is_paper(opacity):
    pale = path("M1 1h22v22H1z", "#05f", f'opacity="{opacity}"')
    assert_alike(np.where(pictogram(rgba(pale + path(HOUSE, "#05f"))) > 127, 255, 0), PLAIN)


TILES = {
    "square": '<rect width="24" height="24" fill="{}"/>',
    "rounded": '<rect width="24" height="24" rx="4" fill="{}"/>',
    "very rounded": '<rect width="24" height="24" rx="6" fill="{}"/>',
}
GLYPH = "transform='translate(4.8 4.8) scale(.6)'"
SMALL = ink(path(HOUSE, "#000", GLYPH))


@pytest.mark.parametrize("tile", TILES)
@pytest.mark.parametrize(
    ("behind", "drawn", "choice"),
    [
        ("#000", "#fff", Paints.LIGHT),
        ("#1976d2", "#fff", Paints.LIGHT),
        ("#fff", "#c00", Paints.DARK),
        ("#222", "#fc0", None),
        ("#fc0", "#222", None),
    ],
)
def test_the_drawing_on_a_tile_is_the_drawing(tile, behind, drawn, choice):
    drawing = rgba(TILES[tile].format(behind) + path(HOUSE, drawn, GLYPH))
    coverage = pictogram(drawing)
    assert_alike(coverage, SMALL, 0.03)
    assert paints(drawing, coverage) is choice


def test_white_on_a_black_banner_is_the_drawing():
    banner = '<rect y="4" width="24" height="16" fill="#000"/>'
    assert_alike(pictogram(rgba(banner + path(HOUSE, "#fff", GLYPH))), SMALL, 0.03)


def test_a_page_is_paper_however_little_is_on_it():
    drawing = '<path d="M5 5L19 19" stroke="{}" stroke-width=".08"/>'
    page = '<path d="M0 0h24v24H0z" fill="#fff"/>'
    coverage = pictogram(rgba(page + drawing.format("#000")))
    right = ink(drawing.format("#000"))
    assert coverage[right > 200].mean() > 100
    assert coverage[np.abs(np.subtract.outer(np.arange(N), np.arange(N))) > 12].max() < 8


def test_a_white_sign_on_a_coloured_disc_is_a_hole():
    disc = '<circle cx="12" cy="12" r="12" fill="#d32f2f"/>'
    cross = '<path d="M7 7L17 17M17 7L7 17" stroke="#fff" stroke-width="3"/>'
    drawing = rgba(disc + cross)
    coverage = pictogram(drawing)
    right = ink(disc) * (ink(cross) < 128)
    assert_alike(coverage, right)
    assert paints(drawing, coverage) is Paints.DARK


def test_a_die_keeps_its_body():
    dots = "".join(
        f'<circle cx="{x}" cy="{y}" r="2" fill="#fff"/>' for x in (6, 18) for y in (6, 18)
    )
    body = '<rect width="24" height="24" rx="4" fill="#111"/>'
    assert_alike(pictogram(rgba(body + dots)), ink(body) * (ink(dots) < 128))


def test_a_screen_is_a_hole_in_its_frame():
    body = '<rect width="24" height="24" rx="3" fill="#333"/>'
    screen = '<rect x="2" y="2" width="20" height="20" fill="#9cf"/>'
    assert_alike(pictogram(rgba(body + screen)), ink(body) * (ink(screen) < 128))


def test_a_face_keeps_eyes_and_mouth():
    face = '<circle cx="12" cy="12" r="11" fill="#ffc83d"/>'
    features = (
        '<g fill="#6a3b18"><circle cx="8" cy="9" r="2"/><circle cx="16" cy="9" r="2"/>'
        '<path d="M6 14h12a6 6 0 0 1-12 0z"/></g>'
    )
    tongue = '<circle cx="12" cy="17.5" r="1.5" fill="#f8312f"/>'
    right = np.maximum(ink(face) * (ink(features) < 128), ink(tongue))
    assert_alike(pictogram(rgba(face + features + tongue)), right)


def test_neighbours_of_different_colour_are_told_apart_by_a_line():
    drawing = path("M2 4h10v16H2z", "#e53935") + path("M12 4h10v16H12z", "#1e88e5")
    coverage = pictogram(rgba(drawing)).astype(float) / 255
    widths = coverage[N // 4 : 3 * N // 4, N // 4 : 3 * N // 4]
    line = (1 - widths).sum(axis=1) * 256 / N
    assert np.allclose(line, LINE * 256 / SIDE, atol=0.6)
    outline = ink(drawing) > 127
    assert (coverage[~outline] < 0.5).all()


def test_shades_of_one_colour_are_not_told_apart():
    drawing = rgba(path("M2 4h10v16H2z", "#e53935") + path("M12 4h10v16H12z", "#d32f2f"))
    assert paints(drawing, pictogram(drawing)) is Paints.ALL


@pytest.mark.parametrize("line", ["#000", "#2859c5", "#5d4037"])
def test_a_line_drawing_is_its_lines(line):
    shape = '<path d="M12 3l9 8v10H3V11zM3 11h18" fill="{}" stroke="{}" stroke-width="1.5"/>'
    drawn = pictogram(rgba(shape.format("#ffe082", line)))
    assert_alike(drawn, ink(shape.format("none", line)), 0.02)


def test_what_stands_out_in_the_fill_of_a_line_drawing_is_ink():
    page = '<rect x="3" y="2" width="18" height="20" fill="{}" stroke="#000" stroke-width="2"/>'
    letter = '<path d="M8 8h8M12 8v9" stroke="#fff" stroke-width="2"/>'
    assert_alike(
        pictogram(rgba(page.format("#2f88ff") + letter)), ink(page.format("none") + letter), 0.02
    )


FACE = (
    '<circle cx="12" cy="12" r="10" fill="#ffc83d"/>'
    + path("M2 12a10 10 0 0 1 20 0z", "#9b5d2e")
    + '<g fill="#212121"><circle cx="9" cy="15" r="1.5"/><circle cx="15" cy="15" r="1.5"/></g>'
)
SIGN = TILES["rounded"].format("#000") + path(HOUSE, "#fff", GLYPH)


@pytest.mark.parametrize(("drawing", "n"), [(FACE, 700), (FACE, 2 * N), (SIGN, 2 * N)])
def test_the_size_of_the_raster_changes_little(drawing, n):
    """Files are read on twice as many pixels as most tests look at."""
    usual = pictogram(rgba(drawing)) / 255
    other = resize(pictogram(rgba(drawing, n)) / 255, (N, N), anti_aliasing=True)
    assert amiss(255 * other, 255 * usual) < 0.02


@pytest.mark.parametrize("drawing", [FACE, path(HOUSE), SIGN])
def test_a_margin_changes_little(drawing):
    usual = pictogram(rgba(drawing)) / 255
    wide = pictogram(rgba(drawing, box="-2 -2 28 28")) / 255
    cut = round(2 / 28 * N)
    inner = resize(wide[cut:-cut, cut:-cut], (N, N), order=1)
    assert amiss(255 * inner, 255 * usual) < 0.04


def test_colours_of_transparent_pixels_do_not_matter():
    drawing = rgba(FACE)
    other = drawing.copy()
    other[other[..., 3] == 0, :3] = 0, 255, 0
    assert np.array_equal(pictogram(drawing), pictogram(other))


def test_outlines_are_smooth():
    """Of a disc that is half one colour, half another, four or so curves and two lines remain."""
    halves = path("M12 2a10 10 0 0 1 0 20z", "#e53935") + path("M12 2a10 10 0 0 0 0 20z", "#1e88e5")
    curves = re.findall("[CLHV]", trace(pictogram(rgba(halves))).svg())
    assert len(curves) <= 16


def test_nothing_gives_no_ink():
    nothing = np.zeros((SIDE, SIDE, 4), np.uint8)
    assert pictogram(nothing).max() == 0
    assert paints(nothing, pictogram(nothing)) is Paints.ALL


@pytest.mark.timeout(60)
def test_noise_does_not_take_long():
    noise = np.random.default_rng(0).integers(0, 256, (SIDE, SIDE, 4)).astype(np.uint8)
    coverage = pictogram(noise)
    assert coverage.shape == (SIDE, SIDE)


def test_near_white():
    shades = np.array(
        [[255, 255, 255], [240, 240, 240], [200, 200, 200], [255, 255, 180]], np.uint8
    )
    assert near_white(shades).tolist() == [True, True, False, False]


def test_what_is_left_out_with_a_tile_is_told():
    tile = TILES["rounded"].format("#1976d2")
    assert tone.pictogram(rgba(tile + path(HOUSE, "#fff", GLYPH))).omissions == {Omission.TILE}
    page = '<path d="M0 0h24v24H0z" fill="#fff"/>' + path(HOUSE, "#c00", GLYPH)
    assert tone.pictogram(rgba(page)).omissions == {Omission.PAGE}
    for drawing in (FACE, path(HOUSE)):
        assert not tone.pictogram(rgba(drawing)).omissions


@pytest.mark.parametrize("sign", ["M31 24l-11-8v16z", "M18 18h12v12H18z", "M24 17a7 7 0 0 1 0 14z"])
def test_a_bare_sign_keeps_its_button(sign):
    button = '<rect x="6" y="6" width="36" height="36" rx="4" fill="#f44336"/>'
    drawing = rgba(button + path(sign, "#fff"), box="0 0 48 48")
    right = rgba(button, box="0 0 48 48")[..., 3] * (
        rgba(path(sign), box="0 0 48 48")[..., 3] < 128
    )
    coverage, omissions = tone.pictogram(drawing)
    assert_alike(coverage, right)
    assert not omissions


def test_gloss_on_a_tile_goes_with_it():
    tile = TILES["rounded"].format("#f44336")
    gloss = path("M2 7c0-4 1-5 5-5-2 2-4 2-5 5z", "#ff8a80")
    for shade in (gloss, path("M3 21h18v1H3z", "#a51f1f")):
        coverage = pictogram(rgba(tile + shade + path(HOUSE, "#fff", GLYPH)))
        assert_alike(coverage, SMALL, 0.03)


def test_the_shades_of_one_shape_on_a_tile_are_told_apart():
    cube = path("M12 4l7 4v8l-7 4-7-4V8z", "#469ea2")
    sides = path(
        "M12 5l5.5 3.2-5.5 3.2-5.5-3.2zM6 9l5.5 3.2v6.3L6 15.4zM18 9l-5.5 3.2v6.3l5.5-3.1z",
        "#6acad1",
    )
    coverage = pictogram(rgba(TILES["very rounded"].format("#242938") + cube + sides))
    assert_alike(coverage, ink(cube) * (ink(sides) < 128), 0.05)


def test_rims_are_shades_of_a_disc():
    disc = '<circle cx="12" cy="12" r="{}" fill="{}"/>'
    rims = disc.format(11, "#8fb98a") + disc.format(10.4, "#459121") + disc.format(9.8, "#79c843")
    arrow = path("M11 6h2v6h4l-5 6-5-6h4z", "#fff")
    right = ink(disc.format(11, "#000")) * (ink(arrow) < 128)
    assert_alike(pictogram(rgba(rims + arrow)), right, 0.03)


BODIES = {
    "picture": '<circle cx="16" cy="8" r="2"/><path d="M5 14l4-3 5 6h5v2h-6l-4-5-4 3z"/>',
    "speech": '<path d="M6 8h12v2H6zM6 13h9v2H6z"/>',
}


@pytest.mark.parametrize("tones", [("#000", "#7f7f7f"), ("#000", "#bfbfbf"), ("#04a", "#80a4d4")])
@pytest.mark.parametrize("kind", BODIES)
def test_a_paler_shade_behind_darker_ones_is_the_body_of_a_thing(kind, tones):
    dark, pale = tones
    body = f'<rect x="1" y="1" width="22" height="22" rx="5" fill="{pale}"/>'
    coverage, omissions = tone.pictogram(rgba(body + f'<g fill="{dark}">{BODIES[kind]}</g>'))
    right = np.where(ink(BODIES[kind]) > 127, 0, ink(body))
    assert_alike(coverage, right)
    assert not omissions


@pytest.mark.parametrize("tones", [("#04a", "#dbeafe"), ("#fff", "#04a"), ("#04a", "#fc3")])
def test_a_tile_of_another_colour_or_a_very_pale_one_is_left_out(tones):
    drawn, behind = tones
    body = f'<rect x="1" y="1" width="22" height="22" rx="5" fill="{behind}"/>'
    glyph = BODIES["picture"]
    coverage, omissions = tone.pictogram(rgba(body + f'<g fill="{drawn}">{glyph}</g>'))
    assert_alike(coverage, ink(glyph), 0.02)
    assert omissions == {Omission.TILE}


def test_a_body_that_shows_through_the_holes_of_what_is_on_it_stays_one():
    body = '<rect x="1" y="1" width="22" height="22" rx="5" fill="#7f7f7f"/>'
    letter = path("M7 6h7a3 3 0 0 1 2 5a3.5 3.5 0 0 1-2 7H7zM10 8.5h3v2h-3zM10 13h3.5v2.5H10z")
    coverage, omissions = tone.pictogram(rgba(body + letter))
    assert_alike(coverage, np.where(ink(letter) > 127, 0, ink(body)))
    assert not omissions


def test_the_midst_of_a_mosaic_is_as_the_rest_of_it():
    colours = ["#e53935", "#1e88e5", "#43a047", "#fdd835"]
    squares = "".join(
        f'<rect x="{6 * x}" y="{6 * y}" width="6" height="6" fill="{colours[(x + 3 * y) % 4]}"/>'
        for x in range(4)
        for y in range(4)
    )
    pieces, _ = scipy.ndimage.label(pictogram(rgba(squares)) > 127)
    sizes = np.bincount(pieces.ravel())[1:]
    assert (sizes > 10000).sum() == 16 and sizes[sizes <= 10000].sum() < 100
