"""Solving a remix in a worker process, one step after another (section 3.4).

The process remembers what it has found for a series, so that each step builds on those before.
"""

from collections.abc import Callable, Mapping
from concurrent.futures import CancelledError
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from time import perf_counter
from typing import TYPE_CHECKING

import numpy as np

from iconstudio.algorithms.iconification import ranking
from iconstudio.algorithms.iconification.energy import Labels, RemixProblem, canvas_ink, joined_ink
from iconstudio.algorithms.iconification.features import Remixed, features
from iconstudio.algorithms.iconification.inner_likeness import inner_likeness
from iconstudio.algorithms.iconification.looks import Looks
from iconstudio.algorithms.iconification.overhang import drawn_ink, seen
from iconstudio.algorithms.iconification.plausibility import Plausibility
from iconstudio.algorithms.iconification.redraw import SCALE, redraw
from iconstudio.algorithms.iconification.warm_start import transferred
from iconstudio.algorithms.raster import Bitmap, overlap, solid
from iconstudio.limits import limited
from iconstudio.model import (
    CANVAS,
    Axis,
    Composite,
    Drawing,
    Frame,
    Inner,
    Placement,
    Score,
    Source,
)
from iconstudio.tasks import forget, remembered, stopped
from iconstudio.workflows.drawing import MEMORY, PREVIEW, SECONDS, Render, draw

if TYPE_CHECKING:
    from iconstudio.algorithms.iconification.alpha_expansion import AlphaExpansion


@dataclass(frozen=True, eq=False)
class Posed:
    """A problem on a canvas of any side m, and what its solutions are compared with."""

    problem: RemixProblem
    silhouette: Bitmap | None = None
    """(m, m): the filled outline that is wanted, if there is one."""
    near: Bitmap | None = None
    """(m, m): where the likeness to it counts; everywhere if None."""
    inner: Inner = field(default_factory=Inner)
    """What is drawn inside it, in canvas units."""
    marked: Bitmap | None = None
    """(K, m, m): what the user wants to keep of each source; nothing if None."""
    heal: bool = True
    """Whether sources may be moved a little to meet, and seams be made anew."""

    @cached_property
    def looks(self) -> tuple[Looks, ...]:
        """Those of the sources, worked out when they are asked for."""
        finer = self.problem.side // CANVAS
        every = self.problem.ink[:, ::finer, ::finer], self.problem.solid[:, ::finer, ::finer]
        return tuple(map(Looks, *every))

    @cached_property
    def outline(self) -> Looks | None:
        """That of the silhouette."""
        finer = self.problem.side // CANVAS
        return None if self.silhouette is None else Looks(self.silhouette[::finer, ::finer])

    def kept(self, labels: Labels) -> Bitmap | None:
        """Return what is marked of its owner, (m, m), if anything is."""
        if self.marked is None:
            return None
        return joined_ink(self.marked, labels)

    def weight(self, lambda_s: float) -> float:
        """Return what the paper's lambda_S comes to on this canvas (see ``RemixProblem``)."""
        return lambda_s * self.problem.side / CANVAS


@dataclass(frozen=True, eq=False)
class CutSeries:
    """A problem to solve for several lambda_S. It goes to a worker process, so it can be pickled.

    The problem is posed there: it is many times as large as what it is made of.
    """

    style: str
    sources: tuple[Source, ...]
    pose: Callable[[], Posed]
    lambdas: tuple[float, ...]
    """In the order in which the results are wanted."""
    explored: tuple[float, ...] = ()
    """Values of lambda_S for which to look for labellings, too, as they help each other: all that
    are wanted, and more. If there are none, each wanted one is looked for by itself."""
    preview: bool = False
    """Whether a coarse result for the first lambda_S goes ahead."""
    earlier: Composite | None = None
    """A result of a similar problem, for the preview to begin with."""
    symmetry: Axis | None = None
    """What the problem holds to beside what the page says."""
    sharing: bool = False
    """Whether a good result has its ink from several sources."""

    @property
    def steps(self) -> tuple["Step", ...]:
        """What there is to do."""
        *most, last = (Step(value) for value in self.lambdas)
        finished = (*most, replace(last, last=True))
        if not self.preview:
            return finished
        return replace(finished[0], preview=True, last=False), *finished


@dataclass(frozen=True, slots=True)
class Step:
    """What to do next for a series: a coarse result, or a finished one."""

    lambda_s: float
    preview: bool = False
    last: bool = False
    """Whether the series is done after it."""


@dataclass(frozen=True, eq=False)
class Solved:
    """What a worker process answers."""

    labels: Labels
    costs: tuple[float, float]
    """Data cost and smoothness cost."""
    energy: float
    shares: tuple[float, ...]
    """Each source's part of the ink."""
    iou: float | None
    """Overlap with the silhouette, if there is one."""
    score: Score
    drawing: Drawing
    seconds: Mapping[str, float] = field(default_factory=dict)
    """To cut and to draw, by stage."""


@dataclass(eq=False)
class _SeriesState:
    """What a process keeps of a series between its steps."""

    posed: Posed
    expansion: "AlphaExpansion"
    row: tuple[float, ...]
    """What the explored lambda_S come to on the canvas."""


def solve(
    key: object,
    series: CutSeries,
    step: Step,
    render: Render,
    plausibility: Plausibility | None = None,
) -> Solved:
    """Cut, judge, redraw and trace: one result. Runs in a worker process.

    What is found is remembered under ``key`` for the other steps of the series.

    Raises
    ------
    CancelledError
        As soon as the result is no longer wanted.
    """
    from iconstudio.algorithms.iconification.block_expansion import Stopped

    began = perf_counter()
    try:
        state = remembered(key, lambda: _begin(series))
        labels = _cut(state, series, step, plausibility)
    except Stopped:
        forget(key)
        raise CancelledError from None
    if step.last:
        forget(key)
    cut = perf_counter()
    with limited(SECONDS, MEMORY):
        solved = finished(state.posed, series, step, labels, render, plausibility)
    return replace(solved, seconds={"remix": cut - began, "vectorize": perf_counter() - cut})


