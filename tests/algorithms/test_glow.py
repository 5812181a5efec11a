"""A glow around a drawing is no part of it; what fades without a drawing in it is the drawing."""

import pytest

from iconstudio.algorithms.tones import tone
from iconstudio.algorithms.tones.alternation import Omission
from tests.algorithms.test_tone import amiss, ink, rgba

GLOW = (
    '<radialGradient id="g"><stop offset="{}" stop-color="{colour}"/>'
    '<stop offset="1" stop-color="{colour}" stop-opacity="0"/></radialGradient>'
    '<circle cx="12" cy="11" r="11" fill="url(#g)"/>'
)
BLUR = (
    '<filter id="b"><feGaussianBlur stdDeviation="1.5"/></filter>'
    '<circle cx="12" cy="12" r="8" fill="#4fc3f7" filter="url(#b)"/>'
)
BULB = (
    '<path d="M8 12a4 4 0 1 1 8 0q-1 2-2 3v2h-4v-2q-1-1-2-3z" fill="#ffb703"/>'
    '<path d="M10 18h4v3h-4z" fill="#495057"/>'
)
SUN = (
    '<circle cx="12" cy="11" r="4.5" fill="#ffb300"/>'
    '<path d="M12 2v3M12 17v3M3 11h3M18 11h3" stroke="#ffb300" stroke-width="1.5"/>'
)
STAR = '<path d="M12 6l2 4 4 .5-3 3 1 4-4-2-4 2 1-4-3-3 4-.5z" fill="#0d47a1"/>'


@pytest.mark.parametrize(
    ("glow", "body"),
    [
        (GLOW.format(0.3, colour="#ffe14d"), BULB),
        (GLOW.format(0, colour="#fff3b0"), SUN),
        (BLUR, STAR),
    ],
    ids=["bulb", "sun", "star"],
)
def test_a_glow_around_a_drawing_is_left_out_and_told(glow, body):
    found = tone.pictogram(rgba(glow + body))
    assert found.omissions == {Omission.GLOW}
    assert amiss(found.coverage, ink(body)) < 0.03


CANDLE = '<path d="M10 7h4v10h-4z" fill="#fff"/>'


@pytest.mark.parametrize("body", ["", CANDLE], ids=["alone", "white"])
def test_a_glow_that_is_all_there_is_stays(body):
    found = tone.pictogram(rgba(GLOW.format(0.5, colour="#ffe14d") + body))
    assert Omission.GLOW not in found.omissions
    assert (found.coverage > 127).mean() > 0.2


def test_a_puff_beside_a_drawing_stays():
    puff = BLUR.replace('cx="12" cy="12" r="8"', 'cx="17" cy="17" r="4"')
    found = tone.pictogram(rgba(puff + '<path d="M1 1h11v11H1z" fill="#0d47a1"/>'))
    assert Omission.GLOW not in found.omissions
    assert found.coverage[363, 363] > 200
