"""Drawings of one paint need no judgement: all that shows is ink."""

import xml.etree.ElementTree as ET

import pytest

from iconstudio.svg import monochrome
from iconstudio.svg.paint import is_of_one_paint
from iconstudio.svg.reading import own_svg

RING = '<circle cx="12" cy="12" r="8" fill="none" stroke="{}" stroke-width="3"/>'
DISC = '<circle cx="12" cy="12" r="8" {}/>'


def markup(body, more=""):
    return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24" {more}>{body}</svg>'


ONE = {
    "black by default": DISC.format(""),
    "white": DISC.format('fill="#ffffff"'),
    "fill and stroke alike": DISC.format('fill="#336699" stroke="#336699" stroke-width="2"'),
    "inherited": f'<g fill="#336699">{DISC.format("")}</g>',
    "by color": f'<g color="#336699">{RING.format("currentColor")}</g>',
    "clipped by another colour": '<defs><clipPath id="a"><rect width="12" height="24" '
    'fill="#ff0000"/></clipPath></defs>' + DISC.format('fill="#336699" clip-path="url(#a)"'),
    "a hidden fill": DISC.format('fill="none" stroke="#336699" stroke-width="2"'),
}
MORE = {
    "two colours": RING.format("#000000") + DISC.format('fill="#ffffff"'),
    "black beside what is inherited": f'<g stroke="#336699">{DISC.format("")}</g>',
    "a layer": DISC.format('opacity="0.5"'),
    "half opaque": DISC.format('fill="rgba(0,0,0,0.5)"'),
    "a gradient": '<linearGradient id="a"><stop stop-color="#000000"/></linearGradient>'
    + DISC.format('fill="url(#a)"'),
    "a mask": DISC.format('mask="url(#a)"'),
    "text": "<text>a</text>",
    "an image": "<image/>",
    "nothing": '<rect width="9" height="9" fill="none"/>',
}


@pytest.mark.thorough(but=1)
@pytest.mark.parametrize("body", ONE.values(), ids=ONE)
def test_one_paint_gives_what_judging_the_picture_gives(body, monkeypatch):
    assert is_of_one_paint(ET.fromstring(f"<g>{body}</g>"))
    data = markup(body).encode()
    found = own_svg(data, "a.svg")
    monkeypatch.setattr(monochrome, "is_of_one_paint", lambda content: False)
    assert own_svg(data, "a.svg") == found


@pytest.mark.parametrize("body", MORE.values(), ids=MORE)
def test_anything_else_is_judged(body):
    assert not is_of_one_paint(ET.fromstring(f"<g>{body}</g>"))
