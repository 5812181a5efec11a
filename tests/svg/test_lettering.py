"""Text: no letter is cut off, and it is as bold, as large and as spelt as styles say."""

import xml.etree.ElementTree as ET

import numpy as np
import pytest

from iconstudio.model import Frame
from iconstudio.resources import resource
from iconstudio.svg.bounds import bounds
from iconstudio.svg.fonts import font
from iconstudio.svg.lettering import set_type
from iconstudio.svg.parse import parse
from iconstudio.svg.resvg import render_colours
from iconstudio.svg.styles import apply_styles
from tests.svg.pictures import assert_shows, ink, overlap, svg

pytestmark = pytest.mark.thorough(but=1)

FONTS = [str(resource(f"fonts/Inter-{one}.otf")) for one in ("Regular", "SemiBold")]
REACH, SIZE = 512, 512
PAGE = f'viewBox="{-REACH} {-REACH} {2 * REACH} {2 * REACH}"'
TELLS_FONT = ("drawn in Inter",)
TEXTS = [
    '<text font-size="24">MMMMMM</text>',
    '<text font-size="24" font-weight="900">MMMMMMMMMM</text>',
    '<g font-size="24" text-anchor="middle"><text x="9">MMMMMM</text></g>',
    '<text font-size="24" text-anchor="end">MMMMMM</text>',
    '<text font-size="24" direction="rtl">MMMMMM</text>',
    '<text style="font:bold 200%/1 serif">ÅÂŷgj</text>',
    '<g font-size="2em"><text font-size="1.5em">MMMM</text></g>',
    '<text font-size="x-large">MMMMMMMM</text>',
    '<text>MMMMMMMM</text>',
    '<text font-size="24" letter-spacing="12">MMMM</text>',
    '<text font-size="24" letter-spacing="0.5em" word-spacing="40">M M M</text>',
    '<text font-size="24" dx="0 20 -60" dy="-30 70">MMM</text>',
    '<text font-size="24" x="10 200 -100" y="0 30">MMMMM</text>',
    '<text font-size="24" x="10%" y="-20%">MM</text>',
    '<text font-size="24">M<tspan font-size="60">M</tspan><tspan dy="50">MMM</tspan>MMM</text>',
    '<text font-size="24"><tspan x="0">MMMM</tspan><tspan x="0" dy="1.2em">MMMMM</tspan></text>',
    '<text font-size="24">MMM<tspan y="70">MMM</tspan></text>',
    '<text font-size="24" textLength="240">MMM</text>',
    '<text font-size="24">M<tspan textLength="200" lengthAdjust="spacingAndGlyphs">M</tspan>'
    "</text>",
    '<text font-size="24" xml:space="preserve">M          M</text>',
    '<text font-size="24" writing-mode="tb">MMMMMM</text>',
    '<text font-size="24" style="writing-mode:vertical-rl" text-anchor="middle">ggMMÅ</text>',
    '<text font-size="24" rotate="90">MMMgg</text>',
    '<text font-size="24" dominant-baseline="hanging">MMM</text>',
    '<text font-size="24" dominant-baseline="middle">MMM</text>',
    '<text font-size="24">M<tspan baseline-shift="super">M<tspan baseline-shift="40">g'
    "</tspan></tspan></text>",
    '<text font-size="24" transform="rotate(50) scale(1.5)">MMMMMM</text>',
    '<text font-size="24" stroke="#000" stroke-width="8">MMMM</text>',
    '<text font-size="24" style="text-transform:uppercase">mmmmmm</text>',
    '<path id="p" d="M-90 0A90 90 0 0 1 90 0"/><text font-size="24"><textPath href="#p">'
    "MMMMMMM</textPath></text>",
    '<path id="p" d="M-90 0h200"/><text font-size="24"><textPath href="#p" startOffset="9">'
    'MMMMMM<tspan dy="-40">g</tspan></textPath></text>',
]  # fmt: skip


