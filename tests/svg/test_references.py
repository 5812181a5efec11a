"""References go where browsers find them, whatever characters ids are made of."""

import pytest

from tests.svg.pictures import BODY, PATH, WINDOW, assert_shows, svg

CLIP = '<clipPath id="{}"><path clip-rule="evenodd" d="M0 0h24v24H0z' + WINDOW + '"/></clipPath>'
HOUSE = f'<path {{}} d="{BODY}"/>'
WAYS = {
    "blank in quotes": ("my clip", "clip-path=\"url('#my clip')\""),
    "blank without quotes": ("my clip", 'clip-path="url(#my clip)"'),
    "escaped blank": ("my clip", 'clip-path="url(#my%20clip)"'),
    "escaped blank in a style": ("my clip", "style=\"clip-path:url('#my%20clip')\""),
    "blanks around": ("clip", "clip-path=\"url( '#clip' )\""),
    "escaped letter": ("é", 'clip-path="url(#%C3%A9)"'),
    "letter that looks escaped": ("a%20b", 'clip-path="url(#a%20b)"'),
    "brackets": ("clip (1)", "style='clip-path:url(\"#clip (1)\")'"),
    "quote": ("it's", "style='clip-path:url(\"#it&apos;s\")'"),
    "per cent": ("50%", 'clip-path="url(#50%)"'),
}


@pytest.mark.parametrize("kind", WAYS)
def test_a_url_is_found(kind):
    name, attribute = WAYS[kind]
    assert_shows(svg(CLIP.format(name) + HOUSE.format(attribute)), PATH)


@pytest.mark.parametrize("address", ["#my house", "#my%20house", " #my%20house "])
def test_a_href_is_found(address):
    house = PATH.replace("<path", '<path id="my house"')
    assert_shows(svg(f'<defs>{house}</defs><use href="{address}"/>'), PATH)


def test_what_an_escaped_reference_animates_is_found():
    animated = '<animate href="#my%20house" attributeName="opacity" values="0;1" fill="freeze"/>'
    house = PATH.replace("<path", '<path id="my house" opacity="0"')
    assert_shows(svg(house + animated), PATH, remarks=["moves"])


def test_what_is_not_there_is_told_as_it_is_written():
    body = f'{PATH}<use href="#my%20house"/><path fill="url(#no%20fill)" d="M0 0h1v1H0z"/>'
    assert_shows(svg(body), PATH, remarks=["“#my house”", "“#no fill”"])
