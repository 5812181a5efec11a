"""How much memory a program and all processes that it starts take together."""

import threading
from collections.abc import Iterator
from pathlib import Path
from types import TracebackType

INTERVAL = 0.05
"""Seconds between two looks."""


class Peak:
    """Looks, in a ``with`` block, at a process with all its descendants again and again.

    Memory that several of them share counts once (the kernel's *proportional set size*).
    """

    def __init__(self, pid: int) -> None:
        self.mebibytes = 0.0
        self._pid = pid
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._look, daemon=True)

    def __enter__(self) -> "Peak":
        self._thread.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._over.set()
        self._thread.join()

    def _look(self) -> None:
        while not self._over.wait(INTERVAL):
            self.mebibytes = max(self.mebibytes, sum(map(_share, family(self._pid))) / 2**10)


def family(pid: int) -> Iterator[int]:
    """Yield a process and all its descendants."""
    yield pid
    for children in Path(f"/proc/{pid}/task").glob("*/children"):
        try:
            found = children.read_text().split()
        except OSError:  # it has ended
            continue
        for child in found:
            yield from family(int(child))


def _share(pid: int) -> int:
    """Return a process's part of the memory that it uses, in KiB; 0 once it has ended."""
    try:
        lines = Path(f"/proc/{pid}/smaps_rollup").read_text().splitlines()
    except OSError:
        return 0
    return next((int(line.split()[1]) for line in lines if line.startswith("Pss:")), 0)
