"""Pictogram montage (section 4.4): the parts that the user scribbles over, joined."""

from collections.abc import Generator, Iterable, Sequence
from dataclasses import replace
from functools import partial
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.energy import RemixProblem, placed_sources
from iconstudio.algorithms.iconification.guidance import (
    MONTAGE_REACH,
    carried,
    held,
    scribble,
    truncated_distance,
)
from iconstudio.algorithms.raster import Bitmap, placed_ink
from iconstudio.model import (
    CANVAS,
    MARGIN,
    Exemplar,
    IconstudioError,
    Layer,
    Montage,
    Placement,
    Source,
    Stroke,
)
from iconstudio.workers import Workers
from iconstudio.workflows.drawing import Render
from iconstudio.workflows.events import Event, Remark
from iconstudio.workflows.remixing import CutSettings, Remixing, RemixResources
from iconstudio.workflows.solving import CutSeries, Posed

LAMBDA_S = 3.0
MOST = 30
SMALLEST, LARGEST = 0.02, 20.0
"""Least and greatest scale of a layer."""


def run(
    resources: RemixResources, montage: Montage, settings: CutSettings | None = None
) -> Generator[Event]:
    """Make a montage: see ``montage_icons``."""
    exemplars = (resources.exemplar(layer.icon) for layer in montage.layers)
    side = (settings or CutSettings()).side
    yield from montage_icons(montage, exemplars, resources.workers, resources.render, side)


def montage_icons(
    montage: Montage,
    exemplars: Iterable[Exemplar],
    workers: Workers,
    render: Render,
    side: int = CANVAS,
) -> Generator[Event]:
    """Join ``exemplars``, one for each layer, by what is scribbled over them.

    They are asked for once the montage is checked. If something marked lies past the canvas, all is
    moved, and made smaller if need be, so that it fits: the result's sources say where they lie.
    Yields ``Remark``, ``Progress``, then one ``Result``. ``side`` is m, the sites in a row of the
    graph cut.
    """
    check(montage)
    drawn = tuple(exemplars)
    montage = framed(montage, drawn)
    yield from map(Remark, _missed(montage, drawn))
    remixing = Remixing(workers, render, total=1)
    try:
        remixing.start(series_of(montage, drawn, side))
        while remixing.busy:
            yield from remixing.ready(wanted=True)
    finally:
        remixing.cancel()


def series_of(montage: Montage, exemplars: Sequence[Exemplar], side: int = CANVAS) -> CutSeries:
    """Return the problem of a montage that is framed: see ``montage_icons``."""
    scribbles = _disjoint([scribble(layer.strokes, side) for layer in montage.layers])
    sources = tuple(
        Source(exemplar, layer.placement)
        for exemplar, layer in zip(exemplars, montage.layers, strict=True)
    )
    return CutSeries("montage", sources, partial(_pose, sources, scribbles), (LAMBDA_S,))


def _missed(montage: Montage, exemplars: Sequence[Exemplar]) -> Generator[str]:
    """Say of which layers the strokes touch no ink.

    Raises
    ------
    IconstudioError
        If it is so of all.
    """
    missed = [
        layer.icon.name
        for layer, exemplar in zip(montage.layers, exemplars, strict=True)
        if layer.strokes and not _marked(layer, exemplar).any()
    ]
    if len(missed) == sum(bool(layer.strokes) for layer in montage.layers):
        raise IconstudioError(
            "No stroke touches ink. Scribble over the parts of the icons to keep."
        )
    for name in missed:
        yield f"No stroke over “{name}” touches it. Draw over what is to be kept of it."


def _pose(sources: Sequence[Source], scribbles: NDArray[np.bool_]) -> Posed:
    side = scribbles.shape[-1]
    ink, filled = placed_sources(sources, side)
    reach = MONTAGE_REACH * side / CANVAS
    data = np.stack([truncated_distance(one, reach) for one in scribbles])
    return Posed(RemixProblem(data + held(scribbles), ink, filled), marked=scribbles)


def framed(montage: Montage, exemplars: Sequence[Exemplar]) -> Montage:
    """Return a montage so placed that all ink that is marked lies on the canvas."""
    left, top, right, bottom = _marked_box(montage, exemplars)
    if min(left, top) >= 0 and max(right, bottom) <= CANVAS:
        return montage
    half = CANVAS / 2
    scale = min(1.0, (CANVAS - 2 * MARGIN) / max(right - left, bottom - top))
    layers = []
    for layer in montage.layers:
        before = layer.placement
        after = Placement(
            scale * before.scale,
            before.flip,
            round(scale * (half + before.dx - (left + right) / 2)),
            round(scale * (half + before.dy - (top + bottom) / 2)),
        )
        strokes = tuple(carried(stroke, before, after) for stroke in layer.strokes)
        layers.append(replace(layer, placement=after, strokes=strokes))
    return Montage(tuple(layers))


