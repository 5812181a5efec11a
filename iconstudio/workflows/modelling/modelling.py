"""Sketch-based pictogram modelling (section 4.1): from a rough polygon to remixed icons."""

import math
from collections.abc import Generator
from dataclasses import replace
from functools import partial

from iconstudio.algorithms.iconification.energy import distance_field, remix_problem
from iconstudio.algorithms.iconification.guide import check_inner, guide_of
from iconstudio.algorithms.iconification.matching import Matcher
from iconstudio.algorithms.iconification.plausibility import Plausibility
from iconstudio.algorithms.iconification.saliency import (
    SMALL,
    Region,
    saliency,
    salient_regions,
)
from iconstudio.algorithms.iconification.style import Style
from iconstudio.algorithms.iconification.symmetry import ROUGHLY, propose
from iconstudio.algorithms.iconification.tsdf import tsdf
from iconstudio.algorithms.raster import fill_polygon
from iconstudio.grammar import counted
from iconstudio.model import Axis, Composite, Sketch, Source
from iconstudio.workers import Workers
from iconstudio.workflows.drawing import Render
from iconstudio.workflows.events import Event, Remark
from iconstudio.workflows.grid import GridSettings, GridTask, Matches, focused, remix_styles
from iconstudio.workflows.modelling.best import with_best
from iconstudio.workflows.modelling.symmetric import with_symmetric
from iconstudio.workflows.modelling.variety import with_variety
from iconstudio.workflows.pinning import (
    PinnedPart,
    idle_pins,
    pinned_parts,
    pinning,
    pins_of_other_styles,
)
from iconstudio.workflows.remixing import RemixResources
from iconstudio.workflows.solving import Posed

FEWEST = 4
"""A style with fewer exemplars is skipped: all its regions would keep the same three."""
FEW = 8
DETAILS = 6
"""Small regions of a sketch whose details are weighted by 1."""
_UNMET = (
    "None of the recommended results shows all that you drew inside the outline, {:.0%} at most: "
    "the icons have little of it there. Look through their rows, or draw it where an icon has it."
)
UNLIKE = 1.25
"""A style with fewer than FEW exemplars is skipped too if none of them resembles the sketch: if the
least errors of equation 4, averaged over the regions, exceed UNLIKE. Chosen by eye over the styles
of some forty sketches: those that it skips were beyond recognition."""


def run(
    resources: RemixResources, sketch: Sketch, settings: GridSettings | None = None
) -> Generator[Event]:
    """Retrieve the icons of a sketch's keyword, and remix them in its shape: see ``model``.

    Raises
    ------
    IconstudioError
        If the polygon or the keyword is no good; before any work is done.
    """
    settings = settings or GridSettings()
    styles = settings.chosen_styles()
    fitted_sketch(sketch)
    matcher = yield from resources.prepare(sketch.keyword, sketch.exclude, settings.scales)
    if idle := idle_pins(sketch):
        yield Remark(idle)
    pins = pinned_parts(sketch, resources.exemplar)
    if unheeded := pins_of_other_styles(pins, styles):
        yield Remark(unheeded)
    events = model(
        sketch,
        matcher,
        settings,
        resources.workers,
        resources.render,
        resources.earlier.get("sketch"),
        pins,
        resources.plausibility,
    )
    yield from focused(resources, "sketch", events, settings)


def model(
    sketch: Sketch,
    matcher: Matcher,
    settings: GridSettings,
    workers: Workers,
    render: Render,
    earlier: Composite | None = None,
    pins: tuple[PinnedPart, ...] = (),
    plausibility: Plausibility | None = None,
) -> Generator[Event]:
    """Remix the exemplars of ``matcher`` in the shape of a sketch, for every style and lambda_S.

    The parts in ``pins`` belong to their sources, in the styles of their icons. The events, and the
    other parameters, are those of ``grid.remix_styles``.
    """
    fitted = sketch.fitted()
    silhouette = fill_polygon(fitted.polygon)
    pose = partial(pose_sketch, fitted, settings.side, pins)
    task = GridTask(
        field=tsdf(silhouette),
        regions=salient_regions(saliency([fitted.polygon], silhouette)),
        details=details_of(fitted),
        guide=guide_of(fitted),
        refusal=refusal,
        pose=pose,
        unmet=_UNMET,
        pinned=tuple(pin.source for pin in pins),
        include=sketch.include,
    )
    events = remix_styles(task, matcher, settings, workers, render, earlier, plausibility)
    if pins or not settings.variants:  # what is pinned says what the user wants
        yield from events
        return
    held = sketch.symmetry is Axis.HORIZONTAL  # about others, all was cut so already
    axis = propose(silhouette, ROUGHLY) if sketch.symmetry is None else None
    axis = Axis.HORIZONTAL if held else axis
    events = with_variety(events, pose, workers, render, plausibility)
    yield from with_best(with_symmetric(events, axis, pose, workers, render, plausibility, held))


def fitted_sketch(sketch: Sketch) -> Sketch:
    """Return a sketch on the canvas, all of which makes sense.

    Raises
    ------
    IconstudioError
        If it does not; a sentence for the user.
    """
    fitted = sketch.fitted()
    check_inner(fitted.inner, fill_polygon(fitted.polygon))
    return fitted


def details_of(sketch: Sketch) -> tuple[Region, ...]:
    """Return small salient regions of a fitted sketch, the more the higher its weight of details.

    An addition to the paper, as it wishes for (section 6).
    """
    count = math.ceil(DETAILS * sketch.detail)
    if not count:
        return ()
    score = saliency([sketch.polygon], fill_polygon(sketch.polygon), extent=SMALL)
    return salient_regions(score, count, SMALL)


def pose_sketch(
    sketch: Sketch, side: int, pins: tuple[PinnedPart, ...], sources: tuple[Source, ...]
) -> Posed:
    """Pose the problem of joining sources in the shape of a fitted sketch, on a canvas of m."""
    silhouette = fill_polygon(sketch.polygon, side)
    problem = remix_problem(distance_field(silhouette), sources, sketch.symmetry)
    problem = replace(problem, data=guide_of(sketch, side).guided(problem))
    return replace(pinning(problem, sources, silhouette, pins), inner=sketch.inner)


def refusal(style: Style, count: int, rows: Matches | None) -> str:
    """Say why a style with ``count`` exemplars, and these matches, would give no good result."""
    if count < FEWEST:
        icons = counted(count, "icon") if count else "no icons"
        return (
            f"The collection has {icons} of this keyword in the style {style.name}; "
            f"at least {FEWEST} are needed."
        )
    if count < FEW and rows and _least_error(rows) > UNLIKE:
        return (
            f"The collection has only {counted(count, 'icon')} of this keyword in the style "
            f"{style.name}, and none resembles the sketch."
        )
    return ""


def _least_error(rows: Matches) -> float:
    """Return the least error of each region, averaged."""
    return sum(row[0].error for row in rows) / len(rows)
