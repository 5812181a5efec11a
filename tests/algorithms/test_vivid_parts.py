"""Yellow and orange between white and cream: other colours, though hardly darker ones."""

import numpy as np
import pytest
import scipy

from tests.algorithms.test_tone import ink, pictogram, rgba

pytestmark = pytest.mark.thorough(but=1)

EYES = '<circle cx="8.7" cy="8" r="3.2" fill="#fff"/><circle cx="15.3" cy="8" r="3.2" fill="#fff"/>'
OWL = f'<ellipse cx="12" cy="13" rx="8" ry="9.5" fill="#7a4a1e"/>{EYES}'
BELLY = '<ellipse cx="12" cy="16" rx="5.5" ry="5.5" fill="#f3dfb8"/>'
PUPILS = '<circle cx="8.7" cy="8" r="1.4"/><circle cx="15.3" cy="8" r="1.4"/>'
PENGUIN = (
    '<ellipse cx="12" cy="13" rx="8" ry="10" fill="#34495e"/>'
    '<ellipse cx="12" cy="14" rx="5.5" ry="8" fill="#fff"/>'
)
BADGE = '<circle cx="12" cy="12" r="11" fill="#6a1b9a"/><circle cx="12" cy="12" r="6" fill="#fff"/>'
BEAK = "M12 9.5l1.8 2.4-1.8 2.4-1.8-2.4z"
HALF = "M12 6a6 6 0 0 0 0 12z"

KINDS = {
    "owl": (OWL + BELLY + PUPILS, BEAK),
    "penguin": (PENGUIN, BEAK),
    "badge": (BADGE, HALF),
}


@pytest.mark.parametrize("colour", ["#f5a623", "#ffcc00", "#ff9800"])
@pytest.mark.parametrize("kind", KINDS)
def test_a_vivid_part_shows_on_pale_ones(kind, colour):
    below, part = KINDS[kind]
    shape = f'<path d="{part}" fill="{colour}"/>'
    drawn = pictogram(rgba(below + shape)) > 127
    inside = ink(shape) > 127
    contour = inside & ~scipy.ndimage.binary_erosion(inside)
    edges = scipy.ndimage.maximum_filter(drawn, 13) != scipy.ndimage.minimum_filter(drawn, 13)
    assert np.mean(edges[contour]) > 0.85


def test_the_white_of_small_eyes_in_a_yellow_face_is_paper():
    face = '<circle cx="12" cy="12" r="9" fill="{}" stroke="#321" stroke-width="1.5"/>'
    eyes = '<path d="M7 10h2.4v2.4H7zM14.6 10H17v2.4h-2.4z" fill="#fff"/>'
    pupils = '<path d="M7.6 10.6h1.2v1.2H7.6zM15.2 10.6h1.2v1.2h-1.2z" fill="#321"/>'
    yellow, white = (
        pictogram(rgba(face.format(fill) + eyes + pupils)) > 127 for fill in ("#ffc83d", "#fff")
    )
    assert (yellow != white).sum() < 60
