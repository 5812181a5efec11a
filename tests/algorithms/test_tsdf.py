import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy import ndimage

from iconstudio.algorithms.iconification.tsdf import D_MAX, tsdf
from iconstudio.model import CANVAS
from tests.shapes import blob


def oracle(filled: np.ndarray, d_max: int) -> np.ndarray:
    """Clamped difference of two full Euclidean distance transforms."""

    def distance(to):
        return ndimage.distance_transform_edt(~to) if to.any() else np.full(to.shape, np.inf)

    return np.clip(distance(filled) - distance(~filled), -d_max, d_max) / CANVAS


@given(arrays(bool, st.tuples(st.integers(1, 20), st.integers(1, 20))), st.integers(1, 8))
def test_equals_the_euclidean_distance_transform(filled, d_max):
    assert np.allclose(tsdf(filled, d_max), oracle(filled, d_max), atol=1e-7)


def test_a_batch_is_the_same_as_one_by_one():
    shapes = np.stack([blob(0), blob(1)])
    assert np.array_equal(tsdf(shapes)[1], tsdf(shapes[1]))


def test_a_straight_edge():
    half = np.zeros((4, 40), bool)
    half[:, 20:] = True
    row = tsdf(half)[0] * CANVAS
    assert np.allclose(row[12:28], [6, 6, 6, 5, 4, 3, 2, 1, -1, -2, -3, -4, -5, -6, -6, -6])
    assert abs(row).max() == D_MAX
