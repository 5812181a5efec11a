"""Alpha-expansion (section 3.4; Boykov, Veksler and Zabih 2001), the plain way.

One expansion lets every site keep its label or take the label alpha, and finds the best of all
these labellings at once by a minimum cut; the energy never rises. Expansions of all labels are
repeated until none helps. The program itself cuts by ``alpha_expansion``, many times as fast.
"""

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.energy import Labels, RemixProblem
from tests.oracles import maxflow
from tests.oracles.lattice import Lattice


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
