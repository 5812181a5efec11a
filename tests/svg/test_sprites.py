"""Sheets of several symbols, fonts, and drawings that move: something is always in sight."""

import pytest

from iconstudio.model import IconstudioError, SpriteError
from iconstudio.session import Session
from iconstudio.svg.animation import IN_PARTS, MIDWAY, RUNNING
from iconstudio.svg.rasterise import rasterise
from iconstudio.svg.reading import file_and_symbol, own_svg
from tests.svg.pictures import HOUSE, PATH, assert_shows, ink, overlap, read, svg

pytestmark = pytest.mark.thorough(but=1)

ROOT = '<svg xmlns="http://www.w3.org/2000/svg"'
DOT = '<circle cx="12" cy="12" r="9"/>'
SHEET = (
    f'{ROOT} style="display:none"><defs><linearGradient id="g"><stop/></linearGradient></defs>'
    f'<symbol id="home" viewBox="0 0 24 24"><path fill="url(#g)" fill-rule="evenodd" d="{HOUSE}"/>'
    f'</symbol><symbol id="dot" viewBox="0 0 24 24">{DOT}</symbol></svg>'
)
STACK = svg(
    f'<svg id="home" viewBox="0 0 24 24" display="none">{PATH}</svg>'
    f'<g id="dot" style="display:none">{DOT}</g>'
)
FONT = (
    f'{ROOT}><defs><font id="f" horiz-adv-x="24"><font-face units-per-em="24" ascent="24"/>'
    '<missing-glyph/><glyph glyph-name="space" unicode=" "/>{}</font></defs></svg>'
)
GLYPH = '<glyph glyph-name="{}" unicode="&#xe{};" d="{}"/>'
FLAG = "M3 3V21L21 3Z"


def chosen(document, symbol):
    return rasterise(own_svg(document.encode(), "sheet.svg", symbol).svg)[1] > 127


@pytest.mark.parametrize("sheet", [SHEET, STACK], ids=["symbols", "stack"])
def test_one_symbol_of_a_sheet_is_chosen(sheet):
    with pytest.raises(SpriteError, match=r"“sheet\.svg#home”") as caught:
        own_svg(sheet.encode(), "folder/sheet.svg")
    assert caught.value.names == ("home", "dot")
    assert overlap(chosen(sheet, "home"), ink(svg(PATH))) > 0.985
    assert overlap(chosen(sheet, "dot"), ink(svg(DOT))) > 0.985
    with pytest.raises(IconstudioError, match="called “bird”"):
        chosen(sheet, "bird")


def test_a_part_of_a_drawing_is_chosen():
    views = svg(
        f'<view id="v" viewBox="0 0 24 24"/><g transform="scale(2)"><g id="home">{PATH}</g>{DOT}'
        "</g>"
        f'<path id="far" d="M90 90h9v9z"/>',
        'viewBox="0 0 99 99"',
    )
    assert overlap(chosen(views, "home"), ink(svg(PATH))) > 0.985
    assert overlap(chosen(views, "v"), ink(svg(f'<g transform="scale(2)">{PATH}{DOT}</g>'))) > 0.9


def test_symbols_without_names_are_numbered():
    with pytest.raises(SpriteError, match=r"\(symbol-1, symbol-2\)") as caught:
        read(f"{ROOT}><symbol>{DOT}</symbol><symbol>{PATH}</symbol></svg>")
    sheet = f"{ROOT}><symbol>{DOT}</symbol><symbol>{PATH}</symbol></svg>"
    assert overlap(chosen(sheet, caught.value.names[1]), ink(svg(PATH))) > 0.985


def test_what_is_only_defined_is_a_sheet():
    sheet = f'{ROOT}><defs><g id="a">{PATH}</g><path id="b" d="M0 0h9v9z"/></defs></svg>'
    with pytest.raises(SpriteError, match=r"2 symbols \(a, b\)"):
        read(sheet)
    assert overlap(chosen(sheet, "a"), ink(svg(PATH))) > 0.985
    assert_shows(f'{ROOT}><defs><g id="a">{PATH}</g></defs></svg>', PATH)


