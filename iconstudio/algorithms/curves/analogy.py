"""A : A' :: B : B' at one level (section 3.3): SYNTHESIZEANALOGY and REFINEANALOGY."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.curves.constraints import Constraint, combined
from iconstudio.algorithms.curves.curve import Curve, Numbers
from iconstudio.algorithms.curves.neighbourhoods import directions, weights
from iconstudio.algorithms.curves.parameters import Parameters
from iconstudio.algorithms.curves.pyramid import Level
from iconstudio.algorithms.curves.search import Costs, Rows, begin, refine


@dataclass(frozen=True, eq=False)
class Synthesised:
    """A curve, and the candidate that each of its points was taken from, (n,)."""

    curve: Curve
    sources: NDArray[np.int64]


class Search:
    """Makes a curve B' for B from an example at one level.

    Parameters
    ----------
    random
        (1,) the state of the random numbers, which goes on.
    """

    def __init__(
        self,
        level: Level,
        plain: Curve,
        parameters: Parameters,
        rotation: bool,
        shape: bool,
        random: NDArray[np.uint64],
    ) -> None:
        self._level, self._plain, self._random = level, plain, random
        self._reach = parameters.reach
        w = weights(parameters)
        coarse = 0.0 if level.coarser is None else parameters.coarse
        self._costs = Costs(
            samples=w,
            ways=parameters.tangents * level.spacing**2 * (w[1:] + w[:-1]) / 2,
            shape=parameters.shape if shape else 0.0,
            alignment=parameters.shape if shape else parameters.alignment,
            coarse=coarse,
            offset=parameters.offset,
            coarse_offset=parameters.offset if coarse else 0.0,
            incoherent=parameters.incoherent,
            epsilon=parameters.epsilon,
            rotation=rotation,
        )

    def begin(self, constraints: Sequence[Constraint] = ()) -> Synthesised:
        """Return a curve made from its start on (SYNTHESIZEANALOGY)."""
        level, plain = self._level, self._plain
        count = max(4, round(plain.length * level.lengthening / level.spacing))
        at = np.linspace(0, plain.end, count + 1)
        if plain.closed:
            at = at[:-1]
        points, sources = np.empty(len(at), complex), np.empty(len(at), np.int64)
        pulls = combined(constraints, at)
        begin(
            level.styled, level.plain, level.order, self._costs, level.spacing, True,
            self._rows(plain, at), *pulls, self._random, points, sources, 0,
        )  # fmt: skip
        return Synthesised(Curve(points, at, plain.end, plain.closed), sources)

    def refined(
        self,
        made: Synthesised,
        coarser: Curve | None,
        constraints: Sequence[Constraint] = (),
    ) -> Synthesised:
        """Return a curve whose points have been looked for once more (REFINEANALOGY)."""
        level, curve = self._level, made.curve
        points, sources = curve.points.copy(), made.sources.copy()
        rows = self._rows(self._plain, curve.parameters)
        coarse_rows = rows if coarser is None else self._rows(coarser, curve.parameters)
        refine(
            level.styled, level.plain, level.coarser or level.plain, level.order, self._costs,
            level.spacing, curve.closed, True, rows, coarser is not None, coarse_rows,
            *combined(constraints, curve.parameters), self._random, points, sources,
        )  # fmt: skip
        return Synthesised(Curve(points, curve.parameters, curve.end, curve.closed), sources)

    def _rows(self, curve: Curve, parameters: Numbers) -> Rows:
        """Return the neighbourhoods of a curve at parameters; those of an open one end with it."""
        offsets = self._level.spacing * np.arange(-self._reach, self._reach + 1)
        along = curve.arc_at(parameters)[:, None] + offsets
        samples = curve.at_arc(along)
        first = np.zeros(len(along), np.int64)
        last = np.full(len(along), 2 * self._reach)
        if not curve.closed:
            first = np.minimum((along < -1e-9).sum(axis=1), self._reach)
            last = 2 * self._reach - np.minimum(
                (along > curve.length + 1e-9).sum(axis=1), self._reach
            )
        return Rows(samples, np.ascontiguousarray(directions(samples.T).T), first, last)
