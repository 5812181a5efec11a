"""Extremes around pixels against SciPy's, and of channels against NumPy's."""

import numpy as np
import pytest
import scipy
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import array_shapes, arrays

from iconstudio.algorithms.extremes import greatest_channel, maximum_filter, minimum_filter

TYPES = st.sampled_from([np.float32, np.uint8, np.int64, np.bool_])
VALUES = TYPES.flatmap(
    lambda kind: arrays(kind, array_shapes(min_dims=2, max_dims=3, min_side=1, max_side=9))
)


@given(VALUES, st.data())
def test_extremes_around_pixels_are_those_of_scipy(values, data):
    values = np.nan_to_num(values)
    one = st.integers(1, 12)
    size = data.draw(one | st.tuples(*[one] * values.ndim))
    for own, plain in (
        (maximum_filter, scipy.ndimage.maximum_filter),
        (minimum_filter, scipy.ndimage.minimum_filter),
    ):
        found, expected = own(values, size), plain(values, size)
        assert found.dtype == values.dtype
        np.testing.assert_array_equal(found, expected)


@pytest.mark.parametrize("sides", [(0, 4), (3, 0)])
def test_of_nothing_there_is_no_extreme(sides):
    assert maximum_filter(np.zeros(sides), 3).shape == sides


@given(arrays(np.float32, st.tuples(*[st.integers(1, 5)] * 3), elements=st.floats(-1, 1, width=32)))
def test_the_greatest_channel_is_that_of_numpy(values):
    np.testing.assert_array_equal(greatest_channel(values), values.max(axis=2))
