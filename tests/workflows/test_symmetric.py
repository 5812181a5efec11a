"""Symmetric results in the places of others of their row."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from iconstudio.algorithms.iconification.energy import joined_ink
from iconstudio.algorithms.iconification.symmetry import (
    flipped,
    likeness,
    mirrored_halves,
    reflected,
)
from iconstudio.algorithms.raster import placed_ink
from iconstudio.model import CANVAS, Axis, Placement
from iconstudio.svg.placed import render_placed
from iconstudio.workflows.events import Result
from iconstudio.workflows.modelling.modelling import pose_sketch
from iconstudio.workflows.modelling.symmetric import (
    ASIDE,
    _plausible,
    row_of,
    symmetric,
    with_symmetric,
)
from iconstudio.workflows.recommending import Recommending
from tests.output.made import SKETCH, SOURCES, made, quarters

BLOCK = 2
SIDE = np.zeros((CANVAS, CANVAS), np.uint8)
SIDE[:, 160:] = BLOCK
"""A ring whose right end is that of a block: even in the middle."""


class Fixed:
    """Finds every picture equally plausible; worker processes can be told of it."""

    def __init__(self, value: float) -> None:
        self.value = value

    def of(self, found) -> float:
        return self.value


def pose(sources):
    return pose_sketch(SKETCH.fitted(), CANVAS, (), sources)


def row(labels, best=0.1, other=0 * SIDE):
    """A row of two results: one of these labels, and another, by default a ring."""
    icons = {0.1: made(labels, 0.1), 0.2: made(other, 0.2)}
    return row_of(icons, best, pose, Axis.HORIZONTAL)


def values(row):
    return [lambda_s for lambda_s, _ in symmetric(row, render_placed, Fixed(0.6))]


def run(workers, labels, before, after, axis=Axis.HORIZONTAL, sources=SOURCES, held=False):
    """Return the recommended result, and what came after it; both with these plausibilities."""
    icon = made(labels, sources=sources)
    icon = replace(icon, score=replace(icon.score, plausible=before))
    events = Recommending(1).after(iter([Result(icon)]))
    events = with_symmetric(events, axis, pose, workers, render_placed, Fixed(after), held)
    return icon, [
        event.icon for event in events if isinstance(event, Result) and event.icon is not icon
    ]


def test_a_symmetric_result_takes_the_place_of_a_less_plausible_one(workers):
    icon, (found,) = run(workers, SIDE, 0.3, 0.6)
    one, other = icon.composite, found.composite
    assert (other.style, other.lambda_s) == (one.style, one.lambda_s)
    assert other.symmetry is Axis.HORIZONTAL
    before, after = (
        likeness(some.drawing.coverage > 127, Axis.HORIZONTAL) for some in (icon, found)
    )
    assert before < 0.95 and after > 0.995
    data, smoothness = pose(other.sources).problem.costs(other.labels)
    assert other.energy == pytest.approx(data + one.lambda_s * smoothness)


def test_what_is_uneven_in_the_middle_is_not_mirrored():
    assert values(row(quarters(), best=0.2)) == []  # nor what is symmetric already


def test_where_the_page_asks_for_symmetry_results_are_made_so_if_they_are_not_much_worse(workers):
    _, found = run(workers, SIDE, 0.6, 0.55)
    assert found == []
    _, (held,) = run(workers, SIDE, 0.6, 0.55, held=True)
    assert likeness(held.drawing.coverage > 127, Axis.HORIZONTAL) > 0.995
    _, worse = run(workers, SIDE, 0.6, 0.4, held=True)
    assert worse == []


def test_about_another_axis_places_that_mirror_each_other_have_one_source(workers):
    even = (SOURCES[0], SOURCES[3], SOURCES[2])  # each looks the same above and below
    above = np.ascontiguousarray(SIDE.T)
    icon, (cut,) = run(workers, above, 0.3, 0.6, Axis.VERTICAL, even)
    assert cut.composite.sources == icon.composite.sources
    assert np.array_equal(cut.composite.labels, reflected(cut.composite.labels, Axis.VERTICAL))
    ink = cut.drawing.coverage > 127
    assert likeness(ink, Axis.VERTICAL) > max(
        0.97, likeness(icon.drawing.coverage > 127, Axis.VERTICAL)
    )


def test_what_has_one_source_at_such_places_but_does_not_look_symmetric_takes_no_place(workers):
    _, found = run(workers, quarters(), 0.3, 0.6, Axis.VERTICAL)
    assert found == []


def test_only_a_used_source_that_is_no_mirror_image_of_itself_gets_one():
    one = row(quarters(), best=0.2)
    sources = one.sources
    assert sources[: len(SOURCES)] == SOURCES
    (added,) = sources[len(SOURCES) :]
    assert added.placement == Placement(1.1, False, -12, -3)
    assert one.twins.tolist() == [0, 4, 2, 3, 1]
    inks = [placed_ink(one.exemplar, one.placement)[0] for one in sources]
    assert np.array_equal(inks[4], inks[1][:, ::-1])


@pytest.mark.thorough
@given(st.integers(0, 2**32 - 1), arrays(np.uint8, (CANVAS, CANVAS), elements=st.integers(0, 4)))
def test_a_half_and_its_mirror_image_are_a_symmetric_picture(seed, labels):
    random = np.random.default_rng(seed)
    aside = int(random.integers(-ASIDE, ASIDE + 1))
    ink = random.random((5, CANVAS, CANVAS)) < 0.5
    twins = np.array([1, 0, 3, 2, 4], np.uint8)
    ink[1], ink[3] = flipped(ink[0], aside), flipped(ink[2], aside)
    ink[4] |= flipped(ink[4], aside)
    axis = (CANVAS - 1 + aside) / 2
    columns = np.arange(CANVAS)
    seen = np.abs(columns - axis) < CANVAS / 2 - ASIDE  # what has a mirror image on the canvas
    whole = joined_ink(ink, labels)
    for picture, kept in zip(
        (joined_ink(ink, some) for some in mirrored_halves(labels, twins, aside)),
        (columns <= axis, columns >= axis),
        strict=True,
    ):
        assert np.array_equal(picture[:, kept], whole[:, kept])
        assert np.array_equal(picture[:, seen], flipped(picture, aside)[:, seen])


def test_a_picture_is_mirrored_where_its_own_middle_is():
    moved = replace(SOURCES[0], placement=Placement(dx=2))
    icon = made(0 * SIDE, sources=(moved, SOURCES[2]))
    one = row_of({0.1: icon}, 0.1, pose, Axis.HORIZONTAL)
    assert one.aside == 4
    assert one.sources[0] is moved and one.twins[0] == 0


def test_the_recommended_result_comes_first():
    narrow = np.where(np.arange(CANVAS) < 200, SIDE, 1)  # both of a ring and a block, and another
    assert values(row(SIDE, 0.1, narrow)) == [0.1, 0.2]
    assert values(row(SIDE, 0.2, narrow)) == [0.2, 0.1]


def test_a_symmetric_result_that_loses_what_is_inside_takes_no_place():
    shown = made(quarters())
    shown = replace(shown, score=replace(shown.score, plausible=0.5, inside=0.9))
    lost = replace(shown, score=replace(shown.score, plausible=0.8, inside=0.3))
    assert _plausible(lost) < _plausible(shown)


@pytest.mark.parametrize(
    ("before", "after", "axis"), [(0.6, 0.5, Axis.HORIZONTAL), (0.3, 0.6, None)]
)
def test_nothing_takes_the_place_of_what_is_more_plausible_or_has_no_axis(
    workers, before, after, axis
):
    assert run(workers, SIDE, before, after, axis)[1] == []


def test_what_is_mirrored_does_not_depend_on_what_came_first():
    narrow = np.where(np.arange(CANVAS) < 200, SIDE, 1)
    icons = {0.1: made(SIDE, 0.1), 0.2: made(narrow, 0.2), 0.3: made(0 * SIDE, 0.3)}
    backwards = dict(reversed(icons.items()))
    one, other = (row_of(some, 0.1, pose, Axis.HORIZONTAL) for some in (icons, backwards))
    assert list(one.labels) == list(other.labels) == [0.1, 0.3, 0.2]
