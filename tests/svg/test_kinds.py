"""Drawings as people have them, of every kind that a reader may stumble over: the right picture."""

import base64
import gzip

import pytest

from iconstudio.model import IconstudioError
from tests.svg.pictures import (
    BODY,
    HOUSE,
    OUTLINE,
    PATH,
    ROOF,
    WINDOW,
    assert_shows,
    ink,
    overlap,
    read,
    svg,
)

ROOT = '<svg xmlns="http://www.w3.org/2000/svg"'
BOX = 'viewBox="0 0 24 24"'
EVENODD = f'fill-rule="evenodd" d="{HOUSE}"'
PIXEL = "data:image/png;base64," + base64.b64encode(b"\x89PNG").decode()
LINK = '<path id="a" fill-rule="evenodd" d="' + HOUSE + '"/>'

AS_THE_HOUSE = {
    # Prefixes that nobody declared, as in what is copied out of pages and programs.
    "xlink without declaration": svg(f'<defs>{LINK}</defs><use xlink:href="#a"/>'),
    "attributes of a program": svg(
        f'<g inkscape:label="a" sketch:type="b" serif:id="c">{PATH}</g>'
    ),
    "elements of a program": svg(f"<sodipodi:namedview pagecolor='#fff'/><x:y>{PATH}</x:y>{PATH}"),
    "prefix svg without declaration": f"<svg:svg {BOX}><svg:path {EVENODD}/></svg:svg>",
    "prefix svg": f'<s:svg xmlns:s="http://www.w3.org/2000/svg" {BOX}><s:path {EVENODD}/></s:svg>',
    "no namespace": f'<svg viewBox="0 0 24 24">{PATH}</svg>',
    "namespace mistyped": f'<svg xmlns="https://www.w3.org/2000/svg" {BOX}>{PATH}</svg>',
    # One colour is ink, whatever it is.
    "white": svg(f'<path fill="#fff" {EVENODD}/>'),
    "white with a transparent page": svg(
        f'<path fill="none" d="M0 0h24v24H0z"/><path fill="#FFFFFF" {EVENODD}/>'
    ),
    "green": svg(f'<path fill="#4CAF50" {EVENODD}/>'),
    "yellow": svg(f'<path fill="yellow" {EVENODD}/>'),
    "grey": svg(f'<path fill="#bebebe" {EVENODD}/>'),
    "pale": svg(f'<g opacity=".38">{PATH}</g>'),
    "pale fill": svg(f'<path fill-opacity=".2" {EVENODD}/>'),
    "white by its root": svg(
        f'<path fill="currentColor" {EVENODD}/>', 'viewBox="0 0 24 24" color="#fff"'
    ),
    "brand colours": svg(
        '<path fill="#F4B400" d="M3 21V10L12 2l9 8v11z"/><path fill="#0F4C81" d="M17 2h4v3h-4z"/>'
        f'<path fill="#fff" d="{WINDOW}"/>'
    ),
    "gradient": svg(
        '<linearGradient id="g" x2="0" y2="1"><stop stop-color="#FFD54F"/><stop offset="1"'
        f' stop-color="#BF360C"/></linearGradient><path fill="url(#g)" {EVENODD}/>'
    ),
    "black on a white page": svg(f'<path fill="#fff" d="M0 0h24v24H0z"/>{PATH}'),
    # CSS Color 4
    "oklch": svg(f'<path d="{BODY}"/><path fill="oklch(100% 0 0)" d="{WINDOW}"/>'),
    "lab": svg(f'<path d="{BODY}"/><path fill="lab(100% 0 0)" d="{WINDOW}"/>'),
    "hwb": svg(f'<path d="{BODY}"/><path style="fill:hwb(0 100% 0%)" d="{WINDOW}"/>'),
    "rgb with spaces": svg(
        f'<path d="{BODY}"/><path fill="rgb(255 255 255 / 100%)" d="{WINDOW}"/>'
    ),
    "nothing, in spaces": svg(f'<path fill="rgb(0 0 0 / 0)" d="M0 0h24v24H0z"/>{PATH}'),
    "wide gamut with a fallback": svg(
        f'<path d="{BODY}"/><path style="fill:white;fill:color(display-p3 1 1 1)" d="{WINDOW}"/>'
    ),
    "unknown with a fallback": svg(
        f'<path d="{BODY}"/><path style="fill:white;fill:color-of-tomorrow(1)" d="{WINDOW}"/>'
    ),
    "a system's colour": svg(
        f'<path fill="CanvasText" d="{BODY}"/><path fill="Canvas" d="{WINDOW}"/>'
    ),
    # Variables
    "variable's fallback": svg(
        f'<path style="fill:var(--ink,#000)" d="{BODY}"/>'
        f'<path fill="var(--paper, #fff)" d="{WINDOW}"/>'
    ),
    "variable": svg(
        f"<style>:root{{--paper:var(--white);--white:#fff}}.p{{fill:var(--paper)}}</style>"
        f'<path d="{BODY}"/><path class="p" d="{WINDOW}"/>'
    ),
    "variable that is not there": svg(f'<path fill="var(--ink)" {EVENODD}/>'),
    "variables in a circle": svg(
        f'<g style="--a:var(--b);--b:var(--a)"><path style="fill:var(--a,#000)" {EVENODD}/></g>'
    ),
    # Entities
    "Illustrator": '<?xml version="1.0"?><!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "a.dtd" ['
    '<!ENTITY ns_svg "http://www.w3.org/2000/svg"><!ENTITY ns_ai "http://ns.adobe.com/ai/">'
    '<!ENTITY d "M17 2h4v3h-4z">]><svg xmlns="&ns_svg;" xmlns:i="&ns_ai;" viewBox="0 0 24 24">'
    '<switch><foreignObject requiredExtensions="&ns_ai;"/><g i:extraneous="self">'
    f'<path fill-rule="evenodd" d="M3 21V10L12 2l9 8v11z{WINDOW}"/><path d="&d;"/></g></switch>'
    "</svg>",
    "a single ampersand": svg(f"<title>Salt & Co.</title>{PATH}"),
    "HTML's entities": svg(f"<title>a&nbsp;b&hellip;</title>{PATH}"),
    "attributes declared": f'<!DOCTYPE svg [<!ATTLIST svg x CDATA "y">]>{svg(PATH)}',
    # Style sheets
    "root selector": svg(
        f"<style>:root{{fill:#111}}</style>{PATH}", 'viewBox="0 0 24 24" fill="none"'
    ),
    "dark scheme": svg(
        "<style>path{fill:#000}@media (prefers-color-scheme: dark){path{fill:none}}"
        f"@media print{{path{{display:none}}}}@media screen{{.h{{fill-rule:evenodd}}}}</style>"
        f'<path class="h" d="{HOUSE}"/>'
    ),
    "gradient by id": svg(
        '<linearGradient id="g"><stop/><stop offset="1" stop-color="#222"/></linearGradient>'
        f'<style>#h{{fill:url(#g);fill-rule:evenodd}}</style><path id="h" d="{HOUSE}"/>'
    ),
    "clip by tag": svg(
        '<clipPath id="c"><path d="M0 0h24v24H0z"/></clipPath><style>g{clip-path:url("#c")}</style>'
        f"<g>{PATH}</g>"
    ),
    "compound selector": svg(
        "<style>g > path.a[d]:not(.b){fill-rule:evenodd}</style>"
        f"<g><path class='a' d='{HOUSE}'/></g>"
    ),
    "important, and a hidden second": svg(
        "<style>path:nth-of-type(2){display:none}"
        ".x{fill:#000 !important;fill-rule:evenodd}</style>"
        f'<path class="x" style="fill:#fff" d="{HOUSE}"/><path d="M0 0h24v24H0z"/>'
    ),
    "nested rules": svg(
        "<style>g{fill:red;.a{fill-rule:evenodd;&:hover{fill:none}}& > .b{display:none}}</style>"
        f"<g><path class='a' d='{HOUSE}'/><path class='b' d='M0 0h24v24z'/></g>"
    ),
    "specificity": svg(
        f"<style>#h{{fill-rule:evenodd}}path.a{{fill-rule:nonzero}}.a{{fill:red}}</style>"
        f'<path id="h" class="a" fill="blue" d="{HOUSE}"/>'
    ),
    "sheet in a comment": svg(
        f"<style><![CDATA[<!-- .a{{fill-rule:evenodd}} -->]]></style><path class='a' d='{HOUSE}'/>"
    ),
    "fonts that nobody uses": svg(
        "<style>@import url(https://fonts.example.org/css?family=A);@font-face{font-family:A;"
        f"src:url(data:font/woff2;base64,d09G)}}</style>{PATH}"
    ),
    "geometry in CSS": svg(
        "<style>rect{x:9px;y:12px;width:6px;height:5px;fill:#fff}</style>"
        f"<path d='{BODY}'/><rect/>"
    ),
    "path in CSS": svg(f"<style>path{{d:path('{HOUSE}');fill-rule:evenodd}}</style><path/>"),
    "transform in CSS": svg(
        f'<g style="transform:translate(6px,0) scale(.5);transform-origin:50% 0">{PATH}</g>'
    ),
    "turned about the middle of a view within": svg(
        '<svg viewBox="0 0 48 48"><g style="transform:scale(2) rotate(90deg);'
        f'transform-origin:50% 50%"><g transform="matrix(0 -1 1 0 12 36)">{PATH}</g></g></svg>'
    ),
    "turned about its middle": svg(
        f'<g style="transform:rotate(.5turn);transform-box:fill-box;transform-origin:center">'
        f'<g transform="rotate(180 12 11.5)">{PATH}</g></g>'
    ),
    # Sizes
    "no size": f'<svg xmlns="http://www.w3.org/2000/svg">{PATH}</svg>',
    "only a width": svg(PATH, 'width="24"'),
    "percentages": svg(PATH, 'width="100%" height="100%"'),
    "automatic": svg(PATH, 'width="auto" height="auto"'),
    "size in CSS": svg(PATH, 'style="width:24px;height:24px"'),
    "empty view box": svg(PATH, 'width="24" height="24" viewBox="0 0 0 0"'),
    "broken view box": svg(PATH, 'viewBox="0 0 24"'),
    "huge view box": svg(
        f'<g transform="scale(80000)">{PATH}</g>', 'viewBox="0 0 1920000 1920000"'
    ),
    "tiny view box": svg(f'<g transform="scale(.00001)">{PATH}</g>', 'viewBox="0 0 .00024 .00024"'),
    "far away": svg(
        f'<g transform="translate(500000 5000000)">{PATH}</g>', 'viewBox="500000 5000000 24 24"'
    ),
    "stretched": svg(
        f'<g transform="scale(1 .5)">{PATH}</g>',
        'viewBox="0 0 24 12" width="24" height="24" preserveAspectRatio="none"',
    ),
    "in a corner of a poster": svg(
        f'<g transform="translate(800 1150) scale(.5)">{PATH}</g>',
        'width="841mm" height="1189mm" viewBox="0 0 841 1189"',
    ),
    # What is not drawn
    "hidden bitmap": svg(f'<g style="display:none"><image href="{PIXEL}"/></g>{PATH}'),
    "transparent bitmap": svg(f'<image opacity="0" href="{PIXEL}"/>{PATH}'),
    "bitmap in a fill of no opacity": svg(
        f'<pattern id="p" width="1" height="1"><image href="{PIXEL}"/></pattern>'
        f'<path fill="url(#p)" fill-opacity="0" d="M0 0h24v24H0z"/>{PATH}'
    ),
    "bitmap that is defined only": svg(f'<defs><image id="i" href="{PIXEL}"/></defs>{PATH}'),
    "hidden text": svg(f'<text visibility="hidden" y="20">x</text>{PATH}'),
    "metadata": svg(
        f'<metadata><a:b xmlns:a="a" href="https://example.org">x</a:b></metadata>{PATH}'
    ),
    "links": svg(f'<a href="https://example.org">{PATH}</a>'),
    "handlers": svg(f'<g onclick="alert(1)">{PATH}</g>'),
    "private data": svg(
        f'<i:pgf xmlns:i="a">{"x" * 3_000_000}</i:pgf><!-- {"y" * 3_000_000} -->{PATH}'
    ),
    # Animation: what it comes to
    "fades in": svg(
        f'<g fill-opacity="0">{PATH}<animate attributeName="fill-opacity" dur="1s" fill="freeze"'
        ' values="0;1"/></g>'
    ),
    "is set": svg(
        f'<g visibility="hidden">{PATH}<set attributeName="visibility" to="visible"/></g>'
    ),
    "grows": svg(
        f'<g transform="scale(0)">{PATH}<animateTransform attributeName="transform" type="scale"'
        ' from="0" to="1" dur="1s" fill="freeze"/></g>'
    ),
    "fades in by CSS": svg(
        "<style>@keyframes in{from{opacity:0}to{opacity:1}}g{opacity:0;animation:in 1s forwards}"
        f"</style><g>{PATH}</g>"
    ),
    # Structure
    "an id twice": svg(
        f'<path id="b" fill="url(#b)" {EVENODD}/><linearGradient id="b"><stop/></linearGradient>'
    ),
    "symbol": svg(f'<symbol id="s" viewBox="0 0 24 24">{PATH}</symbol><use href="#s"/>'),
    "sprite of one": f'{ROOT}><symbol id="s" {BOX}>{PATH}</symbol></svg>',
    "inner svg": svg(f'<svg x="6" y="6" width="12" height="12" viewBox="0 0 24 24">{PATH}</svg>'),
    "English among others": svg(
        '<switch><path systemLanguage="fr" d="M0 0h9v9z"/>'
        f'<g systemLanguage="en-GB">{PATH}</g><path d="M0 0h9v9z"/></switch>'
    ),
    "languages without a switch": svg(
        f'<g systemLanguage="de, en">{PATH}</g><path systemLanguage="fr" d="M0 0h9v9z"/>'
    ),
    "container query": svg(
        f"<style>@container a (width > 1px) {{ path {{ display: none }} }}</style>{PATH}"
    ),
    "language": svg(f'<switch><path systemLanguage="xx" d="M0 0h9v9z"/>{PATH}</switch>'),
    "context's paint": svg(
        f'<path fill="context-fill" fill-opacity="context-fill-opacity" {EVENODD}/>'
    ),
    "script": svg(PATH),
}