def _marked(layer: Layer, exemplar: Exemplar) -> Bitmap:
    """Return the ink of a layer that strokes touch, (CANVAS, CANVAS)."""
    return scribble(layer.strokes) & placed_ink(exemplar, layer.placement)[0]


def _marked_box(
    montage: Montage, exemplars: Sequence[Exemplar]
) -> tuple[float, float, float, float]:
    """Return left, top, right and bottom of the ink that is marked, in canvas units.

    Where that reaches past the canvas it is known to a few units, and may be found a bit larger.
    """
    half = CANVAS / 2
    ends = [
        abs(value - half) + stroke.width / 2
        for layer in montage.layers
        for stroke in layer.strokes
        for point in stroke.points
        for value in point
    ]
    coarse = max(1.0, max(ends) / (half - 2))  # canvas units to a pixel: all strokes are seen
    inked = np.zeros((CANVAS, CANVAS), dtype=bool)
    for layer, exemplar in zip(montage.layers, exemplars, strict=True):
        here = layer.placement
        small = Placement(
            here.scale / coarse, here.flip, round(here.dx / coarse), round(here.dy / coarse)
        )
        strokes = tuple(
            Stroke(
                stroke.width / coarse,
                tuple(((x - half) / coarse + half, (y - half) / coarse + half)
                      for x, y in stroke.points),
            )
            for stroke in layer.strokes
        )  # fmt: skip
        inked |= _marked(replace(layer, placement=small, strokes=strokes), exemplar)
    if coarse == 1 or not inked.any():
        return 0, 0, CANVAS, CANVAS
    rows, columns = (np.flatnonzero(inked.any(axis=axis)) for axis in (1, 0))
    box = columns[0] - 1, rows[0] - 1, columns[-1] + 2, rows[-1] + 2
    left, top, right, bottom = ((float(value) - half) * coarse + half for value in box)
    return left, top, right, bottom


def _disjoint(scribbles: Sequence[NDArray[np.bool_]]) -> NDArray[np.bool_]:
    """Return scribbles that share no pixel, as they may once they are made smaller."""
    taken = np.zeros_like(scribbles[0])
    own = []
    for one in scribbles:
        own.append(one & ~taken)
        taken |= one
    return np.stack(own)


def check(montage: Montage, side: int = CANVAS) -> NDArray[np.bool_]:
    """Return what is scribbled over each layer, (layers, side, side) bool.

    Raises
    ------
    IconstudioError
        If there is nothing to join, a layer is scaled to nothing, or scribbles contradict.
    """
    layers = montage.layers
    if not layers or len(layers) > MOST:
        raise IconstudioError(
            f"A montage needs 1 to {MOST} icons, and has {len(layers)}. "
            f"{'Remove some.' if layers else 'Add icons to it.'}"
        )
    for layer in layers:
        if not SMALLEST <= layer.placement.scale <= LARGEST:
            raise IconstudioError(
                f"“{layer.icon.name}” is scaled to {layer.placement.scale:g} of its size. "
                f"Give a scale between {SMALLEST:g} and {LARGEST:g}."
            )
    scribbles = np.stack([scribble(layer.strokes, side) for layer in layers])
    for layer, own in zip(layers, scribbles, strict=True):
        if layer.strokes and not own.any():
            raise IconstudioError(
                f"The strokes over “{layer.icon.name}” lie outside the canvas. "
                f"Draw between 0 and {CANVAS}."
            )
    if not scribbles.any():
        raise IconstudioError("Nothing is marked. Scribble over the parts of the icons to keep.")
    for first, second in combinations(range(len(layers)), 2):
        if (both := scribbles[first] & scribbles[second]).any():
            places = np.argwhere(both)
            middle = np.abs(places - places.mean(axis=0)).sum(axis=1).argmin()
            y, x = (round(float(value + 0.5) * CANVAS / side) for value in places[middle])
            raise IconstudioError(
                f"The strokes over “{layers[first].icon.name}” and “{layers[second].icon.name}” "
                f"overlap near ({x}, {y}). A pixel can be kept from one icon only: "
                "shorten one of the strokes."
            )
    return scribbles
