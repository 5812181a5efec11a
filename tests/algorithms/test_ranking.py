import numpy as np
import pytest

from iconstudio.algorithms.iconification.energy import RemixProblem
from iconstudio.algorithms.iconification.ranking import Gallery, score, seam_cost
from iconstudio.algorithms.raster import solid
from iconstudio.model import CANVAS, Axis
from tests.shapes import blob

YS, XS = np.mgrid[:CANVAS, :CANVAS] - CANVAS / 2 + 0.5


def problem_of(*inks, symmetry=None):
    ink = np.stack(inks)
    data = np.zeros(ink.shape, np.float32)
    return RemixProblem(data, ink, np.stack([solid(one) for one in inks]), symmetry)


def halves():
    labels = np.zeros((CANVAS, CANVAS), np.uint8)
    labels[:, CANVAS // 2 :] = 1
    return labels


def bar(height, dy=0):
    return (abs(XS) < 80) & (abs(YS - dy) < height)


def test_a_seam_between_equal_drawings_scores_better_than_a_step():
    labels = halves()
    same = score(problem_of(bar(20), bar(20)), labels)
    step = score(problem_of(bar(20), bar(20, 6)), labels)
    larger = score(problem_of(bar(20), bar(20, 14)), labels)
    assert same.seam > 0.98
    assert same.seam > step.seam > larger.seam


@pytest.mark.parametrize("scale", [2, 4])
def test_a_finer_canvas_scores_alike(scale):
    axis = Axis.HORIZONTAL

    def fine(picture):
        return picture.repeat(scale, axis=0).repeat(scale, axis=1)

    inks = bar(20), bar(20, 6)
    torn = halves()
    torn[100:115, 30:45] = 1
    plain = score(problem_of(*inks, symmetry=axis), torn, sharing=True)
    finer = score(problem_of(*map(fine, inks), symmetry=axis), fine(torn), sharing=True)
    for term in ("whole", "symmetry", "sharing"):
        assert getattr(finer, term) == pytest.approx(getattr(plain, term), abs=0.02)
    assert plain.seam < 0.95
    assert finer.seam == pytest.approx(plain.seam, abs=0.05)


def test_seams_through_common_white_are_not_seen():
    labels = np.zeros((CANVAS, CANVAS), np.uint8)
    labels[:40] = 1
    assert seam_cost(problem_of(bar(20), bar(30)), labels) == 0


def test_a_piece_that_floats_free_counts_unless_its_source_has_it():
    column = (abs(XS) < 15) & (abs(YS) < 90)
    labels = np.zeros((CANVAS, CANVAS), np.uint8)
    labels[80:110] = 1  # cuts the column in two: nothing there in the other source
    nothing = np.zeros_like(column)
    torn = score(problem_of(column, nothing), labels)
    assert torn.whole < 0.5
    dots = (np.hypot(XS, YS - 60) < 20) | (np.hypot(XS, YS + 60) < 20)
    assert score(problem_of(dots, nothing), np.zeros_like(labels)).whole == 1


def test_sharing_counts_only_where_it_is_asked_for():
    both = problem_of(bar(20), bar(20))
    one = np.zeros((CANVAS, CANVAS), np.uint8)
    assert score(both, one).sharing == 1
    assert score(both, one, sharing=True).sharing == 0
    assert score(both, halves(), sharing=True).sharing == 1
    most = np.zeros((CANVAS, CANVAS), np.uint8)
    most[:, CANVAS // 2 + 60 :] = 1
    assert 0 < score(both, most, sharing=True).sharing < 1


def test_symmetry_is_judged_against_the_sources():
    left, right = bar(20), bar(40)
    held = problem_of(left, right, symmetry=Axis.HORIZONTAL)
    assert score(held, np.zeros((CANVAS, CANVAS), np.uint8)).symmetry == 1
    lopsided = score(held, halves()).symmetry
    assert lopsided < 0.7
    crooked = bar(20) & ((XS < 0) | (YS < 5))
    same = problem_of(crooked, crooked, symmetry=Axis.HORIZONTAL)
    assert score(same, halves()).symmetry == 1


def test_total_is_the_product():
    one = score(problem_of(bar(20), bar(26)), halves(), sharing=True)
    assert one.total == one.seam * one.whole * one.symmetry * one.sharing * one.likeness


def test_repeats_are_told_by_their_looks():
    seen = Gallery()
    assert seen.add(blob(1))
    assert not seen.add(blob(1))
    assert not seen.add(np.roll(blob(1), 2, axis=1))  # moved by a hair
    assert seen.add(blob(2))
    holed = blob(1) & ~(np.hypot(XS, YS) < 25)
    assert seen.add(holed)
