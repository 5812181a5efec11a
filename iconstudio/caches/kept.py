"""What requests have come to, kept for a while: one that returns, by undo say, is met at once."""

from collections.abc import Sized
from typing import Any, Generic, TypeVar

S = TypeVar("S", bound=Sized)

KEPT = 160
"""Results that are kept: those of five grids."""


class Kept(Generic[S]):
    """Keeps what requests came to, ``most`` results in all, or those of the newest request."""

    def __init__(self, most: int = KEPT) -> None:
        self._most = most
        self._kept: list[tuple[Any, S]] = []

    def find(self, request: Any) -> S | None:
        """Return what a request came to, if it is kept."""
        return next((results for one, results in self._kept if one == request), None)

    def put(self, request: Any, results: S) -> None:
        """Keep what a request came to; what was not wanted for longest is left out for it."""
        self._kept = [one for one in self._kept if one[0] != request] + [(request, results)]
        while len(self._kept) > 1 and sum(len(some) for _, some in self._kept) > self._most:
            del self._kept[0]
