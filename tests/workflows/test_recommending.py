from dataclasses import replace

from iconstudio.workflows.events import Recommended, Result
from iconstudio.workflows.grid import Recommending
from tests.output.made import made, quarters


def recommended(icons):
    events = list(Recommending(len(icons)).after(map(Result, icons)))
    (one,) = (event for event in events if isinstance(event, Recommended))
    return one


def test_an_icon_as_it_went_in_is_never_recommended():
    whole, joined = made(0 * quarters(), 0.75), made(quarters(), 0.05)
    better = replace(whole, score=replace(whole.score, likeness=1.0, seam=1.0))
    worse = replace(joined, score=replace(joined.score, likeness=0.1))
    assert recommended([better, worse]) == Recommended("light", 0.05)
    assert recommended([better, better]) == Recommended("light", None)
