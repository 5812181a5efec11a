"""Which runs begin while what is wanted changes: decided without a clock."""

import pytest
from PySide6.QtCore import QObject, Signal

from iconstudio.gui.jobs.live import LiveRunner


class PretendedJob(QObject):
    """A run that ends when it is told to."""

    event = Signal(object)
    failed = Signal(str)
    finished = Signal()

    def cancel(self):
        """Nothing is heard of it any more."""


class Hand:
    """What is wanted, and a worker that notes which runs begin."""

    def __init__(self):
        self.begun = []
        self.jobs = []

    def submit(self, make):
        make()
        self.jobs.append(PretendedJob())
        return self.jobs[-1]

    def end(self):
        self.jobs[-1].finished.emit()

    def fail(self):
        self.jobs[-1].failed.emit("It cannot be done.")
        self.end()


@pytest.fixture
def hand(qapp):
    return Hand()


@pytest.fixture
def newest(hand):
    newest = LiveRunner(hand, hand.begun.append)
    newest.timer.setInterval(10**6)
    return newest


def move(hand, newest, to):
    newest.request(to)


def test_the_first_begins_at_once(hand, newest):
    move(hand, newest, 1)
    assert hand.begun == [1]
    assert newest.holding and not newest.pending


def test_of_those_that_wait_only_the_newest_begins_once_something_is_shown(hand, newest):
    for number in (1, 2, 3, 4):
        move(hand, newest, number)
    assert hand.begun == [1]
    newest.release()
    assert hand.begun == [1, 4]
    newest.release()
    assert hand.begun == [1, 4]


def test_a_run_that_has_shown_something_gives_way_at_once(hand, newest):
    move(hand, newest, 1)
    newest.release()
    move(hand, newest, 2)
    assert hand.begun == [1, 2]
    move(hand, newest, 3)
    assert hand.begun == [1, 2], "the second has shown nothing yet"


def test_a_run_that_shows_nothing_for_too_long_gives_way(hand, newest):
    move(hand, newest, 1)
    move(hand, newest, 2)
    newest.timer.timeout.emit()
    assert hand.begun == [1, 2]
    newest.timer.stop()
    move(hand, newest, 3)
    assert hand.begun == [1, 2, 3]


def test_the_end_of_a_run_lets_the_newest_begin(hand, newest):
    move(hand, newest, 1)
    hand.end()
    assert hand.begun == [1] and not newest.holding
    move(hand, newest, 2)
    move(hand, newest, 3)
    hand.end()
    assert hand.begun == [1, 2, 3]


def test_what_is_forgotten_never_begins(hand, newest):
    move(hand, newest, 1)
    move(hand, newest, 2)
    newest.discard()
    newest.release()
    hand.end()
    assert hand.begun == [1]


def test_what_runs_or_is_finished_does_not_begin_again(hand, newest):
    move(hand, newest, 1)
    move(hand, newest, 2)
    move(hand, newest, 1)
    assert not newest.pending, "back to what runs"
    hand.end()
    move(hand, newest, 1)
    assert hand.begun == [1]


def test_what_failed_or_was_stopped_begins_again(hand, newest):
    told = []
    newest.failed.connect(told.append)
    move(hand, newest, 1)
    hand.fail()
    move(hand, newest, 1)
    newest.cancel()
    move(hand, newest, 1)
    assert hand.begun == [1, 1, 1]
    assert told == ["It cannot be done."]


def test_the_failure_of_what_is_out_of_date_is_not_told(hand, newest):
    told = []
    newest.failed.connect(told.append)
    move(hand, newest, 1)
    move(hand, newest, 2)
    hand.fail()
    assert hand.begun == [1, 2]
    assert told == []


def test_what_a_whole_run_came_to_is_told_again_at_once_without_a_run(hand, newest):
    told, ended = [], []
    newest.event.connect(told.append)
    newest.ended.connect(ended.append)
    move(hand, newest, 1)
    hand.jobs[-1].event.emit("one")
    hand.end()
    move(hand, newest, 2)
    hand.jobs[-1].event.emit("two")
    del told[:], ended[:]
    move(hand, newest, 1)
    assert hand.begun == [1, 2] and not newest.running and not newest.holding
    assert (told, ended, newest.ran) == (["one"], [True], 1)
    move(hand, newest, 2)
    assert hand.begun == [1, 2, 2], "the second had come to no end"
    hand.jobs[-1].event.emit("two")
    hand.end()
    newest.run(2)
    assert hand.begun == [1, 2, 2, 2], "the user himself asks for it"


def test_what_is_kept_is_bounded(hand):
    newest = LiveRunner(hand, hand.begun.append, kept=3)
    for number in range(5):
        move(hand, newest, number)
        hand.jobs[-1].event.emit(str(number))
        hand.end()
    assert [newest.known(number) for number in range(5)] == [None, None, ["2"], ["3"], ["4"]]
    move(hand, newest, 2)
    move(hand, newest, 5)
    hand.jobs[-1].event.emit("5")
    hand.end()
    assert newest.known(2) and not newest.known(3), "what was wanted for the last time first goes"
