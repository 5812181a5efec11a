"""How long the stages of a run take."""

from time import perf_counter

from iconstudio.workflows.events import Event, Progress, Result


class Stopwatch:
    """Books the time between two events on the stage that the later one belongs to.

    Cutting and drawing go on side by side in the worker processes: the time of both is split as
    the workers' own seconds are.
    """

    def __init__(self) -> None:
        self._began = self._last = perf_counter()
        self._stage = "search"
        self._seconds: dict[str, float] = {}
        self._worked = [0.0, 0.0]

    def note(self, event: Event) -> None:
        """Book the time since the last event."""
        if isinstance(event, Progress):
            self._stage = event.stage
        elif isinstance(event, Result):
            self._stage = "remix"
            self._worked[0] += event.remix_seconds
            self._worked[1] += event.vectorize_seconds
        now = perf_counter()
        self._seconds[self._stage] = self._seconds.get(self._stage, 0.0) + now - self._last
        self._last = now

    def timings(self) -> dict[str, float]:
        """Return the seconds of each stage so far, and in total."""
        seconds = dict(self._seconds)
        both = seconds.get("remix", 0.0)
        cutting, drawing = self._worked
        seconds["remix"] = both * cutting / (cutting + drawing or 1.0)
        seconds["vectorize"] = both - seconds["remix"]
        return seconds | {"total": perf_counter() - self._began}
