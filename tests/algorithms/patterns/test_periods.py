"""The period of an exemplar, and the sizes that fit it."""

import numpy as np
import pytest

from iconstudio.algorithms.patterns.periods import fitting_size, period, rows_apart
from tests.algorithms.patterns.ornaments import checks, shapes, stripes, two_layers


@pytest.mark.parametrize(
    ("exemplar", "expected"),
    [
        (stripes(12), (12, None)),
        (checks(20), (20, 20)),
        (two_layers(), (32, 32)),
        (shapes(), (None, None)),
    ],
)
def test_periods_are_found(exemplar, expected):
    assert period(exemplar.masks[0]) == expected
    assert period(exemplar.masks[0].T) == expected[::-1]


def test_elements_lie_in_rows_that_fill_a_side_or_not():
    random = np.random.default_rng(1)
    rows = np.repeat([10, 30, 50], 4) + random.uniform(-1, 1, 12)
    assert rows_apart(rows, 60) == 20
    assert rows_apart(rows[:5], 60) is None, "too few to tell"
    assert rows_apart(random.uniform(0, 60, 20), 60) is None


def test_sizes_fit_the_period_and_keep_their_ratio():
    assert fitting_size((100, 100), (12, None)) == (96, 96)
    assert fitting_size((200, 100), (None, 12)) == (192, 96)
    assert fitting_size((123, 142), (20, 20)) == (120, 140)
    assert fitting_size((100, 101), (None, None)) == (100, 101)


def test_what_fits_only_far_off_or_stretched_stays_as_wanted():
    assert fitting_size((30, 30), (20, 20)) == (30, 30)
    assert fitting_size((105, 95), (20, 20)) == (105, 95)
