"""Filters, blending and opacity: the picture is right, or it is said that it is not."""

import numpy as np
import pytest

from iconstudio.model import Frame
from iconstudio.svg.parse import parse
from iconstudio.svg.plain import document, plain
from iconstudio.svg.rasterise import rasterise
from iconstudio.svg.resvg import render_colours
from iconstudio.svg.styles import ONLY_IN_STYLE
from tests.svg.pictures import assert_shows, overlap, read, svg

pytestmark = pytest.mark.thorough(but=1)

DISC = '<circle cx="12" cy="12" r="10"/>'
SQUARE = "M7 7h10v10H7z"
HOLE = f'{DISC}<path fill="#fff" d="{SQUARE}"/>'
LEFT, RIGHT = '<circle cx="9" cy="12" r="7"/>', '<circle cx="15" cy="12" r="7"{}/>'
PAGE = '<path fill="#fff" d="M0 0h24v24H0z"/>'
INVERTED = {
    "attribute": 'filter="invert(1)"',
    "per cent": 'style="filter: invert(100%)"',
    "no number": 'style="filter: invert()"',
    "capitals": 'style="filter: INVERT(1)"',
    "older name": 'style="-webkit-filter: invert(1)"',
    "class": 'class="i"',
    "variable": 'style="filter: var(--f)"',
    "list": 'style="filter: grayscale(1) invert(1)"',
    "list with a reference": 'style="filter: url(#f) invert(1)"',
    "list with a reference to nothing": 'style="filter: url(#g) invert(1)"',
    "brightness": 'fill="#777" style="filter: brightness(5)"',
}
STYLE = "<style>:root { --f: invert(1) } .i { filter: invert(1) }</style>"
STILL = '<filter id="f"><feOffset dx="0"/></filter>'


@pytest.mark.parametrize("kind", INVERTED)
def test_filters_of_css_are_drawn(kind):
    assert_shows(svg(f'{STYLE}{STILL}{DISC}<path {INVERTED[kind]} d="{SQUARE}"/>'), HOLE)


@pytest.mark.parametrize("value", ["frobnicate(2)", "invert(lots)", "invert(-1)", "url(#f) foo(1)"])
def test_a_filter_that_is_not_understood_is_told(value):
    document = svg(f'{STILL}{DISC}<path fill="#fff" style="filter: {value}" d="{SQUARE}"/>')
    assert_shows(document, HOLE, remarks=[value])


def test_a_distortion_is_left_out_and_told():
    distort = (
        '<filter id="d"><feTurbulence baseFrequency=".1" result="t"/>'
        '<feDisplacementMap in="SourceGraphic" in2="t" scale="8"/></filter>'
    )
    assert_shows(svg(f'{distort}<g filter="url(#d)">{HOLE}</g>'), HOLE, remarks=["distorts"])


def test_noise_of_many_octaves_is_that_of_those_that_are_seen():
    def noise(octaves):
        turbulence = f'<feTurbulence baseFrequency=".1" numOctaves="{octaves}"/>'
        return svg(f'<filter id="f">{turbulence}</filter><g filter="url(#f)">{PAGE}</g>')

    def drawn(document):
        return render_colours(document, Frame(0, 0, 24), 64).astype(int)

    plainly = plain(parse(noise(2_000_000))[0])  # each of which would take as long
    bounded = drawn(document(plainly.content, (0, 0, 24, 24)))
    assert bounded.std() > 10
    assert np.abs(bounded - drawn(noise(40))).mean() < 1


XOR = (
    '<path fill-rule="evenodd" d="M2 12a7 7 0 1 0 14 0a7 7 0 1 0-14 0z'
    'M8 12a7 7 0 1 0 14 0a7 7 0 1 0-14 0z"/>'
)
CRESCENT = LEFT + RIGHT.format(' fill="#fff"')
BLENDED = {
    "difference on white": (PAGE + LEFT + RIGHT.format(' fill="#fff" style="{}:difference"'), XOR),
    "exclusion on white": (PAGE + LEFT + RIGHT.format(' fill="#fff" style="{}:exclusion"'), XOR),
    "difference": (LEFT + RIGHT.format(' fill="#fff" style="{}:difference"'), CRESCENT),
    "screen": (LEFT + RIGHT.format(' fill="#fff" style="{}:screen"'), CRESCENT),
    "multiply": (PAGE + LEFT + RIGHT.format(' fill="#fff" style="{}:multiply"'), LEFT),
}


@pytest.mark.parametrize("kind", BLENDED)
def test_blending_is_drawn(kind):
    drawing, right = BLENDED[kind]
    document = svg(drawing.replace("{}", "mix-blend-mode"))
    assert_shows(document, right, 0.97)
    assert not any(name in read(document).svg for name in ONLY_IN_STYLE)


def test_blending_that_is_not_drawn_is_told():
    for mode in ("plus-lighter", "foo"):
        document = svg(LEFT + RIGHT.format(f' fill="#fff" style="mix-blend-mode:{mode}"'))
        assert_shows(document, CRESCENT, remarks=[mode])


BAR = '<path d="M2 15h20v7H2z"/>'
DOT = '<circle cx="12" cy="7" r="5"/>'
PALE = {
    "group": f'{BAR}<g opacity="OPACITY">{DOT}</g>',
    "fill": f'{BAR}<g fill-opacity="OPACITY">{DOT}</g>',
    "colour": f'{BAR}<g fill="rgb(0 0 0 / OPACITY)">{DOT}</g>',
    "most of it": f'<g opacity="OPACITY">{BAR}</g>{DOT}',
}