def test_the_symbol_is_named():
    own = own_svg(SHEET.encode(), "folder/sheet.svg", "dot")
    assert own.id.startswith("own:sheet-dot-")
    assert own.credit.title == "sheet.svg#dot"


def test_files_with_a_number_sign_in_their_names(tmp_path):
    for name in ("a#b.svg", "sheet.svg"):
        (tmp_path / name).write_text("x")
    assert file_and_symbol(f"{tmp_path}/a#b.svg") == (f"{tmp_path}/a#b.svg", None)
    assert file_and_symbol(f"{tmp_path}/a#b.svg#c") == (f"{tmp_path}/a#b.svg", "c")
    assert file_and_symbol(f"{tmp_path}/sheet.svg#c#d") == (f"{tmp_path}/sheet.svg", "c#d")
    for other in (f"{tmp_path}/none.svg#c", f"{tmp_path}#c", "set:name", "a\0#b", ""):
        assert file_and_symbol(other) == (other, None)


def test_the_session_finds_symbols(tmp_path):
    (tmp_path / "a#b.svg").write_text(SHEET)
    with Session(tmp_path / "cache") as session:
        assert session.icon(f"{tmp_path}/a#b.svg#dot").credit.title == "a#b.svg#dot"
        with pytest.raises(SpriteError) as caught:
            session.icon(f"{tmp_path}/a#b.svg")
    assert caught.value.names == ("home", "dot")
    assert "“a#b.svg#home”" in str(caught.value)


def test_glyphs_of_a_font():
    one = FONT.format(GLYPH.format("flag", "001", FLAG))
    assert_shows(one, '<path d="M3 21V3L21 21Z"/>')
    two = FONT.format(GLYPH.format("flag", "001", FLAG) + GLYPH.format("dot", "002", "M0 0H9V9Z"))
    with pytest.raises(SpriteError, match=r"2 symbols \(flag, dot\)"):
        read(two)
    assert overlap(chosen(two, "flag"), ink(svg('<path d="M3 21V3L21 21Z"/>'))) > 0.985


def pulse(attributes, *animations, repeat='repeatCount="indefinite"'):
    inner = "".join(
        f'<animate attributeName="{name}" dur="1s" values="{values}" {repeat}/>'
        for name, values in animations
    )
    return svg(f'<circle cx="12" cy="12" {attributes}>{inner}</circle>')


SEEN = {
    "pulse": pulse('r="0"', ("r", "0;11"), ("opacity", "1;0")),
    "chain": pulse('r="0"', ("r", "0;11"), ("opacity", "1;0"), repeat='begin="0;b.end"'),
    "frozen chain": pulse(
        'r="0"', ("r", "0;11"), ("opacity", "1;0"), repeat='begin="0;b.end" fill="freeze"'
    ),
    "no radius": pulse("", ("r", "0;9;0")),
    "fades in and out": pulse('r="9" opacity="0"', ("opacity", "0;1;0")),
    "fades out at last": pulse('r="9"', ("opacity", "1;0"), repeat='fill="freeze"'),
    "scale": svg(
        f'<g transform="translate(12 12)"><g transform="translate(-12 -12)">{DOT}'
        '<animateTransform attributeName="transform" type="scale" values="0;1" dur="1s"'
        ' repeatCount="indefinite"/></g></g>'
    ).replace('<g transform="translate(-12 -12)">', '<g transform="scale(0)">'),
    "added to nothing": svg(
        '<circle cx="12" cy="12" r="9" transform="matrix(0 0 0 0 12 12)"><animateTransform'
        ' attributeName="transform" begin="0;a.begin+1s" dur="1s" type="translate"'
        ' values="12 12;0 0"/><animateTransform additive="sum" attributeName="transform"'
        ' begin="0;a.begin+1s" dur="1s" type="scale" values="0;1"/></circle>'
    ),
    "CSS": svg(
        "<style>@keyframes p{0%{opacity:0}50%{opacity:1}100%{opacity:0}}"
        f".p{{opacity:0;animation:p 1s infinite}}</style><g class='p'>{DOT}</g>"
    ),
    "CSS that ends with nothing": svg(
        "<style>@keyframes p{to{opacity:0}}"
        f".p{{animation:p 1s forwards}}</style><g class='p'>{DOT}</g>"
    ),
}


