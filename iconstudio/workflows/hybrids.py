"""Pictogram hybrids (section 4.3): icons mixed at random, repeats dropped."""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.energy import RemixProblem, joined_ink, placed_sources
from iconstudio.algorithms.guidance import held, scribble, seed_cost, with_mirror_images
from iconstudio.algorithms.ranking import Gallery
from iconstudio.model import (
    CANVAS,
    Exemplar,
    IconstudioError,
    Mix,
    Placement,
    Seeds,
    Source,
    Stroke,
)
from iconstudio.workers import Workers
from iconstudio.workflows.drawing import Render
from iconstudio.workflows.events import Event, Progress, Result
from iconstudio.workflows.remixing import Remixing
from iconstudio.workflows.solving import Job, Posed

LAMBDA_S = 3.0
FEWEST, MOST = 2, 12
MOST_DRAWS = 1000
PIN = 24.0
"""Diameter of what a pin holds, in canvas pixels."""


def check(mix: Mix) -> None:
    """Refuse a mix that cannot be drawn.

    Raises
    ------
    IconstudioError
        If there are too few or too many icons or draws, or an icon comes twice.
    """
    count = len(mix.icons)
    if not FEWEST <= count <= MOST:
        icons = "1 icon" if count == 1 else f"{count} icons"
        raise IconstudioError(
            f"{icons} cannot be mixed: choose {FEWEST} to {MOST} different icons."
        )
    ids = [icon.id for icon in mix.icons]
    for name in ids:
        if ids.count(name) > 1:
            raise IconstudioError(f"“{name}” is chosen twice. Choose different icons.")
    if not 1 <= mix.draws <= MOST_DRAWS:
        raise IconstudioError(f"{mix.draws} draws are not possible: ask for 1 to {MOST_DRAWS}.")
    for seeds, name in ((mix.pins, "pins"), (mix.like, "seeds")):
        if seeds and len(seeds) != count:
            raise IconstudioError(f"There are {name} for {len(seeds)} icons, but {count} icons.")


def mix_icons(
    mix: Mix,
    exemplars: Iterable[Exemplar],
    workers: Workers,
    render: Render,
    side: int = CANVAS,
) -> Iterator[Event]:
    """Draw hybrids of ``exemplars``, one for each of ``mix.icons``; asked for once all is checked.

    Yields ``Progress``, and each ``Result`` in the order of the draws, so that the same seed gives
    the same results; one that looks like a source or like an earlier result is dropped.
    ``side`` is m, the sites in a row of the graph cut.
    """
    check(mix)
    sources = tuple(Source(exemplar, Placement()) for exemplar in exemplars)
    ink, filled = placed_sources(sources)
    posed = (ink, filled) if side == CANVAS else placed_sources(sources, side)
    seen = Gallery()
    for source, own in zip(sources, ink, strict=True):
        if not seen.add(own):
            raise IconstudioError(
                f"“{source.exemplar.id}” looks the same as another of the icons. "
                "Choose different ones."
            )
    remixing = Remixing(workers, render, total=mix.draws)
    numbers = iter(range(mix.first, mix.first + mix.draws))
    waiting: dict[int, Result] = {}
    turn, finer = mix.first, side // CANVAS
    try:
        while turn < mix.first + mix.draws:
            while remixing.hungry and (number := next(numbers, None)) is not None:
                seeds = draw_seeds(mix, number, filled)
                pose = partial(_pose, mix, seeds, *posed)
                job = Job("hybrid", sources, pose, (LAMBDA_S,), sharing=True)
                remixing.start(job, partial(replace, seeds=seeds, draw=number))
            for event in remixing.ready(wanted=True):
                if isinstance(event, Result):
                    waiting[event.draw] = event
                else:
                    yield Progress("remix", event.done, "Mixing")
            while turn in waiting:
                result = waiting.pop(turn)
                turn += 1
                if seen.add(joined_ink(posed[0], result.composite.labels)[::finer, ::finer]):
                    yield result
    finally:
        remixing.cancel()


def draw_seeds(mix: Mix, number: int, shapes: NDArray[np.bool_]) -> Seeds:
    """Return the seed positions of draw ``number``; ``shapes`` are the filled icons (K, h, w).

    Every draw has its own random numbers, whatever other draws there are.
    """
    random = np.random.default_rng([mix.seed, number])
    like = mix.like
    kept = set(random.permutation(len(shapes))[: (len(shapes) + 1) // 2]) if like else set()
    seeds = []
    for index, shape in enumerate(shapes):
        ys, xs = np.nonzero(shape)
        at = int(random.integers(len(xs)))
        drawn = ((float(xs[at]) + 0.5, float(ys[at]) + 0.5),)
        points = like[index] if index in kept else with_mirror_images(drawn, mix.symmetry)
        pins = with_mirror_images(mix.pins[index], mix.symmetry) if mix.pins else ()
        seeds.append((*pins, *(point for point in points if point not in pins)))
    return tuple(seeds)


def _pose(mix: Mix, seeds: Seeds, ink: NDArray[np.bool_], filled: NDArray[np.bool_]) -> Posed:
    """Pose the problem of a draw; ``ink`` and ``filled`` are the icons on the canvas, (K, m, m)."""
    side = ink.shape[-1]
    data = seed_cost(seeds, side)
    if mix.pins:
        data += held(_pinned(mix, side))
    return Posed(RemixProblem(data, ink, filled, mix.symmetry))


def _pinned(mix: Mix, side: int) -> NDArray[np.bool_]:
    """Return what the pins hold of each icon, (K, side, side) bool."""
    dots = [
        [Stroke(PIN, (point,)) for point in with_mirror_images(points, mix.symmetry)]
        for points in mix.pins
    ]
    return np.stack([scribble(one, side) for one in dots])
