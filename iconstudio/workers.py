"""Worker processes that can be stopped or killed, and whose work outlives them.

A renderer may crash or hang on a hostile SVG, and a cut keeps a core busy for
seconds; neither may stop the window. So both run in worker processes, and
whoever waits for them holds a future. What is no longer wanted is stopped by
its ticket, and the process lives on: to start another takes half a second. The
work of a process that dies is given to another one, once.

Each process has a pipe of its own: one that is killed in the middle of a message, or while it holds
a lock, can do no harm to the next.
"""

import atexit
import itertools
import multiprocessing
import os
import pickle
import signal
import threading
import warnings
from collections import deque
from collections.abc import Callable
from concurrent.futures import BrokenExecutor, CancelledError, Future, InvalidStateError
from contextlib import suppress
from time import monotonic
from typing import Any, TypeVar

from iconstudio.limits import OVER_TIME, PATIENCE
from iconstudio.model import IconstudioError
from iconstudio.safepath import protect_children
from iconstudio.tasks import BEGUN, SLOTS, work

T = TypeVar("T")

_GRACE = 10.0
"""Seconds after which a task that was stopped, but works on, is killed if it is in the way."""
_TRIES = 2
"""How many processes a task may lose while it runs."""
_STARTS = 6
"""How many processes may be lost in all before a task is given up: some before they began it."""
_KILL = getattr(signal, "SIGKILL", 0)


class ProcessDied(BrokenExecutor):
    """The process that ran a task died, and so did the one that tried again."""

    def __init__(self, exitcode: int | None) -> None:
        super().__init__(f"the worker process ended with exit code {exitcode}")
        self.exitcode = exitcode


class Ticket:
    """What the tasks of one run have in common: that they can be stopped together."""

    def __init__(self, number: int, stops: Any) -> None:
        self.number = number
        self._stops = stops
        self._stopped: float | None = None

    def stop(self) -> None:
        """Tell the tasks to stop: those that ask ``stopped``, and those that have not begun."""
        self._stops[self.number % SLOTS] = self.number
        self._stopped = monotonic()

    @property
    def overdue(self) -> bool:
        """Whether the tasks should have stopped long ago."""
        return self._stopped is not None and monotonic() - self._stopped > _GRACE


class Workers:
    """Processes that each run one task after another.

    Functions and arguments must be picklable (module-level functions). Processes start on first use
    and end with ``close``, or at the end of the ``with`` block; at the latest they end with the
    program, even when that is killed. All methods may be called from any thread.
    """

    def __init__(self, count: int | None = None) -> None:
        self.count = count or max(1, os.cpu_count() or 1)
        # Plain memory without a lock: one side writes, whole words.
        self._stops = multiprocessing.get_context("spawn").RawArray("q", [-1] * SLOTS)
        self._tickets = itertools.count()
        self._lanes = [_WorkerQueue(self._stops) for _ in range(self.count)]
        protect_children()
        atexit.register(self.close)

    def ticket(self) -> Ticket:
        """Return a new ticket, for the tasks of one run."""
        return Ticket(next(self._tickets), self._stops)

    def submit(
        self,
        function: Callable[..., T],
        *args: object,
        timeout: float | None = None,
        memory: int | None = None,
        lane: int | None = None,
        ticket: Ticket | None = None,
    ) -> "Future[T]":
        """Run ``function(*args)`` in a worker; if its process dies, once more in another.

        ``future.cancel()`` kills it, also while it runs. The future raises ``CancelledError`` once
        it is cancelled or the pool closed, and ``ProcessDied`` if the second process died, too;
        ``answer`` turns this and what a limit ends into sentences.

        Parameters
        ----------
        timeout
            Seconds of a processor after which it is killed, and the future raises ``TimeoutError``;
            see ``limits.time_limit``.
        memory
            Bytes that it may take; then it raises ``MemoryError``, or its process dies.
        lane
            Number of the process, for tasks that build on what an earlier one left there; by
            default the one that has least to do.
        ticket
            By which the task can be stopped: ``stopped`` tells it so. If it has not begun, the
            future raises ``CancelledError``.

        Raises
        ------
        CancelledError
            If the pool has been closed.
        """
        number = self.idlest() if lane is None else lane
        task = _Task((function, args, timeout, memory, ticket and ticket.number), timeout, ticket)
        self._lanes[number].add(task)
        return task

    def everywhere(self, function: Callable[..., object], *args: object) -> None:
        """Have every process run ``function(*args)`` before what comes later; nobody waits for it.

        What it loads and compiles there counts for no time limit of other tasks.
        """
        for lane in range(self.count):
            self.submit(function, *args, lane=lane)

    def idlest(self) -> int:
        """Return the number of the process that has least to do."""
        return min(range(self.count), key=self.load)

    def load(self, lane: int) -> int:
        """Return how many tasks a process has to do."""
        return self._lanes[lane].load

    def close(self) -> None:
        """Cancel all futures, kill the processes and wait until they have ended; for good."""
        atexit.unregister(self.close)
        for lane in self._lanes:
            lane.close()

    def __enter__(self) -> "Workers":
        return self

    def __exit__(self, *exc: object) -> None:
        self.close()


