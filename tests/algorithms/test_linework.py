"""Shapes that the lines of a drawing do not enclose: parts of it, or decoration."""

import re

import numpy as np
import pytest

from iconstudio.algorithms.tones.alternation import Omission
from iconstudio.algorithms.tones.resolution import SIDE
from iconstudio.algorithms.tones.tone import pictogram
from tests.algorithms.test_tone import amiss, ink, path, rgba

pytestmark = pytest.mark.thorough(but=1)

CUP = "M5 4h14v6a7 7 0 0 1-14 0z"
HANDLES = '<path d="M5 5H2v3a4 4 0 0 0 4 4M19 5h3v3a4 4 0 0 1-4 4M12 17v4M7 22h10"'
CLOUD = '<path d="M7 19a4 4 0 0 1 0-8 5 5 0 0 1 9.6-1A4.5 4.5 0 0 1 17 19z"'
PERSON = '<path d="M2 21c0-6 3-8 7-8s7 2 7 8zM5 7a4 4 0 0 0 8 0 4 4 0 0 0-8 0z"'
PAGE = '<path d="M3 2h9l4 4v12H3z"'
RING = '<circle cx="{}" cy="{}" r="6"'
LINES = ' fill="none" stroke="#111" stroke-width="{}"/>'
WIDE, THIN = LINES.format(2), LINES.format(0.8)
CHECK = '<path d="M15.5 17l2 2 3-4" stroke="#fff" stroke-width="1.5" fill="none"/>'

PARTS = {
    "square": ('<rect x="2" y="2" width="12" height="12" fill="#f00"/>', RING.format(15, 15)),
    "disc": ('<circle cx="8" cy="12" r="6.5" fill="#2979ff"/>', RING.format(17, 12)),
    "cup": (f'<path d="{CUP}" fill="#90caf9"/>', HANDLES),
    "sun": ('<circle cx="16" cy="8" r="5" fill="#fbc02d"/>', CLOUD),
    "badge": ('<circle cx="18" cy="17" r="5" fill="#2e7d32"/>', PERSON),
    "sheet": ('<path d="M10 9h12v13H10z" fill="#42a5f5"/>', PAGE),
    "quarter": ('<path d="M12 12V1a11 11 0 0 1 11 11z" fill="#e55"/>', RING.format(11, 13)),
}


@pytest.mark.parametrize("lines", [WIDE, THIN], ids=["wide", "thin"])
@pytest.mark.parametrize("kind", PARTS)
def test_a_shape_that_lines_enclose_in_part_is_a_part_of_the_drawing(kind, lines):
    shape, line = (PARTS[kind][0], PARTS[kind][1] + lines)
    coverage, omissions = pictogram(rgba(shape + line, SIDE))
    assert not omissions
    drawn, whole = ink(line, SIDE), ink(shape + line, SIDE)
    assert coverage[drawn > 200].mean() > 220  # the lines keep their width
    shown = (coverage > 127) & (drawn < 128)
    assert shown.sum() > 0.7 * ((whole > 127) & (drawn < 128)).sum()
    assert (coverage[whole < 100] < 128).all()


def test_what_is_drawn_on_a_part_stays():
    drawing = PARTS["badge"][0] + PERSON + WIDE + CHECK
    coverage, _ = pictogram(rgba(drawing, SIDE))
    assert coverage[ink(CHECK, SIDE) > 200].mean() < 20


DECORATED = {
    "fill moved": ('<path d="M6 6h15v15H6z" fill="#9cf"/>', '<path d="M3 3h15v15H3z"'),
    "disc moved": (
        '<circle cx="14" cy="13" r="8" fill="#fc6"/>',
        '<circle cx="11" cy="11" r="8.5"',
    ),
    "blob behind": (
        '<circle cx="13" cy="12" r="9" fill="#ffd6a5"/>',
        '<path d="M4 11l8-7 8 7v9H4zM10 20v-6h4v6"',
    ),
}


