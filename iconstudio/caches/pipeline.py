"""Work for several processes at once, of which results come out as they are ready."""

from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, wait
from typing import TypeVar

C = TypeVar("C")
R = TypeVar("R")


def pipelined(
    chunks: deque[C], submit: Callable[[C], "Future[R]"], most: int
) -> Iterator[tuple[C, "Future[R]"]]:
    """Submit chunks, at most so many at once, and yield each with its future once that is done.

    More chunks may be added meanwhile. Closing the generator leaves undone what has not begun.
    """
    waiting: dict[Future[R], C] = {}
    while chunks or waiting:
        while chunks and len(waiting) < most:
            chunk = chunks.popleft()
            waiting[submit(chunk)] = chunk
        for future in wait(waiting, return_when=FIRST_COMPLETED).done:
            yield waiting.pop(future), future
