"""A glow drawn as several shapes around a drawing is no part of it; around a point, it is."""

import pytest

from iconstudio.algorithms.tones.halo import without_halo
from iconstudio.svg.omitted import OMITTED
from iconstudio.svg.reading import own_svg
from tests.algorithms.test_glow import BULB, STAR
from tests.algorithms.test_tone import amiss, ink, rgba

RINGS = '<circle cx="12" cy="12" r="{}" fill="#ffe14d" opacity="{}"/>'
TWO = RINGS.format(11.5, 0.25) + RINGS.format(9.5, 0.3)
CLOCK = (
    '<circle cx="12" cy="12" r="7" fill="#ffc107"/>'
    '<path d="M12 7v5l3 2" stroke="#5d4037" stroke-width="1.5" fill="none"/>'
)
POINT = '<circle cx="12" cy="12" r="4" fill="#2196f3"/>'
AROUND = "".join(
    f'<g stroke="#ff0" stroke-width="{wide}" stroke-linejoin="round" opacity=".3">{STAR}</g>'
    for wide in (6, 3)
)


@pytest.mark.parametrize(
    ("halo", "body"),
    [(TWO, BULB), (TWO + RINGS.format(10.5, 0.3), BULB), (TWO, CLOCK), (AROUND, STAR)],
    ids=["two", "three", "around a face", "of the drawing's shape"],
)
def test_a_halo_around_a_drawing_is_left_out(halo, body):
    rest = without_halo(rgba(halo + body))
    assert rest is not None
    assert amiss(rest[..., 3], ink(body)) < 0.01


@pytest.mark.parametrize(
    "drawing",
    [
        TWO + POINT,
        RINGS.format(11, 0.3) + STAR,
        RINGS.format(11, 1) + RINGS.format(8, 1) + STAR,
        TWO.replace("12", "8") + BULB,
        BULB,
        "",
    ],
    ids=["waves around a point", "second tone", "opaque", "to one side", "none", "nothing"],
)
def test_what_is_no_halo_stays(drawing):
    assert without_halo(rgba(drawing)) is None


def test_it_is_told():
    svg = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24">{}</svg>'
    (glow,) = (said for what, said in OMITTED.items() if what.name == "GLOW")
    assert own_svg(svg.format(TWO + BULB).encode(), "a.svg").remarks == (glow,)