class _Task(Future[Any]):
    """What a worker has to do. It stays "pending" until it is done, so it can be cancelled."""

    def __init__(self, work: tuple[Any, ...], timeout: float | None, ticket: Ticket | None) -> None:
        super().__init__()
        self.work = work
        self.timeout = timeout
        self.ticket = ticket

    def cancel(self) -> bool:
        """Cancel it, also while it runs."""
        if not self.cancelled() and super().cancel():
            with suppress(RuntimeError, InvalidStateError):
                self.set_running_or_notify_cancel()  # wakes whoever waits for it
        return self.cancelled()

    def settle(self, value: Any, error: BaseException | None) -> None:
        """Set its result or its error, unless it was cancelled meanwhile."""
        with suppress(InvalidStateError):
            if error is None:
                self.set_result(value)
            else:
                self.set_exception(error)


class _WorkerQueue:
    """A thread that gives one process after another what there is to do, task by task."""

    def __init__(self, stops: Any) -> None:
        self._stops = stops
        self._closed = False
        self._changed = threading.Condition()
        self._waiting: deque[_Task] = deque()
        self._unsettled: dict[_Task, None] = {}
        self._current: _Task | None = None
        self._process: Any = None
        self._connection: Any = None
        self._thread: threading.Thread | None = None

    @property
    def load(self) -> int:
        """How many tasks run or wait."""
        return len(self._unsettled)

    def add(self, task: _Task) -> None:
        """Add a task; what is overdue is cancelled."""
        for other in tuple(self._unsettled):
            if other.ticket is not None and other.ticket.overdue:
                other.cancel()
        with self._changed:
            if self._closed:
                raise CancelledError("The worker processes have been closed.")
            self._unsettled[task] = None
            self._waiting.append(task)
            self._changed.notify()
            if self._thread is None:
                self._thread = threading.Thread(target=self._serve, daemon=True)
                self._thread.start()
        task.add_done_callback(self._settled)

    def close(self) -> None:
        """See ``Workers.close``."""
        with self._changed:
            self._closed = True
            self._changed.notify()
            thread, unsettled = self._thread, tuple(self._unsettled)
        for task in unsettled:
            task.cancel()
        if thread is not None:
            thread.join()

    def _settled(self, task: Future[Any]) -> None:
        with self._changed:
            self._unsettled.pop(task, None)  # type: ignore[call-overload]  # it is one of them
            if task is self._current and task.cancelled() and self._process is not None:
                self._process.kill()

    def _serve(self) -> None:
        while (task := self._next()) is not None:
            value, error = self._outcome(task)
            with self._changed:
                self._current = None
            task.settle(value, error)
            del task, value, error  # Nothing is held while there is nothing to do.
        self._end_process()

    def _next(self) -> _Task | None:
        with self._changed:
            while True:
                self._changed.wait_for(lambda: self._closed or self._waiting)
                if self._closed:
                    return None
                task = self._waiting.popleft()
                if not task.done():
                    self._current = task
                    return task

    def _outcome(self, task: _Task) -> tuple[Any, BaseException | None]:
        """Return what a task comes to: its value or its error."""
        try:
            message = pickle.dumps(task.work, pickle.HIGHEST_PROTOCOL)
        except Exception as error:
            return None, error
        lost, exitcode = 0, None
        for _ in range(_STARTS):
            begun = False
            try:
                self._need_process()
                if task.done():
                    break
                self._connection.send_bytes(message)
                begun = self._connection.recv_bytes() == BEGUN
                if not self._connection.poll(task.timeout and PATIENCE * task.timeout):
                    self._end_process()
                    return None, TimeoutError(f"far more than {task.timeout:g} seconds")
                outcome: tuple[Any, BaseException | None]
                outcome = pickle.loads(self._connection.recv_bytes())
                return outcome
            except (EOFError, OSError):  # it died
                exitcode = self._end_process()
                lost += begun
                if task.done():
                    break
                if exitcode in OVER_TIME:
                    return None, TimeoutError("a limit of its own")
                if lost == _TRIES:
                    break
            except Exception as error:  # what it sent cannot be unpickled
                return None, error
        return None, CancelledError() if task.done() else ProcessDied(exitcode)

    def _need_process(self) -> None:
        if self._process is not None and self._process.is_alive():
            return
        self._end_process()
        # spawn: forking a process that runs Qt and threads is not safe.
        context = multiprocessing.get_context("spawn")
        ours, theirs = context.Pipe()
        _block_interrupts()
        process = context.Process(target=work, args=(theirs, self._stops), daemon=True)
        try:
            process.start()
        except BaseException:
            ours.close()
            raise
        finally:
            theirs.close()
        with self._changed:
            self._process, self._connection = process, ours

    def _end_process(self) -> int | None:
        """Kill the process, if it lives, and return its exit code."""
        with self._changed:
            process, connection = self._process, self._connection
            self._process = self._connection = None
        if process is None:
            return None
        process.kill()
        process.join()
        connection.close()
        exitcode: int | None = process.exitcode
        return exitcode


