"""What seams bring about is put right, and nothing else, by 1.5% of the canvas at most."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from iconstudio.algorithms.tidying.pens import evened, pen_of
from iconstudio.algorithms.tidying.sides import LIMIT, SEAM, Side, points_of
from iconstudio.algorithms.tidying.tidying import distance, tidied
from iconstudio.model.path import Contour, Path


def polygon(*corners, owners):
    """Return a closed contour of lines; owners go on from the last one that is given."""
    owners = [*owners, *[owners[-1]] * (len(corners) - len(owners))]
    ends = [*corners[1:], corners[0]]
    return [
        Side((complex(a), complex(b)), k) for a, b, k in zip(corners, ends, owners, strict=True)
    ]


def half(centre, radius, start, owner):
    """Return half a circle as two cubics, clockwise on a screen, from an angle in quarters on."""
    spokes = radius * np.exp(0.5j * np.pi * np.arange(start, start + 3))
    handle = 4 / 3 * np.tan(np.pi / 8) * 1j
    return [
        Side(tuple(complex(centre + z) for z in (a, a * (1 + handle), b * (1 - handle), b)), owner)
        for a, b in pairwise(spokes)
    ]


def lines(sides):
    return [side for side in sides if side.is_line]


def path_of(sides):
    segments = tuple(tuple((p.real, p.imag) for p in side.piece[1:]) for side in sides)
    return Path((Contour((sides[0].start.real, sides[0].start.imag), segments),))


def test_a_side_that_leans_across_a_seam_is_upright():
    # The left side leans by one degree above the seam, and is upright below it.
    lean = 100 * np.tan(np.radians(1))
    contour = polygon(50, 150, 150 + 220j, 50 + 220j, 50 + 102j, 50 - lean + 100j,
                      owners=[0, 1, 1, 1, SEAM, 0])  # fmt: skip
    (found,) = tidied([contour], {})
    assert len(found) == 4
    assert all(min(abs(w.real), abs(w.imag)) < 1e-9 for w in (s.ways[0] for s in lines(found)))
    assert distance(found, contour) <= LIMIT


@pytest.mark.parametrize(
    "contour",
    [
        polygon(50, 180, 182 + 2j, 210 + 2j, 210 + 90j, 50 + 90j, owners=[0, SEAM, 1, 1, 0]),
        polygon(50, 148, 151 + 2j, 150 + 4j, 150 + 100j, 50 + 100j, owners=[0, SEAM, SEAM, 1, 0]),
        polygon(60, 160, 200 + 60j, 161 + 120j, 60 + 120j, 20.4 + 60j, owners=[0, 1, 1, 1, 0, 0]),
    ],
)
def test_nothing_more_comes_of_it_again(contour):
    found = tidied([contour], {})
    assert found != [contour]
    assert tidied(found, {}) == found


def test_lines_that_miss_each_other_are_one_and_that_of_the_longer():
    contour = polygon(50, 180, 182 + 2j, 210 + 2j, 210 + 90j, 50 + 90j, owners=[0, SEAM, 1, 1, 0])
    (found,) = tidied([contour], {})
    assert len(found) == 4
    assert {side.start.imag for side in found} == {0, 90}


def test_a_step_that_is_meant_stays():
    contour = polygon(50, 180, 182 + 9j, 210 + 9j, 210 + 90j, 50 + 90j, owners=[0, SEAM, 1, 1, 0])
    assert tidied([contour], {}) == [contour]


def test_two_halves_are_one_circle():
    first, last = half(100 + 100j, 60, 0, 0), half(101 + 101.5j, 61.5, 2, 1)
    joints = [Side((a[-1].end, b[0].start), SEAM) for a, b in ((first, last), (last, first))]
    (found,) = tidied([[*first, joints[0], *last, joints[1]]], {})
    points = points_of(found, 1.0)
    centre = (points.real.max() + points.real.min()) / 2
    centre += 1j * (points.imag.max() + points.imag.min()) / 2
    assert np.ptp(abs(points - centre)) < 0.05
    assert len(found) == 4


def test_a_ring_is_round_one_centre():
    hole = [
        side.reversed()
        for side in reversed(half(100 + 100j, 40, 0, 0) + half(100 + 100j, 40, 2, 0))
    ]
    first, last = half(100 + 100j, 60, 0, 0), half(101.2 + 101j, 60.5, 2, 1)
    joints = [Side((a[-1].end, b[0].start), SEAM) for a, b in ((first, last), (last, first))]
    found, same = tidied([[*first, joints[0], *last, joints[1]], hole], {})
    assert same == hole
    assert np.ptp(abs(points_of(found, 1.0) - (100 + 100j))) < 0.05


def test_strokes_of_nearly_one_width_are_of_one():
    # A bar of 3.3 grid units, and after a seam one of 3.0.
    contour = polygon(20 + 0j, 120 + 0j, 121 + 1j, 180 + 1j, 180 + 21j, 121 + 21j, 120 + 22j,
                      20 + 22j, owners=[0, SEAM, 1, 1, 1, SEAM, 0])  # fmt: skip
    (found,) = tidied([contour], {0: 22.0, 1: 20.0})
    assert sorted({round(side.start.imag, 6) for side in found}) == [0, 22]
    apart = polygon(200, 220, 220 + 10j, 200 + 10j, owners=[1])
    _, thicker = evened([contour, apart], {0: 22.0, 1: 20.0})
    assert sorted({side.start.real for side in thicker}) == [199, 221]


def test_strokes_of_another_width_stay():
    thin = polygon(200, 208, 208 + 100j, 200 + 100j, owners=[1])
    thick = polygon(20, 120, 120 + 22j, 20 + 22j, owners=[0])
    assert tidied([thick, thin], {0: 22.0, 1: 8.0}) == [thick, thin]


def test_ends_that_nearly_meet_do():
    # At a corner, two sources end a little before they would meet.
    contour = polygon(50, 148, 151 + 2j, 150 + 4j, 150 + 100j, 50 + 100j,
                      owners=[0, SEAM, SEAM, 1, 1, 0])  # fmt: skip
    (found,) = tidied([contour], {})
    assert [side.start for side in found].count(150) == 1
    assert len(found) == 4


def test_crumbs_of_seams_go_and_small_parts_of_sources_stay():
    body = polygon(50, 150, 150 + 100j, 50 + 100j, owners=[0])
    crumb = polygon(10, 14, 14 + 4j, 10 + 4j, owners=[0, SEAM, 1])
    eye = polygon(10, 14, 14 + 4j, 10 + 4j, owners=[1])
    assert tidied([body, crumb, eye], {}) == [body, eye]


def test_a_curve_without_a_handle_ends_the_same_again():
    # Its direction cannot be changed by moving its handle.
    curve = Side((150 + 0j, 150 + 0j, 190 + 8j, 190 + 60j), 1)
    contour = [Side((50 + 0j, 150 + 0j), 0), curve, Side((190 + 60j, 50 + 60j), 0),
               Side((50 + 60j, 50 + 0j), 0)]  # fmt: skip
    assert distance(tidied([contour], {})[0], contour) < LIMIT


def test_what_is_nearly_symmetric_becomes_so():
    contour = polygon(60, 160, 200 + 60j, 161 + 120j, 60 + 120j, 20.4 + 60j,
                      owners=[0, 1, 1, 1, 0, 0])  # fmt: skip
    (found,) = tidied([contour], {})
    points = {complex(round(s.start.real, 6), round(s.start.imag, 6)) for s in found}
    axis = (max(p.real for p in points) + min(p.real for p in points)) / 2
    assert {complex(round(2 * axis - p.real, 6), p.imag) for p in points} == points


def test_what_a_source_has_unlike_left_and_right_stays():
    contour = polygon(60, 160, 200 + 60j, 161 + 120j, 60 + 120j, 20.4 + 60j, owners=[0])
    other = polygon(100 + 40j, 100 + 50j, 120 + 50j, 120 + 40j, owners=[1])
    assert tidied([contour, other], {}) == [contour, other]


@given(
    st.lists(st.floats(-3, 3), min_size=16, max_size=16),
    st.lists(st.sampled_from([0, 1, SEAM]), min_size=8, max_size=8),
)
def test_nothing_moves_far_and_contours_stay_closed(off, owners):
    corners = [40, 130, 134, 210, 210 + 80j, 210 + 160j, 134 + 160j, 40 + 160j]
    moved = [z + complex(off[2 * k], off[2 * k + 1]) for k, z in enumerate(corners)]
    contour = polygon(*moved, owners=owners)
    found = tidied([contour], {})
    assert len(found) == 1
    assert distance(found[0], contour) <= LIMIT
    assert all(a.end == b.start for a, b in zip(found[0], found[0][1:] + found[0][:1], strict=True))


@given(
    st.lists(st.floats(-2, 2), min_size=8, max_size=8),
    st.lists(st.sampled_from([0, 1, SEAM]), min_size=4, max_size=4),
)
def test_of_what_is_symmetric_comes_what_is_symmetric(off, owners):
    left = [z + complex(off[2 * k], off[2 * k + 1])
            for k, z in enumerate((60 + 120j, 50 + 60j, 52 + 58j, 70 + 0j))]  # fmt: skip
    right = [complex(256 - z.real, z.imag) for z in reversed(left)]
    contour = polygon(*left, *right, owners=[*owners[:3], owners[3], *owners[2::-1], owners[3]])
    (found,) = tidied([contour], {})
    mirrored = [
        Side(tuple(complex(256 - p.real, p.imag) for p in side.piece[::-1]), side.owner)
        for side in reversed(found)
    ]
    assert distance(found, mirrored) < 0.7


@pytest.mark.parametrize("width", [6.0, 18.0])
def test_the_pen_of_a_ring_is_as_wide_as_the_ring(width):
    outer = path_of(half(100 + 100j, 60, 0, 0) + half(100 + 100j, 60, 2, 0))
    circle = half(100 + 100j, 60 - width, 0, 0) + half(100 + 100j, 60 - width, 2, 0)
    inner = path_of([side.reversed() for side in reversed(circle)])
    assert pen_of(Path(outer.contours + inner.contours)) == pytest.approx(width, abs=0.1)
    assert pen_of(outer) is None
