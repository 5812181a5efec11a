"""Remixes made worse on purpose: examples of what is implausible (after section 5.2)."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.energy import Labels, joined_ink
from iconstudio.algorithms.raster import Bitmap
from iconstudio.model import CANVAS, Source

SMALLEST, LARGEST = 22.0, 44.0
"""Radii of the places that are changed, in canvas pixels."""
NEAREST, FARTHEST = 5.0, 14.0
"""By how much a part is moved, in canvas pixels."""
LOST = 0.3
"""What replaces a part that is lost has at most this part of its ink."""
FOREIGN = 0.5, 1.6
"""What replaces a part by another source's has between these parts of its ink."""
TRIES = 12
SMOOTHED = 0.0, 5.0
"""Standard deviations by which data costs are smoothed before the cheapest source is taken."""


@dataclass(frozen=True, eq=False)
class Degraded:
    """A labelling (m, m) of sources, and in which way it is bad."""

    kind: str
    labels: Labels
    sources: tuple[Source, ...]


def cheapest(data: NDArray[np.float32], sources: tuple[Source, ...]) -> Iterator[Degraded]:
    """Yield labellings without any smoothness cost, in pieces of several sizes.

    ``data`` is the data cost, (K, m, m).
    """
    for sigma in SMOOTHED:
        soft = scipy.ndimage.gaussian_filter(data, (0, sigma, sigma)) if sigma else data
        yield Degraded("cheapest", soft.argmin(axis=0).astype(np.uint8), sources)


def degraded(
    labels: Labels, ink: NDArray[np.bool_], sources: tuple[Source, ...], random: np.random.Generator
) -> Iterator[Degraded]:
    """Yield a remix with a part moved, with a part lost, and with a part of another source.

    The canvas is that of the paper: ``labels`` is (CANVAS, CANVAS), ``ink`` the sources'.
    """
    drawn = joined_ink(ink, labels)
    if not drawn.any():
        return
    yield _moved(labels, drawn, sources, random)
    for kind, (least, most) in (("lost", (0.0, LOST)), ("foreign", FOREIGN)):
        for _ in range(TRIES):
            place = _place(drawn, random)
            there = int((drawn & place).sum())
            parts = (ink & place).sum(axis=(1, 2)) / max(1, there)
            parts[np.unique(labels[place])] = -1
            fit = np.flatnonzero((least <= parts) & (parts <= most))
            if there > 150 and len(fit):
                chosen = np.uint8(random.choice(fit))
                yield Degraded(kind, np.where(place, chosen, labels), sources)
                break


def _moved(
    labels: Labels, drawn: Bitmap, sources: tuple[Source, ...], random: np.random.Generator
) -> Degraded:
    """Return a remix of which what lies in one place is moved by some pixels."""
    place = _place(drawn, random)
    turn, reach = random.uniform(0, 2 * np.pi), random.uniform(NEAREST, FARTHEST)
    dx, dy = round(reach * np.cos(turn)), round(reach * np.sin(turn))
    more, changed = list(sources), labels.copy()
    for k in np.unique(labels[place]):
        placed = sources[k].placement
        changed[place & (labels == k)] = len(more)
        more.append(
            replace(sources[k], placement=replace(placed, dx=placed.dx + dx, dy=placed.dy + dy))
        )
    return Degraded("moved", changed, tuple(more))


def _place(drawn: Bitmap, random: np.random.Generator) -> Bitmap:
    """Return a disc around some ink."""
    ys, xs = np.nonzero(drawn)
    at = int(random.integers(len(ys)))
    y, x = np.mgrid[:CANVAS, :CANVAS]
    disc: Bitmap = np.hypot(y - ys[at], x - xs[at]) < random.uniform(SMALLEST, LARGEST)
    return disc