MOVING = {"fades in", "grows", "fades in by CSS", "one that is drawn as one looks on"}


def moment_of(kind):
    return ["moves; it is taken as it stands at the end"] if kind in MOVING else ()


@pytest.mark.thorough(but=24)
@pytest.mark.parametrize("kind", AS_THE_HOUSE)
def test_the_house_is_drawn(kind):
    assert_shows(AS_THE_HOUSE[kind], PATH, remarks=moment_of(kind))


def test_the_tile_behind_a_house_is_left_out_with_a_remark():
    on_tile = svg(f'<path d="M0 0h24v24H0z"/><path fill="#fff" {EVENODD}/>')
    assert_shows(on_tile, PATH, remarks=["ground behind the drawing, such as a tile"])


def declared(encoding, title):
    """The house in an encoding that it declares."""
    prolog = f'<?xml version="1.0" encoding="{encoding}"?>'
    return f"{prolog}{svg(f'<title>{title}</title>{PATH}')}".encode(encoding)


ENCODED = {
    "SVGZ": gzip.compress(svg(PATH).encode()),
    "UTF-16 without mark": f'<?xml version="1.0" encoding="UTF-16BE"?>{svg(PATH)}'.encode(
        "utf-16-be"
    ),
    "UTF-16 with mark": svg(PATH).encode("utf-16"),
    "UTF-32": svg(PATH).encode("utf-32"),
    "Cyrillic": declared("windows-1251", "дом"),
    "Japanese": declared("Shift_JIS", "家"),
    "Chinese": declared("GB2312", "房"),
    "undeclared": svg(f"<title>Häuschen</title>{PATH}").encode("latin-1"),
    "declared wrongly": f'<?xml version="1.0" encoding="UTF-16"?>{svg(PATH)}'.encode(),
    "blank line": b"\n \n" + f'<?xml version="1.0" encoding="UTF-8"?>{svg(PATH)}'.encode(),
    "mark and blank line": b"\xef\xbb\xbf\n" + svg(PATH).encode(),
    "zeros at the end": svg(PATH).encode() + b"\0\0\n",
    "out of a page": f"<!DOCTYPE html><meta charset='utf-8'><p>a & b<br>{svg(PATH)}<p>c".encode(),
    "data address": b"data:image/svg+xml;base64," + base64.b64encode(svg(PATH).encode()),
    "data address in words": ("data:image/svg+xml;utf8," + svg(PATH).replace("#", "%23")).encode(),
}


