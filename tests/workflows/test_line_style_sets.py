"""Whole sets in a line style: what comes of each icon, in what order, and what is left out."""

from concurrent.futures import Future

import pytest

from iconstudio.inputs.styles import named
from iconstudio.model import Credit, IconstudioError, Pictogram
from iconstudio.model.icon_set import Member
from iconstudio.workers import ProcessDied, Workers
from iconstudio.workflows.events import Progress
from iconstudio.workflows.line_style import sets
from iconstudio.workflows.line_style.sets import (
    Here,
    Manner,
    MemberRestyled,
    MemberSkipped,
    restyle_set,
    restyled_member,
)

CREDIT = Credit("shape", "Ann", "MIT", "", "")
MANNER = Manner(named("Shaky"), seed=4)


def cross(x):
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24" fill="none" stroke="black" '
        f'stroke-width="2"><path d="M{x} 4V20M4 {x}H20"/></svg>'
    )


def member(number):
    icon = Pictogram(f"test:{number}", cross(6 + number), CREDIT)
    return Member(icon.id, str(number), lambda: icon)


MEMBERS = [member(number) for number in range(5)]


class Direct:
    """Processes that call the function at once."""

    count = 1

    def __init__(self, function=None):
        self.function = function
        self.called = []

    def submit(self, function, identifier, *args):
        future = Future()
        self.called.append(identifier)
        try:
            future.set_result((self.function or function)(identifier, *args))
        except Exception as error:
            future.set_exception(error)
        return future


def finished(events):
    return {one.member.id: one for one in events if not isinstance(one, Progress)}


@pytest.mark.thorough
def test_the_number_of_processes_changes_nothing():
    alone = finished(restyle_set(MEMBERS, MANNER, Direct()))
    assert list(alone) == [one.id for one in MEMBERS]
    assert all(isinstance(one, MemberRestyled) for one in alone.values())
    with Workers(3) as workers:
        assert finished(restyle_set(MEMBERS, MANNER, Here(workers))) == alone


def test_an_icon_depends_on_itself_alone():
    one = finished(restyle_set(MEMBERS[3:4], MANNER, Direct()))
    assert one["test:3"] == finished(restyle_set(MEMBERS, MANNER, Direct()))["test:3"]
    other = Manner(MANNER.style, seed=5)
    assert other.seed_of("test:3") != MANNER.seed_of("test:3") != MANNER.seed_of("test:4")
    assert finished(restyle_set(MEMBERS[3:4], other, Direct())) != one


def test_strokes_stay_strokes_if_that_is_wanted():
    manner = Manner(MANNER.style, strokes=True)
    _, ((path, width),), _, _ = restyled_member("test:0", MEMBERS[0].read(), manner)
    assert len(path.contours) == 2
    assert width > 0
    _, ((_, filled),), _, _ = restyled_member("test:0", MEMBERS[0].read(), MANNER)
    assert filled == 0


@pytest.mark.parametrize("strokes", [False, True])
def test_icons_of_a_set_stay_on_the_canvas_too(strokes):
    """They were restyled by other code than single ones, which shrink."""
    frame = cross(6).replace("M6 4V20M4 6H20", "M1 1H23V23H1Z")
    manner = Manner(named("Speed"), strokes=strokes)
    _, drawn, _, scale = restyled_member(
        "test:frame", Pictogram("test:frame", frame, CREDIT), manner
    )
    assert 0.8 < scale < 1
    for path, width in drawn:
        left, top, right, bottom = path.bounds
        assert min(left, top) - width / 2 > -1
        assert max(right, bottom) + width / 2 < 257


def test_the_file_of_a_drawing_is_read_where_it_is_restyled():
    icon, drawn, page, scale = restyled_member("a/cross.svg", cross(8).encode(), MANNER)
    assert (icon.credit.title, icon.svg) == ("cross.svg", "")
    assert drawn[0][0]
    assert (page, scale) == ((256, 256), 1)


def raises(error):
    def function(*args):
        raise error

    return function


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (IconstudioError("It has no lines."), "It has no lines."),
        (TimeoutError(), "takes too long"),
        (MemoryError(), "too much memory"),
        (ProcessDied(-11), "crashes"),
        (ValueError("odd"), "The program fails on it: ValueError."),
    ],
)
def test_what_cannot_be_restyled_is_skipped(error, words):
    def fails_on_the_second(identifier, *args):
        if identifier == "test:1":
            raise error
        return restyled_member(identifier, *args)

    found = finished(restyle_set(MEMBERS[:3], MANNER, Direct(fails_on_the_second)))
    assert words in found.pop("test:1").reason
    assert [type(one) for one in found.values()] == [MemberRestyled] * 2