@pytest.mark.parametrize(
    ("kind", "opacity"),
    [("group", 0.25), ("group", 0.8), ("fill", 0.65), ("colour", 0.95), ("most of it", 0.5)],
)
def test_what_is_half_opaque_beside_black_is_ink(kind, opacity):
    drawn = read(svg(PALE[kind].replace("OPACITY", str(opacity))))
    _, coverage = rasterise(drawn.svg)
    _, right = rasterise(svg(BAR + DOT))
    assert overlap(coverage > 127, right > 127) > 0.985
    assert ((coverage > 16) & (coverage < 240)).mean() < 0.03  # but for edges, nothing is grey
    assert not drawn.remarks


def test_a_pale_stroke_leaves_the_shape_beside_it_filled():
    ring = '<circle cx="12" cy="7" r="4" fill="none" stroke="#000" stroke-width="2"{}/>'
    bar = '<path d="M2 14.4h20v6.3H2z"/>'
    assert_shows(svg(bar + ring.format(' stroke-opacity=".6"')), bar + ring.format(""))


@pytest.mark.thorough
def test_a_small_pale_dot_is_ink():
    dot = '<circle cx="21" cy="3" r="1.2"{}/>'
    body = '<path d="M2 8h16v14H2z"/>'
    for opacity in (0.6, 0.8):
        assert_shows(svg(body + dot.format(f' opacity="{opacity}"')), body + dot.format(""))


def test_the_faint_layer_of_a_duotone_is_left_out_and_told():
    document = svg(f'{BAR}<g opacity=".15">{DOT}</g>')
    assert_shows(document, BAR, remarks=["hardly opaque"])


def test_drops_that_run_into_each_other_are_no_shadow():
    sharpened = (
        '<filter id="g"><feGaussianBlur in="SourceGraphic" stdDeviation="1.500" result="a"/>'
        '<feColorMatrix in="a" values="1 0 0 0 0 0 1 0 0 0 0 0 1 0 0 0 0 0 18 -7" result="b"/>'
        '<feBlend in="SourceGraphic" in2="b"/></filter>'
    )
    drops = '<circle cx="7.200" cy="12" r="4.500"/><circle cx="16.800" cy="12" r="4.500"/>'
    own = read(svg(f'{sharpened}<g filter="url(#g)">{drops}</g>'))
    assert not own.remarks
    assert rasterise(own.svg)[1][128, 128] > 127


RED = '<circle cx="12" cy="12" r="10" fill="#c33"{}/>'
LIGHT = '<feDistantLight azimuth="235" elevation="40"/>'
LIT = {
    "bevel": '<feGaussianBlur in="SourceAlpha" stdDeviation=".5" result="b"/>'
    f'<feSpecularLighting in="b" surfaceScale="5" result="s">{LIGHT}</feSpecularLighting>'
    '<feComposite in="s" in2="SourceAlpha" operator="in" result="t"/>'
    '<feComposite in="SourceGraphic" in2="t" operator="arithmetic" k2="1" k3="1"/>',
    "diffuse": f'<feDiffuseLighting surfaceScale="3">{LIGHT}</feDiffuseLighting>'
    '<feComposite in2="SourceAlpha" operator="in"/>',
    "multiplied": f'<feDiffuseLighting in="SourceAlpha" result="l">{LIGHT}</feDiffuseLighting>'
    '<feComposite in="SourceGraphic" in2="l" operator="arithmetic" k1="1"/>',
}


@pytest.mark.parametrize("kind", LIT)
def test_light_is_left_out_and_told(kind):
    filters = f'<filter id="f">{LIT[kind]}</filter>'
    for attribute in ('filter="url(#f)"', 'style="filter:url(#f) brightness(.9)"'):
        document = svg(f"{filters}{RED.format(' ' + attribute)}")
        assert_shows(document, RED.format(""), remarks=["Light on a surface"])


def test_light_and_shadow_are_both_told():
    filters = f'<filter id="f">{LIT["bevel"]}</filter>'
    style = ' style="filter:url(#f) drop-shadow(1px 1px 1px #000)"'
    document = svg(filters + RED.format(style))
    assert_shows(document, RED.format(""), remarks=["shadow", "Light on a surface"])


@pytest.mark.parametrize(
    ("href", "said"),
    [
        ("#x", "A part of the drawing that a filter repeats"),
        ("data:image/png;base64,AA==", "A bitmap in a filter"),
        ("a.png", "A bitmap in another file"),
    ],
)
def test_an_image_in_a_filter_is_told_as_what_it_is(href, said):
    repeated = f'<filter id="f"><feImage href="{href}"/></filter>'
    body = f'{repeated}{DISC}<path filter="url(#f)" d="M0 0h1v1H0z"/>'
    assert_shows(svg(body.replace("<circle", '<circle id="x"')), DISC, remarks=[said])


STOPS = '<stop offset="0" stop-color="{}" stop-opacity="{}"/><stop offset="1" stop-opacity="{}"/>'
FADE = '<linearGradient id="g">' + STOPS + "</linearGradient>"
BEHIND = '<path fill="url(#g)" d="M2 12L12 3L24 15V24H11z"/>'


def test_a_shape_that_fades_from_a_dark_colour_is_a_shadow():
    document = svg(FADE.format("#000", 0.27, 0) + BEHIND + RED.format(""))
    assert_shows(document, RED.format(""), remarks=["A shadow was left out"])


@pytest.mark.parametrize("said", [("#000", 0.6, 0), ("#000", 0.3, 0.2), ("#f80", 0.2, 0)])
def test_what_is_opaque_or_coloured_or_does_not_fade_is_no_shadow(said):
    assert (
        "A shadow was left out."
        not in read(svg(FADE.format(*said) + BEHIND + RED.format(""))).remarks
    )


def test_a_shadow_alone_is_the_drawing():
    assert "A shadow was left out." not in read(svg(FADE.format("#000", 0.2, 0) + BEHIND)).remarks