def answer(future: "Future[T]", doing: str = "The work", advice: str = "") -> T:
    """Return what a worker process answers.

    Raises
    ------
    IconstudioError
        If a limit was reached, its processes died, or it was stopped; a sentence that begins with
        what it was ``doing``, and of a limit ends with the ``advice``.
    """
    try:
        return future.result()
    except CancelledError:
        raise IconstudioError(f"{doing} was stopped.") from None
    except Exception as error:
        reason = loss(error, doing)
        if reason is None:
            raise
        raise IconstudioError(f"{reason} {advice}".rstrip()) from error


def loss(error: BaseException | None, doing: str) -> str | None:
    """Return why a future's task was lost, in a sentence; None if it is an error of its own."""
    if isinstance(error, TimeoutError):
        return f"{doing} takes too long."
    if isinstance(error, MemoryError):
        return f"{doing} takes too much memory."
    if isinstance(error, ProcessDied):
        if error.exitcode == -_KILL:
            return (
                f"{doing} was ended twice by the system, perhaps for lack of memory. "
                "Close other programs and try again."
            )
        return f"{doing} crashes the process that does it, or takes too much memory."
    return None


def _block_interrupts() -> None:
    """Block Ctrl-C in this thread, and so for good in the processes that it starts.

    Otherwise a worker interrupted while it starts would print a traceback.
    """
    if hasattr(signal, "pthread_sigmask"):
        from multiprocessing import resource_tracker

        # Python's helper may have been killed; nothing of ours is in its care.
        warnings.filterwarnings("ignore", "resource_tracker: process died unexpectedly")
        resource_tracker.ensure_running()  # its start would end the blocking
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
