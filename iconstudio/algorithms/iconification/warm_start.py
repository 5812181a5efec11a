"""Labellings of one problem as beginnings for another: what was found before an edit (live mode).

An addition to section 3.4.

After an edit of the outline most sources stay, some move, some go. A labelling of the problem
before is still a good place to begin the next search.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.energy import Labels
from iconstudio.model import CANVAS, Placement, Source


def transferred(
    labels: Labels, before: Sequence[Source], now: Sequence[Source], data: NDArray[np.float32]
) -> Labels:
    """Return ``labels`` of the sources ``before`` as labels of the sources ``now``.

    Each source becomes itself if it is still there; else the same icon where it is placed most
    alike; else, one after another, the source that costs least on all that it owned.

    Parameters
    ----------
    labels
        (m, m), indices of ``before``.
    data
        (K, m, m), what each source of ``now`` costs at each site.
    """
    table = np.zeros(len(before), np.uint8)
    for old in np.unique(labels).tolist():
        place = _heir(before[old], now)
        if place is None:
            place = int(data[:, labels == old].sum(axis=1).argmin())
        table[old] = place
    return table[labels]


def _heir(source: Source, now: Sequence[Source]) -> int | None:
    """Return which of ``now`` shows the same icon, placed most alike; None if none does."""
    same = [k for k, one in enumerate(now) if one.exemplar.id == source.exemplar.id]
    return min(same, key=lambda k: _apart(source.placement, now[k].placement), default=None)


def _apart(one: Placement, other: Placement) -> tuple[bool, float]:
    """Order placements by how far they are from another; those that are flipped come last."""
    grown = abs(one.scale - other.scale) * CANVAS / 2
    return one.flip != other.flip, np.hypot(one.dx - other.dx, one.dy - other.dy) + grown
