"""Sending flow along trees of residual capacities, compiled: the last part of a minimum cut.

By the method of Boykov and Kolmogorov (2004): trees of residual capacities grow from all excess,
positive and negative; where two of different kind meet flow is sent from root to root; what that
cuts off its root is adopted by a neighbour or set free. Distances to the root and their age keep
trees flat, as in the authors' program. What a network is, ``cuts`` says.
"""

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
    tree, parent = np.zeros((2, size), np.int8)
    age, distance, queue, orphans = np.zeros((4, size), np.int32)
    return Trees(tree, parent, age, distance, queue, np.zeros(size, np.bool_), orphans)


@entry
def plant(excess: Integers, trees: Trees, anew: bool) -> int:
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


@entry
def send_in_trees(
    offset: Integers,
    capacity: Integers,
    excess: Integers,
    trees: Trees,
    anew: bool,
    place: NDArray[np.int64],
    most: int,
) -> bool:
    """Send the rest of the flow, from at most so many nodes; return whether there is more to do.

    ``place`` is where the work is, to go on from: head and count of the queue, the time, and the
    node that trees grow from, or -1.
    """
    size = excess.size
    count: int
    here: int
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


@inner
def _activate(trees: Trees, i: int, head: int, count: int) -> int:
    """Put a node at the end of the ring of active nodes, once; return how many there are."""
    if trees.queued[i]:
        return count
    trees.queued[i] = True
    last = head + count
    trees.queue[last if last < trees.queue.size else last - trees.queue.size] = i
    return count + 1


@inner
def _grow(
    offset: Integers, capacity: Integers, trees: Trees, i: int, head: int, count: int
) -> tuple[int, int]:
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
def _send(
    offset: Integers, capacity: Integers, excess: Integers, trees: Trees, i: int, met: int
) -> int:
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
def _adopt(
    offset: Integers,
    capacity: Integers,
    trees: Trees,
    time: int,
    left: int,
    head: int,
    count: int,
    anew: bool,
) -> int:
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
def _depth(
    offset: Integers, parent: NDArray[np.int8], age: Integers, distance: Integers, time: int, i: int
) -> int:
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
