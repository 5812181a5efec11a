import math

import numpy as np
import pytest
from scipy import ndimage

from iconstudio.algorithms.iconification.energy import remix_problem
from iconstudio.algorithms.iconification.guide import (
    DETAIL,
    UNGUIDED,
    Channel,
    check_inner,
    guide_of,
    sharpness,
    strokes,
)
from iconstudio.algorithms.iconification.matching import Matcher, prepare
from iconstudio.algorithms.iconification.saliency import (
    SMALL,
    WHOLE,
    saliency,
    salient_regions,
)
from iconstudio.algorithms.iconification.tsdf import D_MAX, tsdf
from iconstudio.algorithms.raster import fill_polygon, placed_ink
from iconstudio.model import CANVAS, IconstudioError, Inner, Placement, Polygon, Sketch, Source
from tests.shapes import exemplar

SQUARE = Polygon.of([(48, 48), (208, 48), (208, 208), (48, 208)])
HOLE = Polygon.of([(70, 110), (110, 110), (110, 150), (70, 150)])
LINE = ((128.0, 80.0), (128.0, 176.0))


def block(*holes):
    ink = fill_polygon(SQUARE)
    for left, top, right, bottom in holes:
        ink[top:bottom, left:right] = False
    return ink


def frame(*bars):
    ink = block((64, 64, 192, 192))
    for left, top, right, bottom in bars:
        ink[top:bottom, left:right] = True
    return ink


PLAIN = exemplar(block(), "plain")
HOLED = exemplar(block((70, 110, 110, 150)), "holed")
ELSEWHERE = exemplar(block((110, 70, 150, 110)), "elsewhere")
EMPTY = exemplar(frame(), "empty")
BAR = exemplar(frame((121, 80, 135, 176)), "bar")
LEVEL = exemplar(frame((80, 121, 176, 135)), "level")
SLIT = exemplar(block((124, 80, 132, 176)), "slit")


def sketch(**inner):
    return Sketch(SQUARE, "shape", inner=Inner(**inner))


def field(shape):
    """The signed distances of a shape by the book, positive outside, at most D_MAX."""
    far = D_MAX * np.ones(shape.shape)
    outside = ndimage.distance_transform_edt(~shape) if shape.any() else far
    inside = ndimage.distance_transform_edt(shape) if not shape.all() else far
    return np.clip(outside - inside, -D_MAX, D_MAX) / CANVAS


def matched(collection, wanted, guide=None):
    """The exemplars by rising error over the whole canvas, and the errors."""
    matcher = Matcher([*map(prepare, collection)], threads=1)
    fitted = tsdf(fill_polygon(wanted.polygon))
    run = matcher.match(
        fitted, [WHOLE], range(len(collection)), guide_of(wanted) if guide is None else guide
    )
    while True:
        try:
            next(run)
        except StopIteration as end:
            (row,) = end.value
            return [
                (collection[one.index].id.removeprefix("test:"), one.placement, one.error)
                for one in row
            ]


def test_a_hole_changes_the_best_match():
    collection = [PLAIN, ELSEWHERE, HOLED]
    assert [name for name, *_ in matched(collection, sketch())] == ["plain", "elsewhere", "holed"]
    (name, placement, error), (_, _, next_error), _ = matched(collection, sketch(holes=(HOLE,)))
    assert (name, placement) == ("holed", Placement())
    assert error < next_error / 4


@pytest.mark.parametrize(
    ("collection", "first"), [([EMPTY, LEVEL, BAR], "bar"), ([PLAIN, HOLED, SLIT], "slit")]
)
def test_a_line_is_matched_by_a_stroke_of_ink_or_of_paper(collection, first):
    assert matched(collection, sketch(lines=(LINE,)))[0][0] == first
    assert matched(collection, sketch())[0][0] != first


@pytest.mark.parametrize("one", [PLAIN, HOLED, ELSEWHERE, BAR, SLIT], ids=lambda one: one.name)
def test_errors_and_costs_are_those_worked_out_by_hand(one):
    wanted = sketch(holes=(HOLE,), lines=(LINE,))
    guide = guide_of(wanted)
    ink, filled = placed_ink(one, Placement())
    hole = fill_polygon(HOLE)
    drawn = np.zeros_like(hole)
    drawn[80:177, 128] = True
    rim = np.zeros_like(hole)
    rim[110:151, [70, 110]] = rim[[110, 150], 70:111] = True
    near = {
        name: np.exp(-0.5 * (ndimage.distance_transform_edt(~shape) / 4) ** 2)
        for name, shape in (("line", drawn), ("rim", rim))
    }
    near = {name: np.where(value > 0.01, value, 0) for name, value in near.items()}
    differences = [
        (np.ones_like(near["line"]), field(fill_polygon(SQUARE)) - field(filled)),
        (hole * (1 - near["line"]), field(~hole) - field(ink)),
        (
            np.maximum(3 * near["line"], 2 * near["rim"]),
            np.maximum(field(strokes(ink)), 0),
        ),
    ]
    error = sum((weight * difference**2).sum() for weight, difference in differences)
    cost = sum(weight * abs(difference) for weight, difference in differences)

    region = Source(one, Placement())
    found = {name: value for name, at, value in matched([one], wanted) if at == Placement()}
    if found:  # no other placement is better
        assert found[one.id.removeprefix("test:")] == pytest.approx(error, rel=1e-3, abs=1e-3)
    else:
        assert matched([one], wanted)[0][2] < error
    problem = remix_problem(tsdf(fill_polygon(SQUARE)), [region])
    assert np.allclose(guide.guided(problem)[0], cost, atol=1e-5)


