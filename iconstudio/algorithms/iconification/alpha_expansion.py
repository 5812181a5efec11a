"""Alpha-expansion for many lambda_S, each helping the others (section 3.4).

The method is that of Boykov, Veksler and Zabih (2001), as the paper has it.

Importing this module loads numba, so only the process that cuts should do so.

Alpha-expansion ends in one of many local minima, and in which depends on where it begins. What a
labelling costs is D + lambda_S S, so each that is found counts for other lambda_S, too, and each
search begins with the best one it may know.

What is exact: every expansion is the best one (``expansion_capacities``, ``mincut.cuts``) on its
lattice, of blocks or of sites near seams; so no search ends above its beginning. Energies are whole
numbers of ``expansion_capacities.UNIT`` parts, some 1e-5 off. Debug runs (``check``) assert that
flows are feasible, cuts worth their flow, and energies never rise.

What is heuristic, in the order of the work:

1. ``preview``: expansions on blocks of 2 x 2 sites. The energy is the true one, restricted to
   labellings that are constant on blocks: a quarter of the nodes, a tenth of the time. It begins
   with the best on blocks of 4 x 4: from where the data cost rules, at the lowest lambda_S, up to
   the one that is wanted; and from what is known, such as the result before an edit.
2. ``find`` looks for good regions to begin in, for one of a row of lambda_S: on blocks of 2 x 2
   from the lowest lambda_S up to it, each from the last, and from the highest down to it, in either
   way through half of the row at least; and those on 4 x 4 blocks, from the cheapest labels, that
   are nearly as good as the best of these are improved on 2 x 2. It ends with expansions on the
   sites near the seams of the best labelling: elsewhere next to nothing is gained. Where several
   pictures cost nearly the same, what they are worth to the eye may choose which. The rises and
   falls are kept for the others of the row.

What ``find`` returns depends on the problem, the value and the row alone: not on what was asked
before, nor on previews. (A minimum cut need not be the only one, but each network gives the one
with the fewest sites that change, however much flow it had.)
Everything is deterministic: the same calls in the same order give the same labellings.
"""

from collections.abc import Callable, Collection, Iterable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.block_expansion import (
    LARGEST,
    BlockExpansion,
    plane_words,
)
from iconstudio.algorithms.iconification.energy import Labels, RemixProblem, joined_ink
from iconstudio.model import CANVAS

BLOCK = 2
COARSE = 4
RISES = 4
"""In how many steps a preview goes from the lowest lambda_S to the one that is wanted."""
PROMISING = 1.03
"""An energy this much above the best that is found is worth refining."""
NEARLY = 1.015
"""Energies are nearly equal up to this ratio: about what expansions lose beside the optimum."""
DIFFERENT = 0.03
"""Pictures are different if more than this part of the ink is."""
LOWEST = 0.03
"""The least lambda_S that is usual on the paper's canvas: there the data cost rules."""
ROUNDING = 1e-4
"""The energy that whole numbers stand for may be so much off, in parts of it."""


class Found(NamedTuple):
    """A labelling (m, m), and what it costs."""

    data: float
    smoothness: float
    labels: Labels

    def energy(self, lambda_s: float) -> float:
        """Return F(L) for a lambda_S (equation 5)."""
        return self.data + lambda_s * self.smoothness


