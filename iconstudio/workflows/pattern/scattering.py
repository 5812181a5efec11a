"""Icons are scattered over a canvas, as the exemplar to begin with."""

from collections.abc import Sequence
from dataclasses import replace
from math import ceil, sqrt

import numpy as np
from numpy.typing import NDArray

from iconstudio.model import CANVAS, Motif, Pictogram
from iconstudio.workflows.pattern.bounds import SMALLEST_MOTIF
from iconstudio.workflows.pattern.density import stacks

PALETTE = ("#e4572e", "#17618c", "#f0a202", "#5b8e3e", "#8c4a8c", "#2f9c95", "#c2185b", "#6d4c41")
"""Colours that motifs get, one for each icon."""
FEWEST = 9
"""So many motifs an exemplar has at least, some of the same icon: one alone tells no distances."""
_ROOM = 0.78
"""Side of a motif over that of its cell."""
_STAGGER = 0.08
"""Parts of a cell by which every other row is off to one side, and the others to the other one."""
_TRIES, _ROUNDS = 24, 80
"""So many orders of stacks are tried; and so often those that are too near move apart."""
_NEAR = 0.92
"""How near two stacks may come, over the sum of their radii: icons seldom fill a disc."""
_LARGE = 0.45
"""Of the canvas, half of a stack covers so much at most."""
_TURN, _JITTER = 18.0, 0.03
"""Degrees, and parts of a cell, by which motifs are off at most."""


def scattered(icons: Sequence[Pictogram], seed: int = 0) -> tuple[Motif, ...]:
    """Return motifs of icons, in staggered rows that fill the canvas, a little turned.

    The same icons and seed give the same motifs.
    """
    if not icons:
        return ()
    random = np.random.default_rng(seed)
    across = ceil(sqrt(max(FEWEST, len(icons))))
    rounds = ceil(across * across / len(icons))
    order = [n for _ in range(rounds) for n in random.permutation(len(icons)).tolist()]
    cell = CANVAS / across
    motifs = []
    for place, number in enumerate(order[: across * across]):
        row, column = divmod(place, across)
        dx, dy = random.uniform(-_JITTER, _JITTER, 2)
        x = (column + 0.5 + (_STAGGER if row % 2 else -_STAGGER) + dx) * cell
        y = (row + 0.5 + dy) * cell
        motifs.append(
            Motif(
                icons[number],
                round(x, 1),
                round(y, 1),
                round(_ROOM * cell, 1),
                round(float(random.uniform(-_TURN, _TURN)), 1),
                colour=PALETTE[number % len(PALETTE)],
            )
        )
    return tuple(motifs)


def scattered_anew(motifs: Sequence[Motif], seed: int = 0) -> tuple[Motif, ...]:
    """Return the same motifs elsewhere; what lies on each other stays together.

    Colours, turns and the order from back to front stay, and so do sizes as long as there is room:
    else all get smaller alike.
    """
    if not motifs:
        return ()
    random = np.random.default_rng(seed)
    groups = stacks(motifs)
    radii = _NEAR * np.array([one.radius for one in groups])
    most = min(1.0, _LARGE * CANVAS / radii.max())
    found = [_apart(_rows(len(groups), random), most * radii) for _ in range(_TRIES)]
    rooms = [_room(places, radii) for places in found]
    places, factor = found[int(np.argmax(rooms))], min(most, max(rooms))
    moved = list(motifs)
    for group, place in zip(groups, places.tolist(), strict=True):
        for number in group.members:
            one = motifs[number]
            moved[number] = replace(
                one,
                x=round(place.real + factor * (one.x - group.x), 1),
                y=round(place.imag + factor * (one.y - group.y), 1),
                size=round(max(factor * one.size, SMALLEST_MOTIF), 1),
            )
    return tuple(moved)


def _rows(count: int, random: np.random.Generator) -> NDArray[np.complex128]:
    """Return so many places on the canvas, x + iy, in staggered rows, in a random order."""
    rows = round(sqrt(count))
    ends = np.rint(np.linspace(0, count, rows + 1)).astype(int)
    places = [
        complex((column + 0.5 + (_STAGGER if row % 2 else -_STAGGER)) / width, (row + 0.5) / rows)
        for row, width in enumerate(np.diff(ends).tolist())
        for column in range(width)
    ]
    jitter = random.uniform(-_JITTER, _JITTER, (2, count)) / rows
    return CANVAS * random.permutation(np.array(places) + jitter[0] + 1j * jitter[1])


def _gaps(places: NDArray[np.complex128]) -> NDArray[np.float64]:
    """Return how far (n, n) places are from each other."""
    gaps: NDArray[np.float64] = np.abs(places[:, None] - places)
    np.fill_diagonal(gaps, np.inf)
    return gaps


def _room(places: NDArray[np.complex128], radii: NDArray[np.float64]) -> float:
    """Return how many times as large discs may be, so that none overlap."""
    return float((_gaps(places) / (radii[:, None] + radii)).min())


def _apart(places: NDArray[np.complex128], radii: NDArray[np.float64]) -> NDArray[np.complex128]:
    """Return places where discs that overlap have moved apart, on the canvas."""
    low, high = radii, CANVAS - radii
    for _ in range(_ROUNDS):
        between, gaps = places[:, None] - places, _gaps(places)
        over = np.maximum(radii[:, None] + radii - gaps, 0)
        if not over.any():
            break
        places = places + (between / np.maximum(gaps, 1e-9) * over).sum(axis=1) / 2
        places = np.clip(places.real, low, high) + 1j * np.clip(places.imag, low, high)
    return places
