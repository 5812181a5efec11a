from dataclasses import replace

import numpy as np
import pytest

from iconstudio.model import Axis, Placement
from iconstudio.workflows.events import Recommended, Result
from iconstudio.workflows.recommending import NEARLY, Recommending
from tests.output.made import SOURCES, made, quarters


def recommended(icons, alone=False):
    events = list(Recommending(len(icons), alone).after(map(Result, icons)))
    (one,) = (event for event in events if isinstance(event, Recommended))
    return one


def judged(icon, plausible, likeness=0.9):
    terms = replace(icon.score, seam=1.0, whole=1.0, likeness=likeness, plausible=plausible)
    return replace(icon, score=terms)


def test_what_is_plausible_is_recommended_rather_than_what_is_like_the_outline():
    torn, good = made(quarters(), 0.05), made(quarters(), 0.1)
    icons = [judged(torn, 0.2, likeness=0.95), judged(good, 0.8, likeness=0.7)]
    assert recommended(icons) == Recommended("light", 0.1)


def test_what_has_another_shape_is_not_recommended_for_being_plausible():
    other, good = made(quarters(), 0.05), made(quarters(), 0.1)
    icons = [judged(other, 0.6, likeness=0.45), judged(good, 0.45, likeness=0.8)]
    assert recommended(icons) == Recommended("light", 0.1)


def test_what_shows_the_holes_and_lines_is_recommended_rather_than_what_is_more_like_the_outline():
    there, lost = (judged(made(quarters(), value), 0.8, 0.85) for value in (0.05, 0.1))
    there, lost = (
        replace(icon, score=replace(icon.score, inside=inside))
        for icon, inside in ((there, 0.9), (judged(lost, 0.9, 0.95), 0.4))
    )
    assert recommended([lost, there]) == Recommended("light", 0.05)


def test_an_icon_as_it_went_in_stands_for_remixes_of_which_none_is_plausible():
    whole, joined = made(0 * quarters(), 0.75), made(quarters(), 0.05)
    assert recommended([judged(whole, 0.9), judged(joined, 0.6)]) == Recommended("light", 0.05)
    assert recommended([judged(whole, 0.9), judged(joined, 0.4)]) == Recommended("light", 0.75)
    assert recommended([judged(whole, 0.4), judged(joined, 0.2)]) == Recommended("light", 0.05)


def test_an_icon_as_it_went_in_is_never_recommended_unless_it_was_judged():
    whole, joined = made(0 * quarters(), 0.75), made(quarters(), 0.05)
    better = replace(whole, score=replace(whole.score, likeness=1.0, seam=1.0))
    worse = replace(joined, score=replace(joined.score, likeness=0.1))
    assert recommended([better, worse]) == Recommended("light", 0.05)
    assert recommended([better, better]) == Recommended("light", None)


def test_an_icon_that_a_part_was_taken_off_is_as_good_as_a_remix():
    whole, joined = made(0 * quarters(), 0.75), made(quarters(), 0.05)
    icons = [judged(whole, 0.4, 0.9), judged(joined, 0.2, 0.9)]
    assert recommended(icons, alone=True) == Recommended("light", 0.75)
    assert recommended([whole, whole], alone=True) == Recommended("light", 0.75)


def test_what_is_recommended_does_not_depend_on_what_came_first():
    same = [judged(made(0 * quarters(), value), 0.9) for value in (0.1, 0.75, 0.3)]
    for icons in (same, same[::-1]):
        assert recommended(icons) == Recommended("light", 0.75)


@pytest.mark.parametrize("plausible, named", [(0.6, 0.05), (0.4, 0.75)])
def test_an_icon_and_its_mirror_image_are_an_icon_as_it_went_in(plausible, named):
    placed = Placement(1.1, False, -12, -3)
    sources = (SOURCES[0], replace(SOURCES[1], placement=placed), *SOURCES[1:3])
    labels = np.where(quarters() > 0, np.uint8(1), np.uint8(2))
    halves = judged(made(labels, 0.75, sources=sources), 0.9)
    joined = judged(made(quarters(), 0.05), plausible)
    assert recommended([halves, joined]) == Recommended("light", 0.75)
    mirrored = replace(halves, composite=replace(halves.composite, symmetry=Axis.HORIZONTAL))
    assert recommended([mirrored, joined]) == Recommended("light", named)


def test_what_was_made_symmetric_comes_first_if_it_is_nearly_as_good():
    best, even = (judged(made(quarters(), value), 0.9) for value in (0.05, 0.1))
    even = replace(even, composite=replace(even.composite, symmetry=Axis.VERTICAL))
    least = 0.9 * NEARLY**0.5  # what is plausible counts twice
    assert recommended([best, judged(even, least + 0.01)]) == Recommended("light", 0.1)
    assert recommended([best, judged(even, least - 0.01)]) == Recommended("light", 0.05)


def test_what_is_good_for_nothing_is_not_recommended():
    icons = [judged(made(quarters(), value), 0.9, likeness=0.0) for value in (0.05, 0.1)]
    assert recommended(icons) == Recommended("light", None)
