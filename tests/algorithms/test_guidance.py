from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.iconification.guidance import (
    edit_penalty,
    mirror_image,
    points_mask,
    scribble,
    seed_cost,
    truncated_distance,
    with_mirror_images,
)
from iconstudio.algorithms.iconification.saliency import LAMBDA_D, profile, saliency
from iconstudio.model import CANVAS, Axis, Polygon, Stroke
from tests.shapes import saliency_of


@settings(max_examples=40)
@given(st.integers(0, 2**32 - 1), st.sampled_from([2.0, 5.0, 25.0]))
def test_truncated_distances_by_brute_force(seed, reach):
    marked = np.random.default_rng(seed).random((9, 11)) < 0.05
    field = truncated_distance(marked, reach)
    places = np.argwhere(marked)
    for y in range(9):
        for x in range(11):
            nearest = min((np.hypot(y - v, x - u) for v, u in places), default=np.inf)
            assert field[y, x] == pytest.approx(min(nearest, reach) / reach, abs=1e-6)


def test_the_penalty_of_an_edit_by_hand():
    # D_E: in the changed area, on the way out of it, and beyond its reach.
    mask = np.array([[0.0, 0.25, 1.0]], np.float32)
    penalty = edit_penalty(mask, mask, 3)
    assert penalty[0, 0] == pytest.approx([0.1, 0.075, 0.0])  # E_0 costs where it is to change
    for label in (1, 2):
        assert penalty[label, 0] == pytest.approx([0.0, 0.025, 0.1])
    # Beside what is taken off, E_0 costs nothing.
    kept = np.array([[0.0, 1.0, 1.0]], np.float32)
    assert edit_penalty(mask, kept, 2)[0, 0] == pytest.approx([0.1, 0.0, 0.0])


def test_equation_10_by_direct_sums():
    square = Polygon.of([(64, 64), (192, 64), (192, 192), (64, 192)])
    filled = np.zeros((CANVAS, CANVAS), dtype=bool)
    filled[64:192, 64:192] = True
    changed = np.zeros_like(filled)
    changed[70:90, 100:140] = True
    mask = truncated_distance(changed, 25)
    more = saliency([square], filled, mask) - saliency_of(square)
    along = profile(np.arange(-CANVAS, CANVAS + 1.0))
    for x, y in ((120, 80), (30, 200), (255, 0), (160, 100)):
        ys, xs = along[CANVAS - y : 2 * CANVAS - y], along[CANVAS - x : 2 * CANVAS - x]
        direct = (np.outer(ys, xs) * (1 - mask)).sum() / along.sum() ** 2
        assert more[y, x] == pytest.approx(LAMBDA_D * direct, rel=1e-4, abs=1e-6)


def test_the_most_salient_region_of_an_edit_lies_in_its_change():
    from iconstudio.algorithms.iconification.saliency import salient_regions

    square = Polygon.of([(64, 64), (192, 64), (192, 192), (64, 192)])
    filled = np.zeros((CANVAS, CANVAS), dtype=bool)
    filled[64:192, 64:192] = True
    changed = np.zeros_like(filled)
    changed[100:120, 150:240] = True
    score = saliency([square], filled, truncated_distance(changed, 25))
    x, y = salient_regions(score)[0].centre
    assert 150 <= x < 240
    assert 90 <= y < 130


def test_seed_costs_are_zero_at_the_seeds_and_one_far_from_them():
    cost = seed_cost([((10.5, 20.5),), ((100.0, 50.0), (200.0, 50.0))])
    assert cost.shape == (2, CANVAS, CANVAS)
    assert cost[0, 20, 10] == 0
    assert cost[0, 20, 30] == pytest.approx(0.5)
    assert cost[0, 20, 50] == 1
    assert cost[1, 50, 100] == cost[1, 50, 200] == 0
    assert cost[1, 50, 150] == 1


def test_seed_costs_on_a_finer_canvas_are_the_same_picture():
    seeds = [((100.0, 50.0), (200.0, 50.0))]
    usual, fine = seed_cost(seeds), seed_cost(seeds, 2 * CANVAS)
    assert fine[:, ::2, ::2] == pytest.approx(usual, abs=1e-6)


def test_seeds_at_the_very_edge_lie_in_the_last_pixel():
    assert points_mask([(CANVAS, CANVAS)])[CANVAS - 1, CANVAS - 1]


points = st.tuples(st.floats(-40, 300), st.floats(-40, 300))


@settings(max_examples=30)
@given(st.lists(points, min_size=1, max_size=4), st.floats(1, 40))
def test_a_scribble_covers_what_lies_within_half_its_width(corners, width):
    covered = scribble([Stroke(width, tuple(corners))])
    ys, xs = np.mgrid[:CANVAS, :CANVAS] + 0.5
    nearest = np.full((CANVAS, CANVAS), np.inf)
    ends = list(pairwise(corners)) or [(corners[0], corners[0])]
    for (x0, y0), (x1, y1) in ends:
        for t in np.linspace(0, 1, 60):
            x, y = x0 + t * (x1 - x0), y0 + t * (y1 - y0)
            np.minimum(nearest, np.hypot(xs - x, ys - y), out=nearest)
    # The samples of the line lie at most so far apart.
    slack = max(np.hypot(x1 - x0, y1 - y0) for (x0, y0), (x1, y1) in ends) / 59 + 1e-9
    assert covered[nearest <= width / 2].all()
    thin = 0.71  # the pixels that the line runs through are covered however thin it is
    assert not covered[nearest > max(width / 2, thin) + slack].any()


def test_a_hair_line_still_covers_its_pixels():
    covered = scribble([Stroke(0.01, ((10.2, 10.2), (20.2, 10.2)))])
    assert covered[10, 10:21].all()
    assert covered.sum() == 11


@pytest.mark.parametrize("axis", list(Axis))
def test_a_seed_has_its_mirror_image(axis):
    from iconstudio.algorithms.iconification.symmetry import reflected

    point = (30.5, 77.5)
    (same, image) = with_mirror_images([point], axis)
    assert same == point
    assert mirror_image(image, axis) == point
    assert np.array_equal(points_mask([image]), reflected(points_mask([point]), axis))
    assert with_mirror_images([point], None) == (point,)
