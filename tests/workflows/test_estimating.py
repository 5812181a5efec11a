"""The time that remains, told of runs made up by a simple plan, and of real ones written down."""

import heapq
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.model import Composite, Drawing, Icon, Remix, Score
from iconstudio.model import Path as IconPath
from iconstudio.workflows.estimating import Estimate, estimated, spoken
from iconstudio.workflows.events import Progress, Recommended, Result, StyleMatched, StyleSkipped

RECORDINGS = Path(__file__).parent / "recordings"


class Clock:
    def __init__(self):
        self.now = 100.0

    def __call__(self):
        return self.now


def result(row, cut, drawn=0.0, preview=False):
    composite = Composite(row, 1.0, (), np.zeros((0, 0), np.uint8), 0.0, 0.0, 0.0, (), None)
    icon = Remix.of(composite, Drawing(Path(), composite.labels), Score(1, 1, 1, 1, 1))
    return Result(icon, {"remix": cut, "vectorize": drawn}, preview)


def played(timed, clock):
    """Yield events at their times, counted from the start."""
    start = clock.now
    for at, event in timed:
        clock.now = start + at
        yield event


def told(timed, processes=2):
    """Return (time, remaining) of all progress of a run."""
    clock = Clock()
    events = estimated(played(timed, clock), processes, clock)
    return [(clock.now - 100, e.remaining) for e in events if isinstance(e, Progress)]


def grid(rows=4, columns=8, first=4.0, later=0.5, processes=2, tick=0.1):
    """A run whose processes each work on a row at a time, from its first result to its last.

    A tick of progress falls between the results, as of whoever waits for them.
    """
    timed = [(0.01 * row, StyleMatched(str(row), (), ())) for row in range(rows)]
    free = [0.0] * processes
    finished = []
    for row in range(rows):
        end = heapq.heappop(free)
        for column in range(columns):
            cost = later if column else first
            end += cost
            finished.append((end, str(row), cost, column + 1 == columns))
        heapq.heappush(free, end)
    total, last = rows * columns, 0.0
    for done, (at, row, cost, whole) in enumerate(sorted(finished), start=1):
        while last + tick < at:
            last += tick
            timed.append((last, Progress("remix", (done - 1) / total, "Joining parts")))
        timed += [(at, result(row, cost))] + [(at, Recommended(row, 0.1))] * whole
        timed.append((at, Progress("remix", done / total, "Joining parts")))
        last = at
    return sorted(timed, key=lambda pair: pair[0])


def recorded(name):
    """A real run that was written down."""
    timed, end = [], 0.0
    for at, kind, *rest in json.loads((RECORDINGS / f"{name}.json").read_text()):
        end = at
        match kind:
            case "matched":
                timed.append((at, StyleMatched(rest[0], (), ())))
            case "progress":
                timed.append((at, Progress("remix", rest[0], "")))
            case "recommended":
                timed.append((at, Recommended(rest[0], 0.1)))
            case "result":
                timed.append((at, result(*rest)))
    return timed, end


def at(track, when):
    """What was said last at a time."""
    return [remaining for time, remaining in track if time <= when][-1]


@settings(max_examples=60)
@given(
    rows=st.sampled_from([2, 4, 6]),
    columns=st.integers(6, 8),
    times=st.floats(2, 8),
    later=st.floats(0.2, 1),
    processes=st.sampled_from([1, 2]),
)
def test_half_way_it_is_right_within_a_factor_of_two(rows, columns, times, later, processes):
    processes = min(processes, rows)
    timed = grid(rows, columns, times * later, later, processes)
    end = timed[-1][0]
    said = at(told(timed, processes), end / 2)
    if said is None:  # no result is there yet
        assert not any(isinstance(e, Result) for when, e in timed if when <= end / 2)
    else:
        assert end / 4 <= said <= end


@pytest.mark.parametrize("name", ["grid", "hybrids"])
@pytest.mark.parametrize("part", [0.35, 0.5, 0.75])
def test_a_real_run_is_told_within_a_factor_of_two(name, part):
    timed, end = recorded(name)
    said = at(told(timed), part * end)
    assert (1 - part) * end / 2 <= said <= (1 - part) * end * 2


def test_the_result_in_focus_tells_nothing_of_the_others():
    """It comes early, as the others of its row have not been searched for yet."""
    estimate = Estimate(2)
    estimate.note(StyleMatched("a", (), ()), 0.0)
    for event, at in (
        (replace(result("a", 0.5), preview=True), 0.5),
        (result("a", 1.0), 1.5),
        (Progress("remix", 1 / 16, ""), 1.5),
    ):
        estimate.note(event, at)
    assert estimate.remaining(1.5) is None
    estimate.note(StyleMatched("b", (), ()), 1.5)
    for event, at in ((result("b", 2.5), 3.0), (Progress("remix", 2 / 16, ""), 3.0)):
        estimate.note(event, at)
    assert estimate.remaining(3.0) > 3


