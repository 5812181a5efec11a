"""What a remix is judged by, on shapes for which the answer is known."""

import numpy as np
import pytest

from iconstudio.algorithms.iconification.energy import (
    RemixProblem,
    data_cost,
    distance_field,
    joined_ink,
)
from iconstudio.algorithms.iconification.features import Remixed, features
from iconstudio.algorithms.iconification.looks import Looks, foreignness, stretches
from iconstudio.algorithms.iconification.plausibility import FEATURES, OF_OUTLINE
from iconstudio.algorithms.iconification.ranking import score
from iconstudio.algorithms.raster import overlap, solid
from iconstudio.model import CANVAS, Placement, Source
from tests.shapes import exemplar

YS, XS = np.mgrid[:CANVAS, :CANVAS] - CANVAS / 2 + 0.5


def disc(radius, x=0, y=0):
    return np.hypot(XS - x, YS - y) < radius


def ring(radius, width, x=0, y=0):
    return abs(np.hypot(XS - x, YS - y) - radius) < width / 2


def box(width, height, x=0, y=0):
    return (abs(XS - x) < width / 2) & (abs(YS - y) < height / 2)


WHEELS = ring(40, 12, -50, 40) | ring(40, 12, 50, 40) | box(160, 12, 0, -20)
ONE_WHEEL = ring(40, 12, -50, 40) | box(160, 12, 0, -20)
THICK = ring(40, 30, -50, 40) | ring(40, 30, 50, 40) | box(160, 30, 0, -20)
HALVES = np.where(XS > 0, 1, 0).astype(np.uint8)


def judged(*inks, labels=HALVES, outline=None, drawn=None):
    """The features of some sources joined, by default the right half of the second."""
    ink = np.stack(inks)
    filled = np.stack([solid(one) for one in inks])
    data = np.zeros(ink.shape, np.float32)
    if outline is not None:
        data = data_cost(distance_field(outline), filled)
    sources = [Source(exemplar(one, str(k)), Placement()) for k, one in enumerate(inks)]
    problem = RemixProblem(data, ink, filled)
    return features(
        Remixed(
            problem,
            labels,
            joined_ink(ink, labels) if drawn is None else drawn,
            score(problem, labels),
            sources,
            [Looks(one) for one in inks],
            None if outline is None else Looks(outline),
        )
    )


def test_every_feature_is_measured():
    found = judged(WHEELS, WHEELS, outline=solid(WHEELS))
    assert tuple(found) == FEATURES
    assert all(np.isfinite(value) for value in found.values())


def test_nothing_is_wrong_with_a_drawing_itself():
    found = judged(WHEELS, WHEELS, outline=solid(WHEELS))
    for name in (
        *("unlike_ink", "unlike_filled", "holes_of_nearest", "symmetry", "placed_filled", "gap"),
        *("foreign", "foreign_length", "seam", "foreign_worst", "loose", "more_pieces"),
        *("fewer_pieces", "more_holes", "fewer_holes", "new_ends", "width_spread", "widths_mixed"),
        *("moves", "missing", "missing_depth", "lopsided"),
    ):
        assert found[name] == pytest.approx(0, abs=1e-4), name  # a seam costs EPSILON
    assert found["iou"] == 1


def test_what_concerns_the_outline_is_unknown_without_one():
    found = judged(WHEELS, WHEELS)
    unknown = {name for name, value in found.items() if np.isnan(value)}
    assert unknown == set(OF_OUTLINE)


def test_a_wheel_that_is_lost_is_missed():
    found = judged(WHEELS, ONE_WHEEL, outline=solid(WHEELS))
    # A disc of radius 46 in a shape of two discs and a bar.
    size = np.sqrt(solid(WHEELS).sum())
    assert found["missing_depth"] == pytest.approx(46 / size, rel=0.05)
    assert found["symmetry"] > 0.2
    assert judged(WHEELS, WHEELS, outline=solid(WHEELS))["missing_depth"] == 0