@pytest.mark.parametrize("kind", DECORATED)
def test_colour_behind_lines_is_left_out_and_told(kind):
    shape, line = DECORATED[kind]
    coverage, omissions = pictogram(rgba(shape + line + WIDE, SIDE))
    assert amiss(coverage, ink(line + WIDE, SIDE)) < 0.03
    assert omissions == {Omission.DECORATION}


HOME = '<path d="M4 11l8-7 8 7v8H4zM10 19v-6h4v6"'
SHADOWS = {
    "below": '<ellipse cx="12" cy="22" rx="9" ry="1.8" fill="#e0e0e0"/>',
    "touching": '<ellipse cx="12" cy="20.5" rx="10" ry="2.5" fill="#e0e0e0"/>',
    "thrown": '<path d="M20 11l3 3v8H8l-3-2h15z" fill="#dde"/>',
}


@pytest.mark.parametrize("width", [0.8, 1.5])
@pytest.mark.parametrize("kind", SHADOWS)
def test_a_pale_shadow_beside_lines_without_fills_is_left_out_and_told(kind, width):
    line = HOME + LINES.format(width)
    coverage, omissions = pictogram(rgba(SHADOWS[kind] + line, SIDE))
    assert amiss(coverage, ink(line, SIDE)) < 0.01
    assert omissions == {Omission.DECORATION}


BESIDE = {
    "line of a second tone": '<path d="M2 22h20" stroke="#ccc" stroke-width="1.5"/>',
    "pale shape within": '<rect x="8" y="8" width="8" height="7" fill="#ddd"/>',
    "coloured shape": '<ellipse cx="12" cy="22" rx="9" ry="1.8" fill="#f90"/>',
}


@pytest.mark.parametrize("kind", BESIDE)
def test_what_is_no_shadow_beside_lines_without_fills_is_ink(kind):
    drawing = BESIDE[kind] + '<rect x="4" y="4" width="16" height="15"' + LINES.format(1.5)
    coverage, omissions = pictogram(rgba(drawing, SIDE))
    assert amiss(coverage, ink(drawing, SIDE)) < 0.01
    assert not omissions


HAND = '<path d="M3 5h18v10H11l-3 3-5-3z" fill="#bb8c65"/>'
SHADE = '<path d="M3 5v10l5 3 3-3h10{}" fill="none" stroke="#5c3527" stroke-width="{}"/>'


@pytest.mark.parametrize("width", [0.8, 1.1])
@pytest.mark.parametrize("more", ["M3 9h6v6", "M3 10h5v7", "M8 9h-3v5h5v-3"])
def test_a_shape_with_lines_along_one_side_is_ink(more, width):
    drawing = HAND + SHADE.format(more, width)
    coverage, omissions = pictogram(rgba(drawing, SIDE))
    assert (coverage[ink(drawing, SIDE) > 127] > 127).mean() > 0.8
    assert not omissions


FILLED = {
    "whole": '<path d="M4 5h16v14H4z" fill="#ffe082" stroke="#111" stroke-width="2"/>',
    "gap": '<path d="M4 5h16v14H4z" fill="#ffe082"/><path d="M12 5h8v14H4V5h4"' + WIDE,
    "dashes": '<circle cx="12" cy="12" r="9" fill="#fc8" stroke="#111" stroke-width="2" '
    'stroke-dasharray="3 1.5"/>',
    "open below": '<path d="M5 19v-4a7 7 0 0 1 14 0v4" fill="#9cf" stroke="#111"/>',
}


@pytest.mark.parametrize("kind", FILLED)
def test_a_fill_is_paper_also_where_its_outline_has_gaps(kind):
    drawing = FILLED[kind]
    coverage, omissions = pictogram(rgba(drawing, SIDE))
    lines = re.sub('fill="#[0-9a-f]+"', 'fill="none"', drawing)
    assert amiss(coverage, ink(lines, SIDE)) < 0.03
    assert not omissions


