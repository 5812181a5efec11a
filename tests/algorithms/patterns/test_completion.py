"""What upper layers hide is recovered; the true shapes are known."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.ndimage import binary_dilation, binary_erosion

from iconstudio.algorithms.patterns.completion import completed
from iconstudio.algorithms.raster import overlap
from tests.algorithms.patterns.ornaments import soft

SIDE = 96
Y, X = np.mgrid[:SIDE, :SIDE] - (SIDE - 1) / 2


def band(angle, width, off=0.0):
    """Straight, through the middle, at an angle in degrees."""
    turn = np.radians(angle)
    return np.abs(X * np.sin(turn) - Y * np.cos(turn) - off) - width / 2


def disc(radius, x=0.0, y=0.0):
    return np.hypot(X - x, Y - y) - radius


def flower(radius, petals=5, depth=0.3):
    around = np.cos(petals * np.arctan2(Y, X))
    return np.hypot(X, Y) - radius * (1 + depth * around)


def recovered(lower, upper, **options):
    """Return what is made of a layer beneath another one, the truth, and where it was hidden.

    That is more than half of a pixel, and the soft edge around.
    """
    true, over = soft(lower), soft(upper)
    found = completed(true * (1 - over), over > 0.5, **options)
    return found > 0.5, true > 0.5, binary_dilation(over > 0.5, np.ones((3, 3)))


def hidden_overlap(lower, upper):
    found, true, hidden = recovered(lower, upper)
    assert not (found ^ true)[~hidden].any()
    return overlap(found & hidden, true & hidden)


@pytest.mark.parametrize("angle", [0, 17, 45, 90, 131])
@pytest.mark.parametrize("over", [disc(18), flower(17), disc(18, 5, -4)])
def test_a_bar_goes_on_straight(angle, over):
    assert hidden_overlap(band(angle, 9.3), over) > 0.9


def test_a_curve_goes_on_round():
    arc = np.abs(disc(50, 0, 52)) - 4.2
    assert hidden_overlap(arc, flower(16)) > 0.8


def test_a_cross_stays_one():
    assert hidden_overlap(np.minimum(band(3, 9.3), band(93, 8.3)), disc(19)) > 0.9


def test_two_bars_are_not_mixed_up():
    bars = np.minimum(band(0, 7.3, -9), band(0, 7.3, 9))
    assert hidden_overlap(bars, disc(26)) > 0.9


def test_a_disc_that_is_covered_in_part_is_round():
    assert hidden_overlap(disc(26, 12, 8), disc(20, -12, -8)) > 0.95


def test_a_disc_that_is_cut_in_two_is_one():
    assert hidden_overlap(disc(30), band(70, 12)) > 0.95


def test_a_hole_in_which_only_an_upper_layer_is_seen_is_filled():
    assert hidden_overlap(disc(30), disc(12, 5, 5)) == 1


def test_a_line_of_which_one_end_is_seen_ends_rounded_beneath():
    line = np.maximum(band(0, 9.3), X)
    found, true, hidden = recovered(line, disc(20))
    more = found & hidden
    rows, columns = np.nonzero(more)
    assert more.any() and (np.abs(Y[rows, columns]) < 6).all()
    reach = X[0, columns].max() - X[0, columns].min()
    assert 2 < reach < 12
    assert (found == true)[~hidden].all()


def test_where_nothing_may_end_only_what_comes_out_again_is_recovered():
    line = np.maximum(band(0, 9.3), X)
    found, true, hidden = recovered(line, disc(20), ends=False)
    assert not (found & binary_erosion(hidden, np.ones((5, 5)))).any()
    assert (found == true)[~hidden].all()
    whole, true, hidden = recovered(band(0, 9.3), disc(20), ends=False)
    assert overlap(whole & hidden, true & hidden) > 0.9


def test_what_nothing_hides_stays_as_it_is():
    own = soft(disc(20))
    assert completed(own, np.zeros(own.shape, bool)) is own
    assert (completed(own, soft(disc(5, 40, 40)) > 0.5) == own).all()
    nothing = np.zeros_like(own)
    assert not completed(nothing, own > 0.5).any()


@settings(max_examples=15)
@given(st.integers(0, 2**32 - 1))
def test_it_only_adds_and_only_where_it_is_hidden(seed):
    random = np.random.default_rng(seed)
    blobs = [
        np.minimum.reduce([disc(random.uniform(4, 22), *random.uniform(-45, 45, 2))
                           for _ in range(6)])
        for _ in range(2)
    ]  # fmt: skip
    own, over = soft(blobs[0]) * (1 - soft(blobs[1])), soft(blobs[1]) > 0.5
    found = completed(own, over)
    assert (found >= own).all() and found.max() <= 1
    far = ~np.pad(over, 2)
    apart = np.all([np.roll(far, (y, x), (0, 1)) for y in (-2, 0, 2) for x in (-2, 0, 2)], axis=0)
    assert (found == own)[apart[2:-2, 2:-2]].all()
