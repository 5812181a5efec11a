"""Remixing placed sources, several problems at once: what all workflows share (section 3.4)."""

import itertools
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, wait
from dataclasses import dataclass, replace
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms import ranking
from iconstudio.algorithms.energy import Labels, RemixProblem, joined_ink
from iconstudio.algorithms.ranking import Score
from iconstudio.algorithms.raster import overlap, solid
from iconstudio.model import CANVAS, Composite, Drawing, Frame, IconstudioError, Placement, Source
from iconstudio.workers import Workers, died, forget, remembered
from iconstudio.workflows.drawing import Render, draw, drawn_from
from iconstudio.workflows.events import Progress, Result


@dataclass(frozen=True, eq=False)
class Job:
    """A problem to solve for several lambda_S, from the highest down."""

    style: str
    sources: tuple[Source, ...]
    problem: RemixProblem
    lambdas: tuple[float, ...]
    target: NDArray[np.bool_] | None = None
    """(CANVAS, CANVAS): the filled outline that the results are compared with, if there is one."""
    explored: tuple[float, ...] = ()
    """Values of lambda_S for which to look for labellings first: they help each other."""
    sharing: bool = False
    """Whether a good result has its ink from several sources."""
    finish: Callable[[Result], Result] = lambda result: result
    """What the workflow adds to each result."""


@dataclass(frozen=True, eq=False)
class Solved:
    """What a worker process answers; the score knows nothing of a target yet."""

    labels: Labels
    costs: tuple[float, float]
    """Data cost and smoothness cost."""
    score: Score
    drawing: Drawing
    seconds: tuple[float, float]
    """To cut, and to draw."""


class Remixing:
    """Solves jobs in worker processes; results come out as they are ready.

    Parameters
    ----------
    total
        How many results are expected in all, for the progress.
    """

    def __init__(self, workers: Workers, render: Render, total: int) -> None:
        self._workers = workers
        self._render = render
        self._total = total
        self._done = 0
        self._running: dict[Future[Any], _Step] = {}

    @property
    def busy(self) -> bool:
        """Whether results are still to come."""
        return bool(self._running)

    @property
    def hungry(self) -> bool:
        """Whether another job would keep the processes from running dry."""
        return len(self._running) < 2 * self._workers.count

    def start(self, job: Job) -> None:
        """Begin with the highest lambda_S of a job."""
        lambdas = tuple(sorted(job.lambdas, reverse=True))
        self._submit(_Step(job, lambdas, next(_numbers), self._workers.idlest()))

    def expect_fewer(self, count: int) -> None:
        """Take ``count`` results off the expected total."""
        self._total -= count

    def ready(self, timeout: float = 0.0) -> Iterator[Progress | Result]:
        """Yield what has been finished, then the progress.

        Waits at most ``timeout`` seconds for something, so that whoever iterates can stop soon.
        """
        finished = wait(self._running, timeout, return_when=FIRST_COMPLETED).done
        for future in finished:
            step = self._running.pop(future)
            solved = answer(future)
            if len(step.lambdas) > 1:
                self._submit(replace(step, lambdas=step.lambdas[1:]))
            self._done += 1
            yield step.job.finish(_result(step.job, step.lambdas[0], solved))
        yield Progress("remix", self._done / max(1, self._total), "Joining parts")

    def cancel(self) -> None:
        """Kill what still runs."""
        for future in self._running:
            future.cancel()
        self._running.clear()

    def _submit(self, step: "_Step") -> None:
        job = step.job
        future = self._workers.submit(
            solve,
            step.number,
            job.problem,
            step.lambdas[0],
            len(step.lambdas) == 1,
            job.explored,
            job.sharing,
            [drawn_from(source) for source in job.sources],
            self._render,
            lane=step.lane,
        )
        self._running[future] = step


@dataclass(frozen=True, eq=False)
class _Step:
    """The next lambda_S of a job, and those to follow; always in the same process."""

    job: Job
    lambdas: tuple[float, ...]
    number: int
    lane: int


_numbers = itertools.count()


def solve(
    key: object,
    problem: RemixProblem,
    lambda_s: float,
    last: bool,
    explored: Sequence[float],
    sharing: bool,
    drawn: Sequence[tuple[str, Frame, Placement]],
    render: Render,
) -> Solved:
    """Cut, judge, redraw and trace: one result. Runs in a worker process.

    What is found is remembered under ``key`` for other values of lambda_S, unless this is the
    ``last``.
    """
    from iconstudio.algorithms.sweep import Sweep

    began = perf_counter()

    def begin() -> Sweep:
        sweep = Sweep(problem)
        sweep.explore(explored)
        return sweep

    labels = remembered(key, begin).solve(lambda_s)
    if last:
        forget(key)
    score = ranking.score(problem, labels, sharing=sharing)
    cut = perf_counter()
    drawing = draw(labels, problem.ink, drawn, render)
    seconds = cut - began, perf_counter() - cut
    return Solved(labels, problem.costs(labels), score, drawing, seconds)


def warm_up() -> None:
    """Load what cuts, and compile it if it never was, on a problem of nothing."""
    from iconstudio.algorithms.sweep import Sweep

    ink = np.zeros((2, CANVAS, CANVAS), dtype=bool)
    sweep = Sweep(RemixProblem(ink.astype(np.float32), ink, ink))
    sweep.explore([1.0])
    sweep.solve(1.0)


def composite(
    job: Job, lambda_s: float, labels: Labels, data_cost: float, smoothness_cost: float
) -> Composite:
    """Return the labelling with its energy, its shares of ink, and its likeness to the target."""
    ink = joined_ink(job.problem.ink, labels)
    owned = np.bincount(labels[ink], minlength=len(job.sources))
    return Composite(
        style=job.style,
        lambda_s=lambda_s,
        sources=job.sources,
        labels=labels,
        energy=data_cost + lambda_s * smoothness_cost,
        data_cost=data_cost,
        smoothness_cost=smoothness_cost,
        shares=tuple((owned / max(1, owned.sum())).tolist()),
        iou=None if job.target is None else overlap(solid(ink), job.target),
    )


def _result(job: Job, lambda_s: float, solved: Solved) -> Result:
    icon = composite(job, lambda_s, solved.labels, *solved.costs)
    likeness = 1.0 if icon.iou is None else icon.iou
    score = replace(solved.score, likeness=likeness)
    return Result(icon, solved.drawing, score, *solved.seconds)


def answer(future: "Future[Any]") -> Any:
    """Return what a worker process answers.

    Raises
    ------
    IconstudioError
        If it was stopped, or died.
    """
    try:
        return future.result()
    except CancelledError:
        raise IconstudioError("The work was stopped.") from None
    except Exception as error:
        if isinstance(error, MemoryError) or died(error):
            raise IconstudioError(
                "A worker process ended before its work was done, perhaps for lack of memory. "
                "Close other programs and run again."
            ) from error
        raise