class AlphaExpansion:
    """The labellings of a problem found so far, and the means to find better ones.

    ``stop`` is asked every few milliseconds; when it says so, ``Stopped`` is raised, and all that
    was found can still be used. With ``check``, for debug runs, the invariants are asserted: every
    flow is feasible, every cut is worth its flow (``check_cut``), and no search ends above its
    beginning.
    """

    def __init__(
        self,
        problem: RemixProblem,
        stop: Callable[[], bool] = lambda: False,
        check: bool = False,
    ) -> None:
        self._check = check
        self._problem = problem
        self._stop = stop
        self._words = plane_words(problem)
        self._blocks: dict[int, BlockExpansion] = {}
        self._known: list[Found] = []
        self._chains: dict[tuple[int, tuple[float, ...]], Found] = {}

    def add(self, labels: Labels) -> None:
        """Make a labelling (m, m) known, such as that of a similar problem."""
        self._known.append(Found(*self._problem.costs(labels), labels))

    def best(self, lambda_s: float) -> Labels:
        """Return the best labelling known, (m, m)."""
        return _best(self._known, lambda_s).labels

    def energy(self, lambda_s: float) -> float:
        """Return the energy of the best labelling known."""
        return _best(self._known, lambda_s).energy(lambda_s)

    def preview(self, lambda_s: float) -> Labels:
        """Return a good labelling soon, (m, m); what is known already is improved, too."""
        if self._known:
            self._descend(COARSE, lambda_s, self.best(lambda_s))
        self._rise(lambda_s)
        self._descend(BLOCK, lambda_s, self.best(lambda_s))
        return self.best(lambda_s)

    def find(
        self,
        lambda_s: float,
        row: Iterable[float],
        worth: Callable[[Labels], float] | None = None,
    ) -> Labels:
        """Return a labelling of low energy, (m, m), whatever else is known.

        Parameters
        ----------
        lambda_s
            One of the values of ``row``, for which labellings are looked for, too.
        worth
            Chooses among pictures whose energies are nearly equal: the larger, the better.
        """
        values = sorted(row)
        at = values.index(lambda_s)
        half = len(values) // 2  # at least so many on the way, for those near the ends
        rising, falling = values[: max(at, half) + 1], values[min(at, len(values) - 1 - half) :]
        found = [*self._chain(tuple(rising)), *self._chain(tuple(falling[::-1]))]
        for value in values[max(0, at - 1) : at + 2]:
            coarse = self._kept(COARSE, (value,))
            if coarse.energy(lambda_s) < PROMISING * _best(found, lambda_s).energy(lambda_s):
                found.append(self._descend(BLOCK, lambda_s, coarse.labels))
        chosen = _best(found, lambda_s)
        if worth is not None:
            near = self._near(found, lambda_s)
            chosen = max(near, key=lambda one: worth(one.labels)) if near[1:] else chosen
        return self._descend(1, lambda_s, chosen.labels).labels

    def _near(self, found: Sequence["Found"], lambda_s: float) -> list["Found"]:
        """Return the best, and others of nearly its energy that look different, by energy."""
        least = _best(found, lambda_s).energy(lambda_s)
        near: list[tuple[Found, NDArray[np.bool_]]] = []
        for one in sorted(found, key=lambda one: one.energy(lambda_s)):
            if one.energy(lambda_s) <= NEARLY * least:
                ink = joined_ink(self._problem.ink, one.labels)
                if all((ink ^ other).sum() > DIFFERENT * ink.sum() for _, other in near):
                    near.append((one, ink))
        return [one for one, _ in near]

    def find_without(self, lambda_s: float, without: Collection[int]) -> Labels:
        """Return a labelling of low energy, (m, m), that has none of some labels.

        At least one label must be left. Nothing else that is known plays a part.
        """
        labels = self._rise(lambda_s, without)
        for block in (BLOCK, 1):
            labels = self._descend(block, lambda_s, labels, without).labels
        return labels

    def solve(self, lambda_s: float) -> Labels:
        """Return a labelling of low energy, (m, m), that is no worse than any that is known."""
        if not self._known:
            self._descend(BLOCK, lambda_s, None)
        self._descend(1, lambda_s, self.best(lambda_s))
        return self.best(lambda_s)

    def _rise(self, lambda_s: float, without: Collection[int] = ()) -> Labels:
        """Return what is found on coarse blocks on the way up to a lambda_S."""
        lowest = LOWEST * self._problem.side / CANVAS
        first, *others = np.geomspace(min(lowest, lambda_s), lambda_s, RISES)
        labels = self._descend(COARSE, first, None, without).labels
        for value in others:
            labels = self._descend(COARSE, value, labels, without).labels
        return labels

    def _chain(self, values: tuple[float, ...]) -> list["Found"]:
        """Return what is found for values one after another, each from the last."""
        return [self._kept(BLOCK, values[: count + 1]) for count in range(len(values))]

    def _kept(self, block: int, values: tuple[float, ...]) -> "Found":
        """Return what is found at the end of a chain of values, and remember it."""
        key = block, values
        if key not in self._chains:
            start = self._kept(block, values[:-1]).labels if values[1:] else None
            self._chains[key] = self._descend(block, values[-1], start)
        return self._chains[key]

    def _descend(
        self, block: int, lambda_s: float, start: Labels | None, without: Collection[int] = ()
    ) -> "Found":
        """Expand from ``start``, the cheapest labels if None, and remember what is found."""
        if block not in self._blocks:
            self._blocks[block] = BlockExpansion(self._problem, block, self._words, self._check)
        blocks = self._blocks[block]
        labels = blocks.cheapest(without) if start is None else blocks.reduced(start)
        if block == 1:
            blocks.hold(labels)
        before = blocks.full(labels) if self._check else None
        blocks.descend(labels, lambda_s, self._stop, without)
        if block == 1:
            blocks.let_go()
        self.add(blocks.full(labels))
        found = self._known[-1]
        if before is not None:
            fallen = self._energy(before, lambda_s) - self._energy(found.labels, lambda_s)
            assert fallen >= -ROUNDING * self._energy(before, lambda_s)
        return found

    def _energy(self, labels: Labels, lambda_s: float) -> float:
        data, smoothness = self._problem.costs(labels)
        return data + min(lambda_s, LARGEST) * smoothness


def _best(found: Sequence[Found], lambda_s: float) -> Found:
    """Return what costs least; the first of equals."""
    return min(found, key=lambda one: one.energy(lambda_s))
