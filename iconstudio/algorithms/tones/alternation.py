"""Which regions of a drawing are ink: each has the tone that differs from what is around it."""

from enum import Enum
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.tones.regions import Mask, Regions

_LARGE, _ALIKE = 0.18, 7.0
"""How much of a drawing each of two walls of one house has; by how much they differ in colour."""


class Omission(Enum):
    """What of a drawing is no part of its pictogram, though a part of its silhouette."""

    TILE = "the tile behind the drawing"
    PAGE = "the white behind the drawing"
    SHADES = "edges between shades or colours that are drawn as one"
    FAINT = "what is less than half as opaque as the drawing"
    GLOW = "what shines around the drawing, and fades"
    SHADOW = "the flat shadow of a figure on its tile"
    DECORATION = "colour behind or beside the lines of a drawing"
    DESK = "what lies around the sheet that is drawn upon"
    HOLES = "the punch holes of a sheet"
    FINGER = "a finger at the edge of a photo"
    PRINT = "the lines or dots that the paper is printed with"


class Tones(NamedTuple):
    """What of k regions is ink."""

    ink: Mask
    """(k + 1,): the regions that are ink."""
    lines: Mask
    """(k + 1, k + 1): the neighbours with a line between them."""
    over: Mask
    """(k + 1,): the lines of a drawing, which keep their width: other ink keeps away from them."""
    outlined: Mask
    """(k + 1,): paper with a line of ink where it is on the outside."""
    omissions: frozenset[Omission] = frozenset()


def decide(
    tone: NDArray[np.intp], found: Regions, weights: NDArray[np.float64], last: Mask
) -> None:
    """Give each region of ``tone`` 0 the tone, 1 ink or -1 paper, that differs from its neighbours.

    ``weights`` (k + 1, k + 1) say how much it matters that two neighbours differ; ``last`` are
    the regions that the others do not heed.
    """
    around = np.maximum(found.lengths[:, ~last].sum(axis=1), 1)
    difference = np.linalg.norm(found.colours[:, None] - found.colours, axis=2)
    walls = (found.lengths[0] > 0) & (found.areas > _LARGE * found.areas[1:].sum())
    alike = walls & walls[:, None] & (difference < _ALIKE)
    alike |= np.eye(len(tone), dtype=bool)
    while not tone.all():
        # Next is the region whose neighbours are known best; of several, the largest.
        known = (found.lengths[:, (tone != 0) & ~last].sum(axis=1) / around).round(2)
        number = max(
            np.flatnonzero(tone == 0), key=lambda r: (not last[r], known[r], found.areas[r])
        )
        together = alike[number] & (tone == 0)
        tone[together] = -1 if weights[together].sum(axis=0) @ tone > 0 else 1
