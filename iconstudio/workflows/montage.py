"""Pictogram montage (section 4.4): the parts that the user scribbles over, joined."""

from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.energy import RemixProblem, placed_sources
from iconstudio.algorithms.guidance import MONTAGE_REACH, held, scribble, truncated_distance
from iconstudio.model import CANVAS, Exemplar, IconstudioError, Montage, Source
from iconstudio.workers import Workers
from iconstudio.workflows.drawing import Render
from iconstudio.workflows.events import Event
from iconstudio.workflows.remixing import Remixing
from iconstudio.workflows.solving import Job, Posed

LAMBDA_S = 3.0
MOST = 30
SMALLEST, LARGEST = 0.02, 20.0
"""Least and greatest scale of a layer."""


def montage_icons(
    montage: Montage,
    exemplars: Iterable[Exemplar],
    workers: Workers,
    render: Render,
    side: int = CANVAS,
) -> Iterator[Event]:
    """Join ``exemplars``, one for each layer, by what is scribbled over them.

    They are asked for once the montage is checked.
    Yields ``Progress``, then one ``Result``. ``side`` is m, the sites in a row of the graph cut.
    """
    scribbles = check(montage, side)
    sources = tuple(
        Source(exemplar, layer.placement)
        for exemplar, layer in zip(exemplars, montage.layers, strict=True)
    )
    remixing = Remixing(workers, render, total=1)
    try:
        remixing.start(Job("montage", sources, partial(_pose, sources, scribbles), (LAMBDA_S,)))
        while remixing.busy:
            yield from remixing.ready(wanted=True)
    finally:
        remixing.cancel()


def _pose(sources: Sequence[Source], scribbles: NDArray[np.bool_]) -> Posed:
    side = scribbles.shape[-1]
    ink, filled = placed_sources(sources, side)
    reach = MONTAGE_REACH * side / CANVAS
    data = np.stack([truncated_distance(one, reach) for one in scribbles])
    return Posed(RemixProblem(data + held(scribbles), ink, filled), marked=scribbles)


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
            f"{'Remove some.' if layers else 'Bring icons onto the canvas.'}"
        )
    for layer in layers:
        if not SMALLEST <= layer.placement.scale <= LARGEST:
            raise IconstudioError(
                f"“{layer.icon.id}” is scaled to {layer.placement.scale:g} of its size. "
                f"Give a scale between {SMALLEST:g} and {LARGEST:g}."
            )
    scribbles = np.stack([scribble(layer.strokes, side) for layer in layers])
    for layer, own in zip(layers, scribbles, strict=True):
        if layer.strokes and not own.any():
            raise IconstudioError(
                f"The strokes over “{layer.icon.id}” lie outside the canvas. "
                f"Draw between 0 and {CANVAS}."
            )
    if not scribbles.any():
        raise IconstudioError("Nothing is marked. Scribble over the parts of the icons to keep.")
    for first, second in combinations(range(len(layers)), 2):
        if (scribbles[first] & scribbles[second]).any():
            raise IconstudioError(
                f"The strokes over “{layers[first].icon.id}” and “{layers[second].icon.id}” "
                "overlap. A pixel can be kept from one icon only: shorten one of the strokes."
            )
    return scribbles
