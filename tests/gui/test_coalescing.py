"""Which runs begin while what is wanted changes: decided without a clock."""

import pytest
from PySide6.QtCore import QObject, Signal

from iconstudio.gui.jobs.coalescing import Coalescing


class Hand(QObject):
    """What is wanted, and a runner that is told when its run is over."""

    ended = Signal(bool)

    def __init__(self):
        super().__init__()
        self.running = False
        self.inputs = 0
        self.begun = []

    def begin(self):
        if self.running:
            self.ended.emit(False)  # as a runner does for the run that is replaced
        self.running = True
        self.begun.append(self.inputs)

    def end(self):
        self.running = False
        self.ended.emit(True)


@pytest.fixture
def hand(qapp):
    return Hand()


@pytest.fixture
def newest(hand):
    return Coalescing(hand, hand.begin, 10**6)


def move(hand, newest, to):
    hand.inputs = to
    newest.request()


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