@pytest.mark.parametrize("kind", ENCODED)
def test_the_house_is_read_however_it_is_encoded(kind):
    assert_shows(ENCODED[kind], PATH)


UNSCALED = (
    '<path vector-effect="non-scaling-stroke" stroke="#000" stroke-width="2"'
    ' d="M.125 .875V.4167L.5 .125l.375 .29167v.45833z"/>'
)
LINES = f'<path fill="none" stroke="#000" stroke-width="2" d="{ROOF}"/>'
AS_THE_OUTLINE = {
    "lines within a small viewport": svg(
        f'<svg width="2400" height="2400" viewBox="0 0 24 24">{LINES}</svg>',
        'viewBox="0 0 2400 2400"',
    ),
    "lines of a small symbol": svg(
        f'<symbol id="a" viewBox="0 0 24 24">{LINES}</symbol><use href="#a"/>',
        'viewBox="0 0 2400 2400"',
    ),
    "lines that are repeated larger": svg(
        f'<defs><g id="a">{LINES}</g></defs><use href="#a" transform="scale(100)"/>',
        'viewBox="0 0 2400 2400"',
    ),
    "variables": svg(
        f'<path style="fill:var(--f,none);stroke:var(--s,#000);stroke-width:2" d="{ROOF}"/>'
    ),
    "one that is drawn as one looks on": svg(
        f'<g fill="none" stroke="#000" stroke-width="2"><path stroke-dasharray="80"'
        f' stroke-dashoffset="80" d="{ROOF}"><animate attributeName="stroke-dashoffset"'
        ' fill="freeze" dur=".6s" values="80;0"/></path></g>'
    ),
    "strokes that do not scale": svg(
        '<path vector-effect="non-scaling-stroke" fill="none" stroke="#000" stroke-width="8"'
        ' d="M.125 .875V.4167L.5 .125l.375 .29167v.45833z"/>',
        'width="96" height="96" viewBox="0 0 1 1"',
    ),
    "strokes that do not scale, repeated": svg(
        f'<defs><g id="a" transform="scale(3)">{UNSCALED}</g><g id="b"><use href="#a" x="1"/></g>'
        '</defs><use href="#b" transform="translate(-8) scale(8)" fill="none"/>'
    ),
    "strokes that do not scale, in a symbol": svg(
        f'<symbol id="a" viewBox="0 0 1 1" fill="none">{UNSCALED}</symbol>'
        '<use href="#a" x="12" y="12" width="48" height="48" transform="matrix(.5 0 0 .5 -6 -6)"/>'
    ),
    "strokes that do not scale, in a viewport": svg(
        '<g transform="scale(.1)"><svg width="240" height="240" viewBox="0 0 1 1" fill="none">'
        f"{UNSCALED}</svg></g>"
    ),
    "white line": svg(f'<path fill="none" stroke="#fff" stroke-width="2" d="{ROOF}"/>'),
    "width in rem": svg(f'<path style="fill:none;stroke:red;stroke-width:.125rem" d="{ROOF}"/>'),
}


