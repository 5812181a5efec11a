"""Patterns of an exemplar (*Example-Based Art Pattern Synthesis Using Level Sets*)."""

from collections.abc import Generator
from dataclasses import dataclass, replace
from functools import partial
from itertools import chain
from pathlib import Path

from iconstudio.model import (
    CANVAS,
    ColouredLayer,
    Fill,
    IconstudioError,
    Patterned,
    Patterning,
    Pictogram,
    Transform,
)
from iconstudio.model import Path as Outline
from iconstudio.workflows.events import Event, Progress, Remark, Result
from iconstudio.workflows.pattern.drawing import SAMPLES, Drawn, Source, draw
from iconstudio.workflows.pattern.filling import fitted
from iconstudio.workflows.pattern.imaging import ImageExemplar, check_size
from iconstudio.workflows.pattern.layout import Arrangement
from iconstudio.workflows.pattern.seeds import with_seeds
from iconstudio.workflows.previewing import Answer, answers
from iconstudio.workflows.workflow import Resources

_NAMED = 3
"""So many icons a title names."""
MOST_SAMPLES = 2048 * 2048
_SECONDS_A_SAMPLE, _BYTES_A_SAMPLE = 2.5e-5, 600
SECONDS, MEMORY = 600.0, 6 << 30


@dataclass(frozen=True, slots=True, kw_only=True)
class PatternSettings:
    """Which results to make."""

    seeds: int = 1
    """How many patterns: that of the wanted seed, and of those that follow it."""
    previews: bool = False
    """Whether coarse results come first."""


def run(
    resources: Resources, work: Patterning, settings: PatternSettings | None = None
) -> Generator[Event]:
    """Continue an exemplar: yield the pattern that is wanted, and those of other seeds.

    Raises
    ------
    IconstudioError
        If there is no exemplar, or the pattern would be too small or too large.
    """
    settings = settings or PatternSettings()
    yield Progress("pattern", 0.0, "Reading the exemplar")
    size = samples(work)
    source = _source(resources, work)
    fill = None if work.fill is None else fitted(_outline(resources, work.fill), size)
    ticket = resources.workers.ticket()
    try:
        submit = partial(
            resources.workers.submit, draw, source, fill, size, work.tile and fill is None,
            timeout=SECONDS, memory=MEMORY, ticket=ticket,
        )  # fmt: skip
        wanted = with_seeds(work, settings.seeds)
        coarse = submit(work.seed, True) if settings.previews else None
        tasks = [submit(one.seed, False) for one in wanted]
        doing, advice = "Continuing the exemplar", "Ask for a smaller pattern."
        for event in answers(tasks, coarse, "pattern", doing, advice):
            if not isinstance(event, Answer):
                yield event
                continue
            one, drawn = wanted[event.number], event.value
            if not event.preview:
                if drawn.remark and event.number == 0:
                    yield Remark(drawn.remark)
                _check(one, drawn)
            yield Result(icon_of(one, drawn, fill), preview=event.preview)
    finally:
        ticket.stop()


def samples(work: Patterning) -> tuple[int, int]:
    """Return the rows and columns in which a pattern is synthesised.

    Raises
    ------
    IconstudioError
        If that is too few, or too many.
    """
    rows, columns = (
        max(16, round(side * SAMPLES / work.scale)) for side in (work.height, work.width)
    )
    if rows * columns > MOST_SAMPLES:
        minutes = rows * columns * _SECONDS_A_SAMPLE / 60
        memory = rows * columns * _BYTES_A_SAMPLE / 2**30
        raise IconstudioError(
            f"A pattern of {work.width} x {work.height} would take about {minutes:.0f} minutes "
            f"and {memory:.0f} GiB of memory. Make a smaller one that tiles, and repeat it, "
            "or scale its elements up."
        )
    return rows, columns


def check(work: Patterning) -> None:
    """Refuse work without an exemplar, or with one that is too small.

    Raises
    ------
    IconstudioError
        If it is so.
    """
    if work.image is not None:
        check_size(work.image.photo)
    elif not work.motifs:
        raise IconstudioError(
            "There is no exemplar yet. Put icons on its canvas (motifs), or open an image."
        )


def icon_of(work: Patterning, drawn: Drawn, fill: Outline | None) -> Patterned:
    """Return a pattern as a result; ``fill`` is in its samples."""
    rows, columns = drawn.size
    own = Transform().scale(work.width / columns, work.height / rows)
    inked = layers = tuple(_transformed(one, own) for one in drawn.layers)
    if fill is not None and drawn.ground:
        behind = ColouredLayer("ground", (Fill(fill, drawn.ground),))
        layers = (_transformed(behind, own), *inked)
    canvas = Transform().scale(CANVAS / max(work.width, work.height))
    ink = (_transformed(one, canvas).fills for one in inked)
    icons = [*_icons(work), *([work.fill] if work.fill else [])]
    return Patterned(
        Outline(tuple(chain.from_iterable(one.path.contours for one in chain(*ink)))),
        _title(work),
        tuple(dict.fromkeys(chain.from_iterable(icon.origins for icon in icons))),
        layers=layers,
        ground=drawn.ground if fill is None else "",
        width=work.width,
        height=work.height,
        tile=work.tile and fill is None,
        torn=drawn.torn,
    )


def _check(work: Patterning, drawn: Drawn) -> None:
    if any(layer.fills for layer in drawn.layers):
        return
    where = "that shape in a pattern" if work.fill else "a pattern"
    raise IconstudioError(
        f"Nothing of the exemplar fits whole into {where} of {work.width} x {work.height}. Make "
        "the pattern larger (width and height), or its scale smaller. What the exemplar's border "
        "cuts never fits: move it inside."
    )


def _transformed(layer: ColouredLayer, transform: Transform) -> ColouredLayer:
    fills = (replace(one, path=one.path.transformed(transform)) for one in layer.fills)
    return replace(layer, fills=tuple(fills))


def _source(resources: Resources, work: Patterning) -> Source:
    check(work)
    if work.image is not None:
        return ImageExemplar.of(work.image, transparent=not work.ground)
    paths = {icon: _outline(resources, icon) for icon in dict.fromkeys(_icons(work))}
    return Arrangement.of(work, [paths[one.icon] for one in work.motifs])


def _title(work: Patterning) -> str:
    if work.image is not None:
        return f"pattern of {Path(work.image.photo.path).stem or 'an image'}"
    subjects = list(dict.fromkeys(one.icon.credit.title for one in work.motifs))
    more = [f"{len(subjects) - _NAMED} more"] if len(subjects) > _NAMED else []
    return f"pattern of {', '.join([*subjects[:_NAMED], *more])}"


def _icons(work: Patterning) -> tuple[Pictogram, ...]:
    if work.image is not None:
        return work.image.credits
    return tuple(one.icon for one in work.motifs)


def _outline(resources: Resources, icon: Pictogram) -> Outline:
    return resources.drawing(resources.exemplar(icon)).path
