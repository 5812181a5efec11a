"""A white page under a drawing takes no pale part of it away."""

import pytest

from tests.svg.pictures import ink, overlap, read, svg

pytestmark = pytest.mark.thorough(but=1)

PAGES = {
    "rectangle": '<rect width="24" height="24" fill="#fff"/>',
    "percentages": '<rect width="100%" height="100%" fill="white"/>',
    "path": '<path fill="#ffffff" d="M0 0h24v24H0z"/>',
    "group": '<g style="fill:hsl(0 0% 100%)"><rect x="-1" y="-1" width="30" height="30"/></g>',
}
DRAWINGS = {
    "a pale cloud before the sun": '<circle cx="15" cy="9" r="5" fill="#ffb300"/>'
    '<path d="M6 19a4 4 0 0 1 0-8 5 5 0 0 1 10-1 5 5 0 0 1 2 9z" fill="#cfd8dc"/>',
    "an egg": '<ellipse cx="12" cy="12" rx="10" ry="8" fill="#f5f5f5"/>'
    '<circle cx="12" cy="12" r="4" fill="#ffb300"/>',
    "lines on a sheet": '<path fill="#e8eaed" d="M5 2h14v20H5z"/>'
    '<path fill="#1a73e8" d="M8 7h8v2H8zm0 4h8v2H8zm0 4h5v2H8z"/>',
    "dark": '<path fill="#333" d="M3 3h8v18H3z"/><circle cx="17" cy="12" r="4" fill="#d32f2f"/>',
    "lines": '<path d="M4 12h16M12 4v16" fill="none" stroke="#000" stroke-width="2"/>',
}
GONE = "The white, or nearly white, behind the drawing was left out."


@pytest.mark.parametrize("page", PAGES)
@pytest.mark.parametrize("drawing", DRAWINGS)
def test_a_drawing_on_a_white_page_is_the_drawing(drawing, page):
    on_page, alone = svg(PAGES[page] + DRAWINGS[drawing]), svg(DRAWINGS[drawing])
    assert overlap(ink(on_page), ink(alone)) > 0.98
    told = set() if drawing == "lines" else {GONE}
    assert set(read(on_page).remarks) == {*read(alone).remarks, *told}


@pytest.mark.parametrize(
    "bite", ['fill="#fff"', 'fill="none" stroke="#ffffff" stroke-width="3"', 'style="fill:white"']
)
def test_white_that_looks_like_the_page_stays_so(bite):
    disc = '<circle cx="12" cy="12" r="9" fill="#1565c0"/>'
    paper = ~ink(svg(f'{PAGES["rectangle"]}{disc}<circle cx="20" cy="5" r="6" {bite}/>'))
    # Nothing is drawn where the white lies beside the disc.
    assert paper[:48, -48:].all()


def test_the_white_of_a_flag_is_a_part_of_it():
    stripes = '<path fill="#002654" d="M0 0h8v24H0z"/><path fill="#ce1126" d="M16 0h8v24h-8z"/>'
    flag = ink(svg(PAGES["rectangle"] + stripes))
    assert flag[:, 128].any() and not flag[128, 128]


def test_a_page_under_a_filter_stays():
    inverted = (
        f'<g style="filter:invert(1)">{PAGES["rectangle"]}<circle cx="12" cy="12" r="6"/></g>'
    )
    black = '<rect width="24" height="24"/><circle cx="12" cy="12" r="6" fill="#fff"/>'
    assert overlap(ink(svg(inverted)), ink(svg(black))) > 0.98
