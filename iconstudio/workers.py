"""Worker processes that can be stopped or killed: the adapter of pebble.

A renderer may crash or hang on a hostile SVG, and a cut keeps a core busy for
seconds; neither may stop the window. So both run in worker processes, and
whoever waits for them holds a future. What is no longer wanted is stopped by
its ticket, and the process lives on: to start another takes half a second.
"""

import itertools
import math
import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import CancelledError, Future
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager, suppress
from time import monotonic
from typing import Any, TypeVar

T = TypeVar("T")

REMEMBERED = 2
"""How many things a process remembers."""
_memory: dict[object, Any] = {}
_NICENESS = 5
"""By how much workers give way to the window."""
_SLOTS = 1024
"""How many tickets there can be at once."""
_GRACE = 10.0
"""Seconds after which a task that was stopped, but works on, is killed if it is in the way."""
_stops: Any = None
"""In a worker process: for each slot, the last ticket that was stopped."""
_ticket: int | None = None
"""In a worker process: the ticket of the task that runs."""


class Ticket:
    """What the tasks of one run have in common: that they can be stopped together."""

    def __init__(self, number: int, stops: Any) -> None:
        self.number = number
        self._stops = stops
        self._stopped: float | None = None

    def stop(self) -> None:
        """Tell the tasks to stop: those that ask ``stopped``, and those that have not begun."""
        self._stops[self.number % _SLOTS] = self.number
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
        self._stops = multiprocessing.get_context("spawn").RawArray("q", [-1] * _SLOTS)
        self._tickets = itertools.count()
        self._lanes = [_Lane(self._stops) for _ in range(self.count)]

    def ticket(self) -> Ticket:
        """Return a new ticket, for the tasks of one run."""
        return Ticket(next(self._tickets), self._stops)

    def submit(
        self,
        function: Callable[..., Any],
        *args: Any,
        timeout: float | None = None,
        lane: int | None = None,
        ticket: Ticket | None = None,
    ) -> "Future[Any]":
        """Run ``function(*args)`` in a worker.

        ``future.cancel()`` kills it, also while it runs. The future raises ``TimeoutError`` after
        ``timeout`` seconds of running, ``CancelledError`` once it is cancelled or the pool closed,
        and an error of which ``died`` is true if the process died.

        Parameters
        ----------
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
        return self._lanes[number].submit(function, args, timeout, ticket)

    def idlest(self) -> int:
        """Return the number of the process that has least to do."""
        return min(range(self.count), key=self.load)

    def load(self, lane: int) -> int:
        """Return how many tasks a process has to do."""
        return self._lanes[lane].load

    def close(self) -> None:
        """Cancel all futures, kill the processes and wait until they have ended; for good."""
        for lane in self._lanes:
            lane.close()

    def __enter__(self) -> "Workers":
        return self

    def __exit__(self, *exc: object) -> None:
        self.close()


class _Lane:
    """One process, and what it has to do."""

    def __init__(self, stops: Any) -> None:
        self._stops = stops
        self._pool: Any = None
        self._closed = False
        self._lock = threading.Lock()
        self._unsettled: dict[Future[Any], Ticket | None] = {}

    @property
    def load(self) -> int:
        """How many tasks run or wait."""
        return len(self._unsettled)

    def submit(
        self,
        function: Callable[..., Any],
        args: tuple[Any, ...],
        timeout: float | None,
        ticket: Ticket | None,
    ) -> "Future[Any]":
        """See ``Workers.submit``."""
        for future, other in tuple(self._unsettled.items()):
            if other is not None and other.overdue:
                future.cancel()
        number = None if ticket is None else ticket.number
        with self._lock:
            if self._closed:
                raise CancelledError("The worker processes have been closed.")
            if self._pool is not None and not self._pool.active:  # for lack of memory, perhaps
                self._stop()
            if self._pool is None:
                self._pool = _start(self._stops)
            task = function, args, timeout, number
            future = self._pool.schedule(_run, args=task, timeout=timeout)
            self._unsettled[future] = ticket
        future.add_done_callback(self._settle)
        return future

    def close(self) -> None:
        """See ``Workers.close``."""
        with self._lock:
            self._closed = True
            self._stop()

    def _stop(self) -> None:
        pool, self._pool = self._pool, None
        if pool is not None:
            pool.stop()
            self._cancel_all()
            pool.join()

    def _settle(self, future: "Future[Any]") -> None:
        self._unsettled.pop(future, None)
        if future.cancelled():
            # Wake whoever waits for it; pebble does so later, or never once it is stopped.
            with suppress(RuntimeError):
                future.set_running_or_notify_cancel()
        elif isinstance(future.exception(), BrokenProcessPool):
            self._cancel_all()  # pebble forgets those that it has not sent yet

    def _cancel_all(self) -> None:
        for future in tuple(self._unsettled):
            future.cancel()


def remembered(key: object, make: Callable[[], T]) -> T:
    """Return what a task has made under ``key`` in this process before, else ``make()``.

    A process remembers ``REMEMBERED`` things. Tasks that build on each other name their lane.
    """
    found = _memory.pop(key, None)
    _memory[key] = make() if found is None else found
    while len(_memory) > REMEMBERED:
        del _memory[next(iter(_memory))]
    return _memory[key]


def forget(key: object) -> None:
    """Let go of what ``remembered`` keeps under ``key``."""
    _memory.pop(key, None)


def stopped() -> bool:
    """Whether the task that runs in this process is no longer wanted."""
    return _ticket is not None and _stops[_ticket % _SLOTS] >= _ticket


def died(error: BaseException) -> bool:
    """Whether a future's error says that the worker process died, as of a crash."""
    from pebble import ProcessExpired

    return isinstance(error, ProcessExpired)


