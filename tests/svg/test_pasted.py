"""Drawings found in text, wherever they stand in it."""

import base64
import time
from urllib.parse import quote

import pytest
from hypothesis import given
from hypothesis import strategies as st

from iconstudio.svg.pasted import data_images, drawings_in, is_part

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
    assert drawings_in(f"{doctype}and words {PLAIN}") == (PLAIN.encode(),)


def test_what_is_cut_short_is_left_to_its_reader():
    assert drawings_in(PLAIN[:-3]) == (PLAIN[:-3].encode(),)


def test_words_hold_no_drawing():
    assert drawings_in("a dog <svgs> &lt;svg&gt;") == ()
    assert drawings_in("") == ()


@pytest.mark.parametrize(
    "piece",
    ["<svg ", '<svg a="', "<svg a='", "<!--", "<!DOCTYPE svg [", "<svg>", "<![CDATA[", "</svg"],
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
