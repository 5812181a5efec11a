"""Remixing in every style and for every lambda_S (sections 3.3 to 3.5): modelling and editing."""

import math
from collections.abc import Callable, Generator, Sequence, Set
from contextlib import closing
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.guide import UNGUIDED, Guide
from iconstudio.algorithms.iconification.matching import (
    SCALES,
    Matcher,
    sources_of,
)
from iconstudio.algorithms.iconification.plausibility import Plausibility
from iconstudio.algorithms.iconification.saliency import WHOLE, Region
from iconstudio.algorithms.iconification.style import STYLES, Style, blackness
from iconstudio.model import Composite, Exemplar, IconstudioError, Inner, Placement, Remix, Source
from iconstudio.workers import Workers
from iconstudio.workflows.drawing import Render
from iconstudio.workflows.events import (
    Event,
    RegionsFound,
    Remark,
    Result,
    StyleMatched,
    StyleSkipped,
    staged,
)
from iconstudio.workflows.recommending import Recommending
from iconstudio.workflows.remixing import CutSettings, Finish, Remixing, RemixResources
from iconstudio.workflows.solving import CutSeries, Posed

LAMBDAS = tuple(float(v) for v in np.geomspace(0.03, 0.75, 8))
"""The values of lambda_S that are tried on the paper's canvas (section 3.4)."""

ENOUGH = 8
"""With fewer exemplars of a style, those that are less alike serve, too."""

SHOWN = 0.6
"""What shows more of what was drawn inside has it."""

