"""The measure of torn elements, and the mending of them."""

import numpy as np
import pytest
from scipy import ndimage

from iconstudio.algorithms.patterns.distance import signed_distance
from iconstudio.algorithms.patterns.elements import elements_of
from iconstudio.algorithms.patterns.layers import paints
from iconstudio.algorithms.patterns.mending import mended
from iconstudio.algorithms.patterns.prepared import Prepared
from iconstudio.algorithms.patterns.torn import torn_ink
from tests.algorithms.patterns.ornaments import (
    SIDE,
    X,
    Y,
    black_on_white,
    disc,
    shapes,
    soft,
    stripes,
    two_layers,
)

INK = shapes().masks[0] > 0.5


def test_an_exemplar_is_not_torn_even_if_shifted_by_half_a_pixel():
    assert torn_ink(INK, INK) == 0
    shifted = ndimage.shift(shapes().masks[0], (0.5, 0.5), order=1) > 0.5
    assert torn_ink(shifted, INK) <= 0.03


def test_halves_and_merged_elements_are_torn():
    halved = INK.copy()
    halved[:, 45:] = False
    labels, count = ndimage.label(INK)
    assert count == 6
    whole = sum((labels == n).sum() for n in range(1, 7) if not halved[labels == n].any()
                or halved[labels == n].all())  # fmt: skip
    assert 0.2 < torn_ink(halved, INK) < 0.6 and whole
    merged = INK.copy()
    merged[29:32, 15:31] = True
    merged[14:47, 14:17] = True
    assert torn_ink(merged, INK) > 0.4


def test_on_a_tile_elements_go_on_across_the_borders():
    half = np.roll(INK & (np.hypot(*np.indices(INK.shape) - 31) < 9), 32, axis=(0, 1))
    assert torn_ink(half, INK, tile=True) == 0
    half[:4, :] = False
    assert torn_ink(half, INK, tile=True) == 1


def test_what_lies_in_a_ring_that_goes_across_the_border_is_not_torn():
    ring = soft(np.minimum(np.abs(disc(31, 31, 10)) - 1.5, disc(31, 31, 4))) > 0.5
    for shift in (20, 28, 36, 44):
        assert torn_ink(np.roll(ring, shift, axis=(0, 1)), ring, tile=True) == 0


def test_a_network_of_lines_has_no_elements():
    lines = np.minimum(np.abs(Y % 16 - 8), np.abs(disc(16, 16, 4))) - 1.5
    assert not elements_of(black_on_white(soft(lines)), 0).whole


def test_mending_makes_torn_elements_whole_and_keeps_the_others():
    prepared = Prepared.of(shapes())
    torn = INK.copy()
    torn[46:49] = False  # through a ring and the square
    distance = signed_distance(torn.astype(np.float32) - 0.5)
    here = np.indices((SIDE, SIDE), np.int32).transpose(1, 2, 0)
    assert torn_ink(torn, INK) > 0.2
    layer = mended(distance, here, prepared.elements[0], False, np.random.default_rng(0))
    assert torn_ink(layer.distance < 0, INK) == 0
    stayed = [(one.element, one.down, one.right) for one in layer.placed]
    assert {(k, 0, 0) for k in range(5)} <= set(stayed)


def test_parts_of_an_element_stay_together():
    eyes = [disc(y + 3, x + side, 1.4) for y, x in ((14, 14), (45, 40)) for side in (-3, 3)]
    mouths = [np.maximum(np.abs(Y - y + 2), np.abs(X - x) - 5) - 1 for y, x in ((14, 14), (45, 40))]
    faces = black_on_white(soft(np.minimum.reduce([*eyes, *mouths, disc(14, 44, 9)])))
    elements = elements_of(faces, 0)
    assert len(elements.whole) == 3
    assert sorted(ndimage.label(one.ink)[1] for one in elements.whole) == [1, 3, 3]
    assert 12 < elements.gap <= elements.spacing < 35


def test_what_goes_on_beyond_the_exemplar_is_left_alone():
    elements = Prepared.of(stripes()).elements[0]
    assert not elements.whole and np.array_equal(elements.running, stripes().masks[0] > 0.5)


def test_what_is_hidden_has_the_colour_of_what_is_not():
    above, below, ground = paints(two_layers())
    assert np.allclose(above, [1, 0, 0]) and np.allclose(below, [0, 0, 1], atol=0.02)
    assert np.allclose(ground, [1, 1, 0], atol=0.02)


@pytest.mark.parametrize("tile", [False, True])
def test_nothing_to_mend_stays_to_the_pixel(tile):
    prepared = Prepared.of(shapes())
    inside = np.pad(INK[:56, :56], ((0, 8), (0, 8)))
    distance = signed_distance(inside.astype(np.float32) - 0.5, tile)
    here = np.indices((SIDE, SIDE), np.int32).transpose(1, 2, 0)
    layer = mended(distance, here, prepared.elements[0], tile, np.random.default_rng(0))
    assert (layer.distance < 0)[:56, :56][INK[:56, :56]].all()
    assert np.abs(disc(31, 31, 5) - layer.distance)[27:36, 27:36].max() < 0.15
    assert soft(layer.distance).max() == 1
