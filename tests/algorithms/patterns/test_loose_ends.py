"""Lines that end where they should not are joined, go on beneath what hides them, or are gone."""

import numpy as np
import pytest
from scipy import ndimage

from iconstudio.algorithms.patterns.exemplar import Exemplar
from iconstudio.algorithms.patterns.loose_ends import joined, loose_ends
from iconstudio.algorithms.patterns.prepared import Prepared
from tests.algorithms.patterns.ornaments import soft, stripes

ROWS, COLUMNS = 96, 128
Y, X = np.mgrid[:ROWS, :COLUMNS].astype(np.float32)
NOTHING = np.zeros((ROWS, COLUMNS), np.bool_)


def line(y, first, last, half=2.0):
    """A level line with round ends."""
    away = np.hypot(Y - y, np.maximum(np.maximum(first - X, X - last), 0)) - half
    return np.clip(away, -8, 8).astype(np.float32)


def pieces(distance):
    return ndimage.label(distance < 0, np.ones((3, 3)))[1]


@pytest.mark.parametrize("tile", [True, False])
def test_ends_that_face_each_other_are_joined_in_the_lines_own_width(tile):
    broken = np.minimum(line(40, -9, 50), line(43, 70, 200))
    assert len(loose_ends(broken, NOTHING, tile)) == 2
    whole = joined(broken, NOTHING, tile)
    assert not loose_ends(whole, NOTHING, tile)
    assert pieces(whole) == 1
    assert (whole <= broken).all(), "nothing is taken out"
    assert (whole[:, 60] < 0).sum() == pytest.approx(4, abs=1)


def test_on_a_tile_ends_meet_across_its_border():
    whole = joined(line(40, 12, 115), NOTHING, True)
    assert (whole[40] < 0).all() and not loose_ends(whole, NOTHING, True)


def test_an_end_goes_on_beneath_what_it_points_to():
    over = np.hypot(Y - 40, X - 64) < 12
    whole = joined(np.minimum(line(40, -9, 45), line(40, 64, 200)), over, False)
    assert ((whole[40] < 0) | over[40]).all()
    assert not loose_ends(whole, over, False)


def test_a_stub_is_taken_out_and_a_long_line_is_not():
    over = np.hypot(Y - 60, X - 64) < 10
    stub = line(60, 64, 92)
    left = joined(np.minimum(line(20, -9, 200), stub), over, False)
    assert not (left[30:, 76:] < 0).any()
    assert (left[20] < 0).all()
    assert not loose_ends(left, over, False)
    long = line(60, -9, 118)
    assert np.array_equal(joined(long, NOTHING, False) < 0, long < 0)


def test_no_line_is_drawn_through_another():
    broken = np.minimum(line(40, -9, 50), line(40, 70, 200))
    upright = np.clip(abs(X - 60) - 2, -8, 8).astype(np.float32)
    crossed = joined(np.minimum(broken, upright), NOTHING, False)
    assert (crossed[40, 53:57] > 0).all()


def test_what_ends_in_the_exemplar_may_end_in_the_pattern():
    assert Prepared.of(stripes()).endless == (True,)
    y, x = np.mgrid[:64, :64]
    waves = np.abs(y % 16 - 8)
    ending = soft(np.where(y < 32, waves, np.hypot(waves, np.maximum(x - 40, 0))) - 3)
    picture = np.repeat(1 - ending[..., None], 3, axis=2)
    assert Prepared.of(Exemplar(picture, ending[None])).endless == (False,)