Matches = tuple[tuple[Source, ...], ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class GridSettings(CutSettings):
    """Which results to make, and at which scales to try the exemplars."""

    styles: tuple[str, ...] = tuple(style.name for style in STYLES)
    lambdas: tuple[float, ...] = LAMBDAS
    """Values of lambda_S, in any order."""
    scales: tuple[float, ...] = SCALES
    focus: tuple[str, float] | None = None
    """Style and lambda_S of the result that is wanted first; then come others of its style."""
    previews: bool = False
    """Whether coarse results go ahead of the finished ones, for whoever waits."""
    variants: bool = True
    """Whether symmetric results are made, too, of an outline that is nearly so, and others in the
    places of near-copies."""

    @property
    def explored(self) -> tuple[float, ...]:
        """The values of lambda_S that are searched: more than are asked for, as each helps all."""
        return tuple(sorted({*self.lambdas, *LAMBDAS}))

    @property
    def wanted_lambdas(self) -> tuple[float, ...]:
        """The values of lambda_S from the one in focus outwards; without focus, falling."""
        if self.focus is None:
            return tuple(sorted(self.lambdas, reverse=True))
        centre = math.log(max(self.focus[1], 1e-9))
        return tuple(sorted(self.lambdas, key=lambda v: abs(math.log(max(v, 1e-9)) - centre)))

    def chosen_styles(self) -> tuple[Style, ...]:
        """Return the styles named, in the paper's order, that in focus first.

        Raises
        ------
        IconstudioError
            If a name is unknown.
        """
        known = {style.name: style for style in STYLES}
        for name in self.styles:
            if name not in known:
                raise IconstudioError(
                    f"There is no style {name!r}. The styles are {', '.join(known)}."
                )
        first = self.focus[0] if self.focus else ""
        chosen = (style for style in STYLES if style.name in self.styles)
        return tuple(sorted(chosen, key=lambda style: style.name != first))


@dataclass(frozen=True, slots=True, kw_only=True)
class GridTask:
    """The outline that results shall have, what they are made of, and how."""

    field: NDArray[np.float32]
    """D_P, the TSDF of the outline, (CANVAS, CANVAS)."""
    regions: Sequence[Region]
    """Its salient regions, for each of which exemplars are matched."""
    details: Sequence[Region] = ()
    """Small ones beside them. Whether a style resembles the outline is not told by them."""
    guide: Guide = UNGUIDED
    """What counts beside the outline when exemplars are matched."""
    refusal: Callable[[Style, int, Matches | None], str]
    """Says why a style with so many exemplars should be skipped, or nothing; asked before
    matching without matches, and again with those of ``regions``."""
    pose: Callable[[tuple[Source, ...]], Posed]
    """Makes of a style's sources the problem that is to be solved; must be picklable."""
    unmet: str
    """Says that recommended results show no more than a share, ``{:.0%}``, of what was drawn
    inside."""
    finish: Finish = lambda icon: icon
    """What to add to each icon."""
    always: tuple[Source, ...] = ()
    """Sources that every style has, before those that are matched."""
    fitting: Callable[[Sequence[Exemplar]], Matches] = lambda exemplars: ()
    """Returns more sources of a style, made of the exemplars that it admits: a row for each part
    that one of them could be as a whole."""
    whole: bool = False
    """Whether nothing else is joined if there are some for each part."""
    alone: bool = False
    """Whether a source by itself is as good a result as a remix."""
    pinned: tuple[Source, ...] = ()
    """More sources, each of the styles that admit it."""
    include: Set[str] = frozenset()
    """Identifiers of strangers that are used as the other exemplars are."""
    without: Set[str] = frozenset()
    """Identifiers of exemplars that are left out."""

    def sources(self, style: Style, matched: StyleMatched) -> tuple[Source, ...]:
        """Return the sources of a style: those it always has first, pinned ones last."""
        own = [one for one in self.pinned if style.admits(blackness(one.exemplar.ink))]
        fitted = self.fitting(matched.exemplars)
        enough = self.whole and fitted and all(fitted)
        others = () if enough else (*matched.matches, matched.whole)
        return (*self.always, *distinct((*others, *fitted, own)))


def remix_styles(
    task: GridTask,
    matcher: Matcher,
    settings: GridSettings,
    workers: Workers,
    render: Render,
    earlier: Composite | None = None,
    plausibility: Plausibility | None = None,
) -> Generator[Event]:
    """Match exemplars to the salient regions of an outline, and remix them in every style.

    Yields ``RegionsFound``, then for each style ``StyleMatched`` or ``StyleSkipped``, each
    ``Result`` as it is ready, and then the style's ``Recommended``. Results come from the highest
    lambda_S of a style down, or from ``settings.focus`` outwards. Closing the generator cancels
    what is left.

    Parameters
    ----------
    matcher
        Exemplars prepared with ``settings.scales``.
    render
        Draws a source at its placement; must be picklable.
    earlier
        A result of a similar run, for the preview to begin with.
    plausibility
        What judges results, if anything does.
    """
    styles, count = settings.chosen_styles(), len(settings.lambdas)
    regions = (*task.regions, *task.details)
    yield RegionsFound(tuple(region.centre for region in regions), len(task.details))
    remixing = Remixing(workers, render, len(styles) * count, plausibility)
    recommending = Recommending(count, task.alone)
    preview = settings.previews
    try:
        for style in styles:
            matched = yield from _matched(style, matcher, task)
            if matched is None:
                remixing.expect_fewer(count)
                continue
            sources = task.sources(style, matched)
            series = CutSeries(
                style.name,
                sources,
                partial(task.pose, sources),
                settings.wanted_lambdas,
                settings.explored,
                preview,
                earlier if preview and earlier and earlier.style == style.name else None,
            )
            preview = False
            remixing.start(series, task.finish)
            yield from recommending.after(remixing.ready())
        while remixing.busy:
            yield from recommending.after(remixing.ready(wanted=True))
        inside = recommending.inside
        if task.guide.inner != Inner() and inside is not None and inside < SHOWN:
            yield Remark(task.unmet.format(inside))
    finally:
        remixing.cancel()


def _matched(
    style: Style, matcher: Matcher, task: GridTask
) -> Generator[Event, None, StyleMatched | None]:
    """Return the matches of a style; None if it is skipped.

    Yields progress, and then ``StyleMatched`` or ``StyleSkipped``.
    """
    exemplars, count = matcher.exemplars, len(task.regions)
    admitted = admitted_to(style, matcher, task.include, task.without)
    reason = task.refusal(style, len(admitted), None)
    if not reason:
        regions = (*task.regions, *task.details, WHOLE)
        matching = matcher.match(task.field, regions, admitted, task.guide)
        found = yield from staged("match", "Matching parts", matching)
        *rows, whole = sources_of(found, exemplars)
        reason = task.refusal(style, len(admitted), tuple(rows[:count]))
    if reason:
        yield StyleSkipped(style.name, len(admitted), reason)
        return None
    chosen = tuple(exemplars[number].exemplar for number in admitted)
    best = tuple(replace(source, region=-1) for source in whole)
    matched = StyleMatched(style.name, chosen, tuple(rows), best)
    yield matched
    return matched


def admitted_to(
    style: Style, matcher: Matcher, include: Set[str] = frozenset(), without: Set[str] = frozenset()
) -> list[int]:
    """Return the numbers of the exemplars that a style may use.

    Strangers serve only if there are fewer than ``ENOUGH`` others. The parameters are those of
    ``GridTask``.
    """
    every = [
        number
        for number, one in enumerate(matcher.exemplars)
        if style.admits(one.blackness) and one.exemplar.id not in without
    ]
    strangers = matcher.strangers - include
    alike = [number for number in every if matcher.exemplars[number].exemplar.id not in strangers]
    return alike if len(alike) >= ENOUGH else every


def focused(
    resources: RemixResources, subject: str, events: Generator[Event], settings: GridSettings
) -> Generator[Event]:
    """Pass on a run, and keep its result in focus: the next run of that subject begins with it."""
    with closing(events):
        for event in events:
            match event:
                case Result(icon=Remix(composite=one)) if one.symmetry is None:
                    if (one.style, one.lambda_s) == settings.focus:
                        resources.earlier.clear()
                        resources.earlier[subject] = one
            yield event


def distinct(rows: Sequence[Sequence[Source]]) -> tuple[Source, ...]:
    """Return the sources of all regions; the same exemplar at the same placement only once."""
    found: dict[tuple[str, Placement], Source] = {}
    for row in rows:
        for source in row:
            found.setdefault((source.exemplar.id, source.placement), source)
    return tuple(found.values())
