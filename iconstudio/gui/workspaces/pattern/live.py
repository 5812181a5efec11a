"""The pattern as it is made again and again, and with other seeds."""

from collections.abc import Generator
from itertools import repeat

from iconstudio.gui.workspaces.made import Made, made_of
from iconstudio.model import Patterning
from iconstudio.session import Session
from iconstudio.workflows.events import Event
from iconstudio.workflows.pattern.bounds import SEEDS
from iconstudio.workflows.pattern.seeds import with_seeds
from iconstudio.workflows.pattern.spec import PATTERN

Shown = Generator[Event | Made[Patterning]]


def made(session: Session, work: Patterning) -> Shown:
    """Run some work: a coarse result, and the finished one."""
    from iconstudio.workflows.pattern.patterning import PatternSettings

    return made_of(session.run(PATTERN, work, PatternSettings(previews=True)), repeat(work))


def made_with_other_seeds(session: Session, work: Patterning) -> Shown:
    """Run the work with the seeds that follow its own."""
    from iconstudio.workflows.pattern.patterning import PatternSettings

    others = sheet_of(work)[1:]
    return made_of(session.run(PATTERN, others[0], PatternSettings(seeds=len(others))), others)


def sheet_of(work: Patterning) -> tuple[Patterning, ...]:
    """Return what there is to choose from: some work with its own seed, and with others."""
    return with_seeds(work, SEEDS)
