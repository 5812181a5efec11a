"""How long the stages of a command take, and how much memory."""

import os
import sys
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from time import perf_counter

import click

from iconstudio.workflows.events import Event, Progress, Result

_LOADED = perf_counter()
_NAMES = {
    "search": "searching",
    "prepare": "preparing icons",
    "match": "matching",
    "remix": "cutting",
    "vectorize": "drawing",
}
"""What the stages of remixing are called; others are called as they call themselves."""


class Stopwatch:
    """Books the time between two events on the stage that the later one belongs to.

    What goes on side by side in the worker processes, such as cutting and drawing, shares its time
    as the workers' own seconds are.
    """

    def __init__(self) -> None:
        self._began = self._last = perf_counter()
        self._stage = "search"
        self._seconds: dict[str, float] = {}
        self.worked: dict[str, float] = {}
        """The worker processes' own seconds, by stage."""
        self.first: float | None = None
        """Seconds from the start of the program to the first result."""

    def note(self, event: Event) -> None:
        """Book the time since the last event."""
        if isinstance(event, Progress):
            self._stage = event.stage
        elif isinstance(event, Result):
            self._stage = next(iter(event.worked), self._stage)
            for stage, seconds in event.worked.items():
                self.worked[stage] = self.worked.get(stage, 0.0) + seconds
            self.first = since_start() if self.first is None else self.first
        self._book(self._stage)

    def wrote(self) -> None:
        """Book the time since the last event on the writing of files."""
        self._book("write")

    def timings(self) -> dict[str, float]:
        """Return the seconds of each stage so far, and in total."""
        seconds = dict(self._seconds)
        if worked := sum(self.worked.values()):
            both = sum(seconds.pop(stage, 0.0) for stage in self.worked)
            seconds |= {stage: both * own / worked for stage, own in self.worked.items()}
        return seconds | {"total": perf_counter() - self._began}

    def _book(self, stage: str) -> None:
        now = perf_counter()
        self._seconds[stage] = self._seconds.get(stage, 0.0) + now - self._last
        self._last = now


@contextmanager
def profiled(wanted: bool) -> Iterator[Stopwatch]:
    """Give a stopwatch; at the end, if ``wanted``, say on standard error what it has booked.

    The worker processes should have ended by then: memory is known of those that have.
    """
    stopwatch = Stopwatch()
    yield stopwatch
    if wanted:
        click.echo("\n".join(_table(stopwatch)), err=True)


def profile_option(function: "click.decorators.FC") -> "click.decorators.FC":
    """Give a command the option ``--profile``."""
    return click.option(
        "--profile", is_flag=True, help="Say at the end where time and memory went."
    )(function)


def since_start() -> float:
    """Return the seconds since this program was started; without Linux, since this was imported."""
    try:
        fields = Path("/proc/self/stat").read_text().rpartition(")")[2].split()
        started = int(fields[19]) / os.sysconf("SC_CLK_TCK")
        return time.clock_gettime(time.CLOCK_BOOTTIME) - started
    except (OSError, AttributeError, ValueError):
        return perf_counter() - _LOADED


def _table(stopwatch: Stopwatch) -> Iterator[str]:
    seconds: Mapping[str, float] = stopwatch.timings()
    yield f"{'':<17}{'seconds':>8}{'of the worker processes':>26}"
    last = "write", "total"
    others = {stage: stage for stage in seconds if stage not in (*_NAMES, *last)}
    for stage, name in (_NAMES | others | {"write": "writing files"}).items():
        if stage in seconds:
            worked = stopwatch.worked.get(stage)
            own = "" if worked is None else f"{worked:26.2f}"
            yield f"{name:<17}{seconds[stage]:8.2f}{own}"
    yield f"{'all together':<17}{since_start():8.2f}  since the program was started"
    if stopwatch.first is not None:
        yield f"{'first result':<17}{stopwatch.first:8.2f}  after the start"
    for size, whose in _memory():
        yield f"{'memory':<17}{size:8.0f}  MiB at the peak of {whose}"


def _memory() -> Iterator[tuple[float, str]]:
    """Yield the most memory that was resident, in MiB, and whose it was."""
    try:
        import resource
    except ImportError:  # Windows
        return
    unit = 2**20 if sys.platform == "darwin" else 2**10
    for who, whose in (
        (resource.RUSAGE_SELF, "this process"),
        (resource.RUSAGE_CHILDREN, "the largest worker process"),
    ):
        if peak := resource.getrusage(who).ru_maxrss:
            yield peak / unit, whose
