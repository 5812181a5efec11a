"""Expansions of labels on blocks of sites: what alpha-expansion is made of (section 3.4).

Importing this module loads numba, so only the process that cuts should do so.
"""

from collections.abc import Callable, Collection

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter, minimum_filter
from iconstudio.algorithms.iconification.energy import EPSILON, F_INT, PATCH, Labels, RemixProblem
from iconstudio.algorithms.iconification.expansion_capacities import UNIT, move, update
from iconstudio.algorithms.iconification.expansion_network import (
    FREE,
    HELD,
    Box,
    Grid,
    Network,
    Smoothness,
    new_network,
    new_scratch,
)
from iconstudio.algorithms.iconification.lattice import Lattice
from iconstudio.algorithms.iconification.symmetry import mirrored
from iconstudio.algorithms.mincut.cuts import minimum_cut
from iconstudio.algorithms.mincut.trees import SOURCE, new_trees

SEAM_REACH = 5
"""Sites farther than this from a seam keep their labels in the end."""
FAR_FLOW = 0.5
"""From this lambda_S on, seams outweigh the data cost, so that flow goes far."""
LARGEST = 16.0
"""Above this lambda_S, expansions are made as if it were this, as whole numbers have an end."""
_DEAREST = 1 << 29
"""The largest data cost of a node, in units: more than all seams around it."""


class Stopped(Exception):  # noqa: N818 - nothing went wrong
    """The work was no longer wanted."""