def inked(content: ET.Element) -> np.ndarray:
    """Return left, top, right and bottom of what is drawn, to a pixel."""
    frame = Frame(-REACH, -REACH, 2 * REACH)
    document = svg(ET.tostring(content, encoding="unicode"), PAGE)
    alpha = render_colours(document, frame, SIZE, FONTS)[:, :, 3]
    rows, columns = (np.flatnonzero((alpha > 9).any(axis=axis)) for axis in (1, 0))
    unit = 2 * REACH / SIZE
    places = [columns[0], rows[0], columns[-1] + 1, rows[-1] + 1]
    return np.array(places) * unit - REACH


@pytest.mark.parametrize("text", TEXTS)
def test_bounds_hold_all_letters(text: str) -> None:
    """And are no wider than thrice the letters, with some room."""
    root, _ = parse(svg(f"<g>{text}</g>", PAGE))
    apply_styles(root)
    set_type(root)
    (content,) = root
    ids = {one.get("id", ""): one for one in root.iter()}
    for path in content.iter("path"):
        path.set("fill", "none")
    found = bounds(content, (-REACH, -REACH, 2 * REACH, 2 * REACH), ids)
    assert found is not None
    left, top, right, bottom = inked(content)
    unit = 2 * REACH / SIZE
    assert found[0] <= left + unit and found[1] <= top + unit
    assert found[0] + found[2] >= right - unit and found[1] + found[3] >= bottom - unit
    room = 100
    assert found[2] <= 3 * (right - left) + room and found[3] <= 3 * (bottom - top) + room


LETTER = '<text x="{}" y="30" font-size="24">M</text>'


def test_a_long_text_keeps_all_its_letters() -> None:
    """It shows what its letters show one by one."""
    together = svg('<text x="2" y="30" font-size="24">MMMMMM</text>', 'viewBox="0 0 200 40"')
    one_by_one = svg(
        "".join(LETTER.format(2 + 21.4 * place) for place in range(6)), 'viewBox="0 0 200 40"'
    )
    assert overlap(ink(together), ink(one_by_one)) > 0.8


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ('style="font:900 30px sans-serif">Ab', 'font-size="30" font-weight="700">Ab'),
        ("style=\"font:italic bold 30px/1.2 'A', x\">Ab", 'font-size="30" font-weight="700">Ab'),
        ('style="--w:700;font:var(--w) 30px x">Ab', 'font-size="30" font-weight="700">Ab'),
        ('style="font-weight:700;font:30px x">Ab', 'font-size="30">Ab'),
        ('font-size="30" style="text-transform:uppercase">aß', 'font-size="30">ASS'),
        ('font-size="30" style="text-transform:lowercase">AB', 'font-size="30">ab'),
        ('font-size="20" style="text-transform:capitalize">ab cd', 'font-size="20">Ab Cd'),
        ('font-size="30" direction="rtl" text-anchor="end">Ab', 'font-size="30">Ab'),
    ],
)  # fmt: skip
def test_text_is_as_styles_say(text: str, plain: str) -> None:
    """Bold by the shorthand, in capitals by their property, on the page if it runs to the left."""
    one, other = (
        ink(svg(f'<text x="2" y="36" {said}</text>', 'viewBox="0 0 64 48"'))
        for said in (text, plain)
    )
    assert overlap(one, other) > 0.97


def test_text_from_the_right_ends_where_it_begins() -> None:
    """As browsers have it: the anchor is its right end."""
    root, _ = parse(svg('<text x="60" y="30" direction="rtl">Ab<tspan>c</tspan></text>'))
    apply_styles(root)
    set_type(root)
    assert [one.get("text-anchor") for one in root.iter() if one.tag != "svg"] == ["end", "end"]


@pytest.mark.parametrize(
    "value", ["", "bold", "12px", "banana 12px serif", "bold serif", "12 serif"]
)
def test_a_shorthand_that_is_not_valid_sets_nothing(value: str) -> None:
    """As in browsers."""
    assert font(value) == {}


def test_a_text_alone_without_a_page_is_told() -> None:
    """Its box is that of its letters, whatever the room around."""
    small = '<text x="2" y="14" font-size="6">HIM</text>'
    assert_shows(svg('<text font-size="24">HIM</text>', ""), small, 0.95, TELLS_FONT)
