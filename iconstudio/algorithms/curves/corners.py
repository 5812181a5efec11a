"""Sharp corners: where a pen turns round, a line is two, which meet there.

Beyond the paper: its neighbourhoods turn as a whole, so that at a tip points pile up. Where the
shape of B counts, the example says what becomes of corners, and lines stay whole.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from iconstudio.algorithms.curves.constraints import Constraint
from iconstudio.algorithms.curves.curve import Curve

_SHARP = np.radians(100)
"""Lines that turn by more than this are parted."""
_BESIDE = 1.5
"""Canvas units to each side of a point that tell how sharply a line turns there."""
_SHORTEST = 6.0
"""Canvas units between corners; where there are more, one of them counts."""

Piece = tuple[Curve, Sequence[Constraint], float, float]
"""A part of a curve with parameters from 0 to 1, its constraints, and where it begins and ends."""


def parted(curve: Curve, constraints: Sequence[Constraint]) -> list[Piece]:
    """Return a curve in parts between its sharp corners; itself if it has none."""
    corners = _corners(curve)
    if not len(corners):
        return [(curve, constraints, 0.0, curve.end)]
    if curve.closed:
        ends = np.append(corners, corners[0] + curve.end)
    else:
        ends = np.concatenate([[0.0], corners, [curve.end]])
    return [_part(curve, float(first), float(last), constraints) for first, last in pairwise(ends)]


def joined(curve: Curve, pieces: Sequence[tuple[Curve, float, float]]) -> Curve:
    """Return the parts of a curve, with where they begin and end, as one."""
    if len(pieces) == 1 and pieces[0][1] == 0:
        return pieces[0][0]
    points, parameters = [], []
    for number, (piece, first, last) in enumerate(pieces):
        final = number == len(pieces) - 1 and not curve.closed
        kept = slice(None) if final else slice(-1)  # the next one begins with the last point
        points.append(piece.points[kept])
        parameters.append(first + piece.parameters[kept] * (last - first))
    around = np.mod(np.concatenate(parameters), curve.end) if curve.closed else None
    whole = np.concatenate(points)
    if around is None:
        return Curve(whole, np.concatenate(parameters), curve.end)
    start = int(around.argmin())
    return Curve(np.roll(whole, -start), np.roll(around, -start), curve.end, True)


def _corners(curve: Curve) -> np.ndarray:
    """Return the parameters of sharp corners, in order."""
    _, knots = curve.points, curve.parameters
    arc = curve.arc_at(knots)
    back, on = curve.at_arc(arc - _BESIDE), curve.at_arc(arc + _BESIDE)
    turn = abs(np.angle((on - curve.points) * (curve.points - back).conj()))
    if not curve.closed:
        turn[[0, -1]] = 0
        turn[(arc < _SHORTEST) | (arc > curve.length - _SHORTEST)] = 0
    found: list[int] = []
    for index in np.argsort(-turn, kind="stable"):
        if turn[index] < _SHARP:
            break
        gaps = [abs(arc[index] - arc[other]) for other in found]
        if curve.closed:
            gaps = [min(gap, curve.length - gap) for gap in gaps]
        if all(gap >= _SHORTEST for gap in gaps):
            found.append(int(index))
    return np.sort(knots[found])


def _part(curve: Curve, first: float, last: float, constraints: Sequence[Constraint]) -> Piece:
    start, stop = curve.arc_at(np.array([first, last]))
    count = max(2, int(np.ceil(stop - start)))
    inner = np.concatenate([curve.parameters, curve.parameters + curve.end])
    inner = inner[(inner > first) & (inner < last)]
    at = np.union1d(inner, np.linspace(first, last, count + 1))
    points = curve.at(at)
    new = np.append(True, np.diff(points) != 0)
    plain = Curve.of(points[new])
    own = (at[new] - first) / (last - first)
    piece = Curve(plain.points, own[: len(plain.points)], 1.0)
    ends = [Constraint(0.0, complex(piece.points[0])), Constraint(1.0, complex(piece.points[-1]))]
    inside = [
        Constraint((one.parameter + turn - first) / (last - first), one.place, one.weight)
        for one in constraints
        for turn in ((0.0, curve.end) if curve.closed else (0.0,))
        if first < one.parameter + turn < last
    ]
    return piece, [*ends, *inside], first, last
