"""What a worker process does: one task after another, which may build on what it remembers.

The other end of the pipe is ``workers``.
"""

import multiprocessing
import os
import pickle
import signal
import threading
import traceback
from collections.abc import Callable
from concurrent.futures import CancelledError
from contextlib import suppress
from typing import Any, TypeVar

from iconstudio.limits import limited

T = TypeVar("T")

REMEMBERED = 2
"""How many things a process remembers."""
SLOTS = 1024
"""How many tickets there can be at once."""
BEGUN = b"begun"
"""What a process answers when it has understood a task."""
_NICENESS = 5
"""By how much workers give way to the window."""
_memory: dict[object, Any] = {}
_stops: Any = None
"""For each slot, the last ticket that was stopped."""
_ticket: int | None = None
"""The ticket of the task that runs."""


def remembered(key: object, make: Callable[[], T]) -> T:
    """Return what a task has made under ``key`` in this process before, else ``make()``.

    A process remembers ``REMEMBERED`` things. Tasks that build on each other name their lane.
    """
    found: T | None = _memory.pop(key, None)
    value = make() if found is None else found
    _memory[key] = value
    while len(_memory) > REMEMBERED:
        del _memory[next(iter(_memory))]
    return value


def forget(key: object) -> None:
    """Let go of what ``remembered`` keeps under ``key``."""
    _memory.pop(key, None)


def stopped() -> bool:
    """Whether the task that runs in this process is no longer wanted."""
    return _ticket is not None and _stops[_ticket % SLOTS] >= _ticket


def work(connection: Any, stops: Any) -> None:
    """Do one task after another, in a worker process."""
    _initialise(stops)
    with suppress(EOFError, OSError):  # the program has ended
        while True:
            message = connection.recv_bytes()
            connection.send_bytes(_done(message, connection))


def _initialise(stops: Any) -> None:
    """Prepare a worker process."""
    global _stops
    _stops = stops
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


def _done(message: bytes, connection: Any) -> bytes:
    """Return what a task comes to, value and error, as a message."""
    try:
        function, args, timeout, memory, ticket = pickle.loads(message)
        connection.send_bytes(BEGUN)
        value = _run(function, args, timeout, memory, ticket)
        return pickle.dumps((value, None), pickle.HIGHEST_PROTOCOL)
    except BaseException as error:
        error.add_note(f"In a worker process:\n{traceback.format_exc()}")
        try:
            data = pickle.dumps((None, error), pickle.HIGHEST_PROTOCOL)
            pickle.loads(data)
        except Exception:
            data = pickle.dumps((None, RuntimeError(f"{type(error).__name__}: {error}")))
        return data


def _run(
    function: Callable[..., Any],
    args: tuple[Any, ...],
    timeout: float | None,
    memory: int | None,
    ticket: int | None,
) -> Any:
    """Run a task in a worker process, which ends if it takes more than there is."""
    global _ticket
    _ticket = ticket
    if stopped():
        raise CancelledError
    with limited(timeout, memory):
        return function(*args)
