"""Patterns as curves: rendered again, they are the pictures that were synthesised."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.flattening import flattened
from iconstudio.algorithms.patterns import distance as distance_module
from iconstudio.algorithms.patterns.distance import coverage, signed_distance
from iconstudio.algorithms.patterns.exemplar import Pattern, Placed
from iconstudio.algorithms.patterns.outlines import level_sets
from iconstudio.algorithms.patterns.prepared import Prepared
from iconstudio.algorithms.patterns.synthesis import Settings, synthesised
from iconstudio.algorithms.patterns.vector import components, vectorise
from iconstudio.model import Contour, Fill, Frame, Path, Transform, hex_colour
from iconstudio.output.svg import layered_document
from iconstudio.svg.resvg import render_colours
from tests.algorithms.patterns import ornaments

ROWS, COLUMNS = 60, 72
Y, X = np.mgrid[:ROWS, :COLUMNS].astype(np.float32)
RED, BLUE, WHITE = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (1.0, 1.0, 1.0)


def around(away, period):
    """The difference of two places on a tile."""
    return (away + period / 2) % period - period / 2


def disc(y, x, radius):
    return np.hypot(around(Y - y, ROWS), around(X - x, COLUMNS)) - radius


def box(y, x, half):
    return np.maximum(abs(around(Y - y, ROWS)), abs(around(X - x, COLUMNS))) - half


def stripes(right, down, share=0.413):
    """Stripes that close after going so often round a tile, the one way and the other."""
    across = (down * X / COLUMNS - right * Y / ROWS + 0.03) % 1
    width = ROWS * COLUMNS / math.hypot(right * COLUMNS, down * ROWS)
    return (abs(across - 0.5) - share / 2) * width


def pattern(*fields, colours=(RED, BLUE), tile=True):
    """A pattern with these layers, negative in ink, the first above all."""
    distances = np.stack([signed_distance(-field.astype(np.float32), tile) for field in fields])
    picture = np.broadcast_to(np.float32(WHITE), (*fields[0].shape, 3))
    for distance, colour in reversed(list(zip(distances, colours, strict=False))):
        over = coverage(distance)[..., None]
        picture = over * np.float32(colour) + (1 - over) * picture
    return Pattern(picture, distances, 0.0, 0.0, tile, True)


def drawn(layers, scale=1.0, size=(ROWS, COLUMNS), ground=""):
    """The picture (h, w, 4) of layers as an SVG document, from 0 to 1."""
    rows, columns = size
    side = max(size)
    svg = layered_document("A pattern", (), layers, (columns, rows), ground)
    pixels = render_colours(svg, Frame(0, 0, side), round(side * scale))
    return pixels[: int(rows * scale), : int(columns * scale)] / 255


def ground_colour(made):
    """The colour of what lies behind all layers."""
    covered = np.max([coverage(distance) for distance in made.distances], axis=0)
    bare = made.colours[covered <= covered.min()]
    return hex_colour(np.rint(np.median(bare, axis=0) * 255))


def likeness(one, other):
    return (one & other).sum() / (one | other).sum()


def nodes(layers):
    return sum(
        len(part.segments) for one in layers for fill in one.fills for part in fill.path.contours
    )


FIELDS = {
    "shapes across borders": np.minimum.reduce(
        [disc(2, 70, 11), abs(disc(30, 20, 9)) - 2, box(33, 50, 7.3)]
    ),
    "stripes": stripes(1, 0),
    "upright stripes": stripes(0, 1),
    "diagonal stripes": stripes(1, 1),
    "steep stripes": stripes(1, 2),
    "flat stripes": stripes(-2, 1),
    "waves": abs(around(Y - 9 - 5 * np.sin(4 * np.pi * X / COLUMNS), ROWS)) - 7,
    "a stripe with holes": np.maximum(stripes(1, 0), 5 - disc(30, 1, 0)),
    "a grid": -box(25, 30, 20.3),
    "a ring round a stripe": np.minimum(stripes(1, 0, 0.2), abs(disc(2, 40, 9)) - 2),
    "everything": np.full((ROWS, COLUMNS), -3.0),
}  # fmt: skip


@pytest.mark.parametrize("name", FIELDS)
@pytest.mark.parametrize("tile", [True, False])
def test_polygons_look_as_curves_do_but_for_blunt_corners(name, tile):
    made = pattern(FIELDS[name], tile=tile)
    found = drawn(vectorise(made, curves=False))
    assert likeness(found[..., 3] > 0.5, coverage(made.distances[0]) > 0.5) > 0.95
    assert (found[found[..., 3] > 0, :3].round(1) == RED).all()


@pytest.mark.parametrize("name", FIELDS)
@pytest.mark.parametrize("tile", [True, False])
def test_what_is_drawn_is_what_was_traced(name, tile):
    made = pattern(FIELDS[name], tile=tile)
    layers = vectorise(made)
    found = drawn(layers)
    assert likeness(found[..., 3] > 0.5, coverage(made.distances[0]) > 0.5) > 0.98
    assert np.abs(found[..., 3] - coverage(made.distances[0])).mean() < 0.005
    assert (found[found[..., 3] > 0, :3].round(1) == RED).all()
    assert nodes(layers) < 100


def test_nothing_is_drawn_of_an_empty_layer():
    (layer,) = vectorise(pattern(np.full((ROWS, COLUMNS), 3.0)))
    assert layer.fills == () and not drawn([layer]).any()


@pytest.mark.parametrize("name", FIELDS)
def test_a_tile_moved_across_its_borders_is_the_same_drawing(name):
    moves = (17, -31)
    here = drawn(vectorise(pattern(FIELDS[name])))
    there = drawn(vectorise(pattern(np.roll(FIELDS[name], moves, (0, 1)))))
    differences = np.abs(np.roll(here, moves, (0, 1)) - there)[..., 3]
    assert differences.max() < 3.5 / 16 and differences.mean() < 0.003  # resvg has 16 samples


def test_what_crosses_a_border_of_a_tile_is_there_again_at_the_other_one_by_the_same_curves():
    (layer,) = vectorise(pattern(FIELDS["shapes across borders"]))
    crossing = 0
    for fill in layer.fills:
        drawn_once = {str(placed(part, 0, 0)) for part in fill.path.contours}
        for part in fill.path.contours:
            left, top, right, bottom = Path((part,)).bounds
            for axis, low, high, side in ((0, left, right, COLUMNS), (1, top, bottom, ROWS)):
                for border, other in ((0, side), (side, -side)):
                    if low < border < high:
                        crossing += 1
                        move = (other, 0) if axis == 0 else (0, other)
                        assert str(placed(part, *move)) in drawn_once
    assert crossing == 8


def placed(contour, right, down):
    """A contour moved, to a hundredth of a pixel."""
    return Path((contour,)).transformed(Transform().translate(right, down)).svg()


@given(st.integers(0, 2**32 - 1))
@settings(max_examples=15)
def test_every_contour_of_a_tile_is_there_once(seed):
    random = np.random.default_rng(seed)
    waves = np.zeros((24, 30))
    for down, right in ((0, 1), (1, 0), (1, 1), (2, 1), (1, -2)):
        y, x = np.indices(waves.shape)
        phase = 2 * np.pi * (down * y / 24 + right * x / 30 + random.random())
        waves += random.normal() * np.sin(phase)
    sets = level_sets(waves.astype(np.float32), True)
    crossings = sum(
        (np.roll(waves < 0, 1, axis) != (waves < 0)).sum() for axis in (0, 1)
    )  # each side of a pixel that is crossed is a point
    assert sum(len(one.outline) for one in sets) == crossings
    assert all(waves[one.inside] < 0 for one in sets)
    steps = [one.outline.step for one in sets if one.outline.step]
    assert sum(steps) == 0 and len({abs(step) for step in steps}) <= 1


def test_components_go_on_across_the_borders_of_a_tile():
    ink = np.zeros((9, 9), bool)
    ink[[0, -1], 4] = ink[4, [0, -1]] = ink[6, 6] = True
    assert components(ink, False).max() == 5
    assert components(ink, True).max() == 3
    assert np.array_equal(components(ink, True) > 0, ink)


def test_smooth_outlines_are_smooth_and_corners_are_sharp():
    (layer,) = vectorise(pattern(np.minimum(disc(30, 20, 12.3), box(30, 55, 9.3))))
    circle, square = (fill.path.contours[0] for fill in layer.fills)
    assert [len(segment) for segment in circle.segments] == [3] * 4
    ends = np.array([segment[-1] for segment in circle.segments])
    assert np.abs(np.hypot(*(ends - (20.5, 30.5)).T) - 12.3).max() < 0.05
    assert [len(segment) for segment in square.segments] == [1] * 4
    corners = np.array([(46.2, 21.2), (64.8, 21.2), (64.8, 39.8), (46.2, 39.8)])
    for corner in square.points:
        assert np.hypot(*(corners - corner).T).min() < 0.05


ABUTTING = {
    "round a disc": (disc(30, 36, 12.4), disc(30, 36, 21.3), 0),
    "side by side": (box(30, 24, 12.3), box(30, 40, 15.2), 0),
    "across the border": (disc(1, 70, 11), disc(1, 70, 18), 0),
    "a little apart": (disc(30, 36, 12.2), disc(30, 36, 21.3), 0.3),
}


def abutting(name):
    """A shape, and another one that it is cut out of."""
    upper, whole, gap = ABUTTING[name]
    return upper, np.maximum(whole, gap - upper)


@pytest.mark.parametrize("scale", [1, 2, 3.3])
@pytest.mark.parametrize("name", ABUTTING)
def test_between_layers_that_abut_nothing_of_the_ground_is_seen(name, scale):
    upper, whole, _ = ABUTTING[name]
    inside = drawn(vectorise(pattern(np.minimum(upper, whole) + 1.5)), scale)[..., 3] == 1
    found = drawn(vectorise(pattern(*abutting(name))), scale, ground="#00ff00")
    assert found[inside][:, 1].max() < 0.01
    cut_out = [vectorise(pattern(field))[0] for field in abutting(name)[::-1]]
    hairlines = drawn(cut_out, scale, ground="#00ff00")
    assert hairlines[inside][:, 1].max() > 0.15


def test_trapped_layers_look_as_they_did():
    for name in ABUTTING:
        made = pattern(*abutting(name))
        found = drawn(vectorise(made), ground="#ffffff")
        assert np.abs(found[..., :3] - made.colours).mean() < 0.006, name


def test_layers_whose_edges_only_cross_stay_as_they_are():
    below = stripes(1, 0)
    made = pattern(disc(30, 36, 14), below)
    assert vectorise(made)[0].fills == vectorise(pattern(below, colours=(BLUE,)))[0].fills


def test_components_have_their_own_flat_colours():
    made = pattern(np.minimum(disc(15, 15, 9), disc(40, 50, 12)))
    here = disc(40, 50, 14) < 0
    tinted = np.where(here[..., None], made.colours[..., [2, 1, 0]], made.colours)
    made = replace(made, colours=tinted + np.float32(0.01) * np.sin(X)[..., None])
    (layer,) = vectorise(made)
    first, second = (bytes.fromhex(fill.colour[1:]) for fill in layer.fills)
    assert np.abs(np.array([*first]) - (255, 0, 0)).max() < 4
    assert np.abs(np.array([*second]) - (0, 0, 255)).max() < 4
    assert np.abs(np.array([*bytes.fromhex(ground_colour(made)[1:])]) - 255).max() < 4


def test_what_is_too_thin_for_a_pure_pixel_has_a_colour_of_its_own():
    green = np.maximum(abs(Y - 50.3) - 0.6, abs(X - 40) - 12)
    made = pattern(np.minimum.reduce([disc(15, 15, 9), disc(20, 50, 8), green]))
    there = (abs(Y - 50.3) < 3)[..., None]
    made = replace(made, colours=np.where(there, made.colours[..., [1, 0, 2]], made.colours))
    (layer,) = vectorise(made)
    assert [fill.colour for fill in layer.fills][:2] == ["#ff0000"] * 2
    red, level, blue = bytes.fromhex(layer.fills[2].colour[1:])
    assert level == 255 and max(red, blue) < 80


def test_colours_that_hardly_differ_are_one():
    made = pattern(np.minimum(disc(15, 15, 9), disc(40, 50, 12)))
    (layer,) = vectorise(replace(made, colours=made.colours * (1 - X[..., None] / COLUMNS / 30)))
    assert len({fill.colour for fill in layer.fills}) == 1


@pytest.fixture(scope="module")
def synthesised_tile():
    """A tile of discs, rings and squares, and the label of a square in its exemplar."""
    exemplar_square = np.maximum(abs(ornaments.Y - 47), abs(ornaments.X - 15)) - 7.3
    ring = abs(ornaments.disc(14.3, 15.2, 7.3)) - 1.8
    discs = [ornaments.disc(14.2, 46.4, 8.3), ornaments.disc(44.4, 46.3, 6.4)]
    soft = ornaments.soft(np.minimum.reduce([exemplar_square, ring, *discs]))
    prepared = Prepared.of(ornaments.black_on_white(soft))
    *_, made = synthesised(prepared, Settings((64, 64), True, iterations=2))
    (label,) = [
        one.label for one in prepared.elements[0].whole if (one.top, one.left) == (40 - 9, 8 - 9)
    ]
    return made, label


def square_path(left, top, side):
    right, bottom = left + side, top + side
    return Path((Contour((left, top), (((right, top),), ((right, bottom),), ((left, bottom),))),))


def test_elements_whose_shapes_are_known_come_back_by_their_own_segments(synthesised_tile):
    made, label = synthesised_tile
    outer, detail = square_path(8.2, 40.2, 14.6), square_path(12, 44, 3)
    own = [() for _ in range(label - 1)] + [(Fill(outer, "#123456"), Fill(detail, "#fedcba"))]
    (layer,) = vectorise(made, [own])
    squares = [one for one in made.placed if one.label == label]
    found = [fill for fill in layer.fills if fill.colour == "#123456"]
    assert len(found) == len(squares) > 0
    for fill, one in zip(found, squares, strict=True):
        every = {
            placed(outer.contours[0], one.right + right, one.down + down)
            for right in (-64, 0, 64) for down in (-64, 0, 64)
        }  # fmt: skip
        assert {placed(part, 0, 0) for part in fill.path.contours} <= every
    assert [fill.colour for fill in layer.fills].count("#fedcba") == len(squares)
    assert len(layer.fills) == len(made.placed) + len(squares)
    found = drawn([layer], size=(64, 64))[..., 3]
    assert likeness(found > 0.5, made.distances[0] < 0) > 0.98
    assert not found[made.distances[0] > 1].any()


def test_a_synthesised_tile_is_drawn_as_it_is(synthesised_tile):
    made, _ = synthesised_tile
    layers = vectorise(made)
    found = drawn(layers, size=(64, 64))[..., 3]
    assert likeness(found > 0.5, made.distances[0] < 0) > 0.98
    assert len(layers[0].fills) == len(made.placed)
    contours = sum(len(fill.path.contours) for fill in layers[0].fills)
    assert nodes(layers) < 10 * contours
    curves: dict[int, set[str]] = {}
    for fill, one in zip(layers[0].fills, made.placed, strict=True):
        first = fill.path.contours[0]
        x, y = first.start
        curves.setdefault(one.element, set()).add(placed(first, -x, -y))
    assert len(curves) > 1 and all(len(alike) == 1 for alike in curves.values())


def test_layers_are_drawn_in_their_order_over_the_ground():
    prepared = Prepared.of(ornaments.two_layers())
    *_, made = synthesised(prepared, Settings((64, 64), True, iterations=2))
    layers = vectorise(made)
    assert [one.name for one in layers] == ["layer-1", "layer-2"]
    found = drawn(layers, size=(64, 64), ground=ground_colour(made))
    assert np.abs(found[..., :3] - made.colours).mean() < 0.02
    ends = {fill.colour for one in layers for fill in one.fills}
    assert len(ends) == 2


def test_what_is_near_a_known_element_is_traced_as_if_alone():
    known, other = disc(30, 3, 6.3), np.minimum(disc(30, 62, 5.4), disc(30, 20, 5.4))
    made = pattern(np.minimum(known, other))
    owners = np.where(known < 0, 1, 0)[None].astype(np.int32)
    made = replace(made, placed=(Placed(0, 0, 0, 0, 1),), owners=owners)
    triangle = Path((Contour((1, 28), (((6, 28),), ((4, 33),))),))
    fills = vectorise(made, [[(Fill(triangle, "#0000ff"),)]])[0].fills
    alone = vectorise(pattern(other))[0].fills
    for one, by_itself in zip(fills[:-1], alone, strict=True):
        here, there = (list(fill.path.contours[0].points) for fill in (one, by_itself))
        assert np.allclose(here, there, atol=0.03)
    assert fills[-1] == Fill(triangle, "#0000ff")


def test_stripes_that_fill_a_shape_end_at_its_outline():
    y, x = np.indices((64, 64))
    away = np.hypot(y - 31, x - 33) - 26.3
    prepared = Prepared.of(ornaments.stripes())
    guidance = ornaments.soft(away)
    *_, made = synthesised(prepared, Settings((64, 64), True, iterations=1, guidance=guidance))
    (layer,) = vectorise(made)
    points = np.concatenate([row for fill in layer.fills for row, _ in flattened(fill.path)])
    outside = np.hypot(*(points - (33.5, 31.5)).T) - 26.3
    assert outside.max() < 0.25 and (abs(outside) < 0.1).mean() > 0.6
    found = drawn([layer], size=(64, 64))[..., 3]
    assert likeness(found > 0.5, made.distances[0] < 0) > 0.98


def test_a_run_can_be_stopped(synthesised_tile):
    class StoppedError(Exception):
        pass

    def ask():
        nonlocal left
        left -= 1
        if not left:
            raise StoppedError

    for left in (1, 8):  # noqa: B007
        with pytest.raises(StoppedError):
            vectorise(synthesised_tile[0], ask=ask)


@pytest.mark.parametrize("tile", [True, False])
def test_contours_found_in_bands_are_those_of_the_whole(tile, monkeypatch):
    y, x = np.mgrid[:150, :40].astype(np.float32)
    field = np.sin(y / 150 * 10 * np.pi + 0.3) + np.sin(x / 40 * 6 * np.pi) - 0.21

    def found():
        return {
            (one.place, one.outline.points.tobytes(), one.outline.step)
            for one in level_sets(field, tile)
        }, signed_distance(-field, tile)

    in_bands, distances = found()
    monkeypatch.setattr(distance_module, "_BAND", 1000)
    whole, at_once = found()
    assert in_bands == whole and len(whole) > 5
    assert np.allclose(distances, at_once, atol=1e-6)
