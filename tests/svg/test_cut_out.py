"""Shapes that were cut out of each other, as tracers of bitmaps do: hair gaps part them."""

import numpy as np
import pytest

from tests.svg.pictures import ink, overlap, svg

FACE = 'viewBox="0 0 100 100"'
WHOLE = '<circle cx="50" cy="50" r="45" fill="#f8c300"/>'
EYES = "".join(f'<circle cx="{x}" cy="42" r="9" fill="#333"/>' for x in (33, 67))


def hole(x, radius, corners, aside=0.0):
    """Return the outline of a hole as a polygon."""
    turns = np.arange(corners) * 2 * np.pi / corners
    points = (f"{x + aside + radius * np.cos(t):.2f} {42 + radius * np.sin(t):.2f}" for t in turns)
    return f"M{'L'.join(points)}z"


def face(radius, corners, aside=0.0):
    holes = "".join(hole(x, radius, corners, aside) for x in (33, 67))
    return svg(
        f'<path fill="#f8c300" fill-rule="evenodd" d="M50 5a45 45 0 1 0 .01 0z{holes}"/>{EYES}',
        FACE,
    )


@pytest.mark.thorough(but=1)
@pytest.mark.parametrize(
    ("radius", "corners", "aside"),
    [(9, 40, 0.4), (9.3, 40, 0), (9.05, 60, 0), (9, 12, 0), (9.6, 9, 0)],
)
def test_eyes_are_as_on_a_whole_face(radius, corners, aside):
    cut, right = ink(face(radius, corners, aside)), ink(svg(WHOLE + EYES, FACE))
    eye = np.s_[70:140, 50:115]
    assert overlap(~cut[eye], ~right[eye]) > 0.85
    assert overlap(cut, right) > 0.985


def test_a_ring_of_the_ground_that_shows_is_drawn():
    assert ink(face(12, 40))[42 * 256 // 100, 85]
    assert not ink(svg(WHOLE + EYES, FACE))[42 * 256 // 100, 85]