def test_nothing_is_said_before_the_first_result():
    timed = grid()
    first = next(when for when, event in timed if isinstance(event, Result))
    track = told(timed)
    assert {remaining for when, remaining in track if when < first} == {None}
    assert all(remaining is not None for when, remaining in track if when > first)


def test_other_stages_say_nothing():
    timed = [(t / 10, Progress(stage, t / 10, "")) for stage in ("search", "prepare", "match")
             for t in range(11)]  # fmt: skip
    assert {remaining for _, remaining in told(timed)} == {None}


def test_it_counts_down_between_results_and_never_stands_at_nothing():
    for timed in (grid(), grid(1, 8, processes=1), grid(6, 8, 1.0, 0.7), recorded("grid")[0]):
        track = [pair for pair in told(timed) if pair[1] is not None]
        *under_way, (_, last) = track
        assert last == 0
        assert all(remaining > 0 for _, remaining in under_way)


def test_what_stands_still_is_not_said_to_end_at_once():
    timed = grid(1, 8, 2.0, 0.5, processes=1)
    *begun, _ = [pair for pair in timed if pair[0] <= 4.0]
    late = [(t, Progress("remix", 5 / 8, "")) for t in (20.0, 60.0, 200.0)]
    said = [remaining for _, remaining in told([*begun, *late], 1)[-3:]]
    assert said == sorted(said) and said[0] >= 1.0


def test_skipped_styles_shorten_what_is_left():
    """The progress leaps when a style is skipped."""
    whole = grid(2, 8, 2.0, 0.5)
    half = [(when, event) for when, event in whole if when <= 4.0]
    when, before = told(half)[-1]
    done = [event.done for _, event in half if isinstance(event, Progress)][-1]
    skipped = [(when, StyleSkipped("dark", 2, "")), (when, Progress("remix", 1.5 * done, ""))]
    assert told([*half, *skipped])[-1][1] < 0.9 * before


def test_a_preview_tells_nothing():
    plain = grid()
    first = next(n for n, (_, event) in enumerate(plain) if isinstance(event, Result))
    at_first, finished = plain[first]
    coarse = (at_first - 0.5, replace(finished, preview=True))
    track = told([*plain[:first], coarse, *plain[first:]])
    assert {remaining for when, remaining in track if when < at_first} == {None}


def test_a_single_result():
    track = told([(0, Progress("remix", 0, "")), (1, Progress("remix", 0, "")),
                  (2, result("montage", 1.5)), (2, Progress("remix", 1, ""))])  # fmt: skip
    assert [remaining for _, remaining in track] == [None, None, 0]


def test_hybrids_that_are_dropped_do_no_harm():
    """A third of the draws repeat others: no result comes of them."""
    timed = []
    for draw in range(1, 31):
        timed.append((draw, Progress("remix", draw / 30, "Mixing")))
        if draw % 3:
            timed.append((draw, result("hybrid", 2.0)))
    assert 7 <= at(told(timed), 20) <= 20


def test_events_pass_and_closing_ends_the_run():
    timed = grid()
    clock = Clock()
    run = played(timed, clock)
    events = estimated(run, 2, clock)
    passed = [next(events) for _ in timed]
    others = [event for _, event in timed if not isinstance(event, Progress)]
    assert [event for event in passed if not isinstance(event, Progress)] == others
    events.close()
    with pytest.raises(StopIteration):
        next(run)


@pytest.mark.parametrize(
    ("seconds", "words"),
    [(0.0, "about 1 s left"), (4.4, "about 4 s left"), (13.0, "about 15 s left"),
     (58.0, "about 1 min left"), (200.0, "about 3 min left")],
)  # fmt: skip
def test_words(seconds, words):
    assert spoken(seconds) == words


def test_a_run_of_other_icons_goes_on_as_it_has():
    other = Result(Icon(IconPath(()), "other"))
    timed = [(0, Progress("look", 0.5, "")), (4, Progress("make", 0.0, ""))]
    for number in range(1, 9):
        timed += [(4 + number, other), (4 + number, Progress("make", number / 8, ""))]
    remaining = [left for _, left in told(timed)]
    assert remaining[:2] == [None, None]
    assert remaining[2:] == pytest.approx([7, 6, 5, 4, 3, 2, 1, 0])
