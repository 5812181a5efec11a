"""Drawings found in text, wherever they stand in it."""

import base64
import time
from urllib.parse import quote

import pytest
from hypothesis import given
from hypothesis import strategies as st

from iconstudio.svg.pasted import data_images, drawings_in, files_in, is_part
from tests.svg.pictures import read

PLAIN = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="M0 0h9v9z"/></svg>'
NESTED = PLAIN.replace("<path", '<svg x="1"><g/></svg><svg/><path')
QUOTED = PLAIN.replace("<path", "<title id='a>b' class=\"/>\">x</title><path")
DRAWINGS = (PLAIN, NESTED, QUOTED, PLAIN.replace("svg ", "svg:svg ").replace("</svg", "</svg:svg"))
AROUND = (
    "",
    "  \n\t",
    "\ufeff",
    '<?xml version="1.0" encoding="windows-1251"?>\n',
    "<!-- Made by <svg> hand -->",
    "<html><body><!--StartFragment--><p>Look, a &lt; b:</p>",
    "<!DOCTYPE html>\n",
    "```svg\n",
    "</svg>",
    "an <svgfoo> and a 5 < 6",
)


@pytest.mark.parametrize("before", AROUND)
@pytest.mark.parametrize("drawing", DRAWINGS)
def test_a_drawing_is_found_in_the_middle_of_anything(before, drawing):
    assert drawings_in(f"{before}{drawing}\n```</body></html>") == (drawing.encode(),)


@given(st.lists(st.sampled_from(DRAWINGS), max_size=4), st.sampled_from(AROUND))
def test_several_drawings_are_found_in_their_order(drawings, between):
    text = between + between.join(drawings) + between
    assert drawings_in(text) == tuple(one.encode() for one in drawings)


@given(st.text(st.sampled_from("<svg/> !-[]\"'ex")))
def test_any_text_is_read(text):
    assert all(b"<svg" in one.lower() for one in drawings_in(text))


def test_the_document_type_goes_along_with_its_entities():
    doctype = '<!DOCTYPE svg PUBLIC "x" "y" [\n<!ENTITY ns "http://a.org/">\n]>\n<!-- hello -->\n'
    text = f'<?xml version="1.0"?>\n{doctype}{PLAIN}'
    assert drawings_in(text) == (f"{doctype}{PLAIN}".encode(),)
    other = doctype.replace("svg", "drawing")
    assert drawings_in(f"{other}{PLAIN}") == (f"{other}{PLAIN}".encode(),)
    assert drawings_in(f"{doctype}and words {PLAIN}") == (PLAIN.encode(),)


def test_what_is_cut_short_is_left_to_its_reader():
    assert drawings_in(PLAIN[:-3]) == (PLAIN[:-3].encode(),)


def test_words_hold_no_drawing():
    assert drawings_in("a dog <svgs> &lt;svg&gt;") == ()
    assert drawings_in("") == ()


@pytest.mark.parametrize(
    "piece",
    [
        "<svg ",
        '<svg a="',
        "<svg a='",
        "<!--",
        "<!DOCTYPE svg [",
        "<!DOCTYPE a ",
        "<svg>",
        "<![CDATA[",
        "</svg",
    ],
)
def test_a_long_text_takes_no_longer_than_its_length(piece):
    start = time.process_time()
    drawings_in(piece * 50_000)
    data_images("data:image/png;" * 50_000)
    assert time.process_time() - start < 5


@pytest.mark.parametrize(
    "address",
    [
        "data:image/svg+xml;base64," + base64.b64encode(PLAIN.encode()).decode(),
        "data:image/svg+xml;base64," + base64.b64encode(PLAIN.encode()).decode().rstrip("="),
        "data:image/svg+xml," + quote(PLAIN),
        "data:image/svg+xml;charset=utf-8," + quote(PLAIN),
        "DATA:image/SVG+xml;utf8," + quote(PLAIN),
    ],
)
def test_data_addresses_are_read(address):
    assert data_images(f'<img src="{address}" alt="">') == (("image/svg+xml", PLAIN.encode()),)
    assert data_images(address) == data_images(f"url({address})")


def test_a_broken_address_is_no_image():
    assert data_images("data:image/png;base64,A") == (("image/png", b""),)
    assert data_images("data:text/plain,hello") == ()


def test_a_part_of_a_drawing_is_known_from_words():
    assert is_part('<path d="M12 2 L22 22 H2 Z"/>')
    assert is_part('createLucideIcon("a", [["path", { d: "M1 2", key: 1 }]])')
    assert is_part(" M10 10h20v20z\n")
    assert not is_part("M4")
    assert not is_part("Mail 3 letters at 4 h")
    assert not is_part("let it be: a path < here, d = 3")


