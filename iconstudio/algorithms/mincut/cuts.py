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

**Trees.** The rest is sent by the method of Boykov and Kolmogorov (2004): trees of residual
capacities grow from all excess, positive and negative; where two of different kind meet flow is
sent from root to root; what that cuts off its root is adopted by a neighbour or set free. Distances
to the root and their age keep trees flat, as in the authors' program.

Every node needs four neighbours: grids have a border of nodes without excess and capacities.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.compiled import entry, inner

SOURCE = 1
"""In ``Trees.tree``: on the source's side."""

_FREE, _SINK = 0, 2
_ROOT, _ORPHAN = 4, 5
"""Instead of the direction of a node's parent."""
_FAR = 1 << 30
_MOST = 1 << 29
"""The largest capacity or excess of a block; what is more is left to the nodes."""

SLICE = 1 << 14
"""Nodes that trees grow from before ``ask`` is called: a few milliseconds."""
SMALLEST = 64
"""Smaller grids are not cut coarsely first."""

Integers = NDArray[np.int32]


class Trees(NamedTuple):
    """Scratch space of a cut; afterwards ``tree`` is SOURCE for the nodes on the source's side."""

    tree: NDArray[np.int8]
    parent: NDArray[np.int8]
    age: Integers
    distance: Integers
    queue: Integers
    queued: NDArray[np.bool_]
    orphans: Integers


def new_trees(size: int) -> Trees:
    """Return scratch space for ``size`` nodes."""
    small, wide = np.zeros((2, size), np.int8), np.zeros((4, size), np.int32)
    return Trees(*small, *wide[:3], np.zeros(size, np.bool_), wide[3])


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
    place = np.array([0, _plant(excess, trees, anew), 0, -1])
    while _send_in_trees(offset, capacity, excess, trees, anew, place, SLICE):
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
def _add_up(width, capacity, excess, wide, coarse, sums):
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
def _sum(one, other):
    return min(np.int64(one) + other, _MOST)


@entry
def _spread(width, capacity, excess, wide, coarse):
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
def _push(capacity, excess, i, j, d, amount):
    """Send an amount of either sign from node i to its neighbour j in direction d."""
    capacity[i, d] -= amount
    capacity[j, d ^ 1] += amount
    excess[i] -= amount
    excess[j] += amount


@entry
def _send_in_trees(offset, capacity, excess, trees, anew, place, most):
    """Send the rest of the flow, from at most so many nodes; return whether there is more to do.

    ``place`` is where the work is, to go on from: head and count of the queue, the time, and the
    node that trees grow from, or -1.
    """
    size = excess.size
    head, count, time, here = place
    while (here >= 0 or count > 0) and most > 0:
        most -= 1
        if here < 0:
            here = trees.queue[head]
            head = head + 1 if head + 1 < size else 0
            count -= 1
            trees.queued[here] = False
        if trees.tree[here] == _FREE:
            here = -1
            continue
        met, count = _grow(offset, capacity, trees, here, head, count)
        if met < 0:
            here = -1
            continue
        time += 1
        orphans = _send(offset, capacity, excess, trees, here, met)
        count = _adopt(offset, capacity, trees, time, orphans, head, count, anew)
    place[0], place[1], place[2], place[3] = head, count, time, here
    return here >= 0 or count > 0


@entry
def _send_in_chains(offset, capacity, excess, reach):
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


@entry
def _plant(excess, trees, anew):
    """Make every node with excess a tree of its own, and active; return how many."""
    tree, parent, age, distance, queue, queued, _ = trees
    count = 0
    for i in range(excess.size):
        age[i] = 0
        queued[i] = excess[i] > 0 or (anew and excess[i] < 0)
        if excess[i] != 0:
            tree[i] = SOURCE if excess[i] > 0 else _SINK
            parent[i], distance[i] = _ROOT, 1
            if queued[i]:
                queue[count] = i
                count += 1
        else:
            tree[i], parent[i] = _FREE, _ORPHAN
    return count


@inner
def _activate(trees, i, head, count):
    """Put a node at the end of the ring of active nodes, once; return how many there are."""
    if trees.queued[i]:
        return count
    trees.queued[i] = True
    last = head + count
    trees.queue[last if last < trees.queue.size else last - trees.queue.size] = i
    return count + 1


