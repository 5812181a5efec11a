"""Other good labellings in the places of near-copies.

An addition to section 3.4: several lambda_S of a row often give nearly the same picture. Where
fewer than DIFFERENT results differ to the eye, the row is cut again without one or some of the
icons that most of it is of. What is plausible and unlike all others takes the place of a copy. This
comes after all of the rows.
"""

from collections import defaultdict
from collections.abc import Generator, Iterable, Sequence
from concurrent.futures import CancelledError, wait
from contextlib import closing
from dataclasses import dataclass, replace
from functools import partial
from statistics import median

from iconstudio.algorithms.iconification.energy import joined_ink
from iconstudio.algorithms.iconification.overhang import drawn_ink
from iconstudio.algorithms.iconification.plausibility import Plausibility
from iconstudio.algorithms.iconification.ranking import Gallery
from iconstudio.algorithms.raster import Bitmap
from iconstudio.limits import limited
from iconstudio.model import CANVAS, Remix
from iconstudio.tasks import stopped
from iconstudio.workers import Workers, answer
from iconstudio.workflows.drawing import MEMORY, SECONDS, Render
from iconstudio.workflows.events import Event, Progress, Recommended, Result
from iconstudio.workflows.grid import PLAUSIBLE
from iconstudio.workflows.modelling.symmetric import Pose
from iconstudio.workflows.remixing import PROMPT, remix_of
from iconstudio.workflows.solving import CutSeries, Solved, Step, finished, worth

DIFFERENT = 5
"""So many results of a row shall differ to the eye."""
WITHOUT = ((0,), (1,), (0, 1), (2,), (0, 2), (0, 1, 2))
"""Which icons are left out in turn, by their rank in what the row is of."""
FEWEST = 3
"""Icons that must be left."""
HOPELESS = 0.3
"""What is less plausible than that is no good, even in a row that is no better."""


@dataclass(frozen=True, eq=False)
class Repetitive:
    """A row with near-copies. It goes to a worker process, so it can be pickled.

    Attributes
    ----------
    series
        Its ``lambdas`` are those of the copies.
    seen
        Inks that others must differ from, each (CANVAS, CANVAS).
    without
        Identifiers of the icons to leave out, each time.
    wanted
        How many other pictures are wanted at most.
    least
        The least plausible one that is good enough.
    """

    series: CutSeries
    seen: tuple[Bitmap, ...]
    without: tuple[frozenset[str], ...]
    wanted: int
    least: float


def with_variety(
    events: Generator[Event],
    pose: Pose,
    workers: Workers,
    render: Render,
    plausibility: Plausibility | None,
) -> Generator[Event]:
    """Pass on the events of a grid, and then yield other results in the places of near-copies.

    Each is a ``Result`` whose composite says which icons were left out. Recommended results stay.
    Without ``plausibility`` there are none. Closing the generator cancels what is left.

    Parameters
    ----------
    pose
        Makes of a style's sources the problem that is to be solved; must be picklable.
    """
    made: dict[str, list[Remix]] = defaultdict(list)
    found: list[Repetitive] = []
    with closing(events):
        for event in events:
            yield event
            match event:
                case Result(icon=Remix() as icon, preview=False):
                    if icon.composite.symmetry is None:
                        made[icon.composite.style].append(icon)
                case Recommended(style, lambda_s) if plausibility is not None:
                    row = repetitive(made[style], lambda_s, pose)
                    found += [row] if row is not None else []
    ticket = workers.ticket()
    try:
        tasks = {
            workers.submit(varied, row, render, plausibility, ticket=ticket): row for row in found
        }
        left = set(tasks)
        while left:
            done, left = wait(left, PROMPT)
            for future in done:
                series = tasks[future].series
                for one in answer(future, "Joining the parts, or drawing the result,"):
                    yield Result(_remix(series, *one))
            yield Progress("vary", 1 - len(left) / len(tasks), "Looking for other good joins")
    finally:
        ticket.stop()


def repetitive(row: Sequence[Remix], best: float | None, pose: Pose) -> Repetitive | None:
    """Return what to do for a row of which too few results differ, if that is so.

    ``best`` is the lambda_S of the recommended result, which is no copy.
    """
    if len(row) <= DIFFERENT:
        return None
    gallery, copies = Gallery(), []
    inks = {one.composite.lambda_s: drawn_ink(one.drawing) for one in row}
    for value in sorted(inks, key=lambda value: (value != best, -value)):
        if not gallery.add(inks[value]):
            copies.append(value)
    wanted = DIFFERENT - (len(row) - len(copies))
    sources = row[0].composite.sources
    ranked = _by_share(row)
    without = [frozenset(ranked[k] for k in some if k < len(ranked)) for some in WITHOUT]
    icons = {one.exemplar.id for one in sources}
    without = [some for some in dict.fromkeys(without) if some and len(icons - some) >= FEWEST]
    if wanted <= 0 or not without:
        return None
    series = CutSeries(row[0].composite.style, sources, partial(pose, sources), tuple(copies))
    usual = median(one.score.plausible or 0.0 for one in row)
    least = min(PLAUSIBLE, max(HOPELESS, usual))
    seen = tuple(ink for value, ink in inks.items() if value not in copies)
    return Repetitive(series, seen, tuple(without), wanted, least)


def varied(
    row: Repetitive, render: Render, plausibility: Plausibility
) -> list[tuple[float, frozenset[str], Solved]]:
    """Return other results of a row: lambda_S, what was left out, and what came of it.

    Runs in a worker process.

    Raises
    ------
    CancelledError
        As soon as they are no longer wanted.
    """
    from iconstudio.algorithms.iconification.alpha_expansion import AlphaExpansion
    from iconstudio.algorithms.iconification.block_expansion import Stopped

    series, sources = row.series, row.series.sources
    posed = series.pose()
    finer = posed.problem.side // CANVAS
    expansion = AlphaExpansion(posed.problem, stopped)
    gallery = Gallery()
    for ink in row.seen:
        gallery.add(ink)
    found: list[tuple[float, frozenset[str], Solved]] = []
    for without in row.without:
        lambda_s = series.lambdas[len(found)]
        labels = [k for k, one in enumerate(sources) if one.exemplar.id in without]
        try:
            cut = expansion.find_without(posed.weight(lambda_s), labels)
        except Stopped:
            raise CancelledError from None
        if worth(posed, sources, plausibility, cut) < row.least:
            continue
        if gallery.add(joined_ink(posed.problem.ink, cut)[::finer, ::finer]):
            with limited(SECONDS, MEMORY):
                step = Step(lambda_s)
                solved = finished(posed, series, step, cut, render, plausibility)
            found.append((lambda_s, without, solved))
            if len(found) == row.wanted:
                break
    return found


def _remix(series: CutSeries, lambda_s: float, without: frozenset[str], solved: Solved) -> Remix:
    icon = remix_of(series, Step(lambda_s), solved)
    return replace(icon, composite=replace(icon.composite, without=tuple(sorted(without))))


def _by_share(row: Iterable[Remix]) -> list[str]:
    """Return the identifiers of the icons that a row is of, that of the most ink first."""
    shares: dict[str, float] = defaultdict(float)
    for icon in row:
        for source, share in zip(icon.composite.sources, icon.composite.shares, strict=True):
            shares[source.exemplar.id] += share
    used = [one for one, share in shares.items() if share > 0]
    return sorted(used, key=lambda one: (-shares[one], one))
