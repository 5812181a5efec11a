"""The colour code (section 4.1)."""

from colorsys import rgb_to_hls
from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from iconstudio.model import CANVAS, Placement, Source
from iconstudio.output.colours import (
    HUES,
    SIGNIFICANT,
    TINT,
    colour_code,
    palette,
    source_colours,
)
from tests.output.made import BLOCK, SOURCES, with_shares
from tests.shapes import exemplar


def hls(colour):
    return rgb_to_hls(*(float(value) / 255 for value in colour))


BLANK = np.zeros((CANVAS, CANVAS), bool)
TWELVE = tuple(Source(exemplar(BLANK, f"icon-{k}"), Placement()) for k in range(12))


def twelve(composite, *shares):
    """The result with twelve pictograms as its sources."""
    return replace(composite, sources=TWELVE, shares=tuple(shares))


def test_owners_are_the_large_ones_by_falling_share(result):
    shared = with_shares(result.composite, 0.019, 0.281, 0.7, 0.0)
    assert shared.owners(SIGNIFICANT) == (2, 1)
    assert shared.owners() == (2, 1, 0)
    assert shared.owners(0.5) == (2,)


def test_a_hue_a_pictogram_and_a_lightness_a_placement(result):
    first, second, block, disc = map(hls, source_colours(result.composite))
    assert first[0] == pytest.approx(second[0], abs=0.01)
    assert abs(first[1] - second[1]) > 0.1
    hues = [first[0], block[0], disc[0]]
    for a, b in combinations(hues, 2):
        assert min(abs(a - b), 1 - abs(a - b)) > 0.05


@given(st.permutations(range(12)))
def test_the_ten_largest_pictograms_differ(result, order):
    shares = [(1 + rank) / 78 for rank in order]
    composite = twelve(result.composite, *shares)
    colours = source_colours(composite)
    largest = composite.owners(SIGNIFICANT)[: len(HUES)]
    for a, b in combinations(largest, 2):
        assert np.abs(colours[a].astype(int) - colours[b]).max() >= 40


@given(st.lists(st.floats(0, 1), min_size=12, max_size=12))
def test_a_pictogram_keeps_its_hue_where_it_is_free(result, shares):
    """The first ten never want the same, so nothing about the shares can change theirs, but for
    the two that want theirs a second time."""
    shares = [0.1 + share for share in shares[:10]] + [0.0, 0.0]
    colours = source_colours(twelve(result.composite, *shares))
    expected = source_colours(twelve(result.composite, *([0.1] * 10), 0.0, 0.0))
    assert np.array_equal(colours[:10], expected[:10])


def test_a_palette_of_several_results_holds_for_each(result):
    one = with_shares(result.composite, 0.9, 0.1, 0.0, 0.0)
    other = with_shares(result.composite, 0.0, 0.0, 0.4, 0.6)
    colours = palette([one, other])
    assert np.array_equal(source_colours(one, colours), source_colours(other, colours))


def test_each_pixel_has_its_owners_colour(result):
    picture = colour_code(result.composite, result.drawing, 512)
    assert picture.shape == (512, 512, 4) and picture.dtype == np.uint8
    colours = source_colours(result.composite)
    owner = np.kron(result.composite.labels, np.ones((2, 2), np.uint8))
    ys, xs = np.mgrid[:512, :512]
    clear = (abs(xs - 255.5) > 8) & ((abs(ys - 255.5) > 8) | (xs < 250))  # off the borders
    inked = clear & (result.drawing.coverage == 255)
    assert inked.sum() > 10000
    assert np.array_equal(picture[inked][:, :3], colours[owner[inked]])
    assert (picture[inked][:, 3] == 255).all()


def test_the_inside_is_tinted_and_the_outside_clear(result):
    picture = colour_code(result.composite, result.drawing, 256)
    assert (picture[0, :, 3] == 0).all()
    hole = picture[128, 100]  # of the ring, left of the middle
    assert hole[3] == round(255 * TINT)
    assert np.array_equal(hole[:3], source_colours(result.composite)[0])


def test_alpha_is_the_ink(result):
    picture = colour_code(result.composite, result.drawing, 512)
    inked = result.drawing.coverage > round(255 * TINT)
    assert np.array_equal(picture[inked][:, 3], result.drawing.coverage[inked])


@pytest.mark.parametrize("size", [40, 168, 256, 300, 1024])
def test_any_size(result, size):
    picture = colour_code(result.composite, result.drawing, size)
    assert picture.shape == (size, size, 4)
    ink = (picture[..., 3] > 127).mean()
    assert ink == pytest.approx((result.drawing.coverage > 127).mean(), abs=0.01)


def test_borders_are_no_staircases(result):
    """A slanting border between two owners of solid ink runs straight when enlarged."""
    ys, xs = np.mgrid[:CANVAS, :CANVAS]
    labels = np.where(xs > 64 + ys / 2, 1, 0).astype(np.uint8)
    sources = (Source(BLOCK, Placement()), Source(BLOCK, Placement(dx=1)), *SOURCES[2:])
    composite = replace(result.composite, sources=sources, labels=labels)
    drawing = replace(result.drawing, coverage=np.full((512, 512), 255, np.uint8))
    picture = colour_code(composite, drawing, 1024)
    first, second = source_colours(composite)[:2].astype(float)
    part = ((picture[..., :3] - first) @ (second - first)) / ((second - first) @ (second - first))
    rows = np.arange(100, 900)
    edge = 1024 - part[rows].sum(axis=1)
    straight = np.polyval(np.polyfit(rows, edge, 1), rows)
    assert np.abs(edge - straight).max() < 1.5  # a staircase strays by two and more
