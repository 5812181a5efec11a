"""Sketch-based pictogram modelling (section 4.1): from a rough polygon to remixed icons."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from iconstudio.algorithms import matching
from iconstudio.algorithms.energy import remix_problem
from iconstudio.algorithms.expansion import LAMBDAS
from iconstudio.algorithms.matching import SCALES, PreparedExemplar
from iconstudio.algorithms.raster import fill_polygon
from iconstudio.algorithms.saliency import salient_regions
from iconstudio.algorithms.style import STYLES, Style
from iconstudio.algorithms.tsdf import tsdf
from iconstudio.model import IconstudioError, Placement, Sketch, Source
from iconstudio.workers import Workers
from iconstudio.workflows.events import Event, RegionsFound, StyleMatched, StyleSkipped, staged
from iconstudio.workflows.remixing import Job, Remixing, Render

FEWEST = 4
"""A style with fewer exemplars is skipped: all its regions would keep the same three."""
FEW = 8
UNLIKE = 1.25
"""A style with fewer than FEW exemplars is skipped too if none of them resembles the sketch: if the
least errors of equation 4, averaged over the regions, exceed UNLIKE. Chosen by eye over the styles
of some forty sketches: those that it skips were beyond recognition."""


@dataclass(frozen=True, slots=True)
class ModelSettings:
    """Parameters of sketch-based modelling."""

    styles: tuple[str, ...] = tuple(style.name for style in STYLES)
    lambdas: tuple[float, ...] = LAMBDAS
    """Values of lambda_S, in any order."""
    scales: tuple[float, ...] = SCALES

    def chosen_styles(self) -> tuple[Style, ...]:
        """Return the styles named, in the paper's order.

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
        return tuple(style for style in STYLES if style.name in self.styles)


def model(
    sketch: Sketch,
    exemplars: Sequence[PreparedExemplar],
    settings: ModelSettings,
    workers: Workers,
    render: Render,
) -> Iterator[Event]:
    """Remix ``exemplars`` in the shape of a sketch, in every style and for every lambda_S.

    Yields ``RegionsFound``, then for each style ``StyleMatched`` or ``StyleSkipped``, and each
    ``Result`` as it is ready, from the highest lambda_S of a style down. Closing the generator
    cancels what is left.

    Parameters
    ----------
    exemplars
        Prepared with ``settings.scales``.
    render
        Draws a source at its placement; must be picklable.
    """
    styles = settings.chosen_styles()
    polygon = sketch.polygon.fitted()
    target = fill_polygon(polygon)
    field = tsdf(target)
    regions = salient_regions(polygon)
    yield RegionsFound(tuple(region.centre for region in regions))
    hits = yield from staged(
        "match", "Matching parts", matching.coarse_search(field, regions, exemplars)
    )
    remixing = Remixing(workers, render, total=len(styles) * len(settings.lambdas))
    try:
        for style in styles:
            admitted = [i for i, e in enumerate(exemplars) if style.admits(e.blackness)]
            if len(admitted) < FEWEST:
                remixing.expect_fewer(len(settings.lambdas))
                yield StyleSkipped(style.name, len(admitted), _too_few(style, len(admitted)))
                continue
            matches = matching.refine(field, regions, exemplars, hits, admitted)
            rows = matching.sources_of(matches, exemplars)
            if len(admitted) < FEW and _least_error(rows) > UNLIKE:
                remixing.expect_fewer(len(settings.lambdas))
                yield StyleSkipped(style.name, len(admitted), _unlike(style, len(admitted)))
                continue
            admissible = tuple(exemplars[i].exemplar for i in admitted)
            yield StyleMatched(style.name, admissible, rows)
            sources = distinct(rows)
            problem = remix_problem(field, sources)
            remixing.start(Job(style.name, sources, problem, settings.lambdas, target))
            yield from remixing.ready()
        while remixing.busy:
            yield from remixing.ready(timeout=0.1)
    finally:
        remixing.cancel()


def distinct(rows: Sequence[Sequence[Source]]) -> tuple[Source, ...]:
    """Return the sources of all regions; the same exemplar at the same placement only once."""
    found: dict[tuple[str, Placement], Source] = {}
    for row in rows:
        for source in row:
            found.setdefault((source.exemplar.id, source.placement), source)
    return tuple(found.values())


def _least_error(rows: Sequence[Sequence[Source]]) -> float:
    """Return the least error of each region, averaged."""
    return sum(row[0].error for row in rows) / len(rows)


def _unlike(style: Style, count: int) -> str:
    return (
        f"The collection has only {count} icons of this keyword in the style {style.name}, "
        "and none resembles the sketch."
    )


def _too_few(style: Style, count: int) -> str:
    icons = "1 icon" if count == 1 else f"{count or 'no'} icons"
    return (
        f"The collection has {icons} of this keyword in the style {style.name}; "
        f"at least {FEWEST} are needed."
    )
