"""Examples of plausible and implausible pictures, made of the results of sketches."""

from collections.abc import Generator, Iterable, Iterator, Mapping
from dataclasses import replace
from zlib import crc32

import numpy as np

from iconstudio.algorithms.iconification import ranking
from iconstudio.algorithms.iconification.energy import Labels
from iconstudio.algorithms.iconification.features import features
from iconstudio.building.plausibility.degrading import cheapest, degraded
from iconstudio.building.plausibility.judged import Cell, Example, JudgedSketch
from iconstudio.model import CANVAS, Remix, Source
from iconstudio.model.progress import Progress
from iconstudio.workflows.drawing import PREVIEW, Render, draw
from iconstudio.workflows.events import Result
from iconstudio.workflows.grid import GridSettings
from iconstudio.workflows.modelling.modelling import pose_sketch, run
from iconstudio.workflows.modelling.variety import JOINED, joined_pairs
from iconstudio.workflows.remixing import RemixResources
from iconstudio.workflows.solving import Posed, remixed

DROPPED = 4
"""Of the results of a style, every so many is made worse."""
ONE = 0.85
"""A result of which one source has at least this part is as plausible as that source."""


def examples(
    resources: RemixResources,
    sketches: Iterable[JudgedSketch],
    grades: Mapping[Cell, int],
) -> Generator[Progress | Example]:
    """Run sketches, and yield examples of all kinds, and the progress."""
    some = tuple(sketches)
    for done, sketch in enumerate(some):
        yield Progress("prepare", done / len(some), sketch.name)
        icons = [
            event.icon
            for event in run(resources, sketch.sketch, GridSettings(variants=False))
            if isinstance(event, Result) and isinstance(event.icon, Remix) and not event.preview
        ]
        yield from examples_of(sketch, icons, grades, resources.render)


def examples_of(
    sketch: JudgedSketch, icons: Iterable[Remix], grades: Mapping[Cell, int], render: Render
) -> Iterator[Example]:
    """Yield the examples that the results of a sketch give."""
    fitted = replace(sketch.sketch.fitted(), symmetry=None)
    styles: dict[str, list[Remix]] = {}
    for icon in icons:
        styles.setdefault(icon.composite.style, []).append(icon)
    for style, row in sorted(styles.items()):  # they come in any order
        random = np.random.default_rng(crc32(f"{sketch.name} {style}".encode()))
        sources = row[0].composite.sources

        def example(kind: str, grade: int, found: dict[str, float]) -> Example:
            return Example(sketch.name, kind, grade, found, sketch.held_out)

        posed = pose_sketch(fitted, CANVAS, (), sources)
        for k, source in enumerate(sources):
            if source.region < 0:
                labels = np.full((CANVAS, CANVAS), k, np.uint8)
                yield example("whole", 1, _measured(posed, sources, labels, render))
        for number, icon in enumerate(sorted(row, key=lambda one: -one.composite.lambda_s)):
            composite = icon.composite
            found = features(remixed(posed, sources, composite.labels, icon.drawing, icon.score))
            grade = grades.get((sketch.name, style, round(composite.lambda_s, 4), ""))
            if grade is not None:
                yield example("judged", grade, found)
            elif max(composite.shares) >= ONE:
                yield example("one", 1, found)
            if number % DROPPED == 0:
                for bad in degraded(composite.labels, posed.problem.ink, sources, random):
                    own = posed
                    if bad.sources != sources:
                        own = pose_sketch(fitted, CANVAS, (), bad.sources)
                    yield example(bad.kind, 0, _measured(own, bad.sources, bad.labels, render))
        for bad in cheapest(posed.problem.data, sources):
            yield example(bad.kind, 0, _measured(posed, bad.sources, bad.labels, render))
        for labels, pair in _pairs(posed, sources):
            grade = grades.get((sketch.name, style, round(JOINED, 4), pair))
            if grade is not None:
                yield example("judged", grade, _measured(posed, sources, labels, render))


def _pairs(posed: Posed, sources: tuple[Source, ...]) -> Iterator[tuple[Labels, str]]:
    """Yield labellings (m, m) of two sources, and the numbers of these."""
    from iconstudio.algorithms.iconification.alpha_expansion import AlphaExpansion

    for cut in joined_pairs(posed, sources, AlphaExpansion(posed.problem)):
        yield cut.labels, " ".join(map(str, np.unique(cut.labels)))


def _measured(
    posed: Posed, sources: tuple[Source, ...], labels: np.ndarray, render: Render
) -> dict[str, float]:
    drawing = draw(labels, posed.problem.ink, sources, render, PREVIEW, exact=False)
    score = ranking.score(posed.problem, labels)
    return features(remixed(posed, sources, labels, drawing, score))
