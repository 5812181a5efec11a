"""Sketch-based pictogram editing (section 4.2): one part of an icon is changed, the rest stays."""

from collections.abc import Generator
from dataclasses import replace
from functools import partial

from iconstudio.algorithms.iconification.matching import Matcher
from iconstudio.algorithms.iconification.plausibility import Plausibility
from iconstudio.algorithms.iconification.saliency import saliency, salient_regions
from iconstudio.algorithms.iconification.style import STYLES, Style, blackness
from iconstudio.algorithms.iconification.tsdf import tsdf
from iconstudio.algorithms.raster import outlines
from iconstudio.model import (
    CANVAS,
    Composite,
    Edit,
    Exemplar,
    Inner,
    Remix,
    Source,
)
from iconstudio.workers import Workers, answer
from iconstudio.workflows.drawing import Render, draw_whole
from iconstudio.workflows.editing.additions import doubts, judged, with_missed
from iconstudio.workflows.editing.fitting import fitted
from iconstudio.workflows.editing.lookalikes import lookalikes, names_part
from iconstudio.workflows.editing.opened import OPENED, is_opened
from iconstudio.workflows.editing.placing import PlacedEdit, paper, place_edited
from iconstudio.workflows.events import Event, Remark
from iconstudio.workflows.grid import GridSettings, GridTask, Matches, focused, remix_styles
from iconstudio.workflows.remixing import RemixResources

_UNMET = (
    "None of the recommended results shows all that you drew inside the outline, {:.0%} at most: "
    "other icons have little of it there, and where they have not, the icon stays as it is. Draw "
    "it where one of them has it, or try another keyword."
)


def own_styles(icon: Exemplar) -> tuple[str, ...]:
    """Return the styles that an icon belongs to: parts of other styles would not suit it."""
    return tuple(style.name for style in STYLES if style.admits(blackness(icon.ink)))


def run(
    resources: RemixResources, edit: Edit, settings: GridSettings | None = None
) -> Generator[Event]:
    """Retrieve the icons of an edit's keyword, and remix its icon with them: see ``edit_icon``.

    Without settings, in the styles that the icon belongs to.

    Raises
    ------
    IconstudioError
        If the edit or the keyword is no good; before any work is done.
    """
    icon = resources.exemplar(edit.icon)
    change = place_edited(edit, icon, resources.workers, resources.render)
    yield from map(Remark, doubts(change.base.placement, change.enclosed))
    if not edit.inner.lines and is_opened(change.ink, change.left, change.added):
        yield Remark(OPENED)
    settings = settings or GridSettings(styles=own_styles(icon))
    settings.chosen_styles()
    matcher = yield from resources.prepare(edit.keyword, edit.exclude, settings.scales)
    events = edit_icon(
        change,
        matcher,
        settings,
        resources.workers,
        resources.render,
        resources.earlier.get(edit.icon.id),
        resources.plausibility,
    )
    yield from focused(resources, edit.icon.id, events, settings)


def edit_icon(
    change: PlacedEdit,
    matcher: Matcher,
    settings: GridSettings,
    workers: Workers,
    render: Render,
    earlier: Composite | None = None,
    plausibility: Plausibility | None = None,
) -> Generator[Event]:
    """Remix an icon with parts of the exemplars of ``matcher`` where it is to be changed.

    ``change`` is the edit on the canvas, by ``place_edit``. The events, and the other
    parameters, are those of ``grid.remix_styles``. The icon itself, and other files of the same
    drawing, are left out of matching.
    """
    edit = change.edit
    score = saliency(outlines(change.silhouette), change.silhouette, change.mask)
    posed = change if settings.side == CANVAS else change.at(settings.side)
    before = Source(change.icon, change.base.placement)  # what results are compared with
    own = draw_whole(before, change.ink, workers, render)
    wanted = change.wanted

    def finish(icon: Remix) -> Remix:
        drawn = answer(own, f"Drawing “{edit.icon.name}”")
        icon = replace(icon, unchanged=change.unchanged(icon.drawing, drawn))
        return judged(icon, wanted)

    same = lookalikes(change.icon, matcher)
    areas = change.areas if names_part(change.icon, matcher) else ()
    outside = [one for number, one in enumerate(areas, 1) if number not in change.enclosed]
    task = GridTask(
        field=tsdf(change.silhouette),
        regions=salient_regions(score),
        guide=change.guide,
        refusal=_refusal,
        pose=partial(posed.pose, edit.symmetry),
        unmet=_UNMET,
        fitting=partial(fitted, areas, change.ink),
        whole=not change.left.any() and edit.inner == Inner(),
        finish=finish,
        always=(change.base, paper(change.base)) if change.left.any() else (change.base,),
        alone=change.emptied is not None,
        include=edit.include,
        without=same,
    )
    events = remix_styles(task, matcher, settings, workers, render, earlier, plausibility)
    try:
        yield from with_missed(events, wanted, outside, edit.keyword)
    finally:
        own.cancel()


def _refusal(style: Style, count: int, rows: Matches | None) -> str:
    if count:
        return ""
    return f"The collection has no other icon of this keyword in the style {style.name}."
