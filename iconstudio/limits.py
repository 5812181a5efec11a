"""Limits of time and memory for what runs in this process, where the system has them (POSIX).

They are for work that may hang or swell inside a library: that a file from outside can cause.
"""

import os
import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from time import monotonic, process_time

PATIENCE = 10.0
"""How many times its limit of processor time something may take by the clock."""
OVER_TIME = frozenset(
    -number for name in ("SIGPROF", "SIGALRM") if (number := getattr(signal, name, 0))
)
"""Exit codes of processes that a limit of time has ended."""


@contextmanager
def limited(seconds: float | None, memory: int | None) -> Iterator[None]:
    """Limit both; where memory is limited, what a library says of its end is not shown."""
    with time_limit(seconds), memory_limit(memory), silence(memory is not None):
        yield


@contextmanager
def silence(wanted: bool = True) -> Iterator[None]:
    """Let nothing that the block, or a library in it, writes to standard error be seen."""
    try:
        shown = os.dup(2) if wanted else None
    except OSError:  # there is none
        shown = None
    if shown is None:
        yield
        return
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 2)
    os.close(nowhere)
    try:
        yield
    finally:
        os.dup2(shown, 2)
        os.close(shown)


@contextmanager
def time_limit(seconds: float | None) -> Iterator[None]:
    """End this process by a signal if the block takes more than so many seconds of a processor.

    So a machine that has much else to do ends nothing; ``PATIENCE`` times as long by the clock ends
    what waits for ever. Earlier limits of a block around it hold on.
    """
    if seconds is None:
        yield
        return
    by_clock = PATIENCE * seconds
    with _timer("ITIMER_PROF", seconds, process_time), _timer("ITIMER_REAL", by_clock, monotonic):
        yield


@contextmanager
def _timer(name: str, seconds: float, clock: Callable[[], float]) -> Iterator[None]:
    """Have the system send its signal if the block takes longer, where it has such timers."""
    if not hasattr(signal, "setitimer"):  # Windows
        yield
        return
    timer: int = getattr(signal, name)
    began = clock()
    around, _ = signal.setitimer(timer, seconds)
    if 0 < around < seconds:
        signal.setitimer(timer, around)
    try:
        yield
    finally:
        rest = max(around - (clock() - began), 0.001) if around else 0.0
        signal.setitimer(timer, rest)


@contextmanager
def memory_limit(size: int | None) -> Iterator[None]:
    """Let the block take ``size`` bytes of address space more than this process has now.

    What needs more raises ``MemoryError`` in Python, and ends the process in a library.
    """
    try:
        import resource
    except ImportError:  # Windows
        size = None
    if size is None:
        yield
        return
    before = soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    limit = _address_space() + size
    if soft != resource.RLIM_INFINITY:
        limit = min(limit, soft)
    with suppress(ValueError, OSError):  # some versions of macOS
        resource.setrlimit(resource.RLIMIT_AS, (limit, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_AS, before)


def _address_space() -> int:
    """Return how many bytes of address space this process has; 0 if that cannot be told."""
    try:
        pages = Path("/proc/self/statm").read_text().split()[0]
    except OSError:
        return 0
    return int(pages) * os.sysconf("SC_PAGE_SIZE")
