"""Restyling whole sets: every icon in one style, each with a seed of its own.

An icon depends on itself, the style and its seed alone: however many processes work on a set, on
whatever machines, and however often they were stopped, the result is the same.

An icon keeps the proportions of its page. Pages of a set are as high as each other, mostly, while
some are wider: so each is as high as the canvas, and the texture has one scale in all icons.
"""

import hashlib
import logging
from collections import deque
from collections.abc import Callable, Generator, Iterable, Sequence
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, wait
from dataclasses import dataclass, replace
from time import perf_counter
from typing import Any, Protocol

from iconstudio.cluster import DisconnectedError
from iconstudio.grammar import counted
from iconstudio.model import CANVAS, IconstudioError, LineStyle, Path, Pictogram, Transform
from iconstudio.model.icon_set import Member
from iconstudio.workers import Workers, loss
from iconstudio.workflows.estimating import remaining
from iconstudio.workflows.events import Progress
from iconstudio.workflows.line_style.restyling import (
    MEMORY,
    SECONDS,
    Sides,
    restyled_path,
    scaled,
    signed,
)

Drawn = tuple[tuple[Path, float], ...]
"""What is drawn of an icon: paths, each with the width of its stroke; 0 is filled."""

_WIDEST = 2.0
"""Over its height: a page that is wider is as wide as that, and a slimmer one gets room."""
_AHEAD = 3
"""Tasks that are handed out for each process: the next ones wait where they are worked on."""
_PATIENCE = 300.0
"""Seconds without any result after which a cluster is taken for dead."""
_log = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True)
class Manner:
    """How all icons of a set are restyled."""

    style: LineStyle
    strength: float = 1.0
    size: float = 1.0
    seed: int = 0
    strokes: bool = False
    """Whether what was a stroke stays one."""

    def seed_of(self, identifier: str) -> int:
        """Return the seed of an icon, which no other icon changes; below 2**48."""
        digest = hashlib.sha256(f"{self.seed}:{identifier}".encode(errors="replace")).digest()
        return int.from_bytes(digest[:6], "big")


@dataclass(frozen=True, slots=True)
class MemberRestyled:
    """An icon of a set, restyled."""

    member: Member
    source: Pictogram | bytes
    drawn: Drawn
    title: str
    credits: tuple[Pictogram, ...]
    """Whom to thank: the icon's makers, and the style's author."""
    remarks: tuple[str, ...]
    """What could not be read of its drawing; a sentence for the user each."""
    page: Sides = (CANVAS, CANVAS)
    scale: float = 1.0
    """Below 1 if it had no room on its page."""


@dataclass(frozen=True, slots=True)
class MemberSkipped:
    """An icon that cannot be restyled, and the sentence that says why."""

    member: Member
    reason: str


SetEvent = Progress | MemberRestyled | MemberSkipped


class Processes(Protocol):
    """Where icons are restyled."""

    @property
    def count(self) -> int:
        """How many icons are restyled at a time."""
        ...

    def submit(self, function: Callable[..., Any], *args: object) -> "Future[Any]":
        """Call a function of a module there."""
        ...


class Here:
    """The worker processes of this machine."""

    def __init__(self, workers: Workers) -> None:
        self._workers = workers

    @property
    def count(self) -> int:
        """How many processes there are."""
        return self._workers.count

    def submit(self, function: Callable[..., Any], *args: object) -> "Future[Any]":
        """Call a function in one of them, within limits of time and memory."""
        return self._workers.submit(function, *args, timeout=SECONDS, memory=MEMORY)


def restyle_set(
    members: Sequence[Member],
    manner: Manner,
    processes: Processes,
    is_done: Callable[[Member, Pictogram | bytes], bool] = lambda member, source: False,
    clock: Callable[[], float] = perf_counter,
) -> Generator[SetEvent]:
    """Restyle the icons of a set; yield each as soon as it is finished, in any order.

    One that cannot be restyled is skipped. Closing the generator leaves undone what has not begun.

    Parameters
    ----------
    is_done
        Whether an icon need not be restyled: what was made before is still there.
    clock
        Seconds since any moment.

    Raises
    ------
    IconstudioError
        If no process answers any more.
    """
    began, settled, worked = clock(), 0, 0
    coming = deque(members)
    waiting: dict[Future[Any], tuple[Member, Pictogram | bytes]] = {}

    def progress() -> Progress:
        left = remaining(worked, len(members) - settled, clock() - began)
        done = settled / max(1, len(members))
        return Progress("remix", done, f"{settled} of {counted(len(members), 'icon')}", left)

    yield progress()
    try:
        while coming or waiting:
            while coming and len(waiting) < _AHEAD * max(1, processes.count):
                member = coming.popleft()
                try:
                    source = member.read()
                except IconstudioError as error:
                    settled += 1
                    yield MemberSkipped(member, str(error))
                    continue
                if is_done(member, source):
                    settled += 1
                    continue
                task = processes.submit(restyled_member, member.id, source, manner)
                waiting[task] = member, source
            for future in _finished(waiting):
                member, source = waiting.pop(future)
                settled, worked = settled + 1, worked + 1
                yield _outcome(member, source, manner, future)
            yield progress()
    finally:
        for future in waiting:
            future.cancel()


