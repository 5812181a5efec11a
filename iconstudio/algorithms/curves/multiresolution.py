"""From coarse to fine: SYNTHESIZECURVEMULTIRES (section 3.4), SYNTHESIZEANALOGYMULTIRES (3.5)."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.curves.analogy import Search, Synthesised
from iconstudio.algorithms.curves.constraints import Constraint, pulled, softened
from iconstudio.algorithms.curves.curve import Curve
from iconstudio.algorithms.curves.parameters import Parameters
from iconstudio.algorithms.curves.pyramid import Level, blurred, swept

_REACH = 4.0
"""How many spacings from a constraint the curve goes along with it."""

_SAME = 1e-9
"""Parameters that differ by less are the same, but for rounding."""


def analogy(
    levels: Sequence[Level],
    plain: Curve,
    parameters: Parameters,
    seed: int = 0,
    rotation: bool = True,
    shape: bool = False,
    constraints: Sequence[Constraint] = (),
) -> Synthesised:
    """Return B' for B = ``plain``, with B's parameters."""
    random = _state(seed)
    made: Synthesised | None = None
    coarser: Curve | None = None
    before = levels[0]
    bending = None if shape else swept(plain, parameters)
    for above, level in zip(range(len(levels) - 1, -1, -1), levels, strict=True):
        sweep = blurred(plain, level.spacing, parameters)
        search = Search(level, sweep, parameters, random, rotation, shape, bending)
        pulls = [softened(one, above) for one in constraints]
        made = search.begin(pulls) if made is None else search.sharpened(made, before)
        for _ in range(parameters.passes):
            made = search.refined(_through(made, level.spacing, pulls), coarser, pulls)
        made = _through(made, level.spacing, pulls)
        if made.curve.length > parameters.longest * level.lengthening * sweep.length:
            even = plain.resampled(levels[-1].spacing)
            return Synthesised(even, np.zeros(len(even.points), np.int64))
        coarser, before = made.curve, level
    assert made is not None
    return made


def scribble(
    levels: Sequence[Level],
    length: float,
    parameters: Parameters,
    seed: int = 0,
    rotation: bool = False,
) -> Synthesised:
    """Return a new curve of about this length in the style of A' (SYNTHESIZECURVEMULTIRES).

    It begins as the example does somewhere.
    """
    random = _state(seed)
    made: Synthesised | None = None
    coarser: Curve | None = None
    before = levels[0]
    for level in levels:
        search = Search(level, None, parameters, random, rotation)
        if made is None:
            made = search.scribbled(length * level.shortening, seed)
        else:
            made = search.sharpened(made, before)
        for _ in range(parameters.passes):
            made = search.refined(_through(made, level.spacing, ()), coarser)
        made = _through(made, level.spacing, ())
        coarser, before = made.curve, level
    assert made is not None
    return made


def _through(made: Synthesised, spacing: float, constraints: Sequence[Constraint]) -> Synthesised:
    """Return a curve with points ``spacing`` apart, and one at each constraint, as far as it pulls.

    A point is taken from where the one before it was taken from.
    """
    curve = pulled(made.curve, constraints, _REACH * spacing)
    even = curve.resampled(spacing)
    parameters = even.parameters
    if constraints:
        fixed = np.unique([one.parameter for one in constraints])
        gaps = abs(curve.arc_at(parameters)[:, None] - curve.arc_at(fixed)).min(axis=1)
        parameters = np.union1d(parameters[gaps > spacing / 3], fixed)
    even = replace(even, parameters=parameters, points=curve.smoothly(parameters))
    # Where a point stays where it was, rounding must not tell which one is before it.
    before = np.searchsorted(made.curve.parameters, parameters + _SAME, "right") - 1
    return Synthesised(even, made.sources[np.clip(before, 0, len(made.sources) - 1)])


def _state(seed: int) -> NDArray[np.uint64]:
    """Return the state of random numbers that a seed stands for."""
    return np.random.SeedSequence(seed).generate_state(1, np.uint64) | np.uint64(1)
