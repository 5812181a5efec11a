"""Pictogram hybrids (section 4.3): icons mixed at random, repeats dropped."""

import math
from collections.abc import Generator, Iterable
from dataclasses import replace
from functools import partial
from itertools import combinations

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.energy import RemixProblem, canvas_ink, placed_sources
from iconstudio.algorithms.iconification.guidance import (
    held,
    scribble,
    seed_cost,
    with_mirror_images,
)
from iconstudio.algorithms.iconification.plausibility import Plausibility
from iconstudio.algorithms.iconification.ranking import Gallery
from iconstudio.algorithms.iconification.symmetry import reflected
from iconstudio.grammar import counted
from iconstudio.model import (
    CANVAS,
    Axis,
    Exemplar,
    IconstudioError,
    Mix,
    Placement,
    Point,
    Remix,
    Seeds,
    Source,
    Stroke,
)
from iconstudio.workers import Workers
from iconstudio.workflows.drawing import Render
from iconstudio.workflows.events import Event, Progress, Result
from iconstudio.workflows.remixing import CutSettings, Remixing, RemixResources
from iconstudio.workflows.solving import CutSeries, Posed

LAMBDA_S = 3.0
FEWEST, MOST = 2, 12
MOST_DRAWS = 1000
PIN = 24.0
"""Diameter of the disc that a pin holds, in canvas pixels."""
DETAIL = 0.3
"""A piece with at most this part of its icon's ink is a detail, which a pin holds as a whole."""


def check(mix: Mix) -> None:
    """Refuse a mix that cannot be drawn.

    Raises
    ------
    IconstudioError
        If there are too few or too many icons or draws, or an icon comes twice.
    """
    count = len(mix.icons)
    if not FEWEST <= count <= MOST:
        raise IconstudioError(
            f"{counted(count, 'icon')} cannot be mixed: choose {FEWEST} to {MOST} different icons."
        )
    ids = [icon.id for icon in mix.icons]
    for name in ids:
        if ids.count(name) > 1:
            raise IconstudioError(f"“{name}” is chosen twice. Choose different icons.")
    if not 1 <= mix.draws <= MOST_DRAWS:
        raise IconstudioError(
            f"{counted(mix.draws, 'draw')} cannot be made: ask for 1 to {MOST_DRAWS}."
        )
    for seeds, name in ((mix.pins, "pins"), (mix.like, "seeds")):
        if seeds and len(seeds) != count:
            icons = counted(len(seeds), "icon")
            raise IconstudioError(f"There are {name} for {icons}, but {count} icons are mixed.")
    if mix.pins:
        _check_pins(mix)


def _check_pins(mix: Mix) -> None:
    """Refuse pins of two icons that hold the same place."""
    for (one, pins), (other, theirs) in combinations(zip(mix.icons, mix.pins, strict=True), 2):
        own, images = (with_mirror_images(some, mix.symmetry) for some in (pins, theirs))
        if any(math.dist(p, q) < PIN for p in own for q in images):
            raise IconstudioError(
                f"A pin on “{one.name}” and one on “{other.name}” hold the same place. "
                "Only one icon can be kept there: move or remove one of the pins."
            )


def run(
    resources: RemixResources, mix: Mix, settings: CutSettings | None = None
) -> Generator[Event]:
    """Draw hybrids: see ``mix_icons``."""
    exemplars = map(resources.exemplar, mix.icons)
    side = (settings or CutSettings()).side
    workers, render = resources.workers, resources.render
    yield from mix_icons(mix, exemplars, workers, render, side, resources.plausibility)


def mix_icons(
    mix: Mix,
    exemplars: Iterable[Exemplar],
    workers: Workers,
    render: Render,
    side: int = CANVAS,
    plausibility: Plausibility | None = None,
) -> Generator[Event]:
    """Draw hybrids of ``exemplars``, one for each of ``mix.icons``; asked for once all is checked.

    Yields ``Progress``, and each ``Result`` in the order of the draws, so that the same seed gives
    the same results; one that looks like a source or like an earlier result is dropped.
    ``side`` is m, the sites in a row of the graph cut; ``plausibility`` judges results.
    """
    check(mix)
    sources = tuple(Source(exemplar, Placement()) for exemplar in exemplars)
    ink, filled = placed_sources(sources)
    posed = (ink, filled) if side == CANVAS else placed_sources(sources, side)
    seen = Gallery()
    for source, own in zip(sources, ink, strict=True):
        if not seen.add(own):
            raise IconstudioError(
                f"“{source.exemplar.name}” looks the same as another of the icons. "
                "Choose different ones."
            )
    remixing = Remixing(workers, render, mix.draws, plausibility)
    numbers = iter(range(mix.first, mix.first + mix.draws))
    waiting: dict[int, tuple[Result, Remix]] = {}
    turn = mix.first
    try:
        while turn < mix.first + mix.draws:
            while remixing.hungry and (number := next(numbers, None)) is not None:
                seeds = draw_seeds(mix, number, filled)
                pose = partial(_pose, mix, seeds, *posed)
                series = CutSeries("hybrid", sources, pose, (LAMBDA_S,), sharing=True)
                remixing.start(series, partial(replace, seeds=seeds, draw=number))
            for event in remixing.ready(wanted=True):
                match event:
                    case Result(icon=Remix() as icon):
                        waiting[icon.draw] = event, icon
                    case Progress():
                        yield Progress("remix", event.done, "Mixing")
            while turn in waiting:
                result, icon = waiting.pop(turn)
                turn += 1
                if seen.add(canvas_ink(posed[0], icon.composite.labels)):
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
    marked = pinned(mix.pins, ink, mix.symmetry) if mix.pins else None
    if marked is not None:
        data += held(marked)
    return Posed(RemixProblem(data, ink, filled, mix.symmetry), marked=marked)


def pinned(pins: Seeds, ink: NDArray[np.bool_], axis: Axis | None) -> NDArray[np.bool_]:
    """Return what the pins hold of each icon, (K, m, m) bool.

    That is a disc around each pin and, if it is a detail, the whole piece of ink that is pinned,
    but for what other icons' discs hold.

    Parameters
    ----------
    ink
        (K, m, m) bool: the icons.
    """
    side = ink.shape[-1]
    points = [with_mirror_images(some, axis) for some in pins]
    discs = np.stack([scribble([Stroke(PIN, (point,)) for point in some], side) for some in points])
    parts = discs.copy()
    for number, own in enumerate(ink):
        pieces, _ = scipy.ndimage.label(own, np.ones((3, 3)))
        sizes = np.bincount(pieces.ravel())
        for point in points[number]:
            piece = _nearest(pieces, point, PIN / 2)
            if piece and sizes[piece] <= DETAIL * own.sum():
                parts[number] |= pieces == piece
        if axis is not None:
            parts[number] |= reflected(parts[number], axis)
        others = parts[:number].any(axis=0) | np.delete(discs, number, axis=0).any(axis=0)
        parts[number] &= ~others | discs[number]
    return parts


def _nearest(pieces: NDArray[np.int32], point: Point, reach: float) -> int:
    """Return the number of the piece nearest to a point, within so many canvas units; else 0."""
    side = len(pieces)
    ys, xs = np.nonzero(pieces)
    unit = CANVAS / side
    away = np.hypot((xs + 0.5) * unit - point[0], (ys + 0.5) * unit - point[1])
    at = int(away.argmin())
    return int(pieces[ys[at], xs[at]]) if away[at] <= reach else 0
