"""Hair gaps between shapes of different colours are closed, and nothing else is."""

import numpy as np
import pytest

from iconstudio.algorithms.tones.seams import without_seams

SIDE = 512
ORANGE, DARK = (248, 195, 0, 255), (51, 51, 51, 255)
ROWS, COLUMNS = np.mgrid[:SIDE, :SIDE] - SIDE // 2
RADIUS = np.hypot(ROWS, COLUMNS)


def disc_in_ring(gap, inner=DARK):
    """Return a disc in a ring of another colour, which a gap of some pixels parts."""
    rgba = np.zeros((SIDE, SIDE, 4), np.uint8)
    rgba[RADIUS < 240] = ORANGE
    rgba[100 + gap / 2 > RADIUS] = 0
    rgba[100 - gap / 2 > RADIUS] = inner
    return rgba


@pytest.mark.parametrize("gap", [1, 2, 3])
def test_a_seam_is_closed_and_each_side_goes_on_to_its_middle(gap):
    closed = without_seams(disc_in_ring(gap))
    assert (
        closed[RADIUS < 240] == np.where(RADIUS[..., None] < 100, DARK, ORANGE)[RADIUS < 240]
    ).all(axis=1).mean() > 0.995
    assert (closed[RADIUS < 240, 3] == 255).all()
    assert not closed[RADIUS > 241].any()


def test_a_seam_that_shows_half_through_is_closed():
    rgba = disc_in_ring(2)
    rgba[(rgba[..., 3] == 0) & (RADIUS < 200)] = (150, 120, 20, 128)
    assert (without_seams(rgba)[RADIUS < 240, 3] == 255).all()


@pytest.mark.parametrize(
    "rgba",
    [
        pytest.param(disc_in_ring(8), id="a gap that shows"),
        pytest.param(disc_in_ring(2, ORANGE), id="a slit in one colour"),
        pytest.param(np.zeros((SIDE, SIDE, 4), np.uint8), id="nothing"),
    ],
)
def test_what_is_meant_stays(rgba):
    assert without_seams(rgba) is rgba


def test_a_line_that_ends_beside_another_stays():
    rgba = np.zeros((SIDE, SIDE, 4), np.uint8)
    rgba[100:400, 100:110] = DARK
    rgba[200:206, 113:300] = ORANGE
    assert without_seams(rgba) is rgba
