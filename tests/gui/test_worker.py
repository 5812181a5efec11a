"""The thread that runs generators."""

import threading
import time
from concurrent.futures import CancelledError

import pytest

from iconstudio.gui.jobs.worker import Worker
from iconstudio.model import IconstudioError


@pytest.fixture
def worker():
    worker = Worker()
    yield worker
    worker.close()
    assert not worker.alive


def listen(job):
    """Return a list to which everything that the job tells is appended."""
    heard = []
    job.event.connect(lambda event: heard.append(("event", event)))
    job.failed.connect(lambda message: heard.append(("failed", message)))
    job.finished.connect(lambda: heard.append(("finished", None)))
    return heard


def test_events_arrive_in_order_in_the_windows_thread(qtbot, worker):
    threads = []

    def work():
        threads.append(threading.get_ident())
        yield from range(5)

    job = worker.submit(work)
    heard = listen(job)
    job.event.connect(lambda _: threads.append(threading.get_ident()))
    qtbot.waitUntil(lambda: ("finished", None) in heard)
    assert heard == [*(("event", number) for number in range(5)), ("finished", None)]
    assert threads[0] != threading.get_ident()
    assert set(threads[1:]) == {threading.get_ident()}


def test_jobs_run_one_after_the_other(qtbot, worker):
    order = []

    def work(name):
        order.append(f"{name} begins")
        yield name
        order.append(f"{name} ends")

    heard = [listen(worker.submit(lambda name=name: work(name))) for name in "ab"]
    qtbot.waitUntil(lambda: all(("finished", None) in each for each in heard))
    assert order == ["a begins", "a ends", "b begins", "b ends"]


def test_a_mistake_of_the_user_is_told_in_its_own_words(qtbot, worker):
    def work():
        yield 1
        raise IconstudioError("The dog is a cat. Call it so.")

    heard = listen(worker.submit(work))
    qtbot.waitUntil(lambda: ("finished", None) in heard)
    assert heard[1:] == [("failed", "The dog is a cat. Call it so."), ("finished", None)]


def test_any_other_error_is_told_and_logged_and_the_worker_lives_on(qtbot, worker, caplog):
    def work():
        yield 1
        raise ZeroDivisionError("by nought")

    heard = listen(worker.submit(work))
    qtbot.waitUntil(lambda: ("finished", None) in heard)
    assert "ZeroDivisionError: by nought" in heard[1][1]
    assert "a job failed" in caplog.text
    again = listen(worker.submit(lambda: (number for number in [2])))
    qtbot.waitUntil(lambda: again == [("event", 2), ("finished", None)])


def test_workers_that_are_closed_are_no_error(qtbot, worker, caplog):
    def work():
        yield 1
        raise CancelledError("The worker processes have been closed.")

    heard = listen(worker.submit(work))
    qtbot.waitUntil(lambda: ("finished", None) in heard)
    assert heard == [("event", 1), ("finished", None)]
    assert not caplog.text


def test_a_cancelled_generator_is_closed_and_tells_nothing_more(qtbot, worker):
    closed = threading.Event()

    def work():
        try:
            while True:
                time.sleep(0.001)
                yield "tick"
        finally:
            closed.set()

    job = worker.submit(work)
    heard = listen(job)
    qtbot.waitUntil(lambda: len(heard) > 3)
    job.cancel()
    count = len(heard)
    qtbot.waitUntil(lambda: heard[-1] == ("finished", None))
    assert closed.is_set()
    assert len(heard) == count + 1


def test_a_job_that_was_cancelled_before_its_turn_never_starts(qtbot, worker):
    gate, started = threading.Event(), []

    def first():
        gate.wait()
        yield 1

    def second():
        started.append(2)
        yield 2

    worker.submit(first)
    job = worker.submit(second)
    heard = listen(job)
    job.cancel()
    gate.set()
    qtbot.waitUntil(lambda: heard == [("finished", None)])
    assert not started


def test_close_interrupts_what_comes_to_no_yield(qtbot):
    worker = Worker()
    waiting, release = threading.Event(), threading.Event()

    def work():
        waiting.set()
        release.wait()
        yield 1

    worker.submit(work)
    assert waiting.wait(5)
    worker.close(interrupt=release.set, patience=50)
    assert not worker.alive


def test_close_ends_an_endless_generator_and_drops_the_jobs_behind_it(qtbot):
    worker = Worker()
    running, closed = threading.Event(), threading.Event()
    started = []

    def endless():
        running.set()
        try:
            while True:
                yield time.sleep(0.001)
        finally:
            closed.set()

    def behind():
        started.append(1)
        yield 1

    worker.submit(endless)
    worker.submit(behind)
    assert running.wait(5)
    worker.close()
    assert closed.is_set()
    assert not started
    assert not worker.alive
