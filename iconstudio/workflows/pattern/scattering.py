"""Icons are scattered over a canvas, as the exemplar to begin with."""

from collections.abc import Sequence
from math import ceil, sqrt

import numpy as np

from iconstudio.model import CANVAS, Motif, Pictogram

PALETTE = ("#e4572e", "#17618c", "#f0a202", "#5b8e3e", "#8c4a8c", "#2f9c95", "#c2185b", "#6d4c41")
"""Colours that motifs get, one for each icon."""
FEWEST = 9
"""So many motifs an exemplar has at least, some of the same icon: one alone tells no distances."""
_ROOM = 0.78
"""Side of a motif over that of its cell."""
_STAGGER = 0.08
"""Parts of a cell by which every other row is off to one side, and the others to the other one."""
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
