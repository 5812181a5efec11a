import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.iconification.saliency import (
    LAMBDA_B,
    REGIONS,
    SIGMA,
    SPACING,
    SQUARE,
    exterior_angles,
    profile,
)
from iconstudio.model import CANVAS, Polygon
from tests.shapes import regions_of, saliency_of

SQUARE_SHAPE = Polygon.of([(64, 64), (192, 64), (192, 192), (64, 192)])


def test_exterior_angles_of_known_shapes():
    assert np.allclose(exterior_angles(SQUARE_SHAPE), math.pi / 2)
    triangle = Polygon.of([(0, 0), (10, 0), (5, 5 * math.sqrt(3))])
    assert np.allclose(exterior_angles(triangle), 2 * math.pi / 3)
    # A concave corner counts like a convex one; a point on a straight edge does not count.
    arrow = Polygon.of([(0, 0), (5, 0), (10, 0), (5, 5), (10, 10), (0, 10)])
    assert exterior_angles(arrow)[1] == pytest.approx(0)
    assert exterior_angles(arrow)[3] == pytest.approx(math.pi / 2)


def test_profile_is_a_square_smoothed_by_a_gaussian():
    offsets = np.arange(-300, 301) / 1.0
    square = (np.abs(offsets) <= SQUARE / 2).astype(float)
    gaussian = np.exp(-(offsets**2) / (2 * SIGMA**2))
    smoothed = np.convolve(square, gaussian / gaussian.sum(), mode="same")
    inside = np.abs(offsets) < 150
    assert np.allclose(profile(offsets)[inside], smoothed[inside], atol=0.01)


def test_saliency_of_a_square_by_direct_sums():
    """Equations 1 to 3 written out at a few pixels."""
    offsets = np.arange(-170.0, 171.0)
    weight = profile(offsets) / profile(offsets).sum()
    score = saliency_of(SQUARE_SHAPE)

    def at(offset):
        return weight[170 + offset] if abs(offset) <= 170 else 0.0

    def angles(x, y):
        return sum(
            math.pi / 2 * at(y - b) * at(x - a)
            for a, b in ((64, 64), (192, 64), (192, 192), (64, 192))
        )

    def balance(x, y):
        xs, ys = x + offsets, y + offsets
        black = np.outer((ys >= 64) & (ys < 192), (xs >= 64) & (xs < 192))
        return abs(((0.5 - black) * np.outer(weight, weight)).sum())

    most = max(angles(x, y) for x in range(CANVAS) for y in range(x, CANVAS))
    for x, y in [(64, 64), (128, 128), (10, 200), (0, 0), (255, 128)]:
        expected = angles(x, y) / most - LAMBDA_B * balance(x, y)
        assert score[y, x] == pytest.approx(expected, abs=1e-6)


def test_first_region_is_the_most_salient_pixel():
    score = saliency_of(SQUARE_SHAPE)
    x, y = regions_of(SQUARE_SHAPE)[0].centre
    assert score[y, x] == score.max()


@settings(max_examples=10)
@given(
    st.lists(st.tuples(st.floats(0, 100), st.floats(0, 100)), min_size=3, max_size=12, unique=True)
)
def test_regions_keep_their_distance(points):
    polygon = Polygon.of([*points, (0, 0), (100, 0), (90, 100)]).fitted()
    regions = regions_of(polygon)
    assert 4 <= len(regions) <= REGIONS
    centres = [region.centre for region in regions]
    for i, a in enumerate(centres):
        assert all(math.dist(a, b) >= SPACING for b in centres[:i])


def test_masks_are_one_mask_moved():
    for region in regions_of(SQUARE_SHAPE):
        x, y = region.centre
        assert region.mask.shape == (CANVAS, CANVAS)
        assert region.mask[int(y), int(x)] == region.mask.max()
        assert region.mask[int(y), 0] == pytest.approx(
            float(profile(np.array([0.0]))[0] * profile(np.array([float(x)]))[0]), abs=1e-6
        )
