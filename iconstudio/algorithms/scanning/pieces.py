"""Pieces of a bitmap in which colours do not leap."""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import greatest_channel


def pieces_alike(
    levels: NDArray[np.float32], where: NDArray[np.bool_], leap: float
) -> NDArray[np.intp]:
    """Return the number (h, w) of the piece that each pixel of (h, w, c) belongs to.

    Neighbours, of which both are ``where``, are in one piece if no channel differs by ``leap``.
    """
    index = np.arange(where.size).reshape(where.shape)
    meet = []
    for one, other in ((np.s_[1:], np.s_[:-1]), (np.s_[:, 1:], np.s_[:, :-1])):
        alike = greatest_channel(abs(levels[one] - levels[other])) < leap
        alike &= where[one] & where[other]
        meet.append(np.stack([index[one][alike], index[other][alike]]))
    rows, columns = np.concatenate(meet, axis=1)
    graph = scipy.sparse.coo_array((np.ones(len(rows)), (rows, columns)), (where.size,) * 2)
    number: NDArray[np.intp]
    _, number = scipy.sparse.csgraph.connected_components(graph, directed=False)
    return number.reshape(where.shape)