def test_a_file_that_cannot_be_read_is_skipped():
    lost = Member("lost.svg", "lost", raises(IconstudioError("It is gone.")))
    found = finished(restyle_set([lost, *MEMBERS[:1]], MANNER, Direct()))
    assert found["lost.svg"] == MemberSkipped(lost, "It is gone.")
    assert isinstance(found["test:0"], MemberRestyled)


def test_workers_of_another_program_end_it_all():
    processes = Direct(raises(ImportError("Iconstudio 0.1 instead of 0.4")))
    with pytest.raises(IconstudioError, match=r"0\.1 instead.*Install the same version"):
        list(restyle_set(MEMBERS, MANNER, processes))


def test_what_is_done_is_not_done_again():
    processes = Direct()
    events = list(restyle_set(MEMBERS, MANNER, processes, lambda one, _: one.id < "test:3"))
    assert processes.called == ["test:3", "test:4"]
    assert events[-1] == Progress("remix", 1.0, "5 of 5 icons", 0.0)


def test_progress_tells_the_time_that_remains():
    ticks = iter(range(100))

    def clock():
        return float(next(ticks))

    events = list(
        restyle_set(MEMBERS, MANNER, Direct(lambda *_: (MEMBERS[0].read(), (), 1.0)), clock=clock)
    )
    progress = [one for one in events if isinstance(one, Progress)]
    assert progress[0].remaining is None
    assert [one.done for one in progress] == sorted(one.done for one in progress)
    later = [one.remaining for one in progress[1:]]
    assert later == sorted(later, reverse=True)
    assert later[-1] == 0


class Silent(Direct):
    """Processes that never answer, but ``after`` so many tasks."""

    count = 2

    def __init__(self, after=0):
        super().__init__()
        self.after, self.futures = after, []

    def submit(self, function, *args):
        answers = len(self.futures) < self.after
        self.futures.append(super().submit(function, *args) if answers else Future())
        return self.futures[-1]


def test_a_cluster_that_is_silent_is_left(monkeypatch):
    processes = Silent()
    monkeypatch.setattr(sets, "_PATIENCE", 0.01)
    with pytest.raises(IconstudioError, match="goes on where it was"):
        list(restyle_set(MEMBERS, MANNER, processes))
    assert processes.futures and all(one.cancelled() for one in processes.futures)


def test_closing_cancels_what_waits():
    processes = Silent(after=1)
    events = restyle_set(MEMBERS, MANNER, processes)
    assert isinstance(next(events), Progress)
    assert isinstance(next(events), MemberRestyled)
    events.close()
    assert [one.cancelled() for one in processes.futures] == [False, True, True, True, True]


@pytest.mark.parametrize(("opacity", "said"), [(0.3, "left out"), (0.7, "as dark as"), (1.0, "")])
def test_it_is_recorded_what_became_of_pale_parts(opacity, said):
    body = f'<path d="M4 4h16v6H4z"/><path opacity="{opacity}" d="M4 12h16v8H4z"/>'
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24">{body}</svg>'
    icon, _, _, _ = restyled_member("test:two", Pictogram("test:two", svg, CREDIT), MANNER)
    assert len(icon.remarks) == bool(said)
    assert said in "".join(icon.remarks)


@pytest.mark.parametrize(
    ("width", "height", "page", "unit"),
    [
        (24, 24, (256, 256), 256 / 24),
        (30, 24, (320, 256), 256 / 24),
        (15, 24, (160, 256), 256 / 24),
        (3, 24, (128, 256), 256 / 24),
        (96, 24, (512, 256), 512 / 96),
    ],
)
def test_pages_keep_their_proportions_and_are_as_high_as_each_other(width, height, page, unit):
    """So strokes have one width in a set whose pages have several, and textures one scale."""
    middle = width / 2
    svg = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}">'
        f'<path d="M{middle} 6V18" stroke="#000" stroke-width="2" stroke-linecap="round"/></svg>'
    )
    manner = Manner(named("Loose"), seed=4, strokes=True)
    icon = Pictogram("test:line", svg, CREDIT)
    _, ((path, stroke),), found, _ = restyled_member(icon.id, icon, manner)
    assert found == pytest.approx(page)
    assert stroke == pytest.approx(2 * unit, rel=0.01)
    left, top, right, bottom = path.bounds
    assert (left + right) / 2 == pytest.approx(page[0] / 2, abs=6)
    assert (top, bottom) == pytest.approx((page[1] / 2 - 6 * unit, page[1] / 2 + 6 * unit), abs=6)
