"""Pinned parts: places of a sketch's results that the user has given to icons of their choice.

A pin is a layer as of a montage: an icon where it lies, and strokes over the place that is its.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.energy import RemixProblem
from iconstudio.algorithms.iconification.guidance import held, mirror_image, scribble
from iconstudio.algorithms.iconification.style import STYLES, Style, blackness
from iconstudio.algorithms.iconification.symmetry import reflected
from iconstudio.algorithms.raster import Bitmap
from iconstudio.model import Axis, Exemplar, Layer, Pictogram, Sketch, Source, Stroke
from iconstudio.workflows.montage.strokes import cut
from iconstudio.workflows.solving import Posed


@dataclass(frozen=True, eq=False)
class PinnedPart:
    """A source that is to own what its strokes cover."""

    source: Source
    strokes: tuple[Stroke, ...]

    @property
    def pin(self) -> Layer:
        """The pin, as the sketch has it."""
        return Layer(self.source.exemplar.pictogram, self.source.placement, self.strokes)


def pinned_parts(
    sketch: Sketch, exemplar: Callable[[Pictogram], Exemplar]
) -> tuple[PinnedPart, ...]:
    """Return the parts that are pinned, but of icons that are left out; ``exemplar`` draws them."""
    return tuple(
        PinnedPart(Source(exemplar(pin.icon), pin.placement), pin.strokes)
        for pin in sketch.pins
        if pin.icon.id not in sketch.exclude
    )


def idle_pins(sketch: Sketch) -> str:
    """Return the sentence that says which pins are not heeded, as their icons are left out."""
    idle = sorted({pin.icon.name for pin in sketch.pins if pin.icon.id in sketch.exclude})
    if not idle:
        return ""
    names = ", ".join(f"“{name}”" for name in idle)
    return (
        f"A part of {names} is pinned, but the icon is left out, so the pin is not heeded. "
        "Take the icon in again, or unpin the part."
    )


def pins_of_other_styles(parts: Iterable[PinnedPart], styles: Sequence[Style]) -> str:
    """Return the sentence that says which pins no style heeds, as their icons are of others."""
    told = {}
    for part in parts:
        black = blackness(part.source.exemplar.ink)
        if not any(style.admits(black) for style in styles):
            own = " or ".join(style.name for style in STYLES if style.admits(black))
            told[part.source.exemplar.pictogram.name] = own
    if not told:
        return ""
    names = ", ".join(f"“{name}” ({own})" for name, own in sorted(told.items()))
    return (
        f"A part of {names} is pinned, but the icon is of another style than those that are made, "
        "so the pin is not heeded. Make a style of the icon's, too, or unpin the part."
    )


def with_pin(pins: Sequence[Layer], pin: Layer, axis: Axis | None = None) -> tuple[Layer, ...]:
    """Return pins with one more, which takes its place, and its mirror image, from the others."""
    knives = [*pin.strokes, *_mirrored(pin.strokes, axis)]
    before = [Layer(one.icon, one.placement, cut(one.strokes, knives)) for one in pins]
    return (*(one for one in before if one.strokes), pin)


def without_pins(
    pins: Sequence[Layer], place: Bitmap, axis: Axis | None = None
) -> tuple[Layer, ...]:
    """Return pins but for those that hold some of a ``place``, (m, m) bool, or its mirror image."""
    if axis is not None:
        place = place | reflected(place, axis)
    return tuple(pin for pin in pins if not (scribble(pin.strokes, len(place)) & place).any())


def pinning(
    problem: RemixProblem,
    sources: Sequence[Source],
    silhouette: Bitmap,
    parts: Iterable[PinnedPart],
) -> Posed:
    """Return a problem in whose solutions the pinned parts belong to their sources.

    Parts whose sources are not among ``sources`` are passed over; of parts that overlap, the later
    one counts.
    """
    marked = _marked(parts, sources, problem)
    if marked is None:
        return Posed(problem, silhouette)
    data = problem.data + held(marked)
    posed = RemixProblem(data, problem.ink, problem.solid, problem.symmetry)
    return Posed(posed, silhouette, marked=marked)


def _marked(
    parts: Iterable[PinnedPart], sources: Sequence[Source], problem: RemixProblem
) -> NDArray[np.bool_] | None:
    """Return what is pinned of each source, (K, m, m); None if nothing is."""
    labels = {(one.exemplar.id, one.placement): label for label, one in enumerate(sources)}
    marked = np.zeros(problem.data.shape, dtype=bool)
    for part in parts:
        label = labels.get((part.source.exemplar.id, part.source.placement))
        if label is not None:
            own = scribble(part.strokes, problem.side)
            if problem.symmetry is not None:
                own |= reflected(own, problem.symmetry)
            marked &= ~own
            marked[label] |= own
    return marked if marked.any() else None


def _mirrored(strokes: Sequence[Stroke], axis: Axis | None) -> list[Stroke]:
    if axis is None:
        return []
    return [
        Stroke(one.width, tuple(mirror_image(point, axis) for point in one.points))
        for one in strokes
    ]