@pytest.mark.thorough(but=1)
@pytest.mark.parametrize("kind", AS_THE_OUTLINE)
def test_the_outline_is_drawn_and_stays_a_line(kind):
    assert_shows(AS_THE_OUTLINE[kind], OUTLINE, remarks=moment_of(kind))
    assert "stroke" in read(AS_THE_OUTLINE[kind]).svg


SAID = {
    "text": (svg(f'{PATH}<text x="2" y="9" font-size="4">P</text>'), "turn text into shapes"),
    "letters of another script": (
        svg(f'{PATH}<text y="9">中</text>'),
        "no “中”, which was left out",
    ),
    "bitmap": (svg(f'{PATH}<image width="4" height="4" href="{PIXEL}"/>'), "A bitmap was left out"),
    "web page": (svg(f"{PATH}<foreignObject><p>hello</p></foreignObject>"), "only web pages show"),
    "elsewhere": (svg(f'{PATH}<use href="other.svg#a"/>'), "“other.svg#a” outside of itself"),
    "paint from elsewhere": (
        svg(f'<path fill="url(a.svg#g) #000" {EVENODD}/>'),
        "outside of itself",
    ),
    "script": (svg(f"<script>alert(1)</script>{PATH}"), "script was not run"),
    "unknown colour": (svg(f'<path fill="color-of-tomorrow(1)" {EVENODD}/>'), "was not understood"),
    "unknown selector": (
        svg(f"<style>path:nth-col(2){{fill:none}}</style>{PATH}"),
        "style rule for “path:nth-col(2)”",
    ),
    "unknown transform": (
        svg(f'<g style="transform:translate(10vw)">{PATH}</g>'),
        "translate(10vw)",
    ),
    "sheet from elsewhere": (svg(f"<style>@import 'a.css';</style>{PATH}"), "outside of the file"),
    "moves for ever": (
        svg(
            f'<g>{PATH}<animate attributeName="opacity" values="1;0" repeatCount="indefinite"/></g>'
        ),
        "moves",
    ),
    "beside its page": (svg(f'<g transform="translate(-40 10)">{PATH}</g>'), "outside of its page"),
    "hairline": (
        svg(f'<path fill="none" stroke="#000" stroke-width=".02" d="{ROOF}"/>'),
        "too thin",
    ),
    "mesh as a paint": (
        svg(f'<defs><meshgradient id="m"/></defs>{PATH}<path fill="url(#m)" d="M0 0h2v2H0z"/>'),
        "A mesh gradient was not read; what it paints was drawn in one colour.",
    ),
    "hatch as a paint": (
        svg(f'<defs><hatch id="m"/></defs>{PATH}<path fill="url(#m) none" d="M0 0h2v2H0z"/>'),
        "A hatching was not read; what it paints was drawn in one colour.",
    ),
    "mesh": (svg(f'<defs/><meshgradient id="m"/>{PATH}'), "A mesh gradient was left out"),
}


