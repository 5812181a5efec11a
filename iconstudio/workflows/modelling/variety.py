"""Other good labellings in the places of near-copies, and of what is not plausible.

An addition to section 3.4: several lambda_S of a row often give nearly the same picture, and one of
many small parts is seldom plausible. So a row is cut again: of one icon that resembles the outline
as a whole and one other source, which seldom has more than a seam or two; and without one or some
of the icons that most of it is of. What is plausible and unlike all others takes the place of a
copy, or of what is less plausible. This comes after all of the rows.
"""

from collections import defaultdict
from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from concurrent.futures import CancelledError
from contextlib import closing
from dataclasses import dataclass, replace
from functools import partial
from statistics import median
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.energy import Labels, canvas_ink
from iconstudio.algorithms.iconification.overhang import drawn_ink
from iconstudio.algorithms.iconification.plausibility import Plausibility
from iconstudio.algorithms.iconification.ranking import Gallery, shares
from iconstudio.algorithms.raster import Bitmap
from iconstudio.limits import limited
from iconstudio.model import Remix, Source
from iconstudio.tasks import stopped
from iconstudio.workers import Workers
from iconstudio.workflows.drawing import MEMORY, SECONDS, Render
from iconstudio.workflows.events import Event, Progress, Recommended, Result
from iconstudio.workflows.grid import LAMBDAS
from iconstudio.workflows.modelling.symmetric import Pose
from iconstudio.workflows.recommending import PLAUSIBLE, UNTOUCHED
from iconstudio.workflows.remixing import answers_by_row, remix_of
from iconstudio.workflows.solving import CutSeries, Posed, Solved, Step, finished, worth

if TYPE_CHECKING:
    from iconstudio.algorithms.iconification.alpha_expansion import AlphaExpansion

DIFFERENT = 5
"""So many results of a row shall differ to the eye."""
YIELDING = 3
"""So many results of a row may give way to better ones: near-copies, as far as these are wanted to
be others, though they be more, and then the least plausible."""
WHOLES, PARTNERS = 3, 8
"""Icons that most resemble the outline, and sources that each of them is joined with."""
JOINED = float(np.sqrt(LAMBDAS[0] * LAMBDAS[-1]))
"""lambda_S of what is of two sources."""
WITHOUT = ((0,), (1,), (0, 1), (2,), (0, 2), (0, 1, 2))
"""Which icons are left out in turn, by their rank in what the row is of."""
FEWEST = 3
"""Icons that must be left."""
HOPELESS = 0.3
"""What is less plausible than that is no good, even in a row that is no better."""


@dataclass(frozen=True, slots=True)
class Place:
    """Where another result may come.

    Attributes
    ----------
    least
        How plausible that must be at least.
    """

    lambda_s: float
    least: float


@dataclass(frozen=True, eq=False)
class Weak:
    """A row some of whose results may give way. It can be pickled, to go to another process.

    Attributes
    ----------
    places
        Those of near-copies first, so many as are wanted to be others, then the least plausible.
    seen
        Inks that others must differ from, each (CANVAS, CANVAS).
    without
        Identifiers of the icons to leave out, each time.
    """

    style: str
    sources: tuple[Source, ...]
    pose: Pose
    places: tuple[Place, ...]
    seen: tuple[Bitmap, ...]
    without: tuple[frozenset[str], ...]

    @property
    def series(self) -> CutSeries:
        """The problem of the row."""
        values = tuple(place.lambda_s for place in self.places)
        return CutSeries(self.style, self.sources, partial(self.pose, self.sources), values)


@dataclass(frozen=True, eq=False)
class Other:
    """Another result: its place, which icons were left out, and what came of it."""

    lambda_s: float
    without: frozenset[str]
    solved: Solved


def with_variety(
    events: Generator[Event],
    pose: Pose,
    workers: Workers,
    render: Render,
    plausibility: Plausibility | None,
) -> Generator[Event]:
    """Pass on the events of a grid, and then yield other results in the places of weak ones.

    Each is a ``Result`` whose composite says which icons were left out. Recommended results stay.
    Without ``plausibility`` there are none. Closing the generator cancels what is left.

    Parameters
    ----------
    pose
        Makes of a style's sources the problem that is to be solved; must be picklable.
    """
    made: dict[str, list[Remix]] = defaultdict(list)
    found: list[Weak] = []
    with closing(events):
        for event in events:
            yield event
            match event:
                case Result(icon=Remix() as icon, preview=False):
                    if icon.composite.symmetry is None:
                        made[icon.composite.style].append(icon)
                case Recommended(style, lambda_s) if plausibility is not None:
                    row = weak(made[style], lambda_s, pose)
                    found += [row] if row is not None else []
    doing = "Joining the parts, or drawing the result,"
    with closing(
        answers_by_row(workers, others, found, render, plausibility, doing=doing)
    ) as steps:
        for done, answers in steps:
            for row, some in answers:
                for one in some:
                    yield Result(_remix(row.series, one))
            yield Progress("vary", done, "Looking for other good joins")