def test_holes_count_in_the_data_cost():
    sources = [Source(one, Placement()) for one in (PLAIN, HOLED, ELSEWHERE)]
    problem = remix_problem(tsdf(fill_polygon(SQUARE)), sources)
    assert problem.data.sum() == 0  # the outline is the same
    plain, holed, elsewhere = guide_of(sketch(holes=(HOLE,))).guided(problem).sum(axis=(1, 2))
    assert holed < plain / 4
    assert holed < elsewhere / 4


def test_without_anything_inside_all_is_as_in_the_paper():
    guide = guide_of(sketch())
    assert (guide.weight, guide.aims) == (None, ())
    problem = remix_problem(tsdf(fill_polygon(SQUARE)), [Source(HOLED, Placement())])
    assert guide.guided(problem) is problem.data
    collection = [PLAIN, HOLED, BAR]
    assert matched(collection, sketch()) == matched(collection, sketch(), UNGUIDED)


def test_strokes_are_thin_ink_thin_paper_in_ink_and_ends_of_paper():
    found = strokes(frame((121, 80, 135, 176)))
    assert found[128, 128]
    assert found[56, 128]
    assert not found[128, 100]
    slit = strokes(block((124, 80, 132, 176)))
    assert slit[128, 128]
    assert not slit[128, 100]
    window = strokes(block((70, 110, 110, 150)))
    assert window[130, 70]
    assert not window[130, 90]


def test_sharpness_is_at_corners_and_not_where_an_outline_bends_gently():
    at = np.linspace(0, 2 * np.pi, 60, endpoint=False)
    circle = Polygon.of(np.stack([128 + 100 * np.cos(at), 128 + 100 * np.sin(at)], axis=1))
    assert sharpness(circle).max() == 0
    corner = sharpness(SQUARE)
    assert corner[48, 48] == 1
    assert corner[48, 128] == corner[128, 128] == 0
    assert np.array_equal(sharpness(SQUARE, 512)[::2, ::2], corner)


def test_the_weight_of_details_counts_at_corners_alone():
    wanted = Sketch(SQUARE, "shape", detail=0.5)
    weight = guide_of(wanted).weight
    assert weight[48, 48] == 1 + 0.5 * DETAIL
    assert weight[48, 128] == 1


def test_regions_of_details_are_smaller_and_lie_closer():
    score = saliency([SQUARE], fill_polygon(SQUARE), extent=SMALL)
    regions = salient_regions(score, 6, SMALL)
    assert len(regions) == 6
    corners = [(x, y) for x in (48, 208) for y in (48, 208)]
    away = [min(math.dist(one.centre, corner) for corner in corners) for one in regions[:4]]
    assert max(away) < 30
    assert regions[0].mask.sum() < 0.25 * WHOLE.mask.sum()


@pytest.mark.parametrize(
    ("inner", "said"),
    [
        (Inner((Polygon.of([(10, 10), (30, 10), (30, 30)]),)), "Hole 1 lies outside"),
        (Inner((HOLE, Polygon.of([(30, 60), (90, 60), (90, 90)]))), "Hole 2 crosses"),
        (Inner(lines=(LINE, ((128, 128), (250, 128)))), "Line 2 crosses the outline"),
        (Inner(lines=(((1e9, 1e9), (1e9, 2)),)), "Line 1 lies outside"),
        (Inner((Polygon.of([(80, 80), (80.1, 80), (80.1, 80.1)]),)), "too small to be seen"),
    ],
)
def test_what_does_not_lie_inside_is_told(inner, said):
    with pytest.raises(IconstudioError, match=said):
        check_inner(inner, fill_polygon(SQUARE))


def test_what_lies_in_a_removed_part_is_told_so():
    left = Polygon.of([(48, 48), (128, 48), (128, 208), (48, 208)])
    gone = fill_polygon(left)
    outline = fill_polygon(SQUARE) & ~gone
    for inner, said in (
        (Inner((HOLE,)), "Hole 1 lies in what is removed"),
        (Inner((Polygon.of([(100, 100), (160, 100), (160, 150)]),)), "Hole 1 reaches into what is"),
        (Inner(lines=(((60, 60), (90, 90)),)), "Line 1 lies in what is removed"),
        (Inner(lines=(((60, 60), (20, 90)),)), "Line 1 lies outside the outline"),
        (Inner((Polygon.of([(20, 60), (180, 60), (180, 90)]),)), "Hole 1 crosses the outline"),
    ):
        with pytest.raises(IconstudioError, match=said):
            check_inner(inner, outline, gone)


def test_a_hole_around_a_part_of_the_outline_covers_it():
    small = Polygon.of([(220, 220), (240, 220), (240, 240), (220, 240)])
    around = Polygon.of([(214, 214), (250, 214), (250, 250), (214, 250)])
    with pytest.raises(IconstudioError, match="Hole 1 covers a part of the outline"):
        check_inner(Inner((around,)), fill_polygon(SQUARE) | fill_polygon(small))


def test_what_touches_the_outline_lies_inside():
    half = Polygon(((48, 48), (128, 48), (128, 208), (48, 208)))
    check_inner(Inner((half,), (((48, 48), (208, 208)),)), fill_polygon(SQUARE))


def test_a_channel_of_strokes_knows_no_distance_inside():
    assert (Channel.STROKES.field(BAR.ink) >= 0).all()
    assert Channel.STROKES.field(BAR.ink)[128, 128] == 0