def test_what_is_not_symmetric_is_lopsided_where_the_outline_is_symmetric():
    left = WHEELS.copy()
    left[:, CANVAS // 2 :] = solid(WHEELS)[:, CANVAS // 2 :]  # filled on one side
    symmetric, leaning = solid(WHEELS), solid(WHEELS) & ~disc(60, 50, 40)
    found = judged(WHEELS, WHEELS, drawn=left, outline=symmetric)
    assert found["lopsided"] == pytest.approx(1 - overlap(left, left[:, ::-1]), abs=0.01)
    assert found["lopsided"] > 0.1
    assert judged(WHEELS, WHEELS, drawn=left, outline=leaning)["lopsided"] == 0


def test_a_wheel_that_the_nearest_drawing_has_is_a_gap():
    drawn = WHEELS & ~disc(60, 50, 40)
    found = judged(WHEELS, WHEELS, drawn=drawn)
    assert found["gap"] == pytest.approx(46 / CANVAS, rel=0.05)
    assert found["holes_of_nearest"] == pytest.approx(np.log(3 / 2))


def test_a_picture_is_like_a_drawing_however_that_is_stretched_or_mirrored():
    lying = box(160, 40) | box(30, 100, 60)
    flipped = box(120, 80) | box(22.5, 200, -45)
    found = judged(lying, lying, drawn=flipped)
    assert found["unlike_ink"] < 0.05
    assert found["unlike_filled"] < 0.05
    assert found["placed_filled"] > 0.2
    assert judged(lying, lying, drawn=disc(80))["unlike_filled"] > 0.2


def test_a_step_in_a_contour_is_foreign():
    even, step = judged(box(160, 30), box(160, 30)), judged(box(160, 30), box(160, 30, y=8))
    assert even["foreign"] == 0
    assert 0.1 < step["foreign"] < 0.5
    assert step["foreign_worst"] > even["foreign_worst"]
    assert step["seam"] > even["seam"]


def test_stretches_are_compared_wherever_they_lie_but_not_turned():
    upright, moved, leaning = (
        stretches((np.array([z + shift for z in base]),))
        for base, shift in (
            ((lambda t: 1j * t)(np.arange(80.0)), 0),
            ((lambda t: 1j * t)(np.arange(80.0)), 30 + 5j),
            ((lambda t: 1j * t * np.exp(0.2j))(np.arange(80.0)), 0),
        )
    )
    middle = slice(12, 28)  # the lines do not close
    assert foreignness(upright[middle], moved[middle]).max() == pytest.approx(0, abs=0.01)
    # Points up to 20 px from the middle lie off by 2 sin(0.1) times that; root mean square 12.1.
    assert foreignness(leaning[middle], upright[middle]) == pytest.approx(
        2 * np.sin(0.1) * 12.1, rel=0.02
    )


def test_strokes_of_two_widths_are_told():
    found = judged(WHEELS, THICK)
    assert found["widths_mixed"] > 0.3
    assert found["width_spread"] > 0.5


def test_an_end_that_no_source_has_is_new():
    labels = np.where(disc(20, 0, -20), 1, 0).astype(np.uint8)
    broken = judged(WHEELS, ring(40, 12, -50, 40), labels=labels)
    assert np.expm1(broken["new_ends"]) in (2, 3, 4)  # the middle of a blunt end may fork
    assert broken["more_pieces"] > 0.2


def test_a_finer_canvas_is_judged_alike():
    def fine(picture):
        return picture.repeat(2, axis=0).repeat(2, axis=1)

    def of(labels, inks, outline):
        filled = np.stack([solid(one) for one in inks])
        ink, data = np.stack(inks), data_cost(distance_field(outline), filled)
        step = len(labels) // CANVAS
        small = [one[::step, ::step] for one in inks]
        sources = [Source(exemplar(one, str(k)), Placement()) for k, one in enumerate(small)]
        drawn = joined_ink(ink, labels)[::step, ::step]
        looks = [Looks(one) for one in small]
        shape = Looks(outline[::step, ::step])
        problem = RemixProblem(data, ink, filled)
        return features(
            Remixed(problem, labels, drawn, score(problem, labels), sources, looks, shape)
        )

    inks, outline = [WHEELS, THICK], solid(WHEELS)
    plain = of(HALVES, inks, outline)
    finer = of(fine(HALVES), [fine(one) for one in inks], fine(outline))
    for name in FEATURES:
        assert finer[name] == pytest.approx(plain[name], abs=0.15), name


def test_a_blank_picture_is_judged_too():
    nothing = np.zeros_like(WHEELS)
    found = judged(nothing, nothing, outline=solid(WHEELS))
    assert found["missing"] == 1
    assert np.isfinite([found[name] for name in FEATURES]).all()
