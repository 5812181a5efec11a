"""Curves that met still meet (section 4, figure 10): constraints found by themselves."""

from collections.abc import Sequence

import numpy as np

from iconstudio.algorithms.curves.constraints import Constraint
from iconstudio.algorithms.curves.curve import Curve, Numbers, Points

_NEAR = 0.75
"""In canvas units: ends so near to a line are meant to meet it, however thin the strokes are."""

_SAME = 1e-9
"""Parameters that differ by less are the same, but for rounding."""


def junctions(curves: Sequence[Curve], widths: Sequence[float]) -> list[list[Constraint]]:
    """Return the constraints of each curve: where it ends on another one, and others end on it.

    An end meets a line if their strokes, of these widths, overlap by half. All are hard, and keep
    both curves where they are: so they overlap as before.
    """
    found: list[dict[float, complex]] = [{} for _ in curves]
    for number, curve in enumerate(curves):
        if curve.closed or not widths[number]:
            continue
        for end in (0.0, curve.end):
            place = complex(curve.at(np.array([end]))[0])
            for other, line in enumerate(curves):
                if not widths[other]:
                    continue
                near = max(_NEAR, min(widths[number], widths[other]) / 4)
                away = 4 * near if other == number else 0.0
                meeting = _nearest(line, place, end if other == number else None, away)
                if meeting is None or abs(meeting[1] - place) > near:
                    continue
                found[number][end] = place
                if all(abs(meeting[0] - at) > _SAME for at in found[other]):
                    found[other][meeting[0]] = meeting[1]
    return [[Constraint(at, place) for at, place in sorted(one.items())] for one in found]


def _nearest(
    curve: Curve, place: complex, besides: float | None, away: float
) -> tuple[float, complex] | None:
    """Return parameter and place of a curve's nearest point, and ends are preferred.

    Only what is ``away`` from the parameter ``besides`` counts, by arc length.
    """
    starts, ends, arcs = _segments(curve)
    if besides is not None:
        gaps = abs(arcs - curve.arc_at(np.array([besides]))[0])
        far = np.minimum(gaps[:-1], gaps[1:]) > away
        starts, ends, first = starts[far], ends[far], arcs[:-1][far]
    else:
        first = arcs[:-1]
    if not len(starts):
        return None
    way = ends - starts
    part = np.clip(((place - starts) * way.conj()).real / abs(way) ** 2, 0, 1)
    gaps = abs(starts + part * way - place)
    best = int(gaps.argmin())
    at = float(curve.parameters_at(first[best : best + 1] + part[best] * abs(way[best]))[0])
    if abs(at - curve.end) < _SAME:
        at = 0.0 if curve.closed else curve.end
    elif at < _SAME:
        at = 0.0
    return at, complex(starts[best] + part[best] * way[best])


def _segments(curve: Curve) -> tuple[Points, Points, Numbers]:
    points = np.append(curve.points, curve.points[:1]) if curve.closed else curve.points
    return points[:-1], points[1:], curve.arc
