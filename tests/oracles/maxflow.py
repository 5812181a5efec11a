"""Minimum cuts of binary energies: the adapter of PyMaxflow."""

import maxflow
import numpy as np
from numpy.typing import NDArray


def minimise(
    unary: NDArray[np.float64],
    first: NDArray[np.int64],
    second: NDArray[np.int64],
    pairwise: NDArray[np.float64],
) -> NDArray[np.bool_]:
    """Return the x in {0, 1}^n of least energy, exactly.

    The energy is ``sum unary[i] x[i] + sum pairwise[e] (1 - x[first[e]]) x[second[e]]``.

    Parameters
    ----------
    unary
        (n,), of any sign.
    first, second
        (e,) node numbers.
    pairwise
        (e,), not negative.
    """
    graph = maxflow.Graph[float](len(unary), len(first))
    nodes = graph.add_grid_nodes(len(unary))
    # A node on the sink's side has x = 1 and pays its source capacity.
    graph.add_grid_tedges(nodes, np.maximum(unary, 0), np.maximum(-unary, 0))
    graph.add_edges(first, second, pairwise, np.zeros_like(pairwise))
    graph.maxflow()
    return graph.get_grid_segments(nodes)
