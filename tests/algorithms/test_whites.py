"""White on colour: what bites into a colour is paper, what is a shape of its own is ink."""

import numpy as np
import pytest

from iconstudio.algorithms.tones.tone import Paints, paints
from tests.algorithms.test_tone import amiss, pictogram, rgba

BOX = "0 0 100 100"
MOON = '<circle cx="45" cy="50" r="40" fill="{}"/>'
DISC = '<circle cx="65" cy="42" r="34" fill="{}"/>'
APPLE = '<path d="M50 25c10-15 40-5 40 20s-20 50-30 50-5-4-10-4-2 4-12 4-28-25-28-50 30-35 40-20z"'
LEAF = '<path d="M50 21c0-10 8-18 16-20 0 10-6 18-16 20z" fill="#2a2"/>'
CLOUD = '<path d="M25 85a18 18 0 0 1 0-36a22 22 0 0 1 42-4a20 20 0 0 1 10 40z" fill="#fff"/>'

BITES = {
    "crescent": (MOON.format("#000"), DISC.format("#fff")),
    "blue crescent": (MOON.format("#246"), DISC.format("#fff")),
    "yellow crescent": (MOON.format("#fc3"), DISC.format("#fefefe")),
    "shallow bite": (MOON.format("#000"), '<circle cx="85" cy="22" r="20" fill="#fff"/>'),
    "deep bite": (
        '<circle cx="35" cy="50" r="30" fill="#222"/>',
        '<circle cx="65" cy="50" r="34" fill="#fff"/>',
    ),
    "apple": (f'{APPLE} fill="#c22"/>{LEAF}', '<circle cx="95" cy="50" r="18" fill="#fff"/>'),
    "wedge": (
        '<circle cx="50" cy="50" r="40" fill="#fc0"/>',
        '<path d="M50 50L100 20V80z" fill="#fff"/>',
    ),
    "letter": (
        '<rect x="10" y="10" width="60" height="60" fill="#06c"/>',
        '<path d="M40 30h55v18h-18v45h-18v-45h-19z" fill="#fff"/>',
    ),
    "band": (
        '<circle cx="50" cy="50" r="35" fill="#06c"/>',
        '<path d="M5 90L95 10" stroke="#fff" stroke-width="26"/>',
    ),
}


@pytest.mark.parametrize("kind", BITES)
def test_pure_white_that_bites_into_a_colour_is_paper(kind):
    colour, white = BITES[kind]
    drawing = rgba(colour + white, box=BOX)
    right = np.where(rgba(white, box=BOX)[..., 3] > 127, 0, rgba(colour, box=BOX)[..., 3])
    coverage = pictogram(drawing)
    assert amiss(coverage, right) < 0.03
    if kind != "apple":  # whose leaf a line sets off
        assert paints(drawing, coverage) is Paints.DARK


def test_what_is_drawn_on_a_bite_in_the_same_colour_is_ink():
    gear = '<path d="M39 5h12v30h30v12h-80v-12h38zM39 47h12v34h-12z" fill="#555"/>'
    badge = '<circle cx="72" cy="72" r="24" fill="#fff"/>'
    disc, plus = '<circle cx="45" cy="45" r="30" fill="#555"/>', "M60 72h24M72 60v24"
    sign = f'<path d="{plus}" stroke="#555" stroke-width="7"/>'
    right = np.where(
        rgba(badge, box=BOX)[..., 3] > 127,
        rgba(sign, box=BOX)[..., 3],
        rgba(gear + disc, box=BOX)[..., 3],
    )
    assert amiss(pictogram(rgba(gear + disc + badge + sign, box=BOX)), right) < 0.03


SHAPES = {
    "cloud before the sun": f'<circle cx="65" cy="35" r="25" fill="#fc3"/>{CLOUD}',
    "cloud before much of the sun": (
        '<circle cx="60" cy="40" r="35" fill="#fc3"/>'
        '<path d="M20 90a16 16 0 0 1 0-32a20 20 0 0 1 38-4a18 18 0 0 1 10 36z" fill="#fff"/>'
    ),
    "sheep": (
        '<path d="M30 60h8v30h-8zM55 60h8v30h-8z" fill="#333"/><circle cx="78" cy="38" r="14" '
        'fill="#333"/><circle cx="45" cy="45" r="30" fill="#fff"/>'
    ),
    "panda": (
        '<circle cx="22" cy="25" r="15"/><circle cx="78" cy="25" r="15"/>'
        '<circle cx="50" cy="55" r="40" fill="#fff"/>'
        '<circle cx="36" cy="50" r="8"/><circle cx="64" cy="50" r="8"/>'
    ),
    "egg": (
        '<path d="M10 50a30 30 0 0 1 60-25a25 25 0 0 1 20 40a30 25 0 0 1-50 15a30 30 0 0 1-30-30z"'
        ' fill="#fff"/><circle cx="48" cy="48" r="17" fill="#fb0"/>'
    ),
    "pill": (
        '<path d="M50 30h25a20 20 0 0 1 0 40H50z" fill="#fff"/>'
        '<path d="M50 30H25a20 20 0 0 0 0 40H50z" fill="#e33"/>'
    ),
    "badge": (
        '<circle cx="45" cy="45" r="40" fill="#39f"/><circle cx="78" cy="78" r="20" fill="#fff"/>'
        '<path d="M70 78h16M78 70v16" stroke="#3a3" stroke-width="5"/>'
    ),
    "off-white disc": MOON.format("#246") + DISC.format("#f5f5f5"),
}


@pytest.mark.parametrize("kind", SHAPES)
def test_white_shapes_beside_a_colour_are_ink(kind):
    drawing = rgba(SHAPES[kind], box=BOX)
    white = (drawing[..., :3] > 240).all(axis=2) & (drawing[..., 3] > 127)
    assert (pictogram(drawing)[white] > 127).mean() > 0.8


@pytest.mark.parametrize("grey", ["#d2d3d4", "#ccc", "#bbb", "#999"])
def test_grey_beside_white_that_is_paper_is_kept(grey):
    """A chart of a white disc and a ring in two colours."""
    chart = (
        '<circle cx="50" cy="50" r="38" fill="#fff"/><g fill="none" stroke-width="14">'
        f'<circle cx="50" cy="50" r="38" stroke="{grey}"/>'
        '<path d="M50 12a38 38 0 1 1 -22 69" stroke="#ce4b99"/></g>'
    )
    drawing = rgba(chart, box=BOX)
    coverage = pictogram(drawing) > 127
    ring = (
        rgba(
            '<circle cx="50" cy="50" r="38" fill="none" stroke="#000" stroke-width="14"/>', box=BOX
        )[..., 3]
        > 127
    )
    assert coverage[ring].mean() > 0.9 and coverage[~ring].mean() < 0.01
