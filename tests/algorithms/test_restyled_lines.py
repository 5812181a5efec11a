"""Lines in a style, as the program asks for them: they close, meet, and cross no others."""

from dataclasses import replace

import numpy as np
import pytest
import shapely

from iconstudio.algorithms.curves.outline import path_of, strokes_of
from iconstudio.algorithms.curves.restyle import prepare, restyled
from iconstudio.algorithms.flattening import flattened
from iconstudio.inputs.styles import named
from iconstudio.model import Line, LineStyle, StylePair
from tests.line_styles import STYLES, circle

pytestmark = pytest.mark.thorough(but=1)


def style_of(name, **more):
    points = tuple((0.6 * z.real, 0.6 * z.imag) for z in STYLES[name]()[::2].tolist())
    return LineStyle(name, (StylePair(points),), **more)


@pytest.fixture(scope="module", params=["jitter", "castle", "brush"])
def style(request):
    return prepare(style_of(request.param))


def line(*points, width=20.0, closed=False):
    return Line(tuple(points), closed, width)


def styled(lines, style, seed=1):
    return restyled([(one, style) for one in lines], seed)


def end(one, index):
    return complex(*one.points[index])


def test_ends_that_met_still_meet(style):
    """A T, and a corner of two strokes."""
    lines = [
        line((30, 60), (220, 60)),
        line((120, 60), (120, 200)),
        line((220, 60), (220, 180)),
    ]
    bar, stem, side = styled(lines, style)
    assert end(bar, -1) == pytest.approx(220 + 60j, abs=1e-6)
    assert end(side, 0) == pytest.approx(220 + 60j, abs=1e-6)
    assert end(stem, 0) == pytest.approx(120 + 60j, abs=1e-6)
    assert min(abs(complex(*p) - (120 + 60j)) for p in bar.points) < 1e-6


def test_the_same_seed_gives_the_same_lines_and_another_does_not(style):
    lines = [line((30, 60), (220, 60)), line((30, 120), (220, 160))]
    assert styled(lines, style, 3) == styled(lines, style, 3)
    assert styled(lines, style, 3) != styled(lines, style, 4)


def test_rounding_tells_nothing(style):
    """Where lines meet, and run straight, much is equal but for the last digit."""
    lines = [
        line((30, 60), (220, 60), (220, 180), (30, 180), closed=True),
        line((120, 60), (120, 180)),
        line((80, 120), (80, 120.5), (80, 121), (160, 120), width=0.0, closed=True),
    ]
    random = np.random.default_rng(1)
    shaken = []
    for one in lines:
        moved = np.array(one.points) + 1e-13 * random.normal(size=(len(one.points), 2))
        shaken.append(replace(one, points=tuple((x, y) for x, y in moved.tolist())))
    for one, other in zip(styled(lines, style), styled(shaken, style), strict=True):
        assert np.array(one.points) == pytest.approx(np.array(other.points), abs=1e-6)


def test_contours_that_do_not_cross_do_not_cross_when_styled(style):
    """Thin bands, whose sides are nearer to each other than the style goes astray."""
    lines = [
        line(*zip(30 + 200 * np.array([0, 1, 1, 0]), 60 + 5 * np.array([0, 0, 1, 1]) + shift,
                  strict=True), width=0.0, closed=True)
        for shift in (0, 30, 60)
    ]  # fmt: skip
    made = [shapely.LinearRing(one.points) for one in styled(lines, style)]
    assert all(one.is_simple for one in made)
    assert not any(one.intersects(other) for one in made for other in made if one is not other)


def test_strokes_that_did_not_touch_do_not_touch(style):
    lines = [line((30, 60), (220, 60)), line((30, 85), (220, 85))]
    upper, lower = (shapely.LineString(one.points).buffer(10) for one in styled(lines, style))
    assert upper.distance(lower) > 0.5


def test_a_small_circle_stays_round(style):
    points = 128 + 128j + (circle(8.0).points - 128 - 128j)
    small = Line(tuple((z.real, z.imag) for z in points.tolist()), True)
    (made,) = styled([small], style)
    radii = abs(np.array([complex(*p) for p in made.points]) - (128 + 128j))
    assert radii.min() > 5
    assert radii.max() < 11


def test_tips_stay_where_they_are(style):
    star = [
        100 * np.exp(1j * np.pi * (k / 5 - 0.5)) * (1 if k % 2 == 0 else 0.4) for k in range(10)
    ]
    points = tuple((128 + z.real, 128 + z.imag) for z in star)
    (made,) = styled([Line(points, True)], style)
    for tip in points[::2]:
        assert min(abs(complex(*p) - complex(*tip)) for p in made.points) < 1e-6