@pytest.mark.thorough(but=1)
@pytest.mark.parametrize("kind", SAID)
def test_nothing_is_left_out_in_silence(kind):
    document, words = SAID[kind]
    remarks = read(document).remarks
    assert any(words in remark for remark in remarks), remarks
    assert len(remarks) == 1
    assert remarks[0].endswith(".")


def test_the_font_is_told_whether_or_not_it_lacks_letters():
    remarks = read(svg(f'{PATH}<text y="9">P 中</text>')).remarks
    assert len(remarks) == 2
    assert "drawn in Inter" in remarks[0] and "no “中”" in remarks[1]


def test_letters_may_be_bold():
    text = '<text y="18" font-size="18">P</text>'
    plain, bold = ink(svg(text)), ink(svg(f'<g style="font-weight:bold">{text}</g>'))
    assert 1.2 * plain.sum() < bold.sum()


def test_letters_are_drawn():
    sign = '<path fill-rule="evenodd" d="M2 2h20v20H2zM4 4v16h16V4z"/>'
    with_letter = ink(
        svg(f'{sign}<text x="12" y="18" text-anchor="middle" font-size="16">P</text>')
    )
    frame = ink(svg(sign))
    assert (with_letter & ~frame).sum() > 2000
    assert overlap(with_letter & frame, frame) > 0.99


