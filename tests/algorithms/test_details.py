"""What is fine in a drawing: letters, dots and hairlines on paper, and faint parts."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.tones import tone
from iconstudio.algorithms.tones.alternation import Omission
from iconstudio.algorithms.tones.resolution import SIDE
from tests.algorithms.test_tone import amiss, ink, path, pictogram, rgba

pytestmark = pytest.mark.thorough(but=1)

FINE = 2 * SIDE
"""Pixels to a side of what is read from files."""
PAGE = '<rect width="24" height="24" fill="{}"/>'
LETTERS = "".join(
    f'<circle cx="{x}" cy="{y}" r="{r}" fill="none" stroke="#000" stroke-width="{r / 3}"/>'
    f'<circle cx="{x + 1.5}" cy="{y}" r="{r / 5}"/>'
    f'<path d="M{x - 1} {y + r}v{-3 * r}h.2v{3 * r}z"/>'
    for x, y, r in ((4, 4, 0.6), (8, 4, 0.45), (12, 4, 0.36), (4, 20, 0.3), (8, 20, 0.24))
)
"""As an o, a dot and an l, of several sizes."""
DISC = '<circle cx="17" cy="13" r="4" fill="{}"/>'


@st.composite
def drawings(draw) -> str:
    """Lines, dashes and dots in black, from hairlines up."""
    places = st.integers(3, 21)
    parts = ['<path d="M3 3h4v-1" fill="none" stroke="#000" stroke-width=".3"/>']
    for _ in range(draw(st.integers(1, 5))):
        x, y, to_x, to_y = (draw(places) for _ in range(4))
        width = draw(st.sampled_from([0.03, 0.06, 0.12, 0.3, 0.8]))
        dashes = draw(st.sampled_from(["", 'stroke-dasharray=".2"', 'stroke-dasharray="1 .5"']))
        line = f"M{x} {y}Q{y} {to_x} {to_x} {to_y}"
        parts.append(
            f'<path d="{line}" fill="none" stroke="#000" stroke-width="{width}" {dashes}/>'
            f'<circle cx="{to_x}" cy="{y}" r="{width}"/>'
        )
    return "".join(parts)


@pytest.mark.thorough
@settings(max_examples=12)
@given(drawings(), st.sampled_from(["#fff", "#fafafa", "#fde", "#fff2cc", "#ececff"]))
def test_black_on_pale_paper_is_the_drawing_without_it(drawing, paper):
    right = ink(drawing, SIDE)
    coverage = pictogram(rgba(PAGE.format(paper) + drawing, SIDE))
    assert abs(coverage.astype(int) - right).max() <= 10


def test_a_drawing_may_be_of_any_dark_colour_on_its_page():
    coloured = f'<g fill="#1565c0">{LETTERS.replace("#000", "#1565c0")}</g>'
    coverage = pictogram(rgba(PAGE.format("#fff") + coloured))
    assert abs(coverage.astype(int) - ink(coloured)).max() <= 10


@pytest.mark.thorough
@pytest.mark.parametrize("paper", ["#fff", "#fff2cc"])
def test_letters_stay_beside_other_colours(paper):
    disc = DISC.format("#e00")
    coverage = pictogram(rgba(PAGE.format(paper) + LETTERS + disc))
    assert amiss(coverage, ink(LETTERS + disc)) < 0.04


@pytest.mark.thorough
def test_letters_stay_as_holes_of_what_is_ink():
    sign = '<rect width="24" height="24" rx="9" fill="#fc0"/>'
    disc = DISC.format("#fff")
    coverage = pictogram(rgba(sign + LETTERS + disc))
    right = ink(sign).astype(int) - ink(LETTERS + disc)
    assert amiss(255 - coverage, 255 - right) < 0.08


def test_white_letters_stay_as_holes_of_what_is_ink():
    white = f'<g fill="#fff">{LETTERS.replace("#000", "#fff")}</g>'
    sign = '<rect width="24" height="24" rx="9" fill="#1976d2"/>'
    coverage = pictogram(rgba(sign + white + DISC.format("#fc0")))
    right = ink(sign).astype(int) - ink(white + DISC.format("#fc0"))
    assert amiss(255 - coverage, 255 - right) < 0.08


def test_a_thin_outline_of_another_colour_goes_around_pale_paper():
    box = '<rect x="2" y="7" width="20" height="10" fill="{}" stroke="#d6b656" stroke-width=".12"/>'
    letters = f'<g transform="translate(1 8) scale(.8 .5)">{LETTERS}</g>'
    coverage = pictogram(rgba(box.format("#fff2cc") + letters, FINE))
    assert amiss(coverage, ink(box.format("none") + letters, FINE)) < 0.1


@pytest.mark.parametrize("opacity", [0.1, 0.2, 0.4])
@pytest.mark.parametrize("colour", ["#000", "#fc0"])
def test_what_is_faint_is_left_out_and_told(opacity, colour):
    body = path("M4 4h12v12H4z", colour)
    shadow = f'<ellipse cx="12" cy="16" rx="10" ry="4" opacity="{opacity}"/>'
    coverage, omissions = tone.pictogram(rgba(shadow + body, FINE))
    right = ink(body, FINE)
    assert omissions == {Omission.FAINT}
    assert np.array_equal(coverage > 127, right > 127)
    assert coverage[right == 0].max() == 0


def test_hairlines_are_not_faint():
    lines = '<path d="M2 5h20M2 9l20 4" stroke="#000" stroke-width=".01"/>'
    body = path("M4 14h12v6H4z")
    coverage, omissions = tone.pictogram(rgba(lines + body))
    assert not omissions
    assert np.array_equal(coverage, ink(lines + body))