def test_the_outside_of_closed_lines_is_the_same_whichever_way_they_run():
    bumps = 10 * abs(np.sin(np.arange(0, 40 * np.pi, 0.05)))
    x = np.linspace(0, 600, len(bumps))
    style = prepare(LineStyle("clouds", (StylePair(tuple(zip(x, -bumps, strict=True))),)))
    points = tuple((z.real, z.imag) for z in circle(80.0).points.tolist())
    for way in (points, points[::-1]):
        (made,) = styled([Line(way, True)], style)
        radii = abs(np.array([complex(*p) for p in made.points]) - (128 + 128j))
        assert np.median(radii) > np.mean(radii) + 0.2, "round outwards, cusps inwards"
        forwards = np.diff(np.unwrap(np.angle([complex(*p) - 128 - 128j for p in made.points])))
        before = np.diff(np.unwrap(np.angle([complex(*p) - 128 - 128j for p in way])))
        assert forwards.sum() * before.sum() > 0, "and it runs as it did"


def test_an_open_line_runs_as_it_did(style):
    """Whichever side of it the style lies on."""
    for middle in (126.0, 128.0, 130.0):
        (made,) = styled([line((20, 128), (128, middle), (236, 128))], style)
        assert made.points[0][0] < 60
        assert made.points[-1][0] > 200


def test_widths_are_those_of_the_example():
    plain = style_of("brush")
    (pair,) = plain.pairs
    widths = tuple(4 + 2 * np.sin(np.arange(len(pair.styled)) / 40))
    style = prepare(replace(plain, pairs=(replace(pair, widths=widths),)))
    (made,) = styled([line((20, 128), (236, 128))], style)
    assert len(made.widths) == len(made.points)
    assert 8 < min(made.widths) < 16
    assert 24 < max(made.widths) < 32
    assert abs(np.diff(made.widths)).max() < 4
    (contour,) = styled(
        [replace(line((20, 60), (236, 60), (128, 200)), width=0, closed=True)], style
    )
    assert not contour.widths


def test_a_strong_brush_swells_and_makes_no_beads():
    brush = prepare(named("Brush"), strength=2.0)
    wheel = tuple((128 + 30 * np.cos(a), 128 + 30 * np.sin(a)) for a in np.arange(0, 6.28, 0.05))
    for plain, swelling in ((line((10, 60), (246, 60)), 0.5), (line(*wheel, closed=True), 0.1)):
        (made,) = restyled([(plain, brush)])
        widths = np.array(made.widths)
        assert 0.4 * plain.width < widths.min() < widths.max() < 2.3 * plain.width
        assert np.ptp(widths) > swelling * plain.width
        points = np.array(made.points)
        steps = np.hypot(*np.diff(points, axis=0).T)
        assert abs(np.diff(widths)).sum() < 0.5 * steps.sum(), "it changes gradually"


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("way", [1, -1])
def test_widths_are_those_of_the_line_where_the_example_has_none(closed, way):
    """As where a pen was pressed; it is wider to the right, whichever way it runs."""
    ring = [(40.0, 40.0), (220.0, 40.0), (220.0, 180.0), (40.0, 180.0)]
    points = tuple(ring if closed else ring[:2])[::way]
    pressed = replace(line(*points, closed=closed), widths=tuple(x / 10 for x, _ in points))
    (made,) = styled([pressed], prepare(style_of("jitter")))
    assert len(made.widths) == len(made.points)
    for (x, _), width in zip(made.points, made.widths, strict=True):
        assert width == pytest.approx(x / 10, abs=1.2)


def test_a_large_texture_takes_as_many_points_as_a_small_one():
    """Thick loops, three times as strong and four times as large, took a minute."""
    (_, small), (_, large) = (prepare(named("Loops"), 3.0, size).whole for size in (1.0, 4.0))
    counts = [len(levels[-1].order.arc) for levels in (small, large)]
    assert counts[1] == pytest.approx(counts[0], rel=0.05)
    (made,) = styled([line((20, 60), (236, 60))], prepare(named("Waves"), 1.0, 4.0))
    assert np.hypot(*np.diff(np.array(made.points), axis=0).T).max() < 3, "smooth all the same"


@pytest.mark.parametrize("name", ["Retraced", "Curls", "Loops"])
def test_loops_do_not_fray_what_is_filled(name):
    """They came off as pieces of their own, and left holes."""
    ring = [Line(tuple(map(tuple, circle(r).points.view(float).reshape(-1, 2))), True)
            for r in (90.0, 70.0)]  # fmt: skip
    ring[1] = replace(ring[1], points=ring[1].points[::-1])
    style = prepare(named(name))
    assert style.loop > 0
    assert len(path_of(restyled([(one, style) for one in ring], 3)).contours) == 2


