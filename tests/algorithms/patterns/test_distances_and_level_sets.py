"""Distance functions and their evolution, against formulas and the plain form."""

import numpy as np
import pytest

from iconstudio.algorithms.patterns import level_set, warping
from iconstudio.algorithms.patterns.distance import CLAMP, coverage, signed_distance
from tests.algorithms.patterns.ornaments import SIDE, disc, soft


@pytest.mark.parametrize(("y", "x", "radius"), [(31, 31, 20), (30.3, 32.6, 9.4), (33, 30.5, 2.7)])
def test_distances_of_a_circle_are_those_of_the_formula(y, x, radius):
    distance = signed_distance(soft(disc(y, x, radius)) - 0.5)
    expected = np.clip(disc(y, x, radius), -CLAMP, CLAMP)
    assert np.abs(distance - expected).max() < 0.15
    assert np.abs(distance - expected).mean() < 0.05
    assert np.abs(coverage(distance) - soft(disc(y, x, radius))).max() < 0.15


def test_distances_go_on_across_the_borders_of_a_tile():
    mask = soft(disc(31, 31, 12))
    moved = np.roll(mask, (29, 35), axis=(0, 1))
    distance = signed_distance(moved - 0.5, tile=True)
    expected = signed_distance(mask - 0.5)
    assert np.allclose(np.roll(distance, (-29, -35), axis=(0, 1)), expected, atol=1e-5)


@pytest.mark.parametrize("inverted", [False, True])
@pytest.mark.parametrize("radius", [8.0, 14.0])
def test_a_circle_shrinks_under_its_curvature_as_the_formula_says(radius, inverted):
    sign = np.float32(-1 if inverted else 1)  # a hole closes as well
    distance = sign * disc(31.5, 31.5, radius).astype(np.float32)
    smoothing, time, steps = 0.25, 0.5, 60
    for _ in range(steps):
        distance = level_set.step(distance, distance, 0.0, smoothing, time, False)
    area = (coverage(sign * distance)).sum()
    expected = np.sqrt(radius**2 - 2 * smoothing * time * steps)  # r' = -smoothing / r
    assert np.sqrt(area / np.pi) == pytest.approx(expected, abs=0.1)


def test_velocity_pulls_the_zero_level_set_to_where_patches_agree():
    before, agreed = (disc(31, 31, radius).astype(np.float32) for radius in (10, 12.5))
    distance = before
    for _ in range(5):
        distance = level_set.evolved(distance, agreed, 0.95, 0.05, False)
    assert np.sqrt(coverage(distance).sum() / np.pi) == pytest.approx(12.5, abs=0.1)


def plain_step(phi, mean, attraction, smoothing, time):
    """Equations 4 and 5, a pixel at a time."""
    after = phi.copy()
    for y in range(1, len(phi) - 1):
        for x in range(1, phi.shape[1] - 1):
            p = {(i, j): phi[y + i, x + j] for i in (-1, 0, 1) for j in (-1, 0, 1)}
            speed = 2 * attraction * (p[0, 0] - mean[y, x])
            slopes = []
            for i, j in ((1, 0), (0, 1)):
                back, on = p[0, 0] - p[-i, -j], p[i, j] - p[0, 0]
                known = (max(back, 0), min(on, 0)) if speed > 0 else (min(back, 0), max(on, 0))
                slopes += known
            slope = np.clip(np.linalg.norm(slopes), level_set.LEAST_SLOPE, 1)
            change = -speed * slope
            px, py = (p[0, 1] - p[0, -1]) / 2, (p[1, 0] - p[-1, 0]) / 2
            if abs(p[0, 0]) < level_set.BAND and px**2 + py**2 > 1e-6:
                pxx = p[0, 1] - 2 * p[0, 0] + p[0, -1]
                pyy = p[1, 0] - 2 * p[0, 0] + p[-1, 0]
                pxy = (p[1, 1] - p[1, -1] - p[-1, 1] + p[-1, -1]) / 4
                kappa = (pxx * py**2 - 2 * px * py * pxy + pyy * px**2) / (px**2 + py**2) ** 1.5
                change += smoothing * kappa * np.hypot(px, py)
            after[y, x] += time * change
    return after


def test_a_step_is_that_of_the_plain_form():
    random = np.random.default_rng(1)
    phi, mean = random.normal(0, 3, (2, 12, 15)).astype(np.float32)
    after = level_set.step(phi, mean, 0.4, 0.05, 0.5, False)
    expected = plain_step(phi.astype(float), mean, 0.4, 0.05, 0.5)
    assert np.allclose(after[1:-1, 1:-1], expected[1:-1, 1:-1], atol=1e-4)


def test_thin_lines_come_back():
    y = np.arange(SIDE, dtype=np.float32)[:, None] + np.zeros((1, SIDE), np.float32)
    gone, line = np.full((SIDE, SIDE), 2, np.float32), np.clip(np.abs(y - 31) - 0.8, -2, 2)
    for _ in range(5):
        gone = level_set.evolved(gone, line, 0.8, 0.2, False)
    assert (gone[31] < 0).all() and (gone[29] > 0).all()


def test_colours_move_with_the_contour():
    before, after = (disc(31, 31, radius).astype(np.float32) for radius in (12, 13))
    colours = np.repeat(soft(before)[..., None], 3, axis=2)
    moved = warping.warped(colours, before, after, False)
    assert (
        np.abs(moved[..., 0] - soft(after)).mean() < 0.2 * np.abs(soft(before) - soft(after)).mean()
    )
    assert np.array_equal(warping.warped(colours, before, before, False), colours)
