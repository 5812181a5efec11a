"""Analogies from coarse to fine (sections 3.4 and 3.5): SYNTHESIZEANALOGYMULTIRES."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.curves.analogy import Search, Synthesised
from iconstudio.algorithms.curves.constraints import Constraint, softened
from iconstudio.algorithms.curves.curve import Curve
from iconstudio.algorithms.curves.parameters import Parameters
from iconstudio.algorithms.curves.pyramid import Level, blurred


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
    for above, level in zip(range(len(levels) - 1, -1, -1), levels, strict=True):
        sweep = blurred(plain, level.spacing, parameters)
        search = Search(level, sweep, parameters, rotation, shape, random)
        pulls = [softened(one, above) for one in constraints]
        made = search.begin(pulls) if made is None else _resampled(made, level.spacing, pulls)
        for _ in range(parameters.passes):
            made = search.refined(made, coarser, pulls)
            made = _resampled(made, level.spacing, pulls)
        coarser = made.curve
    assert made is not None
    return made


def _resampled(made: Synthesised, spacing: float, constraints: Sequence[Constraint]) -> Synthesised:
    """Return a curve with points ``spacing`` apart, and at the constraints."""
    curve = made.curve.resampled(spacing)
    parameters, points = curve.parameters, curve.points
    if constraints:
        wanted = np.array([one.parameter for one in constraints])
        nearest = abs(parameters[:, None] - wanted).argmin(axis=0)
        parameters = parameters.copy()
        parameters[nearest] = wanted
        points = made.curve.at(parameters)
        curve = Curve(points, parameters, curve.end, curve.closed)
    before = np.searchsorted(made.curve.parameters, parameters, "right") - 1
    return Synthesised(curve, made.sources[np.clip(before, 0, len(made.sources) - 1)])


def _state(seed: int) -> NDArray[np.uint64]:
    """Return the state of random numbers that a seed stands for."""
    return np.random.SeedSequence(seed).generate_state(1, np.uint64) | np.uint64(1)
