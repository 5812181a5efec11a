"""One thread that runs any generator of events, one after the other, and can cancel each."""

import logging
import queue
import threading
from collections.abc import Callable, Generator
from concurrent.futures import CancelledError
from contextlib import closing
from typing import Any

from PySide6.QtCore import QObject, QThread, Signal

from iconstudio.model import IconstudioError

log = logging.getLogger(__name__)


class Job(QObject):
    """A generator at work. Every ``yield`` is an event, and a place to cancel.

    Signals, all in the window's thread
    -----------------------------------
    event(object)
        Something that the generator yielded; none after ``cancel``.
    failed(str)
        The generator raised; a sentence for the user. Not after ``cancel``.
    finished()
        Exactly once, at the end, whatever happened.
    """

    event = Signal(object)
    failed = Signal(str)
    finished = Signal()

    # From the worker's thread to the window's: only there the public signals are sent, so that
    # whoever connects to them in one go with ``submit`` misses none.
    _yielded = Signal(object)
    _raised = Signal(str)
    _ended = Signal()

    def __init__(self, make: Callable[[], Generator[Any]], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._make = make
        self._cancelled = threading.Event()
        self._yielded.connect(self._deliver)
        self._raised.connect(self._complain)
        self._ended.connect(self.finished)

    @property
    def cancelled(self) -> bool:
        """Whether the job was cancelled."""
        return self._cancelled.is_set()

    def cancel(self) -> None:
        """Let the generator go no further than its next ``yield``, where it is closed."""
        self._cancelled.set()

    def run(self) -> None:
        """Run the generator to its end. Called in the worker's thread."""
        try:
            if not self.cancelled:
                self._drain()
        except CancelledError:
            pass  # what works for it has been closed: so is the window
        except IconstudioError as error:
            self._raised.emit(str(error))
        except Exception as error:
            if not self.cancelled:
                log.exception("a job failed")
            self._raised.emit(
                f"The work stopped unexpectedly ({type(error).__name__}: {error}). "
                "Nothing is lost; you can try again."
            )
        finally:
            self._ended.emit()

    def _drain(self) -> None:
        with closing(self._make()) as events:
            for event in events:
                if self.cancelled:
                    return
                self._yielded.emit(event)

    def _deliver(self, event: object) -> None:
        if not self.cancelled:
            self.event.emit(event)

    def _complain(self, message: str) -> None:
        if not self.cancelled:
            self.failed.emit(message)


def once(work: Callable[[], Any]) -> Generator[Any]:
    """Do something, as a job whose only event is what it returns."""
    yield work()


class _Thread(QThread):
    def __init__(self, jobs: "queue.SimpleQueue[Job | None]", parent: QObject) -> None:
        super().__init__(parent)
        self._jobs = jobs

    def run(self) -> None:
        while (job := self._jobs.get()) is not None:
            job.run()


class Worker(QObject):
    """Runs jobs in the order in which they come, in one thread that lives until ``close``."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._queue: queue.SimpleQueue[Job | None] = queue.SimpleQueue()
        self._jobs: list[Job] = []
        self._thread = _Thread(self._queue, self)
        self._thread.start()

    def submit(self, make: Callable[[], Generator[Any]]) -> Job:
        """Return a job that runs the generator ``make()`` once the jobs before it have ended.

        Its signals arrive only after control is back in the event loop, so connect them at once.
        """
        job = Job(make, self)
        self._jobs.append(job)
        job.finished.connect(self._forget)
        self._queue.put(job)
        return job

    def close(self, interrupt: Callable[[], None] | None = None, patience: int = 1500) -> None:
        """Cancel all jobs and wait until the thread has ended.

        A generator that has not come to a ``yield`` after ``patience`` milliseconds is
        helped along by ``interrupt``, which should end whatever it waits for.
        """
        for job in self._jobs:
            job.cancel()
        self._queue.put(None)
        if not self._thread.wait(patience) and interrupt is not None:
            interrupt()
        self._thread.wait()

    @property
    def alive(self) -> bool:
        """Whether the thread still runs."""
        return self._thread.isRunning()

    def _forget(self) -> None:
        job = self.sender()
        if job in self._jobs:
            self._jobs.remove(job)
            job.deleteLater()
