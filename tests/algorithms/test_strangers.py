"""Which exemplars of a keyword are shaped unlike drawings of the thing itself."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.iconification.strangers import (
    FAR,
    FEWEST,
    NEAREST,
    SIDE,
    silhouettes,
    strangers,
    unlikeness,
)
from iconstudio.model import CANVAS
from tests.shapes import blob


def box(left, top, right, bottom):
    ink = np.zeros((CANVAS, CANVAS), bool)
    ink[top:bottom, left:right] = True
    return ink


def frame(*sides):
    return box(*sides) & ~box(*np.add(sides, (8, 8, -8, -8)))


HOUSES = [box(40, 40 + 4 * number, 216, 216) for number in range(FEWEST)]
GATE = box(40, 40, 216, 56) | box(16, 200, 120, 240)
"""A bar, and something else at the lower left."""


def none_named(count):
    return np.zeros((2, count), bool)


def test_a_silhouette_is_what_has_ink_at_all_four_sides():
    (whole, hollow, open_) = silhouettes(
        [box(64, 64, 192, 192), frame(64, 64, 192, 192), frame(64, 64, 192, 192) & ~GAP]
    )
    assert whole.shape == (SIDE, SIDE)
    assert whole.sum() == 32 * 32
    assert np.array_equal(hollow, whole)
    assert (whole - open_).sum() == 2 * 30, "what lies between the gap and the rim that faces it"


GAP = box(120, 184, 128, 192)


def test_unlikeness_is_the_mean_distance_of_jaccard_to_the_nearest():
    """One of 2 pixels within three alike, of 4."""
    shapes = np.tril(np.ones((4, 4), np.float32))[:, None]
    shapes = np.maximum(shapes, shapes[..., ::-1])  # the same from either side
    counts = shapes.sum(axis=(1, 2))  # 2, 4, 4, 4 pixels
    assert counts.tolist() == [2, 4, 4, 4]
    found = unlikeness(shapes, np.ones(4, bool))
    assert found == pytest.approx([1 / 2, (1 / 2 + 0 + 0) / 3, 1 / 6, 1 / 6])
    only = np.array([True, True, False, False])
    assert unlikeness(shapes, only) == pytest.approx([1 / 2, 1 / 2, 0, 0])


def test_a_mirror_image_is_as_like_as_the_drawing_itself():
    turned = [box(16, 100, 128, 180) | box(100, 16, 128, 240)] * 4
    turned += [ink[:, ::-1] for ink in turned]
    assert unlikeness(silhouettes(turned), np.ones(8, bool)) == pytest.approx(np.zeros(8))


def test_what_lies_elsewhere_is_a_stranger():
    inks = [*HOUSES, GATE, HOUSES[3][:, ::-1]]
    assert strangers(inks, *none_named(10)).tolist() == [False] * 8 + [True, False]


def test_a_few_of_another_kind_are_none():
    """A whole dog is a dog among heads, if there are ``NEAREST`` others of that kind."""
    gates = [GATE | box(16, 180 - number, 40, 200) for number in range(NEAREST + 1)]
    assert not strangers([*HOUSES, *gates], *none_named(FEWEST + NEAREST + 1)).any()
    assert strangers([*HOUSES, *gates[:2]], *none_named(FEWEST + 2)).tolist()[-2:] == [True] * 2


def test_shapes_of_those_told_by_name_count_for_nothing():
    inks = [*HOUSES, *[GATE] * (NEAREST + 2)]
    named = np.arange(len(inks)) >= FEWEST + 1
    assert strangers(inks, named, np.zeros_like(named)).tolist() == [False] * FEWEST + [True] * (
        NEAREST + 2
    )


def test_of_few_drawings_only_the_names_count():
    named = np.array([False] * (FEWEST - 2) + [False, True])
    nothing = np.zeros_like(named)
    inks = [*HOUSES[2:], GATE, GATE]
    assert np.array_equal(strangers(inks, named, nothing), named)
    assert np.array_equal(strangers(inks, nothing, named), named)


def test_where_a_name_leaves_doubt_the_shape_decides_more_strictly():
    doubtful = np.array([False] * FEWEST + [True, True])
    inks = [*HOUSES, HOUSES[3], HOUSES[3] & ~box(40, 40, 90, 90)]
    far = unlikeness(silhouettes(inks), ~doubtful)
    assert far[-2] < np.median(far[:-2]) < far[-1] < FAR[0]
    assert strangers(inks, np.zeros_like(doubtful), doubtful).tolist()[-2:] == [False, True]
    assert not strangers(inks, *none_named(len(inks))).any()


MANY = [blob(number) if number % 5 else GATE for number in range(14)]


@settings(max_examples=30)
@given(st.lists(st.booleans(), max_size=14), st.randoms())
def test_names_are_believed_and_the_order_does_not_matter(flags, random):
    named = np.array(flags, bool)
    inks = MANY[: len(flags)]
    doubtful = np.roll(named, 1) & ~named
    found = strangers(inks, named, doubtful)
    assert found.shape == named.shape
    assert (found | ~named).all()
    order = list(range(len(flags)))
    random.shuffle(order)
    again = strangers([inks[number] for number in order], named[order], doubtful[order])
    assert np.array_equal(again, found[order])
