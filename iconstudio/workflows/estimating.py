"""How long a run will go on, told from what it has shown so far.

Of remixes, the worker processes say how long they worked on each. The first one of a row costs more
than those that follow it, as each search helps the others. So the work of the whole run is known
roughly once a few results are there, and how fast the processes get on with it; what is left takes
as long as work has taken up to now.

Of other results nothing is known: the rest of the stage that makes them takes as long for each part
of it as it has up to now.
"""

from collections import Counter, deque
from collections.abc import Callable, Generator
from contextlib import closing
from dataclasses import replace
from time import perf_counter

from iconstudio.model import Remix
from iconstudio.workflows.events import Event, Progress, Recommended, Result, StyleMatched

_GUESS = 0.15
"""At first, a later result of a row is taken to cost this part of the first one; that counts as one
result seen."""
_TRUST = 0.7
"""How far each look at the work moves the end towards what it alone would say."""
_OVERDUE = 0.05
"""A run that should be over is said to need this part of its time again: nobody knows better."""


def estimated(
    events: Generator[Event], processes: int, clock: Callable[[], float] = perf_counter
) -> Generator[Event]:
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
        self._stage = ""
        self._stage_began = 0.0
        self._finished = False
        """Whether a result is there that is no remix."""
        self._began: float | None = None
        """When the first results were begun."""
        self._ends: float | None = None
        self._done = 0.0
        self._rows: Counter[str] = Counter()
        """Finished results of each row; a row is worked on by one process."""
        self._first: list[float] = []
        self._later: list[float] = []
        """Seconds of work for the first results of rows, and for the others."""
        self._previewed = ""
        self._hurried: list[float] = []
        """The row with a preview has a result before its others are searched for; what that took
        tells nothing of them."""
        self._last: dict[str, float] = {}
        """When each row that is under way had its last result."""
        self._free: deque[float] = deque(maxlen=processes)
        """When the processes last had done with a row, and could begin another."""

    def note(self, event: Event, now: float) -> None:
        """Learn from an event."""
        if isinstance(event, Progress) and event.stage != self._stage:
            self._stage, self._stage_began = event.stage, now
        match event:
            case StyleMatched():
                self._begin(now)
                self._rows[event.style] += 0
            case Result(icon=Remix() as icon, preview=True):
                self._previewed = icon.composite.style
            case Result(icon=Remix() as icon):
                row = icon.composite.style
                nth = self._rows[row] - (row == self._previewed)
                kind = self._hurried if nth < 0 else self._later if nth else self._first
                kind.append(sum(event.worked.values()))
                self._rows[row] += 1
                self._last[row] = now
            case Result():
                self._finished = True
            case Progress() if self._finished and event.done > 0:
                self._began, self._done = self._stage_began, event.done
                self._ends = now + (now - self._began) * (1 - event.done) / event.done
            case Recommended():
                self._last.pop(event.style, None)
                self._free.append(now)
            case Progress(stage="remix"):
                self._begin(now)
                if event.done > self._done:
                    self._done = event.done
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
            self._free.extend([now] * self._processes)

    def _look(self, now: float) -> None:
        """Tell the end from the work that is done, under way, and left."""
        finished = sum(self._rows.values())
        if not self._first or self._began is None:
            return
        total = finished / self._done
        first = sum(self._first) / len(self._first)
        later = (sum(self._later) + _GUESS * first) / (len(self._later) + 1)
        unbegun = len(self._rows) - len(self._first)
        work = first * unbegun + later * max(0.0, total - finished - unbegun)
        # All processes have been busy, with what is finished and with what is under way.
        under_way = self._under_way(now)
        spent = self._processes * (now - self._began) - under_way
        speed = sum(map(sum, (self._first, self._later, self._hurried))) / max(spent, 1e-9)
        left = max(0.0, work / max(speed, 1e-9) - under_way) / self._processes
        ends = now + left
        self._ends = ends if self._ends is None else self._ends + _TRUST * (ends - self._ends)

    def _under_way(self, now: float) -> float:
        """Return the seconds that the processes have spent on what is not finished."""
        busy = sorted(self._last.values())[-self._processes :]
        begun = sum(1 for count in self._rows.values() if not count)
        exploring = min(begun, self._processes - len(busy))
        since = [*busy, *list(self._free)[self._processes - exploring :]]
        return sum(now - time for time in since)
