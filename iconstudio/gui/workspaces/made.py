"""Results as pictures, each with the work that it is of."""

from collections.abc import Generator, Iterable, Iterator
from contextlib import closing
from dataclasses import dataclass
from typing import Generic, TypeVar

from iconstudio.gui.pictures.picture import Picture, pictured
from iconstudio.workflows.events import Event

W = TypeVar("W")


@dataclass(frozen=True, slots=True, eq=False)
class Made(Generic[W]):
    """A result, and the work that it is of."""

    picture: Picture
    work: W


def made_of(events: Generator[Event], works: Iterable[W]) -> Generator[Event | Made[W]]:
    """Pass events on, with a ``Made`` in place of each result; ``works`` are theirs, in order."""
    each: Iterator[W] = iter(works)
    with closing(pictured(events)) as shown:
        for event in shown:
            yield Made(event, next(each)) if isinstance(event, Picture) else event
