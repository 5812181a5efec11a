"""How far something is that takes long."""

from dataclasses import dataclass


class Event:
    """What workflows yield; one may have kinds of its own."""

    __slots__ = ()


@dataclass(frozen=True, slots=True)
class Progress(Event):
    """How far a stage is: ``done`` from 0 to 1, ``message`` for the user."""

    stage: str
    """A word by which its seconds are told."""
    done: float
    message: str
    remaining: float | None = None
    """Seconds until the whole run will have ended, if that can be told."""
