"""Shares against their definition: blurred regions, enlarged."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image
from scipy import ndimage

from iconstudio.algorithms.iconification.blending import (
    at,
    in_blocks,
    regions,
    soft_regions,
    spread,
)
from iconstudio.model import CANVAS


def noise(seed: int, m: int) -> np.ndarray:
    smooth = ndimage.gaussian_filter(
        np.random.default_rng(seed).normal(size=(3, m, m)), (0, m / 16, m / 16)
    )
    return smooth.argmax(axis=0).astype(np.uint8)


@pytest.mark.parametrize(("m", "s"), [(128, 4), (256, 1), (256, 3), (512, 2)])
def test_shares_are_blurred_regions_and_sum_to_one(m, s):
    labels = noise(1, m)
    blocks = np.argwhere(np.ones_like(labels))[:: 5 * s]
    total = np.zeros((len(blocks), s, s))
    for share in soft_regions(labels, 2.0, 7):
        rows = share.rows(blocks)
        own = (labels == share.label).astype(np.float32)
        soft = ndimage.gaussian_filter(own, 2.0 * m / CANVAS, radius=7 * m // CANVAS)
        large = np.array(Image.fromarray(soft).resize((m * s, m * s), Image.Resampling.BILINEAR))
        expected = in_blocks(large, s)[at(blocks)]
        weights = np.zeros_like(expected)
        weights[rows] = share.weights(blocks[rows], s)
        assert abs(weights - expected).max() < 1e-5
        total += weights
    assert abs(total - 1).max() < 1e-5


def test_every_region_has_its_window():
    labels = noise(2, 64)
    found = regions(labels)
    assert set(found) == set(np.unique(labels))
    for label, window in found.items():
        assert (labels[window] == label).sum() == (labels == label).sum()
        rest = labels.copy()
        rest[window] = 0 if label else 1
        assert not (rest == label).any()


@settings(max_examples=30)
@given(st.integers(0, 1000))
def test_spreading_is_dilation(seed):
    bitmap = np.random.default_rng(seed).random((9, 12)) < 0.15
    assert np.array_equal(spread(bitmap), ndimage.binary_dilation(bitmap, np.ones((3, 3))))
