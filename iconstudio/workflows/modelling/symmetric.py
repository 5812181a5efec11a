"""Symmetric results of an outline that is nearly symmetric, where these are about as plausible.

An addition to section 3.4, whose constraint (equation 9) gives places that mirror each other one
source, which need not look the same there. About the vertical axis a source can be mirrored, too:
there either half of each result of a row is mirrored onto the other. About another axis the
recommended result is cut again under the constraint. This comes after all of the rows.
"""

from collections import defaultdict
from collections.abc import Callable, Generator, Iterator
from concurrent.futures import CancelledError
from contextlib import closing
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.energy import Labels, canvas_ink
from iconstudio.algorithms.iconification.overhang import drawn_ink
from iconstudio.algorithms.iconification.plausibility import Plausibility
from iconstudio.algorithms.iconification.ranking import Gallery
from iconstudio.algorithms.iconification.symmetry import flipped, likeness, mirrored_halves
from iconstudio.algorithms.raster import Bitmap, overlap, placed_ink
from iconstudio.limits import limited
from iconstudio.model import CANVAS, Axis, Remix, Source
from iconstudio.tasks import stopped
from iconstudio.workers import Workers
from iconstudio.workflows.drawing import MEMORY, SECONDS, Render
from iconstudio.workflows.events import Event, Progress, Recommended, Result
from iconstudio.workflows.remixing import answers_by_row, remix_of
from iconstudio.workflows.solving import CutSeries, Posed, Solved, Step, finished, worth

Pose = Callable[[tuple[Source, ...]], Posed]

TRIED = 3
"""Of the labellings that are mirrored, so many are drawn for each row: the recommended one's, and
the most plausible."""
MIDDLE, EVEN = 16, 0.9
"""What lies so near to the axis, in canvas pixels, overlaps its mirror image so far already: else
mirroring a half would bend it."""
ASIDE = 6
"""Twice the canvas pixels by which that axis may lie beside the canvas's."""
ALIKE = 0.98
"""What overlaps its own mirror image by more, source or result, needs no mirrored one."""
SYMMETRIC = 0.97
"""What overlaps its own mirror image by less is not called symmetric."""
ABOUT, HELD = 0.97, 0.8
"""A symmetric result is wanted from this part of the other one's plausibility on, as what is moved
to both sides counts as moved apart; and where the user asked for symmetry."""


@dataclass(frozen=True, eq=False)
class Row:
    """The results of a style. It can be pickled, to go to another process.

    Attributes
    ----------
    aside
        Twice the canvas pixels by which the axis lies to the right of the canvas's.
    sources
        With the mirror images of those that are used, if they can be mirrored.
    held
        Whether the page asks for the symmetry: then all results are made symmetric.
    twins
        (K,): the number of each source's mirror image; of what nobody uses, its own.
    labels
        (m, m) by lambda_S; that of the recommended result first.
    """

    style: str
    axis: Axis
    aside: int
    sources: tuple[Source, ...]
    twins: NDArray[np.uint8]
    labels: dict[float, Labels]
    pose: Pose
    held: bool = False

    @property
    def least(self) -> float:
        """The least part of the other one's plausibility at which a symmetric result is wanted."""
        return HELD if self.held else ABOUT

    def series(self, lambda_s: float) -> CutSeries:
        """Return the problem of one result."""
        pose = partial(self.pose, self.sources)
        return CutSeries(self.style, self.sources, pose, (lambda_s,), symmetry=self.axis)


def with_symmetric(
    events: Generator[Event],
    axis: Axis | None,
    pose: Pose,
    workers: Workers,
    render: Render,
    plausibility: Plausibility | None,
    held: bool = False,
) -> Generator[Event]:
    """Pass on the events of a grid, and then yield symmetric results that are about as plausible.

    Each is a ``Result`` that takes the place of another one of its row, and whose composite says
    that it was held to a symmetry. Closing the generator cancels what is left. Without
    ``plausibility`` there are none.

    Parameters
    ----------
    axis
        About which the outline is nearly symmetric, if about any.
    held
        Whether the page asks for that symmetry.
    pose
        Makes of a style's sources the problem that is to be solved; must be picklable.
    """
    made: dict[str, dict[float, Remix]] = defaultdict(dict)
    best: dict[str, float] = {}
    with closing(events):
        for event in events:
            yield event
            match event:
                case Result(icon=Remix() as icon, preview=False):
                    made[icon.composite.style][icon.composite.lambda_s] = icon
                case Recommended(style, lambda_s) if lambda_s is not None:
                    best[style] = lambda_s
    if axis is None or plausibility is None:
        return
    rows = [
        replace(row_of(made[style], value, pose, axis), held=held) for style, value in best.items()
    ]
    doing = "Making a result symmetric"
    answered = answers_by_row(workers, symmetric, rows, render, plausibility, doing=doing)
    with closing(answered) as steps:
        for done, answers in steps:
            for row, found in answers:
                for lambda_s, solved in found:
                    icon = remix_of(row.series(lambda_s), Step(lambda_s), solved)
                    if _is_better(icon, made[row.style][lambda_s], row):
                        yield Result(icon)
            yield Progress("symmetry", done, "Making symmetric ones")