class BlockExpansion:
    """A problem on blocks of ``block`` x ``block`` sites, and the networks of its labels.

    Labels here are arrays (N,) uint8 with the grid's border.
    """

    def __init__(
        self, problem: RemixProblem, block: int, words: NDArray[np.uint64], check: bool = False
    ) -> None:
        lattice = Lattice(problem, block)
        self._check = check
        side = problem.side // block
        width = side + 2
        self._inside = (np.arange(1, side + 1)[:, None] * width + np.arange(1, side + 1)).ravel()
        self._image = np.arange(side * side)
        if problem.symmetry is not None:
            self._image = np.minimum(self._image, mirrored(side, problem.symmetry))
        kept = np.zeros(width * width, np.int8)
        kept[self._inside] = np.where(self._image == np.arange(side * side), FREE, 0)
        self._nodes = kept > 0
        data = np.zeros((len(problem.data), width * width), np.int32)
        for costs, row in zip(lattice.data, data, strict=True):
            row[self._inside] = np.minimum(np.rint(costs * UNIT), _DEAREST)[lattice.node]
        offset = np.array([1, -1, width, -width], np.int32)
        self.grid = Grid(words, data, kept, offset, side, block)
        self._networks: list[Network | None] = [None] * len(data)
        self._trees = new_trees(width * width)
        self._scratch = new_scratch(len(words), problem.side, width * width)
        self.begin(1.0)

    def cheapest(self, without: Collection[int] = ()) -> Labels:
        """Return the labels of least data cost, but for some that are left out."""
        left = np.array([one for one in range(len(self.grid.data)) if one not in without])
        labels: Labels = left[self.grid.data[left].argmin(axis=0)].astype(np.uint8)
        return labels

    def reduced(self, labels: Labels) -> Labels:
        """Return the labels of the blocks' first sites; ``labels`` is (m, m)."""
        block = self.grid.block
        out = np.zeros(self.grid.kept.shape, np.uint8)
        out[self._inside] = labels[::block, ::block].ravel()
        return out

    def full(self, labels: Labels) -> Labels:
        """Return labels on the sites, (m, m)."""
        side, block = self.grid.side, self.grid.block
        picture: Labels = labels[self._inside][self._image].reshape(side, side)
        return picture.repeat(block, axis=0).repeat(block, axis=1)

    def hold(self, labels: Labels) -> None:
        """From the next ``begin`` on, let only nodes near seams of the labels change."""
        side = self.grid.side
        inside = (slice(1, -1), slice(1, -1))
        picture = labels.reshape(side + 2, side + 2)[inside]
        seam = maximum_filter(picture, 3) != minimum_filter(picture, 3)
        free = maximum_filter(seam, 2 * SEAM_REACH - 1)
        kept = np.zeros((side + 2, side + 2), np.int8)
        kept[inside] = np.where(free, FREE, np.where(maximum_filter(free, 3), HELD, 0))
        self.grid = self.grid._replace(kept=np.where(self._nodes, kept.ravel(), 0).astype(np.int8))

    def let_go(self) -> None:
        """Forget the networks, most of the memory; the next expansions begin anew."""
        self._networks = [None] * len(self._networks)

    def descend(
        self,
        labels: Labels,
        lambda_s: float,
        stop: Callable[[], bool],
        without: Collection[int] = (),
    ) -> None:
        """Expand all labels in turn but for some, in place, until none gains.

        Raises
        ------
        Stopped
            When ``stop()`` says so; asked every few milliseconds.
        """
        self.begin(lambda_s)

        def ask() -> None:
            if stop():
                raise Stopped

        left = [one for one in range(len(self._networks)) if one not in without]
        idle, number = 0, 0
        while idle < len(left):
            ask()
            idle = 0 if self.expand(labels, left[number], ask) else idle + 1
            number = (number + 1) % len(left)

    def begin(self, lambda_s: float) -> None:
        """Set lambda_S for the expansions to come, of any labels."""
        unit = min(lambda_s, LARGEST) * UNIT
        self._far = lambda_s >= FAR_FLOW
        root = np.ceil(unit * np.sqrt(np.arange(PATCH * PATCH + 1))).astype(np.int32)
        self.smoothness = Smoothness(root, int(np.ceil(unit * F_INT)), int(np.ceil(unit * EPSILON)))
        self._changed = [(0, self.grid.side, 0, self.grid.side)] * len(self._networks)

    def touch(self, box: Box) -> None:
        """Say that labels within a box have changed, one node or more from its border."""
        self._changed = [_joined(one, box) for one in self._changed]

    def expand(self, labels: Labels, alpha: int, ask: Callable[[], None] = lambda: None) -> int:
        """Make the best expansion of a label, in place; return what it gains, in units.

        ``labels`` are those of the last expansion, except where ``touch`` has been told. If ``ask``
        raises, called every few milliseconds, they are as before; then ``begin`` must come next.
        """
        box = self._changed[alpha]
        if box[0] >= box[1]:
            return 0
        self._changed[alpha] = (self.grid.side, 0, self.grid.side, 0)
        grid, trees = self.grid, self._trees
        network = self._networks[alpha]
        cold = network is None
        if network is None:
            network = self._networks[alpha] = new_network(len(grid.kept))
        if not update(grid, self.smoothness, network, self._scratch, labels, alpha, box):
            return 0
        full = box == (0, grid.side, 0, grid.side)
        far = cold and self._far
        total = network.excess.sum() if self._check else 0
        minimum_cut(grid.offset, network.capacity, network.excess, trees, full, far, ask)
        if self._check:
            check_cut(grid, network, trees.tree, int(total))
        gain, box = move(grid.side, network.excess, trees.tree, labels, alpha)
        if gain:
            self.touch(box)
        return gain


def plane_words(problem: RemixProblem) -> NDArray[np.uint64]:
    """Return ``Grid.words`` of a problem."""
    inside = problem.interior.reshape(len(problem.data), -1)
    words = problem.patches | inside.astype(np.uint64) << np.uint64(63)
    if problem.symmetry is None:
        return words[None]
    return np.stack([words, words[:, mirrored(problem.side, problem.symmetry)]])


def check_cut(grid: Grid, network: Network, tree: NDArray[np.int8], total: int) -> None:
    """Assert that a cut is minimum: its flow is feasible, and no more can be sent.

    ``total`` is the sum of the excess before: flow moves it, but nothing is lost.
    """
    taken = tree == SOURCE
    assert (network.capacity >= 0).all()
    assert network.excess.sum() == total
    assert (network.excess[taken] >= 0).all()
    assert (network.excess[~taken] <= 0).all()
    for d, step in enumerate(grid.offset.tolist()):
        assert not network.capacity[taken & ~np.roll(taken, -step), d].any()


def _joined(one: Box, other: Box) -> Box:
    """Return the box around two."""
    return (
        min(one[0], other[0]),
        max(one[1], other[1]),
        min(one[2], other[2]),
        max(one[3], other[3]),
    )
