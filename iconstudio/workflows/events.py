"""What every workflow yields: progress, and what it has finished so far."""

from collections.abc import Generator, Mapping
from dataclasses import dataclass, field
from typing import TypeVar

from iconstudio.model import Exemplar, Icon, Point, Source
from iconstudio.model.progress import Event as Event
from iconstudio.model.progress import Progress as Progress

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class Retrieved(Event):
    """The exemplars of the keyword, best first (section 3.1)."""

    keyword: str
    exemplars: tuple[Exemplar, ...]
    remark: str = ""
    """How the keyword was read if not as typed, for the user."""
    strangers: frozenset[str] = frozenset()
    """Identifiers of the exemplars that are less alike than the others: the last ones."""


@dataclass(frozen=True, slots=True)
class Remark(Event):
    """A sentence about how the work was read, for the user."""

    sentence: str


@dataclass(frozen=True, slots=True)
class RegionsFound(Event):
    """Centres of the salient regions in canvas pixels, most salient first (section 3.2)."""

    centres: tuple[Point, ...]
    details: int = 0
    """How many of them, the last ones, are small regions of details."""


@dataclass(frozen=True, slots=True)
class StyleMatched(Event):
    """The best sources of a style, ``matches[region][rank]`` (section 3.3)."""

    style: str
    exemplars: tuple[Exemplar, ...]
    """What the style had to choose from."""
    matches: tuple[tuple[Source, ...], ...]
    whole: tuple[Source, ...] = ()
    """The best matches of the whole outline, which are sources, too."""

    @property
    def retrieved(self) -> int:
        """How many exemplars the style had to choose from."""
        return len(self.exemplars)


@dataclass(frozen=True, slots=True)
class StyleSkipped(Event):
    """A style that has too few exemplars to give a good result, with the sentence that says so."""

    style: str
    retrieved: int
    reason: str


@dataclass(frozen=True, slots=True)
class Result(Event):
    """A finished icon."""

    icon: Icon
    worked: Mapping[str, float] = field(default_factory=dict)
    """The seconds that it took a worker process, by stage, if that is known."""
    preview: bool = False
    """Whether a better one is to follow in its place."""


@dataclass(frozen=True, slots=True)
class Recommended(Event):
    """The result of a style to look at first: all its results are there.

    ``lambda_s`` is None if none is more than an icon that there was before.
    """

    style: str
    lambda_s: float | None


def staged(
    stage: str, message: str, work: Generator[float, None, T]
) -> Generator[Progress, None, T]:
    """Turn the fractions that ``work`` yields into progress, and return what it returns."""
    try:
        while True:
            yield Progress(stage, next(work), message)
    except StopIteration as end:
        value: T = end.value
        return value
