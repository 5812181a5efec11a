"""What could stand in the place of a part of a sketch's result.

An addition to the paper, whose users take a result as it is.
"""

from collections.abc import Generator, Sequence
from dataclasses import dataclass, replace
from functools import partial

import scipy

from iconstudio.algorithms.raster import Bitmap, overlap, placed_ink
from iconstudio.model import Composite, Remix, Sketch
from iconstudio.workflows.events import Event, Result
from iconstudio.workflows.modelling.modelling import pose_sketch
from iconstudio.workflows.montage.exchanging import exchanged
from iconstudio.workflows.montage.montage import check, framed, series_of
from iconstudio.workflows.montage.reproducing import strokes_over
from iconstudio.workflows.parts import Part
from iconstudio.workflows.pinning import PinnedPart, pinned_parts, with_pin
from iconstudio.workflows.remixing import Remixing, RemixResources
from iconstudio.workflows.solving import CutSeries

MOST = 8
"""Alternatives that are offered."""
_BESIDE = 8.0
"""What has ink so near to a part, in canvas units, could stand in its place."""
_LEAST = 0.2
"""An alternative has at least this part of the part's ink there."""
_ALIKE = 0.9
"""Alternatives whose ink there overlaps by more look the same."""
_MARGIN = 2
"""Canvas units by which the place of a part is larger than its ink, before and after."""


def alternatives(part: Part) -> tuple[PinnedPart, ...]:
    """Return what could stand in the place of a part: other sources of the same result.

    First come those that were matched for the same salient region, then the others with ink there;
    of each, what covers most of the part. Of those that look the same there, only one.
    """
    composite = part.icon.composite
    away = scipy.ndimage.distance_transform_edt(~part.ink)
    place = away <= _BESIDE
    least = _LEAST * part.ink.sum()
    found = []
    for label, source in enumerate(composite.sources):
        ink = placed_ink(source.exemplar, source.placement)[0] & place
        if label != part.label and ink.sum() >= least:
            same_region = source.region >= 0 and source.region == part.source.region
            found.append((not same_region, -overlap(ink, part.ink), label, ink))
    shown: list[Bitmap] = [part.ink]
    offered: list[PinnedPart] = []
    for _, _, label, ink in sorted(found, key=lambda one: one[:3]):
        if len(offered) < MOST and all(overlap(ink, other) < _ALIKE for other in shown):
            shown.append(ink)
            taken = scipy.ndimage.binary_dilation(ink | part.ink, iterations=_MARGIN)
            offered.append(PinnedPart(composite.sources[label], strokes_over(taken)))
    return tuple(offered)


@dataclass(frozen=True, slots=True)
class Tried(Event):
    """A result with an alternative in place of a part, by the number of the alternative."""

    number: int
    icon: Remix


def trying(
    resources: RemixResources, sketch: Sketch, composite: Composite, choices: Sequence[PinnedPart]
) -> Generator[Event]:
    """Yield ``Tried`` for each of the alternatives in a sketch's composite.

    It is pinned, and all is solved again. What takes another result's place stays as it is, but for
    the part, and becomes a montage.
    """
    remixing = Remixing(resources.workers, resources.render, total=len(choices))
    made: dict[int, Remix] = {}

    def note(number: int, icon: Remix) -> Remix:
        made[number] = icon
        return icon

    try:
        for number, choice in enumerate(choices):
            if composite.stands_in:
                series = _in_montage(resources, composite, choice)
            else:
                series = _pinned(resources, sketch, composite, choice)
            remixing.start(series, partial(note, number))
        while remixing.busy:
            for event in remixing.ready(wanted=True):
                if isinstance(event, Result):
                    number = next(n for n, icon in made.items() if icon is event.icon)
                    yield Tried(number, made[number])
                else:
                    yield event
    finally:
        remixing.cancel()


def _pinned(
    resources: RemixResources, sketch: Sketch, composite: Composite, choice: PinnedPart
) -> CutSeries:
    pins = with_pin(sketch.pins, choice.pin, sketch.symmetry)
    held = pinned_parts(replace(sketch, pins=pins), resources.exemplar)
    sources, side = composite.sources, len(composite.labels)
    pose = partial(pose_sketch, sketch.fitted(), side, held, sources)
    return CutSeries(composite.style, sources, pose, (composite.lambda_s,))


def _in_montage(resources: RemixResources, composite: Composite, choice: PinnedPart) -> CutSeries:
    montage = exchanged(composite, choice.pin)
    check(montage)
    exemplars = [resources.exemplar(layer.icon) for layer in montage.layers]
    return series_of(framed(montage, exemplars), exemplars)
