"""How motifs are brought nearer together, and which shape a pattern fills."""

from itertools import combinations
from math import hypot

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.model import CANVAS, Credit, Motif, Pictogram
from iconstudio.workflows.pattern.density import denser
from iconstudio.workflows.pattern.filling import enclosed, fitted
from iconstudio.workflows.pattern.layout import rasterised
from iconstudio.workflows.pattern.scattering import scattered, scattered_anew
from tests.shapes import outline

ICON = Pictogram("a:disc", "", Credit("disc", "", "", "", ""))
SQUARE = [(40, 40), (216, 40), (216, 216), (40, 216)]
HOLE = [(60, 60), (60, 196), (196, 196), (196, 60)]
SMALL_HOLE = [(100, 100), (100, 156), (156, 156), (156, 100)]


@given(st.floats(0.25, 4), st.integers(1, 12), st.integers(0, 20))
@settings(max_examples=30)
def test_so_many_more_lie_on_an_area_and_none_touch(density, count, seed):
    motifs = scattered([Pictogram(f"a:{n}", "", ICON.credit) for n in range(count)], seed)
    found, side = denser(motifs, density)
    assert len(found) == len(motifs)
    assert CANVAS**2 / side**2 == pytest.approx(density)
    for one, other in combinations(found, 2):
        apart = hypot(one.x - other.x, one.y - other.y)
        assert apart >= 0.99 * (one.size + other.size) / 2
    assert all(0 < one.x < side and 0 < one.y < side for one in found)
    shrunk = {round(one.size / before.size, 6) for one, before in zip(found, motifs, strict=True)}
    assert len(shrunk) == 1 and max(shrunk) <= 1


def test_what_lies_on_each_other_stays_together():
    cup, label = Motif(ICON, 60, 60, 80), Motif(ICON, 66, 52, 20)
    other = Motif(ICON, 200, 200, 80)
    (cup, label, _), _ = denser([cup, label, other], 1.4)
    assert (label.x - cup.x, label.y - cup.y) == pytest.approx((6, -8))
    (cup, label, _), _ = denser([cup, label, other], 4)
    assert (label.x - cup.x) / (label.y - cup.y) == pytest.approx(-6 / 8)
    assert label.size / cup.size == pytest.approx(0.25)


@given(st.integers(1, 14), st.integers(0, 20))
@settings(max_examples=20)
def test_scattered_anew_all_keep_colour_and_relative_size_and_what_lies_on_them(count, seed):
    cups = [Motif(ICON, 30 + 5 * n, 40, 20 + 4 * (n % 4), 10.0 * n, False, f"#0000{n:02x}")
            for n in range(1, count)]  # fmt: skip
    apart = [one for n, one in enumerate(cups) if not n % 5]
    plate, berry = Motif(ICON, 128, 180, 60), Motif(ICON, 138, 172, 12, colour="#ff0000")
    before = [plate, *apart, berry]
    after = scattered_anew(before, seed)
    shrunk = [b.size / a.size for a, b in zip(before, after, strict=True)]
    assert shrunk == pytest.approx([shrunk[0]] * len(shrunk), rel=0.02) and max(shrunk) <= 1
    assert [(one.icon, one.colour, one.turn) for one in after] == [
        (one.icon, one.colour, one.turn) for one in before
    ]
    offset = after[-1].x - after[0].x, after[-1].y - after[0].y
    assert offset == pytest.approx((10 * shrunk[0], -8 * shrunk[0]), abs=0.2)
    assert all(0 <= one.x <= CANVAS and 0 <= one.y <= CANVAS for one in after)
    assert after == scattered_anew(before, seed)


def test_scattered_anew_motifs_that_fit_stay_as_large_and_lie_elsewhere():
    before = scattered([Pictogram(f"a:{n}", "", ICON.credit) for n in range(9)])
    after = scattered_anew(before, 3)
    assert [one.size for one in after] == [one.size for one in before]
    moved = [hypot(a.x - b.x, a.y - b.y) for a, b in zip(before, after, strict=True)]
    assert sum(one > 40 for one in moved) > 4


def test_an_icon_in_lines_is_filled_whole_and_another_keeps_its_holes():
    lines, shape = outline(SQUARE, HOLE), outline(SQUARE, SMALL_HOLE)
    whole = rasterised(enclosed(lines), CANVAS) > 0.5
    assert whole.sum() == 176**2
    assert enclosed(shape) == shape


def test_a_shape_is_fitted_into_the_middle():
    mask = rasterised(fitted(outline(SQUARE), (128, 256)), 256, 128) > 0.5
    rows, columns = (np.flatnonzero(mask.any(axis=axis)) for axis in (1, 0))
    assert (rows[0], rows[-1], columns[0], columns[-1]) == (20, 107, 84, 171)