@pytest.mark.parametrize("kind", SEEN)
def test_something_is_seen_of_what_moves(kind):
    own = read(SEEN[kind])
    assert overlap(rasterise(own.svg)[1] > 127, ink(svg(DOT))) > 0.985
    assert own.remarks == (MIDWAY,)


def test_what_is_gone_at_the_end_is_gone():
    gone = '<path d="M0 0h24v24H0z"><set attributeName="display" to="none"/></path>'
    assert_shows(svg(f"{gone}{PATH}"), PATH)


def test_what_moves_in_parts_is_told_in_one_sentence():
    still = (
        '<circle cx="5" cy="5" r="4"><animate attributeName="opacity" dur="1s" values="1;.2;1"'
        ' repeatCount="indefinite"/></circle>'
    )
    both = SEEN["pulse"].replace("</svg>", f"{still}</svg>")
    assert read(both).remarks == (IN_PARTS,)


def test_a_line_along_which_a_long_dash_runs_is_drawn_whole():
    def running(shape, values, dashes):
        return svg(
            f'<g fill="none" stroke="#000" stroke-width="2"><{shape} stroke-dasharray="{dashes}">'
            f'<animate attributeName="stroke-dashoffset" values="{values}" dur="6s"'
            f' repeatCount="indefinite"/></{shape.split()[0]}></g>'
        )

    wind = 'path d="M3 10h13a3.500 3.500 0 1 0-3.500-3.500"'
    whole = f'<g fill="none" stroke="#000" stroke-width="2"><{wind}/></g>'
    for dashes in ("10", "10 6", "40"):
        assert_shows(running(wind, "0;160", dashes), whole, remarks=[RUNNING])
    ring = 'circle cx="12" cy="12" r="9"'
    for shape, dashes in ((wind, "2 1"), (ring, "20 37")):
        still = whole.replace(wind, f'{shape} stroke-dasharray="{dashes}"')
        assert_shows(running(shape, "0;160", dashes), still, remarks=["before it does"])


def template(*names):
    """Return a template of SF Symbols: a wider square for each weight, its first letter's code."""
    symbols = "".join(
        f'<g id="{name}" transform="matrix(1 0 0 1 {number * 300} 696)">'
        f'<path class="monochrome-0" d="M0 0h{ord(name[0])}v-100h-{ord(name[0])}z"/></g>'
        for number, name in enumerate(names)
    )
    return svg(
        '<style>.monochrome-0{fill:#000}</style><g id="Notes"><text y="322">Weights</text>'
        '<rect id="artboard" style="fill:white" width="3300" height="2200"/></g>'
        '<g id="Guides"><path id="Baseline-S" style="fill:none;stroke:#27AAE1" d="M263 696H3036"/>'
        f'</g><g id="Symbols">{symbols}</g>',
        'width="3300" height="2200"',
    )


@pytest.mark.parametrize(
    ("names", "usual"),
    [
        (("Black-S", "Regular-S", "Regular-M", "Ultralight-M"), "Regular-M"),
        (("Black-S", "Regular-S", "Ultralight-S"), "Regular-S"),
        (("Ultralight-M", "Black-M", "Semibold-L"), "Semibold-L"),
    ],
)
def test_a_template_of_sf_symbols_is_its_usual_symbol(names, usual):
    width = ord(usual[0])
    expected = f'<path d="M0 0h{width / 5}v20h-{width / 5}z"/>'
    assert_shows(template(*names), expected, remarks=[f"“{usual}”"])


def test_another_symbol_of_a_template_is_chosen():
    drawn = chosen(template("Regular-M", "Bold-M"), "Bold-M")
    assert overlap(drawn, ink(svg(f'<path d="M0 0h{ord("B") / 5}v20h-{ord("B") / 5}z"/>'))) > 0.985


def test_parts_that_are_called_like_those_of_templates_are_none():
    parts = f'<g id="Symbols"><g id="Regular-M">{PATH}</g></g>'
    assert_shows(svg(parts), PATH)
