"""The pattern as it is made again and again, and with other seeds."""

from collections.abc import Generator, Iterable
from contextlib import closing
from dataclasses import dataclass, replace
from itertools import repeat
from typing import TYPE_CHECKING

from iconstudio.gui.pictures.picture import Picture, pictured
from iconstudio.model import Patterning
from iconstudio.session import Session
from iconstudio.workflows.events import Event
from iconstudio.workflows.pattern.bounds import LARGEST_SEED, SEEDS
from iconstudio.workflows.pattern.spec import PATTERN

if TYPE_CHECKING:
    from iconstudio.workflows.pattern.patterning import PatternSettings


@dataclass(frozen=True, slots=True, eq=False)
class Made:
    """A result, and the work that it is of."""

    picture: Picture
    work: Patterning


def made(session: Session, work: Patterning) -> Generator[Event | Made]:
    """Run some work: a coarse result, and the finished one."""
    from iconstudio.workflows.pattern.patterning import PatternSettings

    return _made(session, work, repeat(work), PatternSettings(previews=True))


def made_with_other_seeds(session: Session, work: Patterning) -> Generator[Event | Made]:
    """Run the work with the seeds that follow its own."""
    from iconstudio.workflows.pattern.patterning import PatternSettings

    others = sheet_of(work)[1:]
    return _made(session, others[0], iter(others), PatternSettings(seeds=len(others)))


def sheet_of(work: Patterning) -> tuple[Patterning, ...]:
    """Return some work with its own seed, and with those that follow it."""
    seeds = ((work.seed + number) % (LARGEST_SEED + 1) for number in range(SEEDS))
    return tuple(replace(work, seed=seed) for seed in seeds)


def _made(
    session: Session, work: Patterning, each: Iterable[Patterning], settings: "PatternSettings"
) -> Generator[Event | Made]:
    works = iter(each)
    with closing(pictured(session.run(PATTERN, work, settings))) as events:
        for event in events:
            yield Made(event, next(works)) if isinstance(event, Picture) else event