REFUSED = {
    "sprite": (
        '<svg xmlns="http://www.w3.org/2000/svg"><symbol id="home"><path d="M0 0h9v9z"/></symbol>'
        '<symbol id="dot"><circle r="9"/></symbol></svg>',
        r"2 symbols \(home, dot\)",
    ),
    "only a bitmap": (
        svg(f'<image href="{PIXEL}" width="9" height="9"/>'),
        "A bitmap was left out",
    ),
    "only an emoji": (svg('<text y="20">🎯</text>'), "no “🎯”, which was left out"),
    "nothing": (svg(), "nothing to be seen in it: it is empty"),
    "external entity": (
        '<!DOCTYPE svg [<!ENTITY x SYSTEM "file:///etc/passwd">]>' + svg("<text>&x;</text>"),
        "from outside itself",
    ),
    "external document type": (
        '<!DOCTYPE svg [<!ENTITY % x SYSTEM "a.dtd"> %x;]>' + svg(PATH),
        "from outside itself",
    ),
    "cut short": (svg(PATH)[:-9], "cut short"),
    "another language": ("<math><mi>x</mi></math>", "root element is <math>"),
    "words": ("Dear dog,", "a text, not a drawing"),
    "empty": ("", "is empty. Save"),
    "bitmap": (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\xff\xfe\x80", "no SVG drawing"),
    "bytes": (b"\1\2\xff\xfe\x80", "no SVG drawing"),
    "SVGZ cut short": (gzip.compress(svg(PATH).encode())[:-20], "cut short"),
    "SVGZ damaged": (b"\x1f\x8b\x08\0\0\0\0\0\0\xff\xff\xff\xff\xff", "damaged"),
    "bomb": (gzip.compress(b" " * 40_000_000), "more than 32,000,000 bytes"),
}


@pytest.mark.parametrize("kind", REFUSED)
def test_what_cannot_be_drawn_is_refused_in_a_sentence(kind):
    document, words = REFUSED[kind]
    with pytest.raises(IconstudioError, match=words) as caught:
        read(document, "a.svg")
    assert str(caught.value).startswith("“a.svg” cannot be used. ")
    assert str(caught.value).endswith(".")
