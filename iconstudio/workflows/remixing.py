"""Remixing placed sources, several series at once: what all workflows share (section 3.4)."""

import itertools
from collections import deque
from collections.abc import Callable, Generator, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import dataclass
from typing import Protocol, TypeVar

from iconstudio.algorithms.iconification.matching import Matcher
from iconstudio.algorithms.iconification.plausibility import Plausibility
from iconstudio.model import CANVAS, Composite, Remix
from iconstudio.workers import Workers, answer
from iconstudio.workflows.drawing import Render
from iconstudio.workflows.events import Event, Progress, Result
from iconstudio.workflows.solving import CutSeries, Solved, Step, solve
from iconstudio.workflows.workflow import Resources

FINE = 2 * CANVAS
"""The side of fine results: seams run between half pixels of the canvas."""
PIPELINED = 2
"""How many steps are sent to a process ahead, so that it need not wait for the next."""
PROMPT = 0.03
"""Seconds after which whoever waits for results looks whether they are still wanted."""

Finish = Callable[[Remix], Remix]
Row = TypeVar("Row")
T = TypeVar("T")


@dataclass(frozen=True, slots=True, kw_only=True)
class CutSettings:
    """How results are cut, whatever of."""

    side: int = CANVAS
    """m, the sites in a row of the graph cut: the paper's, or ``FINE``."""


class RemixResources(Resources, Protocol):
    """What a run that remixes works with: a ``Session``, too."""

    earlier: dict[str, Composite]
    """The result in focus of the run before, by what it is of: a preview may begin with it."""

    @property
    def render(self) -> Render:
        """Draws a source at its placement; can be pickled."""
        ...

    @property
    def plausibility(self) -> Plausibility | None:
        """What tells plausible results from others, if it is at hand."""
        ...

    def prepare(
        self, keyword: str, exclude: frozenset[str] = ..., scales: tuple[float, ...] = ...
    ) -> Generator[Event, None, Matcher]:
        """Retrieve a keyword's icons, and make them ready for matching."""
        ...


class Remixing:
    """Solves several series in worker processes; results come out as they are ready.

    All steps of a series are made by one process, which takes up the next one when it has nothing
    left to do: what was started first comes first.

    Parameters
    ----------
    total
        How many finished results are expected in all, for the progress.
    plausibility
        What judges results, if anything does.
    """

    def __init__(
        self,
        workers: Workers,
        render: Render,
        total: int,
        plausibility: Plausibility | None = None,
    ) -> None:
        self._workers = workers
        self._render = render
        self._total = total
        self._plausibility = plausibility
        self._done = 0
        self._ticket = workers.ticket()
        self._waiting: deque[tuple[CutSeries, Finish]] = deque()
        self._lanes: list[deque[_Task]] = [deque() for _ in range(workers.count)]
        self._running: dict[Future[Solved], _Task] = {}

    @property
    def busy(self) -> bool:
        """Whether results are still to come."""
        return bool(self._running)

    @property
    def hungry(self) -> bool:
        """Whether another series would keep the processes from running dry."""
        return not self._waiting

    def start(self, series: CutSeries, finish: Finish = lambda icon: icon) -> None:
        """Begin a series as soon as a process is free.

        ``finish`` is what the workflow adds to each result.
        """
        self._waiting.append((series, finish))
        self._feed()

    def expect_fewer(self, count: int) -> None:
        """Take ``count`` results off the expected total."""
        self._total -= count

    def ready(self, wanted: bool = False) -> Iterator[Progress | Result]:
        """Yield what has been finished, then the progress.

        If results are ``wanted``, wait a little for one: so that whoever iterates can soon stop.
        """
        timeout = PROMPT if wanted else 0
        done = wait(self._running, timeout, return_when=FIRST_COMPLETED).done
        for future in [one for one in self._running if one in done]:
            task = self._running.pop(future)
            solved = answer(future, "Joining the parts, or drawing the result,")
            self._feed()
            self._done += not task.step.preview
            icon = task.finish(remix_of(task.series, task.step, solved))
            yield Result(icon, solved.seconds, preview=task.step.preview)
        yield Progress("remix", self._done / max(1, self._total), "Joining parts")

    def cancel(self) -> None:
        """Stop what still runs; its processes live on."""
        self._ticket.stop()
        self._waiting.clear()
        self._running.clear()

    def _feed(self) -> None:
        """Give each process enough to do, the idlest first.

        Until a preview is there, the other processes begin nothing that would slow it down.
        """
        previewing = any(task.step.preview for task in self._running.values())
        for lane in sorted(range(self._workers.count), key=self._workers.load):
            under_way = sum(task.lane == lane for task in self._running.values())
            for _ in range(PIPELINED - under_way):
                if not self._lanes[lane] and self._waiting and not previewing:
                    self._lanes[lane].extend(_tasks(*self._waiting.popleft(), lane))
                    previewing = self._lanes[lane][0].step.preview
                if self._lanes[lane]:
                    self._submit(self._lanes[lane].popleft())

    def _submit(self, task: "_Task") -> None:
        future = self._workers.submit(
            solve,
            task.number,
            task.series,
            task.step,
            self._render,
            self._plausibility,
            lane=task.lane,
            ticket=self._ticket,
        )
        self._running[future] = task


@dataclass(frozen=True, eq=False)
class _Task:
    """A step of a series, in one of the processes."""

    number: int
    series: CutSeries
    finish: Finish
    step: Step
    lane: int


_numbers = itertools.count()


def _tasks(series: CutSeries, finish: Finish, lane: int) -> list[_Task]:
    number = next(_numbers)
    return [_Task(number, series, finish, step, lane) for step in series.steps]


def answers_by_row(
    workers: Workers, function: Callable[..., T], rows: Sequence[Row], *args: object, doing: str
) -> Generator[tuple[float, list[tuple[Row, T]]]]:
    """Ask a worker process ``function(row, *args)`` of each row, all at once.

    Yield again and again which part of the rows is done, and which of them were answered since.
    Closing the generator stops what is left.

    Raises
    ------
    IconstudioError
        If one is lost; a sentence that begins with what it was ``doing``.
    """
    ticket = workers.ticket()
    try:
        asked = {workers.submit(function, row, *args, ticket=ticket): row for row in rows}
        left = set(asked)
        while left:
            done, left = wait(left, PROMPT)
            answers = [(asked[future], answer(future, doing)) for future in done]
            yield 1 - len(left) / len(rows), answers
    finally:
        ticket.stop()


def remix_of(series: CutSeries, step: Step, solved: Solved) -> Remix:
    """Return the icon that a step of a series has come to."""
    data_cost, smoothness_cost = solved.costs
    composite = Composite(
        style=series.style,
        lambda_s=step.lambda_s,
        sources=series.sources,
        labels=solved.labels,
        energy=solved.energy,
        data_cost=data_cost,
        smoothness_cost=smoothness_cost,
        shares=solved.shares,
        iou=solved.iou,
        symmetry=series.symmetry,
    )
    return Remix.of(composite, solved.drawing, solved.score)
