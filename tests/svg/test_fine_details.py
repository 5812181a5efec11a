"""Letters on boxes, and shadows, from the file to the picture."""

import numpy as np
import pytest
import scipy

from iconstudio.algorithms.tones.alternation import Omission
from iconstudio.svg.monochrome import SOME_THIN
from iconstudio.svg.omitted import OMITTED
from iconstudio.svg.rasterise import rasterise
from iconstudio.svg.reading import own_svg
from iconstudio.svg.shadows import LEFT_OUT

pytestmark = pytest.mark.thorough(but=1)

SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">{}</svg>'
BOX = '<rect x="5" y="30" width="90" height="40" fill="{}" stroke="#000"/>'
TEXT = '<text x="50" y="53" font-size="{}" text-anchor="middle">Signal</text>'


def read(body: str):
    return own_svg(SVG.format(body).encode(), "a.svg")


def drawn(body: str) -> np.ndarray:
    return rasterise(read(body).svg)[1].astype(int)


@pytest.mark.parametrize("size", [12, 5])
@pytest.mark.parametrize("paper", ["#fff", "#fde"])
def test_a_box_keeps_its_label(size, paper):
    label = TEXT.format(size)
    assert abs(drawn(BOX.format(paper) + label) - drawn(BOX.format("none") + label)).max() < 64


@pytest.mark.parametrize("paper", ["#ff9800", "#e53935", "#7986cb"])
def test_a_box_of_a_darker_colour_keeps_its_black_label(paper):
    label = TEXT.format(12)
    assert abs(drawn(BOX.format(paper) + label) - drawn(BOX.format("none") + label)).max() < 64


SHAPE = '<path d="M20 20h50v50h-50z" fill="#e33" {}/>'
SHADOWS = {
    "primitive": '<feDropShadow dx="4" dy="4" stdDeviation="2"/>',
    "merged": '<feGaussianBlur in="SourceAlpha" stdDeviation="2"/><feOffset dx="4" result="o"/>'
    '<feMerge><feMergeNode in="o"/><feMergeNode in="SourceGraphic"/></feMerge>',
    "blended": '<feOffset in="SourceAlpha" dy="4"/><feGaussianBlur stdDeviation="2"/>'
    '<feBlend in2="x" result="s"/><feBlend in="SourceGraphic" in2="s"/>',
}


@pytest.mark.parametrize("kind", SHADOWS)
def test_a_shadow_is_left_out_and_told(kind):
    described = f'<filter id="f">{SHADOWS[kind]}</filter>'
    shadowed = read(described + SHAPE.format('filter="url(#f)"'))
    assert LEFT_OUT in shadowed.remarks
    assert shadowed.svg == read(SHAPE.format("")).svg


def test_a_shadow_in_css_is_left_out_and_told():
    shadowed = read(SHAPE.format('style="filter: drop-shadow(0 2px 3px rgba(0, 0, 0, .5))"'))
    assert LEFT_OUT in shadowed.remarks
    assert shadowed.svg == read(SHAPE.format("")).svg


@pytest.mark.thorough
def test_a_filter_that_is_no_shadow_is_drawn():
    dilated = '<filter id="f"><feMorphology operator="dilate" radius="9"/></filter>'
    line = '<path d="M20 20h50v50h-50z" fill="none" stroke="#000" stroke-width="4" {}/>'
    thick = read(dilated + line.format('filter="url(#f)"'))
    assert LEFT_OUT not in thick.remarks
    assert (rasterise(thick.svg)[1] > 127).sum() > 2 * (drawn(line.format("")) > 127).sum()


def test_a_faint_part_is_no_grey():
    faint = '<rect x="50" y="45" width="45" height="10" opacity=".15"/>'
    icon = read('<circle cx="40" cy="50" r="35" fill="#3f51b5"/>' + faint)
    assert set(OMITTED.values()) & set(icon.remarks)
    grey = rasterise(icon.svg)[1]
    assert ((grey > 20) & (grey < 120)).mean() < 0.02
    assert "opacity" not in icon.svg


BLUR = '<filter id="f" x="-50%" y="-50%" width="200%" height="200%">'
BLUR += '<feGaussianBlur stdDeviation="{}"/></filter><g filter="url(#f)">{}</g>'
BLURRED = {
    "disc": '<circle cx="50" cy="50" r="33"/>',
    "coloured": '<circle cx="50" cy="50" r="33" fill="#e53"/>',
    "square": '<path d="M20 20h60v60H20z" fill="#246"/>',
    "pale": '<circle cx="50" cy="50" r="33" opacity=".5"/>',
}


@pytest.mark.parametrize(
    ("kind", "deviation"), [("disc", 1), ("coloured", 4), ("square", 2.5), ("pale", 4)]
)
def test_a_blurred_shape_is_that_shape(kind, deviation):
    blurred = read(BLUR.format(deviation, BLURRED[kind]))
    assert not blurred.remarks
    ink, right = (one > 127 for one in (rasterise(blurred.svg)[1], drawn(BLURRED[kind])))
    assert (ink != right).sum() < (0.03 if kind != "square" else 0.06) * right.sum()
    assert scipy.ndimage.label(ink)[1] == 1


def test_a_gradient_that_fades_has_an_edge_and_is_not_told():
    stops = '<stop stop-color="#e53"/><stop offset="1" stop-color="#e53" stop-opacity="0"/>'
    for kind in ("radialGradient", "linearGradient"):
        shape = '<circle cx="50" cy="50" r="45" fill="url(#g)"/>'
        icon = read(f'<{kind} id="g">{stops}</{kind}>{shape}')
        assert not icon.remarks
        grey = rasterise(icon.svg)[1]
        assert ((grey > 20) & (grey < 230)).mean() < 0.02


