"""Where an outline runs along a curve of its source, it is that curve."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.tracing.vectorize import trace
from iconstudio.model import CANVAS, Frame, Path
from iconstudio.svg.resvg import render_coverage
from tests.paths import circle, rectangle, segments

N = 4 * CANVAS


def picture(*paths: Path) -> np.ndarray:
    data = "".join(path.svg() for path in paths)
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 256 256"><path d="{data}"/></svg>'
    return render_coverage(svg, Frame(0, 0, CANVAS), N)


numbers = st.floats(60, 120).map(lambda value: round(value, 2))


@settings(max_examples=15)
@given(numbers, numbers, st.floats(10, 50).map(lambda value: round(value, 2)))
def test_what_has_one_source_is_its_own_path(x, y, size):
    round_one, square = circle(x, y, size), rectangle(x + size + 5, y, 2 * size, size)
    traced = trace(picture(round_one, square), sources=[round_one, square])
    assert segments(traced) == segments(round_one) | segments(square)


def test_away_from_a_seam_curves_are_exact_and_nothing_else_is():
    """The left half of a circle, and the right one of another, a canvas unit lower."""
    one, other = circle(128, 128, 80), circle(128, 129, 80)
    coverage = picture(one)
    coverage[:, N // 2 :] = picture(other)[:, N // 2 :]
    traced = trace(coverage, sources=[one, other])
    for row in segments(traced):
        weights = (1, 3, 3, 1) if len(row) == 4 else (4, 4)
        middle = sum(w * complex(*p) for w, p in zip(weights, row, strict=True)) / 8
        centre = 128 + (128j if middle.real < 128 else 129j)
        if abs(middle.real - 128) > 20:
            assert abs(middle - centre) == pytest.approx(80, abs=0.03)
    assert (48.0, 128.0) in {end for row in segments(traced) for end in (row[0], row[-1])}
    assert (208.0, 129.0) in {end for row in segments(traced) for end in (row[0], row[-1])}
    assert len(segments(traced)) <= 12


def test_curves_that_cross_meet_where_they_cross():
    """Of an overlap of two squares, the outline has the corners of both, and where sides cross."""
    one, other = rectangle(40, 40, 100, 100), rectangle(90, 90, 100, 100)
    traced = trace(picture(one, other), sources=[one, other])
    ends = {end for row in segments(traced) for end in (row[0], row[-1])}
    assert ends == {
        (40, 40), (140, 40), (140, 90), (190, 90), (190, 190), (90, 190), (90, 140), (40, 140),
    }  # fmt: skip


def test_a_source_that_lies_elsewhere_changes_nothing():
    coverage = picture(circle(128, 128, 60))
    other = [rectangle(10, 10, 30, 30), circle(128, 128, 70), Path()]
    assert trace(coverage, sources=other) == trace(coverage)


@pytest.mark.parametrize("off", [0.2, 0.5])
def test_a_curve_that_is_near_but_not_the_drawn_one_is_not_taken(off):
    drawn, near = rectangle(60, 60, 100, 100), rectangle(60 + off, 60 + off, 100, 100)
    traced = trace(picture(drawn), sources=[near])
    ends = [end for row in segments(traced) for end in (row[0], row[-1])]
    assert max(min(abs(x - 60), abs(x - 160)) for x, _ in ends) < 0.05
