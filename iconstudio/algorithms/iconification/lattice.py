"""The blocks of sites on which a remix is solved (section 3.4)."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.energy import RemixProblem
from iconstudio.algorithms.iconification.symmetry import mirrored


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