def finished(
    posed: Posed,
    series: CutSeries,
    step: Step,
    labels: Labels,
    render: Render,
    plausibility: Plausibility | None = None,
) -> Solved:
    """Judge, redraw and trace a labelling (m, m) that a step has come to.

    Whether it is plausible is asked of finished results alone.
    """
    problem, kept = posed.problem, posed.kept(labels)
    scale = PREVIEW if step.preview else SCALE
    drawing = draw(
        labels, problem.ink, series.sources, render, scale, kept, not step.preview, posed.heal
    )
    shares = _shares(drawing, labels, len(series.sources))
    data_cost, smoothness_cost = problem.costs(labels)
    iou, likeness = _compared(posed, drawing)
    score = replace(
        ranking.score(problem, labels, marked=kept),
        likeness=likeness,
        inside=inner_likeness(posed.inner, drawn_ink(drawing)),
    )
    sharing = ranking.evenness(shares) if series.sharing else 1.0
    plausible = None
    if plausibility is not None and not step.preview:
        found = features(remixed(posed, series.sources, labels, drawing, score))
        plausible = plausibility.of(found)
    return Solved(
        labels,
        (data_cost, smoothness_cost),
        data_cost + posed.weight(step.lambda_s) * smoothness_cost,
        shares,
        iou,
        replace(score, sharing=sharing, plausible=plausible),
        drawing,
    )


def remixed(
    posed: Posed,
    sources: tuple[Source, ...],
    labels: Labels,
    drawing: Drawing,
    score: Score,
) -> Remixed:
    """Return a labelling (m, m) and its drawing as they are judged."""
    drawn = drawn_ink(drawing)
    return Remixed(posed.problem, labels, drawn, score, sources, posed.looks, posed.outline)


def warm_up(render: Render) -> None:
    """Load what cuts and draws, and compile it if it never was, on a problem of nothing."""
    from iconstudio.algorithms.iconification.alpha_expansion import AlphaExpansion
    from iconstudio.algorithms.iconification.joined_path import joined_path

    ink = np.zeros((2, CANVAS, CANVAS), dtype=bool)
    expansion = AlphaExpansion(RemixProblem(ink.astype(np.float32), ink, ink))
    expansion.find(1.0, [1.0])
    dot = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 8 8"><path d="M2 2h4v4H2z"/></svg>'
    frame = Frame(0, 0, 8)
    drawn = render(dot, frame, Placement(), CANVAS)
    joined_path(drawn, [render.outline(dot, frame)])
    halves = np.repeat(np.arange(CANVAS) % 2 == 0, CANVAS).reshape(CANVAS, -1).astype(np.uint8)
    redraw(halves, {0: drawn, 1: np.zeros_like(drawn)})


def _begin(series: CutSeries) -> _SeriesState:
    from iconstudio.algorithms.iconification.alpha_expansion import AlphaExpansion

    posed = series.pose()
    expansion = AlphaExpansion(posed.problem, stopped)
    before = series.earlier
    if before is not None and before.labels.shape == posed.problem.data.shape[1:]:
        data = posed.problem.data
        expansion.add(transferred(before.labels, before.sources, series.sources, data))
    return _SeriesState(posed, expansion, tuple(map(posed.weight, series.explored)))


def _cut(
    state: _SeriesState, series: CutSeries, step: Step, plausibility: Plausibility | None
) -> Labels:
    """Return the labelling of a step. Only a preview depends on the result before an edit."""
    weight = state.posed.weight(step.lambda_s)
    if step.preview:
        return state.expansion.preview(weight)
    if state.row:
        chosen = None
        if plausibility is not None:
            chosen = partial(worth, state.posed, series.sources, plausibility)
        return state.expansion.find(weight, state.row, chosen)
    return state.expansion.solve(weight)


def worth(
    posed: Posed, sources: tuple[Source, ...], plausibility: Plausibility, labels: Labels
) -> float:
    """Return how plausible a labelling (m, m) is before it is drawn."""
    problem = posed.problem
    drawn = canvas_ink(problem.ink, labels)
    score = ranking.score(problem, labels, marked=posed.kept(labels))
    one = Remixed(problem, labels, drawn, score, sources, posed.looks, posed.outline)
    return plausibility.of(features(one))


def _shares(drawing: Drawing, labels: Labels, count: int) -> tuple[float, ...]:
    """Return which part of a drawing's ink each of the sources owns."""
    ink = drawing.coverage > 127
    owned = np.bincount(drawing.owned(labels)[ink], minlength=count)
    return tuple((owned / max(1, owned.sum())).tolist())


def _compared(posed: Posed, drawing: Drawing) -> tuple[float | None, float]:
    """Return overlap and likeness of a drawing with what was wanted; likeness is 1 if nothing was.

    The drawing is what the user sees: it may differ from the labelling.
    """
    if posed.silhouette is None:
        return None, 1.0
    size = len(drawing.coverage)
    filled, silhouette = (
        solid(drawing.coverage > 127),
        seen(posed.silhouette, drawing.frame, size, False),
    )
    iou = overlap(filled, silhouette)
    if posed.near is None:
        return iou, iou
    near = seen(posed.near, drawing.frame, size, False)
    return iou, overlap(filled[near], silhouette[near])
