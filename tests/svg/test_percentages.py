"""Percentages are parts of the page, however little of it the ink fills; hair-thin strokes."""

import pytest

from tests.svg.pictures import assert_shows, svg

PAGE = 'viewBox="0 0 100 100"'
PLAIN = '<path d="M50 50h30v10H50z"/><circle cx="60" cy="70" r="5"/>'
PARTS = {
    "of shapes": '<rect x="50%" y="50%" width="30%" height="10%"/>'
    '<circle cx="60%" cy="70%" r="5%"/>',
    "in style": '<rect style="x:50%;y:50%;width:30%;height:10%"/>'
    '<circle style="cx:60%;cy:70%;r:5%"/>',
    "of lines": '<line x1="50%" y1="55%" x2="80%" y2="55%" stroke="#000" stroke-width="10%"/>'
    '<ellipse cx="60%" cy="70%" rx="5%" ry="5%"/>',
    "inherited": '<g stroke-width="10%"><path d="M50 55H80" stroke="#000"/></g>'
    '<circle cx="60" cy="70" r="5"/>',
    "of dashes": '<path d="M50 55H99" stroke="#000" stroke-width="10" stroke-dasharray="30%,90%"/>'
    '<circle cx="60" cy="70" r="5"/>',
    "in a clip path": '<clipPath id="c"><rect x="50%" y="50%" width="30%" height="25%"/></clipPath>'
    '<g clip-path="url(#c)"><path d="M0 50h99v10H0z"/><circle cx="60" cy="70" r="5"/></g>',
    "in a mask": '<mask id="m" maskUnits="userSpaceOnUse" x="0" y="0" width="100" height="100">'
    '<rect x="50%" y="50%" width="30%" height="25%" fill="#fff"/></mask>'
    '<g mask="url(#m)"><path d="M0 50h99v10H0z"/><circle cx="60" cy="70" r="5"/></g>',
    "in a viewport": '<svg x="50%" y="50%" width="30%" height="30%" viewBox="0 0 60 60">'
    '<rect width="100%" height="20"/><circle cx="20" cy="40" r="10"/></svg>',
}  # fmt: skip


@pytest.mark.parametrize("kind", PARTS)
def test_percentages_are_parts_of_the_page(kind):
    assert_shows(svg(PARTS[kind], PAGE), f'<svg viewBox="0 0 100 100">{PLAIN}</svg>', least=0.97)


FACE = (
    '<circle cx="12" cy="12" r="10" fill="#fd4"/><path d="M7 8h2v3H7zM15 8h2v3h-2z" fill="#333"/>'
)


@pytest.mark.thorough
@pytest.mark.thorough(but=1)
@pytest.mark.parametrize(
    "stroke",
    [
        'stroke="#000" stroke-width="0.00064"',
        'stroke="#f0f" stroke-width="0.01"',
        'stroke="#000" stroke-width="0"',
        'stroke="#000" stroke-width=".03"',
        'stroke="#000" stroke-opacity="0"',
    ],
)
def test_a_stroke_that_nobody_sees_beside_a_fill_is_no_line(stroke):
    assert_shows(svg(f"<g {stroke}>{FACE}</g>"), FACE)


def test_a_hairline_in_the_colour_of_its_fill_changes_nothing():
    square = '<path d="M4 4h16v16H4z" fill="#000"{}/>'
    assert_shows(svg(square.format(' stroke="#000" stroke-width=".05"')), square.format(""))


@pytest.mark.thorough
def test_a_hairline_around_white_is_its_line():
    page = '<path d="M3 3h18v18H3z" fill="#fff" stroke="#000" stroke-width="{}"/>'
    dot = '<circle cx="12" cy="12" r="4" fill="#24c" stroke="#000" stroke-width="{}"/>'
    body = page.format(".03") + dot.format(".03")
    assert_shows(svg(body), page.format(".2") + dot.format("0"), 0.9, remarks=["too thin"])


def test_a_hairline_alone_is_still_drawn_thicker_and_told():
    lines = '<path d="M3 3h18v6H3z"/><path d="M3 15h18" fill="none" stroke="#000"{}/>'
    thin = svg(lines.format(' stroke-width=".02"'))
    assert_shows(thin, lines.format(' stroke-width=".35"'), 0.9, remarks=["too thin"])
