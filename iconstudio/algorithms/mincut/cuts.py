"""Exact minimum cuts of grids of four neighbours, compiled.

Importing this module loads numba, so only the process that cuts should do so. The functions let go
of the interpreter lock.

A network is two arrays. ``excess[i] > 0`` is a capacity from the source to node i, ``< 0`` one to
the sink. ``capacity[i, d]`` is the capacity to its neighbour ``i + offset[d]``; ``d ^ 1`` is the
way back. All are whole numbers, so flows are exact, without any tolerance, and the same on every
machine. The cut that is found is the one with the fewest nodes on the source's side; the excess
that remains there is what it gains over the cut with none.

**Blocks.** Where the capacities between nodes are large, flow goes far, in many small steps. So 2 x
2 nodes are first joined and their network is cut, recursively; what flowed between two blocks is
then shared out among their nodes, in proportion to the capacities, so it is feasible. Nodes within
a block are evened out by what follows.

**Chains.** Then, flow is sent along each row to the right and back to the left, and along each
column: it carries most of the flow at little cost. How much a node may send on is known beforehand
from a run in the other direction, so no flow ends where it finds no use.

**Trees.** The rest is sent from root to root of trees that grow from all excess (``trees``).

Every node needs four neighbours: grids have a border of nodes without excess and capacities.
"""

from collections.abc import Callable

import numpy as np

from iconstudio.algorithms.compiled import entry, inner
from iconstudio.algorithms.mincut.trees import (
    Integers,
    Trees,
    new_trees,
    plant,
    send_in_trees,
)

_MOST = 1 << 29
"""The largest capacity or excess of a block; what is more is left to the nodes."""

SLICE = 1 << 14
"""Nodes that trees grow from before ``ask`` is called: a few milliseconds."""
SMALLEST = 64
"""Smaller grids are not cut coarsely first."""


def minimum_cut(
    offset: Integers,
    capacity: Integers,
    excess: Integers,
    trees: Trees,
    anew: bool,
    far: bool,
    ask: Callable[[], None] = lambda: None,
) -> None:
    """Send all the flow there is; the source's side is then what ``excess`` can still reach.

    Parameters
    ----------
    offset
        (4,): from a node to its right, left, lower and upper neighbour.
    capacity, excess
        (N, 4) and (N,), changed in place to what remains.
    anew
        Whether flow is to be expected all over the grid: then chains come first, and trees grow
        from both sides, else only from the source's.
    far
        Whether it is to be expected to go far: then blocks come before all.
    ask
        Called every few milliseconds. What it raises leaves a flow that is feasible, if not all.
    """
    if far:
        _send_in_blocks(offset, capacity, excess, ask)
    if anew:
        _send_in_chains(offset, capacity, excess, trees.distance)
    place = np.array([0, plant(excess, trees, anew), 0, -1])
    while send_in_trees(offset, capacity, excess, trees, anew, place, SLICE):
        ask()


def _send_in_blocks(
    offset: Integers, capacity: Integers, excess: Integers, ask: Callable[[], None]
) -> None:
    """Send what flow the sums over 2 x 2 nodes suggest."""
    width = int(offset[2])
    rows, columns = len(excess) // width - 2, width - 2
    if rows % 2 or columns % 2 or min(rows, columns) < SMALLEST:
        return
    wide = columns // 2 + 2
    size = (rows // 2 + 2) * wide
    coarse, sums = np.zeros((size, 4), np.int32), np.zeros(size, np.int32)
    _add_up(width, capacity, excess, wide, coarse, sums)
    steps = np.array([1, -1, wide, -wide], np.int32)
    minimum_cut(steps, coarse, sums, new_trees(size), True, True, ask)
    _spread(width, capacity, excess, wide, coarse)


@entry
def _add_up(
    width: int, capacity: Integers, excess: Integers, wide: int, coarse: Integers, sums: Integers
) -> None:
    """Add up the excess of 2 x 2 nodes each, and the capacities between them."""
    for p in range(wide + 1, len(sums) - wide - 1):
        y, x = p // wide, p % wide
        if x == 0 or x == wide - 1:
            continue
        i = (2 * y - 1) * width + 2 * x - 1
        j = i + width
        total = np.int64(excess[i]) + excess[i + 1] + excess[j] + excess[j + 1]
        sums[p] = min(max(total, -_MOST), _MOST)
        coarse[p, 0] = _sum(capacity[i + 1, 0], capacity[j + 1, 0])
        coarse[p, 1] = _sum(capacity[i, 1], capacity[j, 1])
        coarse[p, 2] = _sum(capacity[j, 2], capacity[j + 1, 2])
        coarse[p, 3] = _sum(capacity[i, 3], capacity[i + 1, 3])


@inner
def _sum(one: np.int32, other: np.int32) -> np.int64:
    return min(np.int64(one) + other, np.int64(_MOST))


@entry
def _spread(width: int, capacity: Integers, excess: Integers, wide: int, coarse: Integers) -> None:
    """Send what flowed between blocks between their nodes, in proportion to the capacities.

    Within a block flows the mean of what comes in and what goes out, if it can. ``coarse`` is what
    remains of the capacities between blocks.
    """
    for axis in range(2):
        d, along, across = (0, width, 1) if axis == 0 else (2, 1, width)
        sent = np.zeros(excess.size, np.int64)
        for p in range(wide + 1, len(coarse) - wide - 1):
            y, x = p // wide, p % wide
            if x == 0 or x == wide - 1:
                continue
            first = (2 * y - 1) * width + 2 * x - 1 + across
            second = first + along
            flow = _sum(capacity[first, d], capacity[second, d]) - coarse[p, d]
            if flow > 0:
                one, other = np.int64(capacity[first, d]), np.int64(capacity[second, d])
                sent[first] = flow * one // (one + other)
            elif flow < 0:
                one = np.int64(capacity[first + across, d + 1])
                other = np.int64(capacity[second + across, d + 1])
                sent[first] = -(-flow * one // (one + other))
            sent[second] = flow - sent[first]
            for node in (first, second):
                inside = (sent[node - 2 * across] + sent[node]) >> 1
                inside = min(max(inside, -capacity[node, d + 1]), capacity[node - across, d])
                _push(capacity, excess, node - across, node, d, inside)
                _push(capacity, excess, node, node + across, d, sent[node])


@inner
def _push(capacity: Integers, excess: Integers, i: int, j: int, d: int, amount: int) -> None:
    """Send an amount of either sign from node i to its neighbour j in direction d."""
    capacity[i, d] -= amount
    capacity[j, d ^ 1] += amount
    excess[i] -= amount
    excess[j] += amount


@entry
def _send_in_chains(
    offset: Integers, capacity: Integers, excess: Integers, reach: Integers
) -> None:
    """Send flow along rows, then along columns: to the right, left, down and up.

    ``reach`` is scratch space: how much of what flows on from a node finds a use, after what the
    nodes that it passes send themselves.
    """
    margin = offset[2]
    for d in range(4):
        step = offset[d]
        start, stop, stride = margin, excess.size - margin, 1
        if step < 0:
            start, stop, stride = stop - 1, start - 1, -1
        for i in range(stop - stride, start - stride, -stride):
            j = i + step
            reach[i] = min(capacity[i, d], max(reach[j] - excess[j], 0))
        for i in range(start, stop, stride):
            if excess[i] > 0:
                amount = min(excess[i], reach[i])
                capacity[i, d] -= amount
                capacity[i + step, d ^ 1] += amount
                excess[i] -= amount
                excess[i + step] += amount