@contextmanager
def memory_limit(size: int) -> Iterator[None]:
    """Let this process have ``size`` bytes of address space at most, where the system can.

    What needs more raises ``MemoryError`` in Python, and ends the process in a library.
    """
    try:
        import resource
    except ImportError:  # Windows
        yield
        return
    before = soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    if soft != resource.RLIM_INFINITY:
        size = min(size, soft)
    with suppress(ValueError, OSError):  # some versions of macOS
        resource.setrlimit(resource.RLIMIT_AS, (size, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_AS, before)


def _start(stops: Any) -> Any:
    from pebble import ProcessPool

    # spawn: forking a process that runs Qt and threads is not safe.
    context = multiprocessing.get_context("spawn")
    with _interrupts_blocked():
        pool = ProcessPool(
            max_workers=1, initializer=_initialise, initargs=[stops], context=context
        )
        _ = pool.active  # starts it
    return pool


@contextmanager
def _interrupts_blocked() -> Iterator[None]:
    """Block Ctrl-C in this thread, and so for good in the threads and processes that it starts.

    Otherwise a worker interrupted while it starts would print a traceback.
    """
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    from multiprocessing import resource_tracker

    resource_tracker.ensure_running()  # its start would end the blocking
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _initialise(stops: Any) -> None:
    """Prepare a worker process."""
    global _stops
    _stops = stops
    # pebble's handler runs only between two steps of Python, so not in a cut or a hung renderer.
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        os.environ.setdefault(name, "1")
    if hasattr(os, "nice"):
        os.nice(_NICENESS)
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def _run(
    function: Callable[..., Any],
    args: tuple[Any, ...],
    timeout: float | None,
    ticket: int | None,
) -> Any:
    """Run a task in a worker process, which outlives its time by two seconds at most.

    This is for a task that hangs in a library when nobody is left to kill it.
    """
    global _ticket
    _ticket = ticket
    if stopped():
        raise CancelledError
    if timeout is None or not hasattr(signal, "alarm"):
        return function(*args)
    signal.alarm(math.ceil(timeout) + 1)
    try:
        return function(*args)
    finally:
        signal.alarm(0)
