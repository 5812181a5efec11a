"""How far something is that takes long."""

from dataclasses import dataclass
from typing import Literal

Stage = Literal["search", "prepare", "match", "remix", "vectorize"]


@dataclass(frozen=True, slots=True)
class Progress:
    """How far a stage is: ``done`` from 0 to 1, ``message`` for the user."""

    stage: Stage
    done: float
    message: str
    remaining: float | None = None
    """Seconds until the whole run will have ended, if that can be told."""
