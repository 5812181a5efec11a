"""The period of an exemplar, and the sizes that fit it."""

import numpy as np
import pytest

from iconstudio.algorithms.patterns.periods import fitting_size, period
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


def test_sizes_fit_the_period():
    assert fitting_size((100, 100), stripes(12).masks) == (96, 100)
    assert fitting_size((10, 131), checks(20).masks) == (20, 140)
    noise = np.random.default_rng(0).random((1, 64, 64)).astype(np.float32)
    assert fitting_size((100, 101), noise) == (100, 101)
