"""Motifs are brought nearer together, or farther apart."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from math import hypot, sqrt

from scipy.cluster.hierarchy import DisjointSet

from iconstudio.model import CANVAS, Motif

_RADIUS = 0.54
"""Of a motif, over the side of its canvas: it fills that, and keeps a little clear."""
_OVERLAP = 0.32
"""Motifs are one group if they are so near, over the sum of their sides."""


@dataclass(frozen=True, slots=True)
class Stack:
    """Motifs that lie on each other, and move together."""

    members: tuple[int, ...]
    """Their numbers, from back to front."""
    x: float
    y: float
    radius: float


def denser(motifs: Sequence[Motif], density: float) -> tuple[tuple[Motif, ...], float]:
    """Return motifs on a smaller canvas, or a larger one, and its side.

    They stay as large as they are while there is room; beyond that they get smaller, so that
    ``density`` times as many lie on an area without touching. What overlaps stays together.
    """
    factor = sqrt(density)
    side = CANVAS / factor
    groups = stacks(motifs)
    room = min((_room(*pair) for pair in combinations(groups, 2)), default=factor)
    shrunk = min(1.0, max(room, 1.0) / factor)
    moved = list(motifs)
    for group in groups:
        x, y = (_placed(one, group.radius, factor, shrunk) for one in (group.x, group.y))
        for number in group.members:
            one = motifs[number]
            moved[number] = replace(
                one,
                x=x + shrunk * (one.x - group.x),
                y=y + shrunk * (one.y - group.y),
                size=shrunk * one.size,
            )
    return tuple(moved), side


def _placed(value: float, radius: float, factor: float, shrunk: float) -> float:
    """Return a coordinate on the canvas; what was within stays within."""
    side, least = CANVAS / factor, shrunk * min(radius, value, CANVAS - value)
    place = value / factor
    return min(max(place, least), side - least) if 0 <= least <= side / 2 else place


def _room(one: Stack, other: Stack) -> float:
    """Return by how much two groups can be brought nearer."""
    return hypot(one.x - other.x, one.y - other.y) / (one.radius + other.radius)


def stacks(motifs: Sequence[Motif]) -> list[Stack]:
    """Return motifs by what lies on each other."""
    together = DisjointSet(range(len(motifs)))
    for a, b in combinations(range(len(motifs)), 2):
        one, other = motifs[a], motifs[b]
        reach = _OVERLAP * (one.size + other.size)
        if hypot(one.x - other.x, one.y - other.y) < reach:
            together.merge(a, b)
    return [_stack(motifs, members) for members in together.subsets()]


def _stack(motifs: Sequence[Motif], members: Iterable[int]) -> Stack:
    numbers = tuple(sorted(members))
    some = [motifs[number] for number in numbers]
    weight = sum(one.size**2 for one in some)
    x = sum(one.x * one.size**2 for one in some) / weight
    y = sum(one.y * one.size**2 for one in some) / weight
    radius = max(hypot(one.x - x, one.y - y) + _RADIUS * one.size for one in some)
    return Stack(numbers, x, y, radius)
