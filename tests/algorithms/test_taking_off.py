"""What a rough mark means."""

import numpy as np
import pytest

from iconstudio.algorithms.iconification.taking_off import meant, taken_off
from iconstudio.algorithms.raster import solid
from iconstudio.model import CANVAS

YS, XS = np.mgrid[:CANVAS, :CANVAS] + 0.5


def box(left, top, right, bottom):
    return (left < XS) & (right > XS) & (top < YS) & (bottom > YS)


WALL, HANDLE = box(154, 60, 170, 220), box(170, 90, 226, 106)


def test_the_rim_of_a_wall_stays_where_a_handle_goes():
    marked = box(164, 70, 240, 130)
    left = (WALL | HANDLE) & ~meant(WALL | HANDLE, marked)
    assert (left ^ WALL).sum() < 40, "a dent of a unit where the handle joined it"


@pytest.mark.parametrize(
    ("ink", "marked"),
    [
        (WALL, box(164, 70, 240, 130)),  # nothing but the rim
        (WALL | HANDLE, box(190, 70, 240, 130)),  # a stroke cut across
        (WALL | box(170, 96, 226, 101), box(164, 70, 240, 130)),  # all that goes is thin
        (WALL | HANDLE, box(150, 86, 240, 130)),
    ],
)
def test_what_is_marked_on_purpose_goes(ink, marked):
    assert np.array_equal(meant(ink, marked) & ink, marked & ink)


def test_loose_ends_that_a_mark_misses_go_too():
    ink = WALL | box(190, 90, 226, 106)
    gone = taken_off(ink, solid(ink), box(195, 80, 222, 120))
    assert np.array_equal(ink & ~gone, WALL)
    assert not taken_off(ink, solid(ink), ink & False).any()