def test_dots_are_drawn_by_the_same_hand_whether_filled_or_stroked(style):
    """They were discs as by a machine, or as ragged as filled shapes, among lines drawn by hand."""
    ring, disc = circle(10.0).points + 80j, circle(20.0).points + 80
    dots = [
        line((128, 128), (128, 128.1), width=40),
        line((40, 40), width=40),
        replace(line(*zip(ring.real, ring.imag, strict=True), closed=True), width=20.0),
        replace(line(*zip(disc.real, disc.imag, strict=True), closed=True), width=0.0),
    ]
    centres = 128 + 128j, 40 + 40j, 128 + 208j, 208 + 128j
    for centre, made in zip(centres, styled(dots, style), strict=True):
        ((points, closed),) = flattened(path_of([made]))
        assert closed
        radii = abs(points @ [1, 1j] - centre)
        assert 0.5 < np.ptp(radii) < 8
        assert np.mean(radii) == pytest.approx(20, abs=3)
        around = points @ [1, 1j]
        length, area = abs(np.diff(around)).sum(), shapely.Polygon(points).area
        assert 4 * np.pi * area / length**2 > 0.85, "as smooth as the edge of a stroke"


def test_filled_shapes_that_are_no_dots_of_a_pen_stay_contours(style):
    disc = circle(10.0).points
    contour = replace(line(*zip(disc.real, disc.imag, strict=True), closed=True), width=0.0)
    hole = circle(4.0).points[::-1]
    inner = replace(contour, points=tuple(zip(hole.real, hole.imag, strict=True)))
    square = line((60, 60), (80, 60), (80, 80), (60, 80), width=0.0, closed=True)
    stroke = line((20, 220), (200, 220))
    for lines in ([contour], [contour, inner, stroke], [square, stroke]):
        made = styled(lines, style)
        assert not any(one.width for one in made if one.closed)


@pytest.mark.parametrize(
    "odd",
    [
        [(50.0, 50.0), (50.0, 50.0)],
        [(50.0, 50.0), (50.0, 50.2)],
        [(50.0, 50.0), (51.0, 50.0), (50.0, 50.0)],
        [(10.0, 10.0), (90.0, 10.0), (10.0, 10.0), (90.0, 10.0)],
    ],
)
@pytest.mark.parametrize("closed", [False, True])
def test_odd_lines_come_back_as_lines(style, odd, closed):
    (made,) = styled([Line(tuple(odd), closed, 10.0)], style)
    assert made.points
    assert np.isfinite(np.array(made.points)).all()
    assert abs(np.array(made.points) - 50).max() < 80


def test_nothing_is_nothing():
    assert restyled([]) == []


def test_a_pinhole_in_thick_strokes_is_none():
    """A triangle whose inside is much smaller than its stroke is wide."""
    triangle = ((100, 100), (142, 100), (121, 136))
    for width, holes in ((6.0, 1), (20.0, 0)):
        path = path_of([line(*triangle, width=width, closed=True)])
        assert len(path.contours) == 1 + holes


def test_a_shape_beside_strokes_is_drawn_by_their_pen():
    """Its edge was ragged beside theirs, as if another hand had drawn it."""
    square = Line(((40.0, 40.0), (140.0, 40.0), (140.0, 140.0), (40.0, 140.0)), True)
    bar = line((40, 200), (216, 200))
    style = prepare(named("Shaky"))
    shape, _ = made = styled([square, bar], style)
    assert (shape.width, shape.filled, shape.closed) == (20.0, True, True)
    area = path_of([shape]).bounds
    assert area == pytest.approx((40, 40, 140, 140), abs=8)
    assert len(path_of([shape]).contours) == 1, "its inside is filled"
    outlines = [path_of(made), *(path for path, width in strokes_of(made) if not width)]
    assert [len(one.contours) for one in outlines] == [2, 1]
    (alone,) = styled([square], style)
    assert not alone.width


def test_a_shape_that_the_pen_beside_it_cannot_draw_stays_an_edge(style):
    star = [(100 if k % 2 else 18) * np.exp(1j * np.pi * k / 4) for k in range(8)]
    tips = Line(tuple((120 + z.real, 120 + z.imag) for z in star), True)
    shape, _ = styled([tips, line((20, 240), (236, 240))], style)
    assert not shape.width
