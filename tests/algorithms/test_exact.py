"""Where an outline runs along a curve of its source, it is that curve."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.flattening import flattened
from iconstudio.algorithms.iconification.healing import Examples
from iconstudio.algorithms.iconification.joined_path import joined_path
from iconstudio.algorithms.regions import doubled
from iconstudio.algorithms.tracing.exact import Followed
from iconstudio.algorithms.tracing.pieces import pieces_of
from iconstudio.algorithms.tracing.source_curve import SourceCurve
from iconstudio.algorithms.tracing.vectorize import outlines, trace
from iconstudio.model import CANVAS, Frame, Path
from iconstudio.model.path import Contour
from iconstudio.svg.resvg import render_coverage
from tests.paths import circle, rectangle, segments

N = 4 * CANVAS


def picture(*paths: Path) -> np.ndarray:
    data = "".join(path.svg() for path in paths)
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 256 256"><path d="{data}"/></svg>'
    return render_coverage(svg, Frame(0, 0, CANVAS), N)


numbers = st.floats(60, 90).map(lambda value: round(value, 2))


@settings(max_examples=15)
@given(numbers, numbers, st.floats(10, 50).map(lambda value: round(value, 2)))
def test_what_has_one_source_is_its_own_path(x, y, size):
    round_one, square = circle(x, y, size), rectangle(x + size + 5, y, 2 * size, size)
    traced = joined_path(picture(round_one, square), [round_one, square])
    assert segments(traced) == segments(round_one) | segments(square)


@pytest.mark.parametrize("off", [0.5, 1, 2])
def test_two_halves_of_a_circle_that_lie_apart_are_a_circle(off):
    one, other = circle(128, 128, 80), circle(128, 128 + off, 80)
    coverage = picture(one)
    coverage[:, N // 2 :] = picture(other)[:, N // 2 :]
    traced = joined_path(coverage, [one, other])
    (row,) = [points for points, _ in flattened(traced)]
    middle = (row.max(axis=0) + row.min(axis=0)) / 2
    assert abs(np.hypot(*(row - middle).T) - 80).max() < 0.3
    assert len(segments(traced)) <= 12


@pytest.mark.parametrize("off", [0.5, 1, 2])
def test_two_halves_of_a_stroke_that_lie_apart_are_a_stroke(off):
    one, other = rectangle(30, 100, 196, 24), rectangle(30, 100 + off, 196, 24)
    coverage = picture(one)
    coverage[:, N // 2 :] = picture(other)[:, N // 2 :]
    traced = joined_path(coverage, [one, other])
    tops = {y for points in segments(traced) for _, y in points}
    assert len(tops) <= 4
    assert max(tops) - min(tops) == pytest.approx(24, abs=0.3)


def test_away_from_a_seam_curves_are_exact():
    """The left half of a circle, and the right one of a larger one."""
    one, other = circle(128, 128, 80), circle(128, 128, 82)
    coverage = picture(one)
    coverage[:, N // 2 :] = picture(other)[:, N // 2 :]
    for row, _ in flattened(joined_path(coverage, [one, other], heal=False)):
        away = np.hypot(*(row - 128).T)
        left, right = row[:, 0] < 95, row[:, 0] > 161
        assert abs(away[left] - 80).max() < 0.03
        assert abs(away[right] - 82).max() < 0.03
        assert away.min() > 79.8
        assert away.max() < 82.2


def test_a_row_that_ends_at_the_node_where_it_begins_is_no_run():
    (contour,) = circle(128, 128, 80).contours
    curve = SourceCurve.of(contour, 0.25)
    ends = np.array([curve.length - 0.2, curve.length + 0.2])
    (outline,) = outlines(picture(circle(128, 128, 80)))
    run = Followed(curve, 0, ends).run()
    assert run.pieces == []
    assert pieces_of(outline.even(), 1.0, 1, [run]) == pieces_of(outline.even(), 1.0, 1)


def test_a_corner_that_was_cut_off_does_not_come_back_as_a_spike():
    spiky = Path((Contour((40, 40), (((200, 60),), ((40, 80),))),))
    coverage = picture(spiky)
    coverage[:, 4 * 170 :] = 0
    for row, _ in flattened(joined_path(coverage, [spiky])):
        assert row[:, 0].max() < 171


def test_curves_that_cross_meet_where_they_cross():
    """Of an overlap of two squares, the outline has the corners of both, and where sides cross."""
    one, other = rectangle(40, 40, 100, 100), rectangle(90, 90, 100, 100)
    traced = joined_path(picture(one, other), [one, other])
    ends = {end for row in segments(traced) for end in (row[0], row[-1])}
    assert ends == {
        (40, 40), (140, 40), (140, 90), (190, 90), (190, 190), (90, 190), (90, 140), (40, 140),
    }  # fmt: skip


def test_where_no_contour_is_long_enough_to_learn_from_seams_stay_as_they_are_drawn():
    small, bump = rectangle(100, 100, 6, 5), circle(106, 102.5, 1.5)
    coverage = picture(small, bump)
    assert joined_path(coverage, [small]) == joined_path(coverage, [small], heal=False)


def test_a_source_that_lies_elsewhere_changes_nothing():
    coverage = picture(circle(128, 128, 60))
    other = [rectangle(10, 10, 30, 30), circle(128, 128, 70), Path()]
    assert joined_path(coverage, other) == trace(coverage)


@pytest.mark.parametrize("off", [0.2, 0.5])
def test_a_curve_that_is_near_but_not_the_drawn_one_is_not_taken(off):
    drawn, near = rectangle(60, 60, 100, 100), rectangle(60 + off, 60 + off, 100, 100)
    traced = joined_path(picture(drawn), [near])
    ends = [end for row in segments(traced) for end in (row[0], row[-1])]
    assert max(min(abs(x - 60), abs(x - 160)) for x, _ in ends) < 0.05


def test_the_likely_examples_of_a_seam_are_those_nearest_to_it():
    random = np.random.default_rng(0)
    rows = (random.normal(size=(3000, 21)) + 1j * random.normal(size=(3000, 21))).astype(complex)
    rows[1000:2000] = rows[:1000]  # as of an icon that lies at two places
    rows -= rows.mean(axis=1, keepdims=True)
    few = Examples(rows.astype(np.complex64)).compared(rows[::600]).likely()
    assert few.compared(rows[::600]).away().max() < 1e-2
    kept = [Examples(rows[k : k + 1].astype(np.complex64)) for k in range(3000)]
    errors = np.array([one.compared(rows[:1]).away()[0] for one in kept])
    wanted = rows[np.argsort(errors)[:20]]
    assert few.compared(wanted).away().max() < 1e-2


def test_a_path_that_covers_itself_is_told_by_the_area_that_it_covers_twice():
    square = circle(64, 64, 40)
    moved = circle(90, 64, 40)
    assert doubled(Path(square.contours)) < 0.01
    twice = doubled(Path((*square.contours, *moved.contours)))
    lens = 2 * 40**2 * np.arccos(26 / 80) - 26 / 2 * np.sqrt(4 * 40**2 - 26**2)
    assert abs(twice - lens) < 0.01 * lens
