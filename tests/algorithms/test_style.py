import numpy as np
import pytest
from hypothesis import given
from hypothesis.extra.numpy import arrays

from iconstudio.algorithms.iconification.style import STYLES, blackness, has_pale_areas


def test_a_full_rectangle_is_all_black():
    ink = np.zeros((40, 40), bool)
    ink[5:20, 7:31] = True
    assert blackness(ink) == pytest.approx(1)


def test_a_frame_is_as_black_as_its_border():
    ink = np.zeros((40, 40), bool)
    ink[10:30, 10:30] = True
    ink[15:25, 15:25] = False
    assert blackness(ink) == pytest.approx(1 - 100 / 400)


def test_a_disc_and_a_ring():
    ys, xs = np.mgrid[:200, :200] - 99.5
    radius = np.hypot(xs, ys)
    assert blackness(radius < 90) == pytest.approx(1, abs=0.02)
    assert blackness((radius < 90) & (radius > 45)) == pytest.approx(0.75, abs=0.02)


def test_the_hull_spans_what_lies_apart():
    ink = np.zeros((20, 30), bool)
    ink[5:10, 0:5] = ink[5:10, 25:30] = True
    assert blackness(ink) == pytest.approx(50 / 150)


def test_one_pixel_and_none():
    ink = np.zeros((5, 5), bool)
    assert blackness(ink) == 0
    ink[2, 2] = True
    assert blackness(ink) == pytest.approx(1)


@given(arrays(bool, (8, 8)))
def test_blackness_is_a_proportion_that_mirroring_keeps(ink):
    value = blackness(ink)
    assert 0 <= value <= 1
    assert blackness(ink[:, ::-1]) == pytest.approx(value)
    assert blackness(ink.T) == pytest.approx(value)


def test_the_intervals_of_the_paper():
    assert [style.name for style in STYLES if style.admits(0.5)] == ["light", "medium"]
    assert [style.name for style in STYLES if style.admits(0.0)] == ["lightest"]
    assert [style.name for style in STYLES if style.admits(1.0)] == ["dark"]
    assert [style.name for style in STYLES if style.admits(0.4)] == ["lightest", "light", "medium"]


def test_pale_areas_are_told_from_soft_edges():
    ys, xs = np.mgrid[:64, :64]
    soft = np.clip((20 - np.hypot(xs - 32, ys - 32)) * 127 + 127, 0, 255).astype(np.uint8)
    assert not has_pale_areas(soft)
    layered = soft.copy()
    layered[50:60, 10:50] = 100
    assert has_pale_areas(layered)
