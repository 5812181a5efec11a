"""Motifs that keep company: a flower and its leaves, a plane over each cloud (beyond the paper)."""

from collections import Counter
from collections.abc import Hashable, Sequence
from itertools import combinations, pairwise

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage
from scipy.cluster.hierarchy import DisjointSet

from iconstudio.algorithms.raster import Bitmap

_JUMP = 2.5
"""Groups are so many times as far from each other as what is in them, at least."""
_TOUCHING = 1.0
"""Pixels between motifs that are as good as none."""


def companies(kinds: Sequence[Hashable], inks: Sequence[Bitmap]) -> list[list[int]]:
    """Return groups of motifs, by their numbers, that belong together.

    Either all are in groups, far nearer to each other than to other groups, and each group has the
    same kinds of motifs, each as often. Or those of one kind lie each on one of another kind, and
    on each of these as many.

    Parameters
    ----------
    kinds
        What tells one motif's icon from another's.
    inks
        (n, n) each, where it is.
    """
    apart = _apart(inks)
    joined = DisjointSet(range(len(inks)))
    for one, other in _grouped(kinds, apart) or _on_each_other(kinds, apart):
        joined.merge(one, other)
    return sorted(sorted(group) for group in joined.subsets())


def _apart(inks: Sequence[Bitmap]) -> NDArray[np.float64]:
    """Return how many pixels motifs are apart, (n, n)."""
    apart = np.zeros((len(inks), len(inks)))
    for one, ink in enumerate(inks):
        away = ndimage.distance_transform_edt(~ink)
        for other in range(one):
            apart[one, other] = apart[other, one] = away[inks[other]].min()
    return apart


def _grouped(kinds: Sequence[Hashable], apart: NDArray[np.float64]) -> list[tuple[int, int]]:
    """Return pairs that belong together if all are in groups alike: edges of a spanning tree."""
    pairs = sorted(combinations(range(len(apart)), 2), key=lambda pair: apart[pair])
    tree = DisjointSet(range(len(apart)))
    edges = [pair for pair in pairs if tree.merge(*pair)]
    joined = DisjointSet(range(len(apart)))
    for n, (edge, longer) in enumerate(pairwise(edges), 1):
        joined.merge(*edge)
        if apart[longer] < _JUMP * max(apart[edge], _TOUCHING):
            continue
        groups = joined.subsets()
        if len({frozenset(Counter(kinds[one] for one in group).items()) for group in groups}) == 1:
            return edges[:n]
    return []


def _on_each_other(kinds: Sequence[Hashable], apart: NDArray[np.float64]) -> list[tuple[int, int]]:
    touching: dict[tuple[Hashable, Hashable], list[tuple[int, int]]] = {}
    for one, other in np.argwhere(apart == 0).tolist():
        touching.setdefault((kinds[one], kinds[other]), []).append((one, other))
    found: list[tuple[int, int]] = []
    for (upper, lower), pairs in touching.items():
        if upper == lower:
            continue
        each = Counter(one for one, _ in pairs)
        on_each = Counter(other for _, other in pairs)
        if (
            set(each.values()) == {1}
            and len(each) == kinds.count(upper)
            and len(set(on_each.values())) == 1
            and len(on_each) == kinds.count(lower) > 1
        ):
            found += pairs
    return found