@inner
def _grow(offset, capacity, trees, i, head, count):
    """Add free neighbours to the tree of i; stop and return the direction of the other tree."""
    tree, parent, age, distance, _, _, _ = trees
    side = tree[i]
    for d in range(4):
        j = i + offset[d]
        if (capacity[i, d] if side == SOURCE else capacity[j, d ^ 1]) <= 0:
            continue
        if tree[j] == _FREE:
            tree[j] = side
            parent[j], age[j], distance[j] = d ^ 1, age[i], distance[i] + 1
            count = _activate(trees, j, head, count)
        elif tree[j] != side:
            return d, count
        elif age[j] <= age[i] and distance[j] > distance[i]:
            parent[j], age[j], distance[j] = d ^ 1, age[i], distance[i] + 1
    return -1, count


@inner
def _send(offset, capacity, excess, trees, i, met):
    """Send flow from root to root across the edge where two trees meet; return the orphans made."""
    parent = trees.parent
    if trees.tree[i] == _SINK:
        i += offset[met]
        met ^= 1
    other = i + offset[met]
    amount = capacity[i, met]
    p = i
    while parent[p] != _ROOT:
        d = parent[p]
        p += offset[d]
        amount = min(amount, capacity[p, d ^ 1])
    amount = min(amount, excess[p])
    q = other
    while parent[q] != _ROOT:
        amount = min(amount, capacity[q, parent[q]])
        q += offset[parent[q]]
    amount = min(amount, -excess[q])
    capacity[i, met] -= amount
    capacity[other, met ^ 1] += amount
    orphans = 0
    for node, way in ((i, -1), (other, 1)):
        while parent[node] != _ROOT:
            d = parent[node]
            up = node + offset[d]
            capacity[node, d] -= way * amount
            capacity[up, d ^ 1] += way * amount
            if (capacity[node, d] if way > 0 else capacity[up, d ^ 1]) == 0:
                parent[node] = _ORPHAN
                trees.orphans[orphans] = node
                orphans += 1
            node = up
        excess[node] += way * amount
        if excess[node] == 0:
            parent[node] = _ORPHAN
            trees.orphans[orphans] = node
            orphans += 1
    return orphans


@inner
def _adopt(offset, capacity, trees, time, left, head, count, anew):
    """Find each orphan a parent in its tree, or set it free, which may make more orphans.

    Returns how many nodes are active.
    """
    tree, parent, age, distance, _, _, orphans = trees
    first = 0
    while left > 0:
        i = orphans[first]
        first = first + 1 if first + 1 < orphans.size else 0
        left -= 1
        side = tree[i]
        best, least = -1, _FAR
        for d in range(4):
            j = i + offset[d]
            if tree[j] == side and (capacity[j, d ^ 1] if side == SOURCE else capacity[i, d]) > 0:
                length = _depth(offset, parent, age, distance, time, j)
                if length < least:
                    best, least = d, length
        if best >= 0:
            parent[i], age[i], distance[i] = best, time, least + 1
            continue
        tree[i] = _FREE
        for d in range(4):
            j = i + offset[d]
            if tree[j] != side:
                continue
            if (anew or side == SOURCE) and (
                capacity[j, d ^ 1] if side == SOURCE else capacity[i, d]
            ) > 0:
                count = _activate(trees, j, head, count)
            if parent[j] == d ^ 1:
                parent[j] = _ORPHAN
                last = first + left
                orphans[last if last < orphans.size else last - orphans.size] = j
                left += 1
    return count


@inner
def _depth(offset, parent, age, distance, time, i):
    """Return how far a node is from its root, _FAR if it hangs from an orphan; mark the way."""
    length, node = 0, i
    while age[node] != time:
        length += 1
        if parent[node] == _ROOT:
            age[node], distance[node] = time, 1
            break
        if parent[node] == _ORPHAN:
            return _FAR
        node += offset[parent[node]]
    else:
        length += distance[node]
    node, below = i, length
    while age[node] != time:
        age[node], distance[node] = time, below
        below -= 1
        node += offset[parent[node]]
    return length
