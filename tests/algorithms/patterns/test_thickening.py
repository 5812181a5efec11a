"""Thin lines are made thick enough; all else stays as it is."""

import numpy as np
import pytest

from iconstudio.algorithms.patterns.thickening import thickened
from tests.algorithms.patterns.ornaments import SIDE, X, Y, disc, soft


@pytest.mark.parametrize("slope", [0.0, 0.3, 1.0])
@pytest.mark.parametrize("width", [1.2, 2.5])
def test_a_line_is_as_wide_as_wanted(slope, width):
    off = np.abs(Y - 20 - slope * (X - 30)) / np.hypot(1, slope)
    found = thickened(soft(off - width / 2), 6.0)
    assert (found[off < 2] == 1).all() and not found[off > 4.5].any()


@pytest.mark.parametrize("distance", [disc(30, 30, 12), disc(20, 20, 2),
                         np.maximum(np.abs(Y - 30), np.abs(X - 30)) - 9.2])  # fmt: skip
def test_what_is_no_line_stays(distance):
    mask = soft(distance)
    assert thickened(mask, 6.0) is mask


def test_what_is_wide_enough_stays():
    line = soft(np.abs(Y - 30.4) - 4)
    assert thickened(line, 6.0) is line and thickened(soft(np.abs(Y - 30.4) - 0.6), 1.9).sum() > 0
    assert not thickened(np.zeros((SIDE, SIDE), np.float32), 6.0).any()


def test_a_line_between_shapes_is_thickened_alone():
    blobs = np.minimum(disc(30, 12, 9), disc(30, 52, 9))
    line = np.maximum(np.abs(Y - 30) - 1, np.abs(X - 32) - 20)
    mask = soft(np.minimum(blobs, line))
    found = thickened(mask, 6.0)
    more = (found > 0.5) & (mask <= 0.5)
    assert (
        more[:, 28:37].sum(axis=0).min() >= 2 and not more[:, :8].any() and not more[:, 56:].any()
    )