SHAPE = '<path class="a" d="M3 3h18v18H3zM8 8h8v8H8z"/>'
DRAWN = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24">{SHAPE}</svg>'
HOLLOW = ".a{fill:none;stroke:#000;stroke-width:2}"
INNER = DRAWN.replace("<", "%3C").replace(">", "%3E").replace('"', "%27").replace("%27", "'")
CODE = """const Box = ({ color = "#16a34a", size = 24 }) => (
  <svg viewBox="0 0 24 24" width={size} fill="none">
    <rect x={4} y={8} width={16} height={10} stroke={color} strokeWidth={3} />
    <path d="M22 10v6" style={{ stroke: color, strokeWidth: 3 }} />
  </svg>
);"""
FILES = {
    "a component with its styles": f"<template>{DRAWN}</template>\n<style scoped>{HOLLOW}</style>",
    "code with its defaults": CODE,
    "a page": f"<!DOCTYPE html><html><style>{HOLLOW}</style><p>Ä box: {DRAWN}</p></html>",
    "a style sheet": f'a{{background:url("data:image/svg+xml,{INNER}")}}',
    "an address": f'url("data:image/svg+xml,{INNER}")',
    "an address in base64": "data:image/svg+xml;base64,"
    + base64.b64encode(DRAWN.encode()).decode(),
    "what it declares": f'<?xml version="1.0" encoding="utf-8"?>\n<!-- Ä -->\n{DRAWN}',
    "a part": SHAPE,
    "JSON": f'{{"icon": "{DRAWN}"}}'.replace('="', '=\\"')
    .replace('" ', '\\" ')
    .replace('">', '\\">'),
}


@pytest.mark.parametrize("kind", FILES)
def test_what_is_pasted_is_read_as_its_file_is(kind):
    (pasted,) = files_in(FILES[kind])
    one, other = read(pasted), read(FILES[kind])
    assert (one.svg, one.remarks, one.credit) == (other.svg, other.remarks, other.credit)
    assert "<path" in one.svg


def test_the_styles_around_a_pasted_drawing_are_read():
    (pasted,) = files_in(FILES["a component with its styles"])
    assert "stroke-width" in read(pasted).svg
    (pasted,) = files_in(CODE)
    assert read(pasted).remarks == ()


SEVERAL = {
    "a page": f"<html><style>{HOLLOW}</style><p>{DRAWN} and {DRAWN}</p></html>",
    "a style sheet at the end": f"<div>{DRAWN}{DRAWN}</div><style>{HOLLOW}</style>",
    "the other drawing": DRAWN.replace("<path", f"<style>{HOLLOW}</style><path") + DRAWN,
    "a component": f"<template><p>{DRAWN}{DRAWN}</p></template>\n<style scoped>{HOLLOW}</style>",
    "variables": "<style>:root{--w:2}</style>"
    f"<style>{HOLLOW.replace(':2', ':var(--w)')}</style>{DRAWN}{DRAWN}",
}


@pytest.mark.parametrize("kind", SEVERAL)
def test_each_of_several_drawings_has_the_styles_around_it(kind):
    pasted = files_in(SEVERAL[kind])
    assert len(pasted) == 2
    expected = read(DRAWN.replace("<path", f"<style>{HOLLOW}</style><path")).svg
    for one in pasted:
        drawing = read(one)
        assert drawing.svg == expected
        assert drawing.remarks == ()


def test_styles_that_speak_of_something_else_are_left_to_the_page():
    other = "<style>p.b{color:red}</style>"
    assert files_in(f"{other}{PLAIN}{PLAIN}") == (PLAIN.encode(), PLAIN.encode())


def test_what_a_text_declares_of_its_encoding_is_not_heeded():
    (pasted,) = files_in(f'\ufeff <?xml version="1.0" encoding="utf-16"?><!-- Ж -->{DRAWN}')
    assert "Ж" in pasted.decode()
    assert read(pasted).svg == read(DRAWN).svg


def test_of_several_drawings_each_is_a_file():
    assert files_in(f"{PLAIN} and {DRAWN}") == (PLAIN.encode(), DRAWN.encode())
    addresses = [f"data:image/svg+xml,{quote(one)}" for one in (PLAIN, DRAWN)]
    assert files_in(" ".join(addresses)) == (PLAIN.encode(), DRAWN.encode())
    assert files_in("words") == files_in("data:image/png;base64,AAAA") == ()
