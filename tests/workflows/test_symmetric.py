"""Symmetric results in the places of recommended ones."""

from dataclasses import replace

import numpy as np
import pytest

from iconstudio.algorithms.iconification.symmetry import reflected
from iconstudio.model import CANVAS, Axis
from iconstudio.svg.placed import render_placed
from iconstudio.workflows.events import Result
from iconstudio.workflows.grid import Recommending
from iconstudio.workflows.modelling.modelling import pose_sketch
from iconstudio.workflows.modelling.symmetric import _plausible, with_symmetric
from iconstudio.workflows.remixing import Remixing
from tests.output.made import SKETCH, made, quarters

AXIS = Axis.HORIZONTAL


class Fixed:
    """Finds every picture equally plausible; worker processes can be told of it."""

    def __init__(self, value: float) -> None:
        self.value = value

    def of(self, found) -> float:
        return self.value


def pose(sources):
    return pose_sketch(SKETCH.fitted(), CANVAS, (), sources)


def run(workers, before, after, axis=AXIS):
    """Return the recommended result, and what came after it; both with these plausibilities."""
    icon = made(quarters())
    icon = replace(icon, score=replace(icon.score, plausible=before))
    events = Recommending(1).after(iter([Result(icon)]))
    remixing = Remixing(workers, render_placed, 1, Fixed(after))
    return icon, [
        event.icon
        for event in with_symmetric(events, axis, pose, remixing)
        if isinstance(event, Result) and event.icon is not icon
    ]


def test_a_symmetric_result_takes_the_place_of_a_less_plausible_one(workers):
    icon, (symmetric,) = run(workers, 0.3, 0.6)
    one, other = icon.composite, symmetric.composite
    assert (other.style, other.lambda_s, other.symmetry) == (one.style, one.lambda_s, AXIS)
    assert other.sources == one.sources
    assert np.array_equal(other.labels, reflected(other.labels, AXIS))
    assert not np.array_equal(one.labels, reflected(one.labels, AXIS))
    problem = pose(one.sources).problem
    data, smoothness = problem.costs(other.labels)
    assert other.energy == pytest.approx(data + one.lambda_s * smoothness)


def test_a_symmetric_result_that_loses_what_is_inside_takes_no_place():
    shown = made(quarters())
    shown = replace(shown, score=replace(shown.score, plausible=0.5, inside=0.9))
    lost = replace(shown, score=replace(shown.score, plausible=0.8, inside=0.3))
    assert _plausible(lost) < _plausible(shown)


@pytest.mark.parametrize(("before", "after", "axis"), [(0.5, 0.5, AXIS), (0.3, 0.6, None)])
def test_nothing_takes_the_place_of_what_is_as_plausible_or_has_no_axis(
    workers, before, after, axis
):
    assert run(workers, before, after, axis)[1] == []
