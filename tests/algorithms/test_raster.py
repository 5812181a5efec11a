import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy import ndimage
from skimage.draw import polygon2mask

from iconstudio.algorithms.geometry import crosses_itself
from iconstudio.algorithms.raster import (
    fill_polygon,
    interior,
    placed_ink,
    scaled_ink,
    shifted,
    solid,
)
from iconstudio.model import CANVAS, Placement, Polygon
from iconstudio.svg.placed import render_placed
from tests.shapes import blob, exemplar

bitmaps = arrays(bool, st.tuples(st.integers(1, 12), st.integers(1, 12)))


@given(bitmaps)
def test_solid_fills_what_the_outside_cannot_reach(ink):
    assert np.array_equal(solid(ink), ndimage.binary_fill_holes(ink))


@given(bitmaps)
def test_interior_is_white_inside_the_contour(ink):
    filled = solid(ink)
    inside = interior(ink, filled)
    assert not (inside & ink).any()
    assert np.array_equal(inside | ink, filled)


def test_polygon_with_whole_corners_fills_whole_pixels():
    ink = fill_polygon(Polygon.of([(4, 6), (14, 6), (14, 18), (4, 18)]), CANVAS // 2)
    expected = np.zeros((CANVAS // 2, CANVAS // 2), bool)
    expected[3:9, 2:7] = True
    assert np.array_equal(ink, expected)


def test_outline_that_crosses_itself_encloses_all_of_a_star():
    angles = np.pi / 2 + np.arange(5) * 4 * np.pi / 5
    star = Polygon.of(np.stack([128 + 100 * np.cos(angles), 128 - 100 * np.sin(angles)], 1))
    assert crosses_itself(star)
    assert fill_polygon(star)[128, 128]


@given(st.integers(-9, 9), st.integers(-9, 9), st.integers(0, 3))
def test_shifted_moves_right_and_down(dx, dy, border):
    picture = np.arange(1, 1 + (6 + 2 * border) ** 2).reshape(6 + 2 * border, -1)
    moved = shifted(picture, dx, dy, 6, 0)
    for y in range(6):
        for x in range(6):
            fy, fx = y - dy + border, x - dx + border
            inside = 0 <= fy < len(picture) and 0 <= fx < len(picture)
            assert moved[y, x] == (picture[fy, fx] if inside else 0)


@pytest.mark.parametrize("scale", [0.8, 0.9, 1.0, 1.1])
@pytest.mark.parametrize("flip", [False, True])
def test_placed_ink_agrees_with_drawing_the_svg_at_the_placement(scale, flip):
    shape = exemplar(blob(3))
    placement = Placement(scale, flip, 9, -14)
    ink, filled = placed_ink(shape, placement)
    drawn = render_placed(shape.pictogram.svg, shape.frame, placement, CANVAS) > 127
    assert (ink & drawn).sum() / (ink | drawn).sum() > 0.99
    assert (filled >= ink).all()


def test_what_is_enclosed_stays_enclosed_when_the_canvas_cuts_it():
    ring = np.zeros((CANVAS, CANVAS), bool)
    ring[60:200, 60:200] = True
    ring[80:180, 80:180] = False
    ink, filled = placed_ink(exemplar(ring), Placement(dx=120))
    assert not ink[128, 250]
    assert filled[128, 250]


def test_scaling_about_the_centre_keeps_the_centre():
    ink = scaled_ink(exemplar(blob(1)).coverage, 1.25, pad=40)
    assert ink.shape == (CANVAS + 80, CANVAS + 80)
    assert abs(ink.sum() / blob(1).sum() - 1.25**2) < 0.02


@settings(max_examples=50)
@given(st.integers(3, 40), st.sampled_from([64, 256]), st.integers(0, 2**32 - 1))
def test_a_polygon_encloses_the_pixels_that_a_slow_library_finds(count, side, seed):
    random = np.random.default_rng(seed)
    angles = np.sort(random.uniform(0, 2 * np.pi, count))
    radii = random.uniform(20, 160, count)  # some of it lies beyond the canvas
    points = 128 + radii[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    polygon = Polygon.of(points.tolist())
    assume(not crosses_itself(polygon))
    slow = polygon2mask((side, side), points[:, ::-1] * side / CANVAS - 0.5)
    assert np.array_equal(fill_polygon(polygon, side), solid(slow))
