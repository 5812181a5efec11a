"""Seams by exact minimum cuts: the adapter of PyMaxflow.

Where a new patch overlaps what is there, each pixel comes from one of the two; the cut between
them is the cheapest of all ("Graphcut Textures", Kwatra et al. 2003, in place of the seams that
image quilting finds by dynamic programming, which cannot close).
"""

import maxflow
import numpy as np
from numpy.typing import NDArray

_NEVER = 1e9


def minimum_seam(
    difference: NDArray[np.float32], there: NDArray[np.bool_], kept: NDArray[np.bool_]
) -> tuple[NDArray[np.bool_], float]:
    """Return which pixels of a patch are taken, and what the seam costs.

    Parameters
    ----------
    difference
        (h, w), how much the patch differs from what is there. A cut between two neighbours costs
        the sum of theirs.
    there
        (h, w), where anything is there; elsewhere the patch is taken.
    kept
        (h, w), where what is there stays.
    """
    if not there.any():
        return np.ones(there.shape, np.bool_), 0.0
    # Seams where nothing differs cost a little, too: short ones are better.
    cost = np.where(there, difference, 0.0).astype(float) + 1e-4
    graph = maxflow.GraphFloat(cost.size, 2 * cost.size)
    nodes = graph.add_grid_nodes(cost.shape)
    right, down = np.zeros_like(cost), np.zeros_like(cost)
    right[:, :-1] = cost[:, :-1] + cost[:, 1:]
    down[:-1] = cost[:-1] + cost[1:]
    graph.add_grid_edges(nodes, right, structure=_RIGHT, symmetric=True)
    graph.add_grid_edges(nodes, down, structure=_DOWN, symmetric=True)
    graph.add_grid_tedges(nodes, np.where(kept, _NEVER, 0.0), np.where(there, 0.0, _NEVER))
    value = graph.maxflow()
    return graph.get_grid_segments(nodes), value


_RIGHT = np.array([[0, 0, 0], [0, 0, 1], [0, 0, 0]])
_DOWN = np.array([[0, 0, 0], [0, 0, 0], [0, 1, 0]])
