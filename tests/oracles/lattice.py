"""The graph of a remix, edge by edge, as plain alpha-expansion cuts it (section 3.4)."""

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification import lattice
from iconstudio.algorithms.iconification.energy import Labels
from iconstudio.algorithms.iconification.symmetry import mirrored
from iconstudio.algorithms.raster import Scalar


class Lattice(lattice.Lattice):
    """The blocks, the edges between them, and what these cost."""

    @cached_property
    def _first_block(self) -> NDArray[np.int64]:
        return np.unique(self.node, return_index=True)[1]

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

    def grid(self, values: NDArray[Scalar]) -> NDArray[Scalar]:
        """Return values of the nodes on the blocks, (side, side)."""
        return values[self.node].reshape(self.side, self.side)


def _key(p: NDArray[np.int64], q: NDArray[np.int64], side: int) -> NDArray[np.int64]:
    """Return a number for each undirected edge between blocks."""
    return np.minimum(p, q) * side**2 + np.maximum(p, q)