def weak(row: Sequence[Remix], best: float | None, pose: Pose) -> Weak | None:
    """Return which results of a row may give way; None if there is nothing to join anew.

    ``best`` is the lambda_S of the recommended result, which stays. So do all of a row of few: each
    was asked for.
    """
    if len(row) <= DIFFERENT:
        return None
    row = sorted(row, key=lambda one: -one.composite.lambda_s)  # in whichever order they came
    plausible = {one.composite.lambda_s: one.score.plausible or 0.0 for one in row}
    inks = {one.composite.lambda_s: drawn_ink(one.drawing) for one in row}
    gallery, copies = Gallery(), []
    for value in sorted(inks, key=lambda value: (value != best, -value)):
        if not gallery.add(inks[value]):
            copies.append(value)
    wanted = max(0, DIFFERENT - (len(row) - len(copies)))
    enough = min(PLAUSIBLE, max(HOPELESS, median(plausible.values())))
    places = [Place(value, enough) for value in copies[:wanted]]
    left = sorted(inks.keys() - {best, *copies[:wanted]}, key=lambda v: (plausible[v], v))
    places += [
        Place(value, max(PLAUSIBLE, plausible[value]))
        for value in left[: max(0, YIELDING - len(places))]
    ]
    composite = row[0].composite
    ranked = _by_share(row)
    without = [frozenset(ranked[k] for k in some if k < len(ranked)) for some in WITHOUT]
    names = {one.exemplar.id for one in composite.sources}
    without = [some for some in dict.fromkeys(without) if some and len(names - some) >= FEWEST]
    if len(names) < FEWEST:
        return None
    taken = {place.lambda_s for place in places}
    seen = tuple(ink for value, ink in inks.items() if value not in taken)
    return Weak(composite.style, composite.sources, pose, tuple(places), seen, tuple(without))


def others(row: Weak, render: Render, plausibility: Plausibility) -> list[Other]:
    """Return other results of a row. Runs in a worker process.

    Raises
    ------
    CancelledError
        As soon as they are no longer wanted.
    """
    from iconstudio.algorithms.iconification.alpha_expansion import AlphaExpansion
    from iconstudio.algorithms.iconification.block_expansion import Stopped

    series = row.series
    posed = series.pose()
    expansion = AlphaExpansion(posed.problem, stopped)
    gallery = Gallery()
    for ink in row.seen:
        gallery.add(ink)
    found: list[Other] = []
    left = list(row.places)
    judge = partial(worth, posed, row.sources, plausibility)
    try:
        for promise, cut in _cuts(row, posed, expansion, judge):
            place = left[0]
            ink = canvas_ink(posed.problem.ink, cut.labels)
            if promise < place.least or not gallery.add(ink):
                continue
            with limited(SECONDS, MEMORY):
                step = Step(place.lambda_s)
                solved = finished(posed, series, step, cut.labels, render, plausibility)
            if (solved.score.plausible or 0.0) >= place.least:
                found.append(Other(place.lambda_s, cut.without, solved))
                left.pop(0)
            if not left:
                break
    except Stopped:
        raise CancelledError from None
    return found


@dataclass(frozen=True, eq=False, slots=True)
class Cut:
    """Another labelling (m, m), and identifiers of the icons that it is without."""

    labels: Labels
    without: frozenset[str]


def _cuts(
    row: Weak, posed: Posed, expansion: "AlphaExpansion", judge: Callable[[Labels], float]
) -> Iterator[tuple[float, Cut]]:
    """Yield other labellings, and how plausible each is: the best of two icons, then the rest."""
    pairs = [(judge(cut.labels), cut) for cut in joined_pairs(posed, row.sources, expansion)]
    yield from sorted(pairs, key=lambda pair: -pair[0])
    for without in row.without:
        left_out = [k for k, one in enumerate(row.sources) if one.exemplar.id in without]
        labels = expansion.find_without(posed.weight(JOINED), left_out)
        yield judge(labels), Cut(labels, without)


def joined_pairs(
    posed: Posed, sources: Sequence[Source], expansion: "AlphaExpansion"
) -> Iterator[Cut]:
    """Yield labellings of two sources each, of two icons, neither of which is all of it.

    One of them resembles the outline as a whole; the other is among those that better it most.
    """
    names = [one.exemplar.id for one in sources]
    for pair in _pairs(posed.problem.data, names):
        left_out = [k for k in range(len(names)) if k not in pair]
        labels = expansion.find_without(posed.weight(JOINED), left_out)
        if max(shares(posed.problem, labels)) < UNTOUCHED:
            yield Cut(labels, frozenset(names) - {names[k] for k in pair})


def _pairs(data: NDArray[np.float32], names: Sequence[str]) -> Iterator[frozenset[int]]:
    """Yield pairs of sources of two icons to join, by their data costs (K, m, m)."""
    wholes: dict[str, int] = {}
    for k in np.argsort(data.sum(axis=(1, 2)), kind="stable"):
        wholes.setdefault(names[k], int(k))
    known: set[frozenset[int]] = set()
    for whole in list(wholes.values())[:WHOLES]:
        together = np.minimum(data, data[whole]).sum(axis=(1, 2))
        partners = [k for k in np.argsort(together, kind="stable") if names[k] != names[whole]]
        for partner in partners[:PARTNERS]:
            pair = frozenset((whole, int(partner)))
            if pair not in known:
                known.add(pair)
                yield pair


def _remix(series: CutSeries, other: Other) -> Remix:
    icon = remix_of(series, Step(other.lambda_s), other.solved)
    composite = replace(icon.composite, without=tuple(sorted(other.without)))
    return replace(icon, composite=composite)


def _by_share(row: Iterable[Remix]) -> list[str]:
    """Return the identifiers of the icons that a row is of, that of the most ink first."""
    owned: dict[str, float] = defaultdict(float)
    for icon in row:
        for source, share in zip(icon.composite.sources, icon.composite.shares, strict=True):
            owned[source.exemplar.id] += share
    used = [one for one, share in owned.items() if share > 0]
    return sorted(used, key=lambda one: (-owned[one], one))
