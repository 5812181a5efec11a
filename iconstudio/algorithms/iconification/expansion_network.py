"""What the network of an alpha-expansion is made of: grid, costs, and the flow that is kept."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.mincut.trees import Integers

HELD, FREE = 1, 2
"""In ``Grid.kept``."""

Box = tuple[int, int, int, int]
"""First row, last row + 1, first column, last column + 1."""


class Grid(NamedTuple):
    """What is cut. N counts the nodes with the border, row by row."""

    words: NDArray[np.uint64]
    """(planes, K, sites): the patch of each site, 49 bits; bit 63 says interior structure."""
    data: Integers
    """(K, N): data cost."""
    kept: NDArray[np.int8]
    """(N,): ``FREE`` for nodes that may change, ``HELD`` for neighbours of these that keep their
    labels; 0 for all others, which are not looked at, and for what is no node of the grid."""
    offset: Integers
    """(4,): from a node to its right, left, lower and upper neighbour; d ^ 1 is the way back."""
    side: int
    """Nodes in a row, without the border."""
    block: int


class Smoothness(NamedTuple):
    """lambda_S times the parts of F_S (equations 7 and 8)."""

    root: Integers
    """(50,): by the number of bits in which two patches differ."""
    through: int
    """f_int."""
    least: int


class Network(NamedTuple):
    """The residual network of one label, kept from cut to cut."""

    capacity: Integers
    """(N, 4): what may still flow in each direction."""
    whole: Integers
    """(N, 2): the capacities to the right and down before anything flowed."""
    excess: Integers
    """(N,)"""


class Scratch(NamedTuple):
    """What ``update`` works with."""

    site: Integers
    """(3, planes, sites): the patch distance of each site's label and alpha; f_int if the label,
    and if alpha shows interior structure there, else 0."""
    row: Integers
    """(2, sites in a row)"""
    there: Integers
    """(2, N): the capacities to the right and down."""
    back: Integers
    """(2, N): the opposite ones."""


def new_scratch(planes: int, sites: int, size: int) -> Scratch:
    """Return what ``update`` works with, for a row of ``sites``, and ``size`` nodes."""
    return Scratch(
        np.zeros((3, planes, sites * sites), np.int32),
        np.zeros((2, sites), np.int32),
        *np.zeros((2, 2, size), np.int32),
    )


def new_network(size: int) -> Network:
    """Return a network of ``size`` nodes without any flow."""
    return Network(
        np.zeros((size, 4), np.int32), np.zeros((size, 2), np.int32), np.zeros(size, np.int32)
    )