def test_lines_of_a_second_colour_are_lines():
    frame = '<rect x="2" y="2" width="20" height="20" fill="none" stroke="#00a" stroke-width="2"/>'
    grid = '<path d="M9 3v18M15 3v18" stroke="#a9c" stroke-width="1.5"/>'
    coverage, omissions = pictogram(rgba(frame + grid, SIDE))
    assert amiss(coverage, ink(frame + grid, SIDE)) < 0.05
    assert not omissions


@pytest.mark.parametrize(("screen", "bars"), [("#e0e0e0", "#9e9e9e"), ("#fff", "#bbb")])
def test_greys_that_lie_free_on_a_screen_are_ink(screen, bars):
    phone = (
        '<rect x="5" y="1" width="14" height="22" rx="2" fill="#111"/>'
        f'<path d="M7 3h10v18h-10z" fill="{screen}"/>'
    )
    marks = "M8.5 5h7v3h-7zM8.5 10h7v2h-7z"
    coverage = pictogram(rgba(phone + f'<path d="{marks}" fill="{bars}"/>')).coverage > 127
    expected = rgba(f'<path d="{marks}"/>')[..., 3] > 127
    assert coverage[expected].mean() > 0.9
    frame = rgba('<path d="M7.3 3.3h9.4v17.4h-9.4z"/>')[..., 3] > 127
    assert not coverage[frame & ~expected].mean() > 0.1


@pytest.mark.parametrize(
    ("frame", "dark", "light"),
    [
        ("#5d4037", "#b58863", "#f0d9b5"),
        ("#0d2b52", "#4a90d9", "#dde8f4"),
        ("#222", "#888", "#eee"),
    ],
)
def test_the_squares_of_a_board_with_a_frame_stay(frame, dark, light):
    places = [(x, y) for x in range(8) for y in range(8)]
    squares = "".join(
        f'<path d="M{2.4 * x + 2.4} {2.4 * y + 2.4}h2.4v2.4h-2.4z" fill="{colour}"/>'
        for x, y in places
        for colour in [(light, dark)[(x + y) % 2]]
    )
    edge = f'<path d="M2 2h20v20H2z" fill="none" stroke="{frame}" stroke-width=".8"/>'
    coverage = pictogram(rgba(squares + edge, SIDE)).coverage
    middles = ((2.4 * np.array(places) + 3.6) * SIDE / 24).astype(int)
    shown = coverage[middles[:, 1], middles[:, 0]] > 127
    assert (shown == [(x + y) % 2 for x, y in places]).all()


BEAK = '<path d="M10.5 11h3l-1.500 2z" fill="{}"/>'
PENGUIN = (
    '<ellipse cx="12" cy="12" rx="9" ry="11" fill="#263238"/>'
    '<ellipse cx="12" cy="13" rx="7" ry="9" fill="#fafafa"/>'
)


def test_a_small_part_in_a_strong_colour_on_white_is_ink():
    beak = BEAK.format("#ff9800")
    drawn = pictogram(rgba(PENGUIN + beak, SIDE)).coverage
    there = ink(beak, SIDE) > 127
    assert (drawn[there] > 127).mean() > 0.9
    pale = pictogram(rgba(PENGUIN + BEAK.format("#f0e8d0"), SIDE)).coverage
    assert (pale[there] > 127).mean() < 0.1


def test_the_counter_of_a_white_letter_is_as_what_is_around_it():
    sign = '<rect x="2" y="2" width="20" height="20" rx="2" fill="#1565c0" stroke="#111"/>'
    letter = path(
        "M8.500 6h5a3.500 3.500 0 0 1 0 7.500h-2.500v5h-2.500zM11 8.500v2.500h2v-2.500z", "#fff"
    )
    drawn = pictogram(rgba(sign + letter, SIDE)).coverage > 127
    within = ink('<rect x="4" y="4" width="16" height="16"/>', SIDE) > 127
    right = ink(letter, SIDE) > 127
    assert (drawn != right)[within].sum() < 0.05 * right.sum()
