"""What was made plain and black here is read back as the same picture, and no other."""

import numpy as np
import pytest
from PIL import Image

from iconstudio.model import IconstudioError
from iconstudio.output.svg import svg_document
from iconstudio.svg.mark import IN_MARKUP
from iconstudio.svg.rasterise import rasterise
from tests.algorithms.test_whites import BITES, SHAPES
from tests.output.made import made, quarters, titled
from tests.svg.pictures import OUTLINE, PATH, ink, overlap, read, svg

pytestmark = pytest.mark.thorough(but=1)

FLAG = '<path fill="#e70013" d="M0 0h60v40H0z"/>'
CRESCENT = '<circle cx="{}" cy="20" r="10" fill="#fff"/><circle cx="{}" cy="20" r="8" fill="{}"/>'
TILE = '<rect width="60" height="40" rx="6" fill="{}"/>'
DRAWINGS = {
    "tunisia": (
        f'{FLAG}<circle cx="30" cy="20" r="10" fill="#fff"/>'
        '<circle cx="30" cy="20" r="7.5" fill="#e70013"/>'
        '<circle cx="32" cy="20" r="6" fill="#fff"/>'
    ),
    "turkey": (
        FLAG + CRESCENT.format(22, 24, "#e70013") + '<path d="M34 16l8 4-8 4z" fill="#fff"/>'
    ),
    "white page": TILE.format("#fff") + CRESCENT.format(30, 30, "#06c"),
    "tile on a tile": TILE.format("#06c")
    + '<rect x="12" y="4" width="32" height="32" rx="4" fill="#fff"/>'
    + CRESCENT.format(28, 28, "#fc0"),
    "ring on a disc": CRESCENT.format(30, 32, "#222"),
    "thin lines": '<path d="M5 5h50v30H5z" fill="none" stroke="#06c" stroke-width=".2"/>',
    "pale layer": TILE.format("#06c") + '<path d="M0 0h30v40H0z" opacity=".4"/>',
    "mask": '<mask id="m"><path fill="#fff" d="M0 0h60v40H0z"/><circle cx="30" cy="20" r="9"/>'
    '</mask><rect width="60" height="40" mask="url(#m)" fill="#e33"/>',
    "letters": '<text x="5" y="30" font-size="24" fill="#c22">Ab</text>',
    "stroke": f'<g transform="scale(1.6)">{OUTLINE}</g>',
    "house": f'<g fill="#39f" transform="scale(1.6)">{PATH}</g>',
    "off the page": '<circle cx="90" cy="90" r="20" fill="#c22"/>',
    "gradient": (
        '<linearGradient id="g"><stop stop-color="#fc0"/><stop offset="1" stop-color="#c00"/>'
        '</linearGradient><circle cx="30" cy="20" r="18" fill="url(#g)"/>'
        '<circle cx="24" cy="16" r="4" fill="#420"/>'
    ),
}
ALL = (
    {name: svg(body, 'viewBox="0 0 60 40"') for name, body in DRAWINGS.items()}
    | {name: svg("".join(body), 'viewBox="0 0 100 100"') for name, body in list(BITES.items())[::4]}
    | {name: svg(body, 'viewBox="0 0 100 100"') for name, body in list(SHAPES.items())[::4]}
)


def picture(document):
    return rasterise(document)[1].astype(int)


@pytest.mark.parametrize("name", ALL)
def test_the_plain_form_of_a_drawing_is_read_as_the_same_picture(name):
    once = read(ALL[name])
    again = read(once.svg, "saved.svg")
    first, second = picture(once.svg), picture(again.svg)
    assert abs(first - second).sum() < 0.001 * first.sum()
    assert again.remarks == ()
    assert read(again.svg).svg == again.svg


def test_a_result_that_was_saved_is_read_as_it_is():
    document = svg_document(titled(made(quarters()), "Dog"))
    again = read(document, "dog.svg")
    assert (picture(again.svg) == picture(document)).all()
    assert IN_MARKUP in document


def test_a_scan_that_was_saved_is_read_as_it_is(session, tmp_path):
    """Scans may be as large as they are, and need no air around."""
    path = tmp_path / "scan.png"
    pixels = np.full((60, 60, 3), 255, np.uint8)
    pixels[10:50, 10:50], pixels[20:40, 20:40], pixels[25:35, 25:35] = 0, 255, 0
    Image.fromarray(pixels).save(path)
    once = session.icon(str(path))
    assert (picture(read(once.svg).svg) == picture(once.svg)).all()


def test_a_mark_on_other_colours_says_nothing():
    """As of a drawing that was coloured in another program since."""
    coloured = DRAWINGS["tunisia"]
    with_mark = svg(coloured, f'viewBox="0 0 60 40" {IN_MARKUP}')
    assert read(with_mark).svg == read(svg(coloured, 'viewBox="0 0 60 40"')).svg
    faint = svg(f'<g opacity=".3">{PATH}</g>', f'viewBox="0 0 24 24" {IN_MARKUP}')
    assert overlap(ink(faint), ink(svg(PATH))) > 0.99


def test_a_mark_says_nothing_of_what_is_safe_or_to_be_seen():
    for body in (
        "",
        '<path d="M0 0h9v9H0z" fill="#fff"/>',
        '<path d="M0 0h9v9H0z" fill="none"/>',
    ):
        plain, marked = svg(body), svg(body, f'viewBox="0 0 24 24" {IN_MARKUP}')
        assert said(plain) == said(marked)
    loop = '<g id="a"><use href="#a"/></g><path d="M0 0h9v9H0z"/>'
    marked = read(svg(loop, f'viewBox="0 0 24 24" {IN_MARKUP}'))
    assert read(svg(loop)).remarks == marked.remarks != ()


def said(document):
    try:
        return read(document).svg.replace(f" {IN_MARKUP}", "")
    except IconstudioError as error:
        return str(error)
