"""Alpha-expansion (section 3.4; Boykov, Veksler and Zabih 2001), the plain way.

One expansion lets every site keep its label or take the label alpha, and finds the best of all
these labellings at once by a minimum cut; the energy never rises. Expansions of all labels are
repeated until none helps.

The program itself cuts by ``sweep``, on the same lattices and many times as fast; the expansions
here are the oracle that its tests and benchmarks compare it with.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms import maxflow
from iconstudio.algorithms.energy import Labels, RemixProblem
from iconstudio.algorithms.symmetry import mirrored

LAMBDAS = tuple(float(v) for v in np.geomspace(0.03, 0.75, 8))
"""The values of lambda_S that are tried on the paper's canvas (section 3.4)."""


@dataclass(frozen=True, eq=False)
class Lattice:
    """The problem on blocks of ``block`` x ``block`` sites.

    Each block is a node of the graph; under a symmetry constraint, a block and its mirror image
    are one node together (section 3.4, equation 9): the result is symmetric at half the cost.
    """

    problem: RemixProblem
    block: int = 1

    @property
    def side(self) -> int:
        """Blocks in a row."""
        return self.problem.side // self.block

    @cached_property
    def node(self) -> NDArray[np.int64]:
        """(side * side,): the node of each block."""
        block = np.arange(self.side**2)
        if self.problem.symmetry is None:
            return block
        pair = np.minimum(block, mirrored(self.side, self.problem.symmetry))
        return np.unique(pair, return_inverse=True)[1]

    @cached_property
    def _first_block(self) -> NDArray[np.int64]:
        return np.unique(self.node, return_index=True)[1]

    @cached_property
    def data(self) -> NDArray[np.float64]:
        """(K, nodes): data cost of each node."""
        b, n = self.block, self.side
        blocks = np.zeros((len(self.problem.data), n * n))
        for one, out in zip(self.problem.data, blocks, strict=True):
            rows = one.reshape(n, b, n * b).sum(axis=1, dtype=np.float64)
            for k in range(b):
                out += rows[:, k::b].ravel()
        if self.problem.symmetry is None:
            return blocks
        return np.stack([np.bincount(self.node, row) for row in blocks])

    @cached_property
    def edges(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Two arrays (e,): the nodes that an edge joins."""
        return self._graph[0], self._graph[1]

    @cached_property
    def pairs(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Two arrays (e, p): the pairs of sites that face each other across each edge."""
        return self._graph[2], self._graph[3]

    @cached_property
    def _graph(self) -> tuple[NDArray[np.int64], ...]:
        """The nodes that each edge joins, and its pairs of sites."""
        b, n = self.block, self.side
        site = np.arange(self.problem.side**2).reshape(n, b, n, b)
        right, lower = site[:, :, 1:, 0], site[1:, 0, :, :]
        left, upper = site[:, :, :-1, -1], site[:-1, -1, :, :]
        first = np.concatenate([left.transpose(0, 2, 1).reshape(-1, b), upper.reshape(-1, b)])
        second = np.concatenate([right.transpose(0, 2, 1).reshape(-1, b), lower.reshape(-1, b)])
        block = np.arange(n * n).reshape(n, n)
        p = np.concatenate([block[:, :-1].ravel(), block[:-1].ravel()])
        q = np.concatenate([block[:, 1:].ravel(), block[1:].ravel()])
        if self.problem.symmetry is None:
            return p, q, first, second
        # Every edge has a mirror image between the same two nodes: of both, one is kept, with the
        # pairs of both. Across the axis a node faces itself, which costs nothing.
        image = mirrored(n, self.problem.symmetry)
        here, there = _key(p, q, n), _key(image[p], image[q], n)
        kept = here < there
        r = mirrored(self.problem.side, self.problem.symmetry)
        return (
            self.node[p[kept]],
            self.node[q[kept]],
            np.concatenate([first[kept], r[first[kept]]], axis=1),
            np.concatenate([second[kept], r[second[kept]]], axis=1),
        )

    def smoothness(
        self, edges: NDArray[np.int64], label_first: Labels, label_second: Labels
    ) -> NDArray[np.float64]:
        """Return F_S summed over the pairs of sites of each of ``edges``, (e,)."""
        out = np.zeros(len(edges))
        cut = np.flatnonzero(label_first != label_second)
        first, second = self.pairs
        cost = self.problem.smoothness(
            first[edges[cut]],
            second[edges[cut]],
            label_first[cut][:, None],
            label_second[cut][:, None],
        )
        out[cut] = cost.sum(axis=1, dtype=np.float64)
        return out

    def reduced(self, labels: Labels) -> Labels:
        """Return the labels of the nodes' first sites, (nodes,)."""
        return labels[:: self.block, :: self.block].ravel()[self._first_block]

    def full(self, labels: Labels) -> Labels:
        """Return a labelling of the nodes on the sites, (m, m)."""
        return self.grid(labels).repeat(self.block, axis=0).repeat(self.block, axis=1)

    def grid(self, values: NDArray) -> NDArray:
        """Return values of the nodes on the blocks, (side, side)."""
        return values[self.node].reshape(self.side, self.side)


def _key(p: NDArray[np.int64], q: NDArray[np.int64], side: int) -> NDArray[np.int64]:
    """Return a number for each undirected edge between blocks."""
    return np.minimum(p, q) * side**2 + np.maximum(p, q)


def expand(
    lattice: Lattice,
    labels: Labels,
    alpha: int,
    lambda_s: float,
    free: NDArray[np.bool_] | None = None,
) -> tuple[Labels, float]:
    """Return the best labelling within one expansion of ``alpha``, and how much it gains.

    Parameters
    ----------
    labels
        (nodes,) current labels.
    free
        (nodes,) bool: nodes that may change; all if None. The others keep their labels.

    Returns
    -------
    labels, gain
        The energy falls by ``gain``; where it would be 0, ``labels`` comes back unchanged.
    """
    movable = labels != alpha
    if free is not None:
        movable &= free
    count = int(movable.sum())
    if count == 0:
        return labels, 0.0
    first, second = lattice.edges
    edges = np.flatnonzero(movable[first] | movable[second])
    p, q = first[edges], second[edges]
    a, b = labels[p], labels[q]
    a_moved = np.where(movable[p], np.uint8(alpha), a)
    b_moved = np.where(movable[q], np.uint8(alpha), b)
    # E(x_p, x_q) for x = 1 where a node takes alpha.
    e00 = lambda_s * lattice.smoothness(edges, a, b)
    e01 = lambda_s * lattice.smoothness(edges, a, b_moved)
    e10 = lambda_s * lattice.smoothness(edges, a_moved, b)
    e11 = lambda_s * lattice.smoothness(edges, a_moved, b_moved)
    nodes = np.flatnonzero(movable)
    unary = np.zeros(len(labels))
    unary[nodes] = lattice.data[alpha, nodes] - lattice.data[labels[nodes], nodes]
    # E = e00 + (e10 - e00) x_p + (e11 - e10) x_q + (e01 + e10 - e00 - e11) (1 - x_p) x_q, where the
    # last bracket is not negative because F_S is a metric.
    unary += np.bincount(p, e10 - e00, len(labels)) + np.bincount(q, e11 - e10, len(labels))
    pairwise = np.maximum(e01 + e10 - e00 - e11, 0)
    joined = np.flatnonzero(movable[p] & movable[q] & (pairwise > 0))
    number = np.cumsum(movable) - 1
    taken = maxflow.minimise(unary[nodes], number[p[joined]], number[q[joined]], pairwise[joined])
    if not taken.any():
        return labels, 0.0
    moved = labels.copy()
    moved[nodes[taken]] = alpha
    x = np.zeros(len(labels))
    x[nodes[taken]] = 1
    xp, xq = x[p], x[q]
    change = (unary * x).sum() + ((e01 + e10 - e00 - e11) * (1 - xp) * xq).sum()
    # Rounding may make a worthless move; the energy must never rise.
    return (moved, -change) if change < -1e-9 else (labels, 0.0)


def minimise(lattice: Lattice, labels: Labels, lambda_s: float) -> Labels:
    """Repeat expansions from ``labels`` (nodes,) until none of the K labels helps."""
    count = len(lattice.data)
    idle, alpha = 0, 0
    while idle < count:
        labels, gain = expand(lattice, labels, alpha, lambda_s)
        idle = 0 if gain > 0 else idle + 1
        alpha = (alpha + 1) % count
    return labels


def energy(problem: RemixProblem, labels: Labels, lambda_s: float) -> float:
    """Return F(L) of equation 5."""
    data, smoothness = problem.costs(labels)
    return data + lambda_s * smoothness
