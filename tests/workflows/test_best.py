"""The results to look at first, named again once all are there."""

from dataclasses import replace

import numpy as np

from iconstudio.model import CANVAS
from iconstudio.workflows.events import Recommended, Result
from iconstudio.workflows.modelling.best import NEARLY, with_best
from iconstudio.workflows.recommending import Recommending
from tests.output.made import made, quarters


def icon(style, lambda_s, labels, plausible):
    one = made(labels, lambda_s)
    composite = replace(one.composite, style=style, shares=(0.5, 0.5, 0.0))
    score = replace(one.score, seam=1.0, whole=1.0, likeness=1.0, plausible=plausible)
    return replace(one, composite=composite, score=score)


def whole(label):
    return np.full((CANVAS, CANVAS), label, np.uint8)


def named(*results, count=2):
    """Return what each style names in the end."""
    events = Recommending(count).after(Result(one) for one in results)
    found = [event for event in with_best(events) if isinstance(event, Recommended)]
    return {event.style: event.lambda_s for event in found}


def test_what_takes_a_place_later_is_named_if_it_is_best():
    row = icon("light", 0.1, quarters(), 0.8), icon("light", 0.2, whole(1), 0.7)
    assert named(*row) == {"light": 0.1}
    later = icon("light", 0.2, whole(2), 0.9)
    assert named(*row, later) == {"light": 0.2}


def test_of_two_rows_with_one_picture_the_darker_names_another_if_it_is_nearly_as_good():
    first, second = icon("light", 0.1, whole(1), 0.6), icon("light", 0.2, quarters(), 0.9)
    nearly = 0.9 * NEARLY**0.5  # what is plausible counts twice
    good = icon("dark", 0.1, whole(1), nearly + 0.01), icon("dark", 0.2, quarters(), 0.9)
    bad = icon("dark", 0.1, whole(1), nearly - 0.01), good[1]
    assert named(first, second, *good) == {"light": 0.2, "dark": 0.1}
    assert named(*good, first, second) == {
        "light": 0.2,
        "dark": 0.1,
    }  # in whichever order they come
    assert named(first, second, *bad) == {"light": 0.2, "dark": 0.2}


def test_a_row_that_has_not_ended_is_not_named():
    assert named(icon("light", 0.1, quarters(), 0.9)) == {}
