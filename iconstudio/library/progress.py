"""How far a long task of the library is."""

from typing import NamedTuple


class Progress(NamedTuple):
    """``done`` from 0 to 1, ``message`` for the user."""

    done: float
    message: str
