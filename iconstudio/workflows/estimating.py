"""How long a run will go on, told from what it has shown so far.

The worker processes say how long they worked on each result. The first one of a row costs more than
those that follow it, as each search helps the others. So the work of the whole run is known roughly
once a few results are there, and how fast the processes get on with it; what is left takes as long
as work has taken up to now.
"""

from collections import Counter, deque
from collections.abc import Callable, Iterator
from contextlib import closing
from dataclasses import replace
from time import perf_counter

from iconstudio.workflows.events import Event, Progress, Result, StyleMatched

_LATER = 0.25
_GUESSES = 2
"""At first, a later result of a row is taken to cost this part of the first one; that counts as so
many results seen."""
_TRUST = 0.5
"""How far each look at the work moves the end towards what it alone would say."""
_OVERDUE = 0.05
"""A run that should be over is said to need this part of its time again: nobody knows better."""


def estimated(
    events: Iterator[Event], processes: int, clock: Callable[[], float] = perf_counter
) -> Iterator[Event]:
    """Pass on the events of a run, with ``remaining`` in its progress.

    It stays None until the first result is finished: nobody could tell. Closing the iterator closes
    ``events``.

    Parameters
    ----------
    processes
        How many results are worked on at a time.
    clock
        Seconds since any moment.
    """
    estimate = Estimate(processes)
    with closing(events):
        for event in events:
            now = clock()
            estimate.note(event, now)
            if isinstance(event, Progress):
                event = replace(event, remaining=estimate.remaining(now))
            yield event


def spoken(seconds: float) -> str:
    """Return a time that remains in words, as roughly as it is known."""
    if seconds < 9.5:
        return f"about {max(1, round(seconds))} s left"
    if seconds < 57.5:
        return f"about {5 * round(seconds / 5)} s left"
    return f"about {max(1, round(seconds / 60))} min left"


class Estimate:
    """What is known of a run's length; times are seconds of one clock. See ``estimated``."""

    def __init__(self, processes: int) -> None:
        self._processes = processes
        self._began: float | None = None
        """When the first results were begun."""
        self._ends: float | None = None
        self._done = 0.0
        self._rows: Counter[str] = Counter()
        """Finished results of each row that was begun."""
        self._first: list[float] = []
        self._later: list[float] = []
        """Seconds of work for the first results of rows, and for the others."""
        self._ended: deque[float] = deque(maxlen=processes)
        """When each process last ended a result, as far as that can be told."""

    def note(self, event: Event, now: float) -> None:
        """Learn from an event."""
        match event:
            case StyleMatched():
                self._begin(now)
                self._rows[event.style] += 0
            case Result(preview=False):
                row = event.composite.style
                kind = self._later if self._rows[row] else self._first
                kind.append(event.remix_seconds + event.vectorize_seconds)
                self._rows[row] += 1
            case Progress(stage="remix"):
                self._begin(now)
                if event.done > self._done:
                    self._done = event.done
                    self._ended.append(now)
                    self._look(now)

    def remaining(self, now: float) -> float | None:
        """Return the seconds until the run ends, or None if that cannot be told yet."""
        if self._ends is None or self._began is None:
            return None
        if self._done >= 1:
            return 0.0
        return max(self._ends - now, _OVERDUE * (now - self._began))

    def _begin(self, now: float) -> None:
        if self._began is None:
            self._began = now

    def _look(self, now: float) -> None:
        """Tell the end from the work that is done, under way, and left."""
        finished = sum(self._rows.values())
        if not finished or self._began is None:
            return
        first = sum(self._first) / len(self._first)
        guessed = _GUESSES * _LATER * first
        later = (sum(self._later) + guessed) / (len(self._later) + _GUESSES)
        rows = len(self._rows) - len(self._first)
        work = first * rows + later * max(0.0, finished / self._done - finished - rows)
        done = sum(self._first) + sum(self._later)
        speed = done / max(sum(self._ended) - self._began * len(self._ended), 1e-9)
        idle = self._processes - len(self._ended)
        since = now * self._processes - sum(self._ended) - self._began * idle
        left = max(0.0, work - speed * since) / max(speed * self._processes, 1e-9)
        ends = now + left
        self._ends = ends if self._ends is None else self._ends + _TRUST * (ends - self._ends)
