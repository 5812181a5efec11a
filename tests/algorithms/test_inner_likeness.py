import numpy as np
import pytest

from iconstudio.algorithms.iconification.inner_likeness import inner_likeness
from iconstudio.algorithms.raster import fill_polygon
from iconstudio.model import Inner, Polygon

SQUARE = Polygon.of([(48, 48), (208, 48), (208, 208), (48, 208)])
HOLE = Polygon.of([(80, 110), (120, 110), (120, 150), (80, 150)])
LINE = ((128.0, 80.0), (128.0, 176.0))
BLOCK = fill_polygon(SQUARE)


def without(left, top, right, bottom, ink=BLOCK):
    ink = ink.copy()
    ink[top:bottom, left:right] = False
    return ink


def with_bar(left, top, right, bottom, ink):
    ink = ink.copy()
    ink[top:bottom, left:right] = True
    return ink


FRAME = without(64, 64, 192, 192)
HOLED = without(80, 110, 120, 150)
BESIDE = without(140, 110, 180, 150)


@pytest.mark.parametrize("finer", [1, 2])
def test_a_hole_is_there_wholly_or_not_at_all(finer):
    def shown(ink):
        return inner_likeness(Inner((HOLE,)), np.kron(ink, np.ones((finer, finer), bool)))

    assert shown(HOLED) == 1
    assert shown(BLOCK) == shown(BESIDE) == 0


def test_paper_without_a_rim_is_no_hole():
    assert inner_likeness(Inner((HOLE,)), FRAME) < 0.1
    ring = with_bar(76, 106, 124, 154, FRAME) & ~fill_polygon(HOLE)
    assert inner_likeness(Inner((HOLE,)), ring) == 1


def test_a_line_is_a_stroke_of_ink_or_of_paper_along_it():
    lines = Inner(lines=(LINE,))
    assert inner_likeness(lines, with_bar(124, 78, 132, 178, FRAME)) == 1
    assert inner_likeness(lines, without(124, 78, 132, 178)) == 1
    assert inner_likeness(lines, BLOCK) == 0
    across = inner_likeness(lines, with_bar(80, 124, 176, 132, FRAME))
    assert across == pytest.approx((20 / 96) ** 2, abs=0.01)  # a stroke of 8, and 6 on each side


def test_half_a_line_counts_for_a_quarter():
    half = inner_likeness(Inner(lines=(LINE,)), with_bar(124, 80, 132, 122, FRAME))
    assert half == pytest.approx(0.25, abs=0.03)  # a stroke of 42, and 6 beyond it, of 96


def test_all_that_is_drawn_counts_alike_and_nothing_is_always_there():
    inner = Inner((HOLE,), (LINE,))
    assert inner_likeness(inner, HOLED) == pytest.approx(0.5, abs=0.05)
    assert inner_likeness(Inner(), BLOCK) == 1
