"""Alpha-expansion (section 3.4; Boykov, Veksler and Zabih 2001), coarse to fine.

One expansion lets every site keep its label or take the label alpha, and finds the best of all
these labellings at once by a minimum cut; the energy never rises. Expansions of all labels are
repeated until none helps.

Cuts of the whole lattice are slow, so the labelling is first found on blocks of 2 x 2 sites: this
is the same energy, restricted to labellings that are constant on blocks. It is then polished on
the sites themselves, near the borders of each region.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from iconstudio.algorithms import maxflow
from iconstudio.algorithms.energy import SITES, Labels, RemixProblem
from iconstudio.model import CANVAS

LAMBDAS = tuple(float(v) for v in np.geomspace(0.03, 0.75, 8))
"""The values of lambda_S that are tried (section 3.4)."""
BLOCK = 2
BAND = 3
"""How far, in pixels, polishing may move the border of a region in one expansion."""


@dataclass(frozen=True, eq=False)
class Lattice:
    """The problem on blocks of ``block`` x ``block`` sites; each block is a node of the graph."""

    problem: RemixProblem
    block: int = 1

    @property
    def side(self) -> int:
        """Nodes in a row."""
        return CANVAS // self.block

    @cached_property
    def data(self) -> NDArray[np.float64]:
        """(K, nodes): data cost of each block."""
        b, n = self.block, self.side
        return (
            self.problem.data.reshape(-1, n, b, n, b).sum(axis=(2, 4), dtype=np.float64)
        ).reshape(-1, n * n)

    @cached_property
    def edges(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Two arrays (e,): the nodes that an edge joins, left and right or upper and lower."""
        node = np.arange(self.side**2).reshape(self.side, self.side)
        return (
            np.concatenate([node[:, :-1].ravel(), node[:-1].ravel()]),
            np.concatenate([node[:, 1:].ravel(), node[1:].ravel()]),
        )

    @cached_property
    def pairs(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Two arrays (e, block): the pairs of sites that face each other across each edge."""
        b, n = self.block, self.side
        site = np.arange(SITES).reshape(n, b, n, b)
        right, lower = site[:, :, 1:, 0], site[1:, 0, :, :]
        left, upper = site[:, :, :-1, -1], site[:-1, -1, :, :]
        return (
            np.concatenate([left.transpose(0, 2, 1).reshape(-1, b), upper.reshape(-1, b)]),
            np.concatenate([right.transpose(0, 2, 1).reshape(-1, b), lower.reshape(-1, b)]),
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
        """Return the labels of the blocks' first sites, (nodes,)."""
        return labels[:: self.block, :: self.block].ravel()

    def full(self, labels: Labels) -> Labels:
        """Return a labelling of the blocks on the sites, (CANVAS, CANVAS)."""
        grid = labels.reshape(self.side, self.side)
        return grid.repeat(self.block, axis=0).repeat(self.block, axis=1)


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


def minimise(lattice: Lattice, labels: Labels, lambda_s: float, band: int | None = None) -> Labels:
    """Repeat expansions from ``labels`` (nodes,) until none of the K labels helps.

    With ``band``, an expansion of alpha changes only nodes within that distance of its region.
    """
    count = len(lattice.data)
    idle, alpha = 0, 0
    while idle < count:
        free = _near(labels == alpha, lattice.side, band) if band else None
        labels, gain = expand(lattice, labels, alpha, lambda_s, free)
        idle = 0 if gain > 0 else idle + 1
        alpha = (alpha + 1) % count
    return labels


def remix(problem: RemixProblem, lambda_s: float, start: Labels | None = None) -> Labels:
    """Return labels (CANVAS, CANVAS) of low energy (equation 5).

    ``start`` is a labelling to begin with, such as the answer for the next higher lambda_S:
    sweeping from high to low reaches lower energies than beginning anew. Without it, each site
    begins with its cheapest label.
    """
    fine, coarse = Lattice(problem), Lattice(problem, BLOCK)
    cheapest = coarse.data.argmin(axis=0).astype(np.uint8)
    blocks = cheapest if start is None else coarse.reduced(start)
    labels = coarse.full(minimise(coarse, blocks, lambda_s))
    if start is not None and energy(problem, start, lambda_s) < energy(problem, labels, lambda_s):
        labels = start
    return minimise(fine, labels.ravel(), lambda_s, BAND).reshape(CANVAS, CANVAS)


def energy(problem: RemixProblem, labels: Labels, lambda_s: float) -> float:
    """Return F(L) of equation 5."""
    data, smoothness = problem.costs(labels)
    return data + lambda_s * smoothness


def _near(region: NDArray[np.bool_], side: int, reach: int) -> NDArray[np.bool_]:
    picture = region.reshape(side, side).view(np.uint8)
    return ndimage.maximum_filter(picture, 2 * reach + 1, mode="constant").ravel().view(bool)