def test_a_layer_of_a_fifth_is_a_part_of_the_drawing():
    layer = '<path d="M20 50h60v40H20z" {}/>'
    body = '<path d="M35 10h30v30H35z"/>'
    icon = read(layer.format('opacity=".2"') + body)
    assert not icon.remarks
    assert abs(rasterise(icon.svg)[1].astype(int) - drawn(layer.format("") + body)).max() < 64


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["opacity", "fill-opacity"])
def test_a_fainter_layer_within_lines_that_is_no_ink_is_told(name):
    layer = f'<path {name}=".35" d="M16 16h64v48H16z"/>'
    screen = '<path fill="none" stroke="#000" stroke-width="6" d="M16 16h64v48H16zM36 80h24"/>'
    assert read(layer + screen).remarks == (OMITTED[Omission.DECORATION],)
    assert not read(screen).remarks
    assert not read(layer + '<path d="M36 64h24v16H36z"/>').remarks


TILE = '<rect x="4" y="4" width="92" height="92" rx="22" fill="#dd2476"/>'
LONG = '<path d="M72 30L96 54V74Q96 96 74 96H54L30 72z" fill-opacity=".2"/>'
NOTES = (
    '<path d="M35 28v44h8V44l21-5v21h8V28z" fill="#fff"/>'
    '<circle cx="36" cy="70" r="9" fill="#fff"/><circle cx="65" cy="62" r="9" fill="#fff"/>'
)
GLOW = (
    '<radialGradient id="g"><stop offset=".3" stop-color="#ffe14d"/>'
    '<stop offset="1" stop-color="#ffe14d" stop-opacity="0"/></radialGradient>'
    '<circle cx="50" cy="45" r="42" fill="url(#g)"/>'
)
BULB = (
    '<path d="M35 50a15 15 0 1 1 30 0q-2 8-7 12v8H42v-8q-5-4-7-12z" fill="#ffb703"/>'
    '<rect x="42" y="72" width="16" height="12" rx="3" fill="#495057"/>'
)


@pytest.mark.thorough
def test_of_one_shadow_or_glow_one_sentence_is_told():
    assert read(TILE + LONG + NOTES).remarks == (OMITTED[Omission.TILE], OMITTED[Omission.FAINT])
    assert read(GLOW + BULB).remarks == (OMITTED[Omission.GLOW],)
    pale = '<path d="M2 88h96v8H2z" opacity=".1"/>'
    assert read(GLOW + BULB + pale).remarks == (OMITTED[Omission.FAINT], OMITTED[Omission.GLOW])


BLOCK = '<path d="M20 60h60v30H20z"/>'
RULES = {
    "a rectangle": '<rect x="10" y="20" width="80" height="{}"/>',
    "an outlined stroke": '<path d="M10 20h80v{}h-80z"/>',
    "one that is not closed": '<path d="M10 20h80v{}h-80"/>',
    "a turned one": '<path d="M10 20h80v{}h-80z" transform="rotate(10 50 20)"/>',
    "a smaller one, enlarged": '<g transform="scale(2)"><path d="M5 10h40v{}h-40z"/></g>',
}


@pytest.mark.parametrize("kind", RULES)
def test_a_filled_shape_as_thin_as_a_hairline_is_drawn_thicker_as_a_stroke_is(kind):
    icon = read(BLOCK + RULES[kind].format(0.1))
    assert icon.remarks == (SOME_THIN,)
    ink = rasterise(icon.svg)[1] > 127
    assert scipy.ndimage.label(ink)[1] == 2 and ink[:120].any(axis=0).sum() > 200


def test_the_light_along_an_edge_is_no_line():
    light = '<path d="M20 60h60v.3h-60z" fill="#fff"/>'
    for faint in (light.replace("/>", ' opacity=".2"/>'), f'<g opacity=".2">{light}</g>'):
        assert SOME_THIN not in read(BLOCK + faint).remarks
    assert SOME_THIN in read(BLOCK + light.replace("M20", "M9").replace("h60", "h80")).remarks


@pytest.mark.parametrize(
    "shape",
    [
        '<path d="M40 70h2v.01z"/>',
        '<circle cx="50" cy="20" r=".3"/>',
        '<path d="M9 20h80"/>',
        RULES["a rectangle"],
    ],
)
def test_a_dot_and_nothing_and_a_line_that_shows_stay_as_they_are(shape):
    assert not read(shape.format(2) + BLOCK).remarks


@pytest.mark.thorough
def test_a_line_is_not_cut_by_the_scrap_of_another_that_peeks_out_behind():
    """As that around an area by the grid of a radar chart."""
    grid = '<path d="{}" fill="none" stroke="#cbd5e1"/>'
    outer = grid.format("M50 10 85 35 72 80H28L15 35z")
    inner = grid.format("M50 30 68 42 61 66H39L32 42z")
    area = (
        '<path d="M50 15 80 40 60 65 30 78 25 40z" fill="#3b82f6" fill-opacity=".4" '
        'stroke="#2563eb" stroke-width="2"/>'
    )
    bare, with_scrap = (
        rasterise(read(outer + behind + area).svg)[1] > 127 for behind in ("", inner)
    )
    assert with_scrap[scipy.ndimage.binary_erosion(bare)].all()
