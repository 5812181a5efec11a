"""Outlines of what a pen draws are read as what the pen follows; shapes stay shapes."""

import numpy as np
import pytest
import shapely

from iconstudio.algorithms import areas
from iconstudio.algorithms.contours import contours_of
from iconstudio.algorithms.curves.outline import path_of
from iconstudio.algorithms.curves.outlined_strokes import with_strokes
from iconstudio.algorithms.flattening import flattened

WIDTH = 20.0


def arc(centre, radius, first=0.0, last=2 * np.pi):
    angle = np.linspace(first, last, 60)
    return tuple(zip(centre[0] + radius * np.cos(angle), centre[1] + radius * np.sin(angle),
                     strict=True))  # fmt: skip


def drawn(*lines, width=WIDTH, **more):
    """The contours of what a pen draws along lines."""
    return contours_of(
        areas.united(areas.stroked(np.array(one), False, width, **more) for one in lines)
    )


def area_of(lines):
    return areas.filled(row for row, _ in flattened(path_of(lines)))


LINES = {
    "a bar": [((40, 128), (216, 128))],
    "an arc": [arc((128, 128), 80, 0, 4)],
    "a corner": [((40, 60), (200, 60), (200, 200))],
    "a tip": [((40, 200), (128, 40), (216, 200))],
    "a T": [((40, 60), (216, 60)), ((128, 60), (128, 220))],
    "a cross": [((40, 40), (216, 216)), ((216, 40), (40, 216))],
    "a fork": [((128, 128), (128, 40)), ((128, 128), (60, 200)), ((128, 128), (196, 200))],
    "a ring with a bar": [arc((128, 128), 80), ((48, 128), (208, 128))],
}


@pytest.mark.parametrize("name", LINES)
def test_what_a_round_pen_drew_is_the_line_that_it_followed(name):
    found = with_strokes(drawn(*LINES[name]))
    assert {round(one.width, 0) for one in found} == {WIDTH}
    given = shapely.union_all([shapely.LineString(one) for one in LINES[name]])
    again = shapely.union_all(
        [shapely.LineString([*one.points, *one.points[: one.closed]]) for one in found]
    )
    assert shapely.hausdorff_distance(given, again, 0.01) < 0.2 * WIDTH


def test_a_ring_is_closed():
    (found,) = with_strokes(drawn(arc((128, 128), 80)))
    assert found.closed


def test_sharp_corners_and_flat_ends_are_strokes_too():
    """Their lines end so much sooner, and come out round."""
    contours = drawn(((40, 60), (200, 60), (200, 200)), cap="flat", join="mitre")
    (found,) = with_strokes(contours)
    ends = sorted((found.points[0], found.points[-1]))
    assert ends == [pytest.approx((50, 60), abs=1), pytest.approx((200, 190), abs=1)]
    assert min(np.hypot(x - 200, y - 60) for x, y in found.points) < 1


@pytest.mark.parametrize(
    "shape",
    [
        shapely.box(40, 40, 216, 216),
        shapely.Point(128, 128).buffer(20),
        shapely.box(100, 100, 120, 140),
        shapely.Polygon([(20, 128), (236, 118), (236, 138)]),
        shapely.Polygon([(40, 200), (128, 40), (216, 200)]),
    ],
    ids=["a square", "a dot", "a short bar", "a wedge", "a triangle"],
)
def test_shapes_stay_shapes(shape):
    contours = contours_of(shape)
    assert with_strokes(contours) == contours


def test_strokes_reach_into_what_is_solid():
    """A pin: below its head it is a line."""
    pole = areas.stroked(np.array([(60.0, 40.0), (60.0, 230.0)]), False, WIDTH)
    head = shapely.Point(60, 60).buffer(24)
    solid, stroke = with_strokes(contours_of(areas.united([pole, head])))
    assert (solid.width, stroke.width) == (0, pytest.approx(WIDTH, rel=0.03))
    bottom, top = sorted((stroke.points[0][1], stroke.points[-1][1]), reverse=True)
    assert bottom == pytest.approx(230, abs=1)
    assert top < 84


def test_nothing_of_a_picture_is_lost():
    contours = (*drawn(*LINES["a T"]), *contours_of(shapely.box(150, 150, 230, 230)))
    before, after = area_of(contours), area_of(with_strokes(contours))
    assert shapely.symmetric_difference(before, after).area < 0.01 * before.area