def restyled_member(
    identifier: str, source: Pictogram | bytes, manner: Manner
) -> tuple[Pictogram, Drawn, Sides, float]:
    """Return an icon without its drawing, what is drawn of it, its page, and at what scale.

    Its remarks say what the lines do not show of it.

    The drawing may be hostile: runs in a worker process, here or in a cluster.

    Raises
    ------
    IconstudioError
        If it cannot be drawn, or has no lines.
    """
    from iconstudio.algorithms.curves.outline import strokes_of
    from iconstudio.svg.lines import lines_of, said_of_pale_parts
    from iconstudio.svg.rasterise import page_frame, rasterise_page
    from iconstudio.svg.reading import own_svg

    icon = own_svg(source, identifier) if isinstance(source, bytes) else source
    frame, coverage = rasterise_page(icon.svg)
    lines = lines_of(icon.svg, frame, coverage)
    page: Sides = (CANVAS, CANVAS)
    if frame == page_frame(icon.svg):
        page, larger = _page(icon.svg)
        lines = scaled(lines, larger)
    styles = [manner.style] * len(lines)
    seed = manner.seed_of(identifier)
    path, made, scale = restyled_path(lines, styles, manner.strength, manner.size, seed, page=page)
    drawn = strokes_of(made) if manner.strokes else ((path, 0.0),)
    if not any(path for path, _ in drawn):
        raise IconstudioError("Nothing of it is left in this style. Make the style smaller.")
    corner = Transform(1, 0, 0, 1, (page[0] - CANVAS) / 2, (page[1] - CANVAS) / 2)
    drawn = tuple((path.transformed(corner), width) for path, width in drawn)
    remarks = (*icon.remarks, *filter(None, [said_of_pale_parts(coverage)]))
    return replace(icon, svg="", remarks=remarks), drawn, page, scale


def _page(svg: str) -> tuple[Sides, float]:
    """Return the sides of a document's page, and how much larger it is than if it fits the canvas.

    Neither side is less than half of the other.
    """
    from iconstudio.svg.resvg import page_of

    _, _, width, height = page_of(svg)
    unit = CANVAS / max(height, width / _WIDEST)
    across, down = width * unit, height * unit
    page = max(across, down / _WIDEST), max(down, across / _WIDEST)
    return page, max(width, height) * unit / CANVAS


def _finished(waiting: Iterable["Future[Any]"]) -> Iterable["Future[Any]"]:
    """Return the futures that are finished; wait until one is."""
    futures = tuple(waiting)
    if not futures:
        return ()
    finished = wait(futures, _PATIENCE, FIRST_COMPLETED).done
    if not finished:
        raise IconstudioError(
            f"No icon was finished in {_PATIENCE / 60:.0f} minutes. See whether the workers run, "
            "and give the same command again: it goes on where it was."
        )
    return [one for one in futures if one in finished]


def _outcome(
    member: Member, source: Pictogram | bytes, manner: Manner, future: "Future[Any]"
) -> MemberRestyled | MemberSkipped:
    """Return what has come of an icon."""
    try:
        icon, drawn, page, scale = future.result()
    except DisconnectedError:
        raise
    except IconstudioError as error:
        return MemberSkipped(member, str(error))
    except ImportError as error:
        raise IconstudioError(
            f"A worker cannot run this program: {error}. Install the same version of it there."
        ) from error
    except CancelledError:
        raise IconstudioError("The work was stopped.") from None
    except Exception as error:
        reason = loss(error, "Restyling it")
        if reason is None:  # one icon less is better than none at all
            _log.info("Restyling %s failed", member.id, exc_info=error)
            reason = f"The program fails on it: {type(error).__name__}."
        return MemberSkipped(member, reason)
    title, credits = signed(icon, [manner.style])
    return MemberRestyled(member, source, drawn, title, credits, icon.remarks, page, scale)
