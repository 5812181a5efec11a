"""Curves at one level: new ones (section 3.1: SYNTHESIZECURVE), and A : A' :: B : B' (section 3.3:
SYNTHESIZEANALOGY and REFINEANALOGY).
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.curves.comparison import Rows
from iconstudio.algorithms.curves.constraints import Constraint, combined
from iconstudio.algorithms.curves.curve import Curve, Numbers, Points
from iconstudio.algorithms.curves.neighbourhoods import Neighbourhoods, bend, directions, weights
from iconstudio.algorithms.curves.parameters import Parameters
from iconstudio.algorithms.curves.passes import begin, refine
from iconstudio.algorithms.curves.pyramid import Level, carried
from iconstudio.algorithms.curves.search import Costs

_START = 3
"""Points that a new curve begins with, copied from A'."""


@dataclass(frozen=True, eq=False)
class Synthesised:
    """A curve, and the candidate that each of its points was taken from, (n,)."""

    curve: Curve
    sources: NDArray[np.int64]


class Search:
    """Makes curves at one level from an example: B' for B, or any if there is no B.

    Parameters
    ----------
    plain
        B, at this level.
    sweep
        What B's neighbourhoods are unbent along, unless their shape counts.
    random
        (1,) the state of the random numbers, which goes on.
    """

    def __init__(
        self,
        level: Level,
        plain: Curve | None,
        parameters: Parameters,
        random: NDArray[np.uint64],
        rotation: bool = True,
        shape: bool = False,
        sweep: Curve | None = None,
    ) -> None:
        self._level, self._plain, self._random = level, plain, random
        self._sweep = sweep
        self._reach = parameters.reach
        w = weights(parameters)
        coarse = 0.0 if level.coarser is None else parameters.coarse
        self._costs = Costs(
            samples=w,
            ways=parameters.tangents * level.spacing**2 * (w[1:] + w[:-1]) / 2,
            shape=parameters.shape if shape else 0.0,
            alignment=parameters.shape if shape else parameters.alignment,
            coarse=coarse,
            offset=parameters.offset if plain else 0.0,
            coarse_offset=parameters.offset if coarse else 0.0,
            incoherent=parameters.incoherent,
            stride=(parameters.reach + 0.01) * level.spacing,
            late=parameters.late,
            epsilon=parameters.epsilon,
            rotation=rotation,
        )

    def begin(self, constraints: Sequence[Constraint] = ()) -> Synthesised:
        """Return a curve made from its start on (SYNTHESIZEANALOGY)."""
        level, plain = self._level, self._plain
        assert plain is not None
        count = max(4, round(plain.length * level.lengthening / level.spacing))
        at = np.linspace(0, plain.end, count + 1)
        if plain.closed:
            # Once more over the start, to be cross-faded: so the end meets it.
            over = min(count // 3, 2 * self._reach)
            at = np.concatenate([at[:-1], plain.end + at[:over]])
        points, sources = np.empty(len(at), complex), np.empty(len(at), np.int64)
        self._begin(at, points, sources, 0, constraints)
        if plain.closed:
            new = (np.arange(over) + 0.5) / over
            points[:over] = new * points[:over] + (1 - new) * points[count:]
            sources[:over] = np.where(new < 0.5, sources[count:], sources[:over])
            at, points, sources = at[:count], points[:count], sources[:count]
        return Synthesised(Curve(points, at, plain.end, plain.closed), sources)

    def scribbled(self, length: float, seed: int) -> Synthesised:
        """Return a curve that goes on from a few points of A' (SYNTHESIZECURVE)."""
        level = self._level
        step = max(1, round(level.spacing / (level.order.arc[1] - level.order.arc[0])))
        free = np.flatnonzero(~level.order.ending)
        first = int(np.random.default_rng(seed).choice(free if len(free) else [0]))
        taken = np.minimum(first + step * np.arange(_START), len(level.order.arc) - 1)
        count = max(_START, round(length / level.spacing) + 1)
        points, sources = np.zeros(count, complex), np.zeros(count, np.int64)
        sources[:_START] = taken
        points[:_START] = level.styled.middles[taken] - level.styled.middles[taken[0]]
        at = np.linspace(0, 1, count)
        self._begin(at, points, sources, _START, ())
        return Synthesised(Curve(points, at, 1.0), sources)

    def sharpened(self, coarser: Synthesised, above: Level) -> Synthesised:
        """Return a curve of the level ``above`` with its points where their candidates are here.

        Beyond the paper: refinement alone begins with a blurred curve, and loops never come back.
        """
        level, curve = self._level, coarser.curve
        assert level.coarser is not None
        w = self._costs.samples
        rows = self._rows(curve, curve.parameters)
        inside = (rows.first[:, None] <= np.arange(len(w))) & (
            np.arange(len(w)) <= rows.last[:, None]
        )
        weight = w * inside
        total = weight.sum(axis=1)
        centre = (weight * rows.samples).sum(axis=1) / total
        taken = carried(coarser.sources, above, level)
        before = (level.coarser.real + 1j * level.coarser.imag)[: len(w), taken].T
        mean = (weight * before).sum(axis=1) / total
        products = (weight * before.conj() * (rows.samples - centre[:, None])).sum(axis=1)
        turn = np.ones(len(taken), complex)
        if self._costs.rotation:
            turn = products / np.maximum(abs(products), 1e-12)
        off = level.styled.middles[taken] - level.coarser.middles[taken] - mean
        return Synthesised(replace(curve, points=centre + turn * off), taken)

    def refined(
        self,
        made: Synthesised,
        coarser: Curve | None,
        constraints: Sequence[Constraint] = (),
    ) -> Synthesised:
        """Return a curve whose points have been looked for once more (REFINEANALOGY)."""
        level, curve = self._level, made.curve
        points, sources = curve.points.copy(), made.sources.copy()
        around = 0.0 if self._sweep is None else self._sweep.length
        refine(
            level.styled, level.plain, level.coarser or level.plain, level.order, self._costs,
            level.spacing, curve.closed, self._plain is not None,
            self._rows(self._plain, curve.parameters), coarser is not None,
            self._rows(coarser, curve.parameters),
            *combined(constraints, curve.parameters), *self._bends(curve.parameters), around,
            self._random, points, sources,
        )  # fmt: skip
        return Synthesised(Curve(points, curve.parameters, curve.end, curve.closed), sources)

    def _begin(
        self,
        at: Numbers,
        points: Points,
        sources: NDArray[np.int64],
        done: int,
        constraints: Sequence[Constraint],
    ) -> None:
        level = self._level
        begin(
            level.styled, level.plain, level.order, self._costs, level.spacing,
            self._plain is not None, self._rows(self._plain, at),
            *combined(constraints, at), *self._bends(at), self._random, points, sources, done,
        )  # fmt: skip

    def _rows(self, curve: Curve | None, parameters: Numbers) -> Rows:
        """Return the neighbourhoods of a curve at parameters; those of an open one end with it."""
        count = 2 * self._reach + 1
        if curve is None:
            nothing = np.zeros((len(parameters), count), complex)
            none = np.zeros(len(parameters), np.int64)
            return Rows(nothing, nothing[:, 1:].copy(), none, none)
        found = Neighbourhoods.of(curve, parameters, self._level.spacing, self._reach, self._sweep)
        first = np.argmax(found.inside, axis=0)
        last = count - 1 - np.argmax(found.inside[::-1], axis=0)
        samples = np.ascontiguousarray(found.samples.T)
        ways = np.ascontiguousarray(directions(found.samples).T)
        return Rows(samples, ways, first, last)

    def _bends(self, parameters: Numbers) -> tuple[Points, Numbers]:
        """Return how the sweep bends around parameters (N, K), and the arc length there (N,)."""
        if self._sweep is None:
            return np.zeros((len(parameters), 2 * self._reach + 1), complex), parameters
        middle = self._sweep.arc_at(parameters)
        off: Numbers = self._level.spacing * np.arange(-self._reach, self._reach + 1.0)
        return np.ascontiguousarray(bend(self._sweep, middle, off[:, None]).T), middle
