"""Limits of time and memory for what runs in this process, where the system has them (POSIX).

They are for work that may hang or swell inside a library: that a file from outside can cause.
"""

import os
import signal
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from time import monotonic


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
    """End this process by ``SIGALRM`` if the block takes more than so many seconds.

    An earlier limit of a block around it holds on. In the main thread only.
    """
    if seconds is None or not hasattr(signal, "setitimer"):  # Windows
        yield
        return
    began = monotonic()
    around, _ = signal.setitimer(signal.ITIMER_REAL, seconds)
    if 0 < around < seconds:
        signal.setitimer(signal.ITIMER_REAL, around)
    try:
        yield
    finally:
        rest = max(around - (monotonic() - began), 0.001) if around else 0.0
        signal.setitimer(signal.ITIMER_REAL, rest)


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
