import numpy as np
import pytest

from iconstudio.algorithms.iconification.guidance import scribble
from iconstudio.algorithms.iconification.midlines import midlines
from iconstudio.model import CANVAS, Stroke

YS, XS = np.mgrid[:CANVAS, :CANVAS] + 0.5


def test_a_bar_has_one_line_along_its_middle():
    bar = (abs(YS - 128) < 10) & (abs(XS - 128) < 80)
    points, widths = max(midlines(bar), key=lambda line: len(line[0]))
    xs, ys = np.array(points).T
    assert abs(ys - 128).max() <= 1
    assert np.ptp(xs) > 130
    assert max(widths) == pytest.approx(20, abs=1.5)


@pytest.mark.parametrize("side", [CANVAS, 2 * CANVAS])
def test_discs_along_the_lines_lie_in_the_shape_and_cover_it(side):
    ys, xs = (np.mgrid[:side, :side] + 0.5) * CANVAS / side
    ring = (np.hypot(xs - 128, ys - 128) < 90) & (np.hypot(xs - 128, ys - 128) > 70)
    cross = ((abs(xs - 60) < 8) | (abs(ys - 60) < 12)) & (xs < 220) & (ys < 220)
    shape = ring | cross
    covered = np.zeros_like(shape)
    for points, widths in midlines(shape):
        for point, width in zip(points, widths, strict=True):
            covered |= scribble([Stroke(width, (point,))], side)
    assert not (covered & ~shape).any()
    assert (covered & shape).sum() > 0.97 * shape.sum()


def test_a_dot_is_a_point_and_nothing_has_no_lines():
    dot = np.zeros((CANVAS, CANVAS), bool)
    assert midlines(dot) == ()
    dot[30, 40] = True
    assert midlines(dot) == ((((40.5, 30.5),), (1.0,)),)


def test_a_shape_at_the_border_ends_there():
    left = XS < 20
    assert max(max(widths) for _, widths in midlines(left)) == pytest.approx(20, abs=1.5)
