"""Answers of worker processes in their order, after a coarse one if that is there before."""

from collections.abc import Generator, Sequence
from concurrent.futures import Future, wait
from dataclasses import dataclass
from typing import Generic, TypeVar

from iconstudio.workers import answer
from iconstudio.workflows.events import Event, Progress

T = TypeVar("T")

_PATIENCE = 0.05
"""Seconds that pass at most before a run can be stopped."""


@dataclass(frozen=True, slots=True)
class Answer(Generic[T]):
    """What has come of a task, by its number."""

    number: int
    value: T
    preview: bool = False
    """Whether it is a coarse one."""


def answers(
    tasks: "Sequence[Future[T]]",
    coarse: "Future[T] | None",
    stage: str,
    doing: str,
    advice: str = "",
) -> Generator[Event | Answer[T]]:
    """Yield the answers of tasks, each followed by progress, and progress while they work.

    Parameters
    ----------
    coarse
        What makes a preview of the first; if it fails, there is none.
    stage, doing, advice
        What is under way, and what to do if it reaches its limits: see ``answer``.

    Raises
    ------
    IconstudioError
        If a task raised one, or took too long or too much memory.
    """
    for number, task in enumerate(tasks):
        while not wait([task], _PATIENCE).done:  # where it can be stopped
            if coarse is not None and coarse.done():
                if coarse.exception() is None:
                    yield Answer(number, coarse.result(), preview=True)
                coarse = None
            yield Progress(stage, number / len(tasks), doing)
        coarse = None
        yield Answer(number, answer(task, doing, advice))
        yield Progress(stage, (number + 1) / len(tasks), doing)
