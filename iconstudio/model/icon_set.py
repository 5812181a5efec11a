"""Sets of icons, of which each is read when it is needed."""

from collections.abc import Callable
from dataclasses import dataclass

from iconstudio.model.pictogram import Pictogram


@dataclass(frozen=True, slots=True)
class Member:
    """An icon of a set."""

    id: str
    """``set:name``, or the path in a folder."""
    name: str
    """What it is called in the set."""
    read: Callable[[], Pictogram | bytes]
    """Returns the icon, or what is in the file of a drawing; raises ``IconstudioError``."""