def row_of(made: dict[float, Remix], best: float, pose: Pose, axis: Axis) -> Row:
    """Return a style's results, by lambda_S, as they are to be made symmetric.

    About the vertical axis they are so where the recommended one nearly is.
    """
    first = made[best].composite
    falling = sorted(made, reverse=True)  # in whichever order they came
    labels = {best: first.labels} | {value: made[value].composite.labels for value in falling}
    sources, twins = list(first.sources), list(range(len(first.sources)))
    aside = 0
    if axis is Axis.HORIZONTAL:
        ink = drawn_ink(made[best].drawing)
        aside = max(range(-ASIDE, ASIDE + 1), key=lambda by: (_evenness(ink, by), -abs(by)))
        for k in np.unique(np.stack(list(labels.values()))).tolist():
            exemplar, placement = sources[k].exemplar, sources[k].placement
            ink, _ = placed_ink(exemplar, placement)
            if overlap(ink, flipped(ink, aside)) < ALIKE:
                twins[k] = len(sources)
                twins.append(k)
                twin = replace(placement, flip=not placement.flip, dx=aside - placement.dx)
                sources.append(replace(sources[k], placement=twin))
    numbers = np.array(twins, np.uint8)
    return Row(first.style, axis, aside, tuple(sources), numbers, labels, pose)


def symmetric(row: Row, render: Render, plausibility: Plausibility) -> list[tuple[float, Solved]]:
    """Return symmetric results of a row by lambda_S. Runs in a worker process.

    Raises
    ------
    CancelledError
        As soon as they are no longer wanted.
    """
    posed = row.pose(row.sources)
    if row.axis is Axis.HORIZONTAL:
        cuts = list(_mirrored(row, posed, plausibility))
    else:
        posed = replace(posed, problem=replace(posed.problem, symmetry=row.axis))
        cuts = [_cut_again(row, posed)]
    found = []
    for lambda_s, labels in cuts:
        if stopped():
            raise CancelledError
        with limited(SECONDS, MEMORY):
            series, step = row.series(lambda_s), Step(lambda_s)
            solved = finished(posed, series, step, labels, render, plausibility)
        found.append((lambda_s, solved))
    return found


def _mirrored(row: Row, posed: Posed, plausibility: Plausibility) -> Iterator[tuple[float, Labels]]:
    """Yield what mirroring a half gives: of the recommended result, and what is most plausible."""
    gallery = Gallery()
    cuts: list[tuple[float, float, Labels]] = []
    for lambda_s, whole in row.labels.items():
        ink = canvas_ink(posed.problem.ink, whole)
        if stopped():
            raise CancelledError
        if _evenness(ink, row.aside) < EVEN or overlap(ink, flipped(ink, row.aside)) >= ALIKE:
            continue
        halves = [
            (worth(posed, row.sources, plausibility, labels), lambda_s, labels)
            for labels in mirrored_halves(whole, row.twins, row.aside)
            if gallery.add(canvas_ink(posed.problem.ink, labels))
        ]
        cuts += sorted(halves, key=lambda cut: -cut[0])[:1]
    recommended = next(iter(row.labels))
    cuts.sort(key=lambda cut: (cut[1] != recommended, -cut[0]))
    yield from ((lambda_s, labels) for _, lambda_s, labels in cuts[: None if row.held else TRIED])


def _evenness(ink: Bitmap, aside: int) -> float:
    """Return how far the middle of a picture overlaps its mirror image; 1 if nothing is there."""
    middle = (CANVAS + aside) // 2
    near = np.s_[:, middle - MIDDLE : middle + MIDDLE]
    here, there = ink[near], flipped(ink, aside)[near]
    return overlap(here, there) if here.any() else 1.0


def _cut_again(row: Row, posed: Posed) -> tuple[float, Labels]:
    from iconstudio.algorithms.iconification.alpha_expansion import AlphaExpansion
    from iconstudio.algorithms.iconification.block_expansion import Stopped

    lambda_s = next(iter(row.labels))
    try:
        return lambda_s, AlphaExpansion(posed.problem, stopped).solve(posed.weight(lambda_s))
    except Stopped:
        raise CancelledError from None


def _is_better(icon: Remix, other: Remix, row: Row) -> bool:
    """Return whether a symmetric result is about as plausible, and more symmetric to the eye.

    One source at places that mirror each other need not look the same there.
    """
    before, after = (_likeness(drawn_ink(one.drawing), row) for one in (other, icon))
    symmetric = after >= SYMMETRIC and after > before
    return symmetric and _plausible(icon) > row.least * _plausible(other)


def _likeness(ink: Bitmap, row: Row) -> float:
    if row.axis is Axis.HORIZONTAL:
        return overlap(ink, flipped(ink, row.aside))
    return likeness(ink, row.axis)


def _plausible(icon: Remix) -> float:
    """Return how plausible a result that shows what is inside is; if nothing judges, how good."""
    score = icon.score
    return score.total if score.plausible is None else score.plausible * score.inside
