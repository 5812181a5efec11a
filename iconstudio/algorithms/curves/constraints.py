"""Places that a curve must pass through or near (section 3.2)."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from iconstudio.algorithms.curves.curve import Curve, Numbers, Points


@dataclass(frozen=True, slots=True)
class Constraint:
    """B' at parameter ``parameter`` is to be at ``place``; hard if the weight is infinite."""

    parameter: float
    place: complex
    weight: float = np.inf


def softened(constraint: Constraint, levels: int) -> Constraint:
    """Return a constraint as it is so many levels above the finest: ``w = 1 / (1/w_c + L - l)``.

    >>> softened(Constraint(0.5, 0j), 2).weight
    0.5
    >>> softened(Constraint(0.5, 0j), 0).weight
    inf
    """
    softness = 1 / constraint.weight + levels
    return replace(constraint, weight=1 / softness if softness else np.inf)


def combined(constraints: Sequence[Constraint], parameters: Numbers) -> tuple[Points, Numbers]:
    """Return the place and weight, (n,) each, that all constraints at each parameter come to.

    Several at one parameter pull as their weighted mean does with the sum of their weights; hard
    ones that contradict meet in the middle.
    """
    places, pulls = np.zeros(len(parameters), complex), np.zeros(len(parameters))
    hard = np.zeros(len(parameters))
    for one in constraints:
        index = int(abs(parameters - one.parameter).argmin())
        if np.isinf(one.weight):
            kept = hard[index] / (hard[index] + 1)
            places[index] = one.place + kept * (places[index] - one.place)
            hard[index] += 1
            pulls[index] = np.inf
        elif not hard[index]:
            total = pulls[index] + one.weight
            places[index] += (one.place - places[index]) * (one.weight / total)
            pulls[index] = total
    return places, pulls


def pulled(curve: Curve, constraints: Sequence[Constraint], reach: float) -> Curve:
    """Return a curve that goes through its constraints, or as far as they weigh.

    A point alone would make a needle, so those within some ``reach`` of it by arc length go along.
    """
    if not constraints:
        return curve
    at = np.array([one.parameter for one in constraints])
    places = np.array([one.place for one in constraints])
    far = np.array([1 / (1 + 1 / one.weight) for one in constraints])
    wanted = far * (places - curve.at(at))
    knots = curve.arc_at(at)
    along = curve.arc[: len(curve.points)]
    shares = _bell(_apart(knots, knots, curve), reach) + 1e-6 * np.eye(len(at))
    moved = _bell(_apart(along, knots, curve), reach) @ np.linalg.solve(shares, wanted)
    return replace(curve, points=curve.points + moved)


def _apart(here: Numbers, there: Numbers, curve: Curve) -> Numbers:
    gaps = abs(here[:, None] - there[None, :])
    return np.minimum(gaps, curve.length - gaps) if curve.closed else gaps


def _bell(gaps: Numbers, reach: float) -> Numbers:
    bell: Numbers = np.exp(-0.5 * (gaps / reach) ** 2)
    return bell
