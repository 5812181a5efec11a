"""What was added to an icon is shown by results, or it is said that it is not."""

import numpy as np

from iconstudio.model import CANVAS, Placement
from iconstudio.workflows.editing.additions import doubts, judged, shown, with_missed
from iconstudio.workflows.events import Remark, Result
from tests.output.made import made, quarters

ICON = made(0 * quarters())
"""A ring of 100 canvas units, filled to its rim."""
AWAY, WITHIN = np.zeros((2, CANVAS, CANVAS), bool)
AWAY[:20, :20] = WITHIN[120:140, 120:140] = True


def said(area):
    """Return what is said of an icon that was to fill an area."""
    events = (event for event in [Result(ICON)])
    return [event.sentence for event in with_missed(events, area) if isinstance(event, Remark)]


def test_how_much_of_what_is_wanted_is_filled():
    assert shown(ICON, AWAY) == 0
    assert shown(ICON, WITHIN) == 1
    assert shown(ICON, AWAY | WITHIN) == 0.5
    assert shown(ICON, AWAY & WITHIN) == 1


def test_what_shows_nothing_that_was_added_does_not_fit_the_change():
    assert judged(ICON, WITHIN) is ICON
    assert judged(ICON, AWAY).score.total == 0


def test_what_shows_little_of_what_was_added_fits_the_change_less():
    fits = [
        judged(ICON, AWAY | WITHIN & (np.arange(CANVAS) < end)).score.likeness
        for end in (124, 128, 140)
    ]
    assert 0 < fits[0] < fits[1] < fits[2] < ICON.score.likeness
    few = AWAY & (np.arange(CANVAS) < 3)  # 60 of 460 pixels
    assert judged(ICON, few | WITHIN) is ICON


def test_it_is_said_if_all_is_made_smaller_to_have_room():
    (sentence,) = doubts(Placement(0.87), ())
    assert "to 87% of its size" in sentence
    assert list(doubts(Placement(), ())) == list(doubts(Placement(0.999), ())) == []
    inside, other = doubts(Placement(1.0, dx=9), (1, 3))
    assert "area 1 lies inside" in inside and "area 3 lies inside" in other


def test_it_is_said_if_no_result_shows_what_was_added():
    (sentence,) = said(AWAY)
    assert "0% at most" in sentence
    assert said(WITHIN) == said(AWAY & WITHIN) == []
