"""Kinks: where what was taken from two places of an example does not fit, a line jumps aside.

Beyond the paper. What turns more sharply there than the example does anywhere becomes smooth: its
offsets from the plain line are blurred along a short stretch, as far as is enough.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy.ndimage import gaussian_filter1d, maximum_filter1d

from iconstudio.algorithms.curves.constraints import Constraint
from iconstudio.algorithms.curves.curve import Curve, Numbers, Points
from iconstudio.algorithms.curves.pyramid import Level

_REACH = 2
"""Points to each side that tell how a line turns."""
_MORE, _LEAST = 1.3, np.radians(8)
"""How much more sharply than the example a line may turn, and how sharply anyhow."""
_CORNER = 3 * _REACH
"""Points to each side of a corner of the plain line where lines may turn as it does."""
_BLURS = 1.5, 3.0, 5.0, 8.0
"""Standard deviations, in points, of a blur; the next one where one was not enough."""


def without_kinks(
    curve: Curve, plain: Curve, level: Level, constraints: Sequence[Constraint]
) -> Curve:
    """Return a curve without turns that are none of the example's, nor of the plain line's.

    Its points are as far apart as those of the ``level``. It still passes its constraints.
    """
    count = len(curve.points)
    if count < 4 * _REACH:
        return curve
    mode = "wrap" if curve.closed else "nearest"
    before = plain.at(curve.parameters)
    bends = maximum_filter1d(_turns(before, curve.closed), 2 * _CORNER + 1, mode=mode)
    most = np.maximum(_MORE * _sharpest(level), _LEAST) + bends
    free = _free(curve, constraints)
    off = curve.points - before
    for sigma in _BLURS:
        kinks = _turns(before + off, curve.closed) > most
        if not kinks.any():
            break
        reach = round(2 * sigma)
        near = maximum_filter1d(kinks.astype(float), 2 * reach + 1, mode=mode)
        share = free * gaussian_filter1d(near, sigma, mode=mode)
        off = off + share * (_blurred(off, sigma, mode) - off)
    return replace(curve, points=before + off)


def _turns(points: Points, closed: bool) -> Numbers:
    """Return by how much a line turns at each point; it does not at its ends."""
    ahead, behind = np.roll(points, -_REACH) - points, points - np.roll(points, _REACH)
    turns: Numbers = abs(np.angle(ahead * behind.conj()))
    if not closed:
        turns[:_REACH] = turns[-_REACH:] = 0.0
    return turns


def _sharpest(level: Level) -> float:
    """Return by how much the example turns, at most."""
    middle = len(level.styled.real) // 4
    ahead, behind = (
        level.styled.real[at] + 1j * level.styled.imag[at]
        for at in (middle + _REACH, middle - _REACH)
    )
    return float(abs(np.angle(ahead * -behind.conj())).max())


def _free(curve: Curve, constraints: Sequence[Constraint]) -> Numbers:
    """Return how far each point may move, from 0 at an end or a constraint up to 1."""
    fixed = [one.parameter for one in constraints]
    if not curve.closed:
        fixed += [0.0, curve.end]
    if not fixed:
        return np.ones(len(curve.points))
    at = np.searchsorted(curve.parameters, np.array(fixed) - 1e-9) % len(curve.points)
    apart = abs(np.arange(len(curve.points))[:, None] - at)
    if curve.closed:
        apart = np.minimum(apart, len(curve.points) - apart)
    free: Numbers = np.minimum(1.0, apart.min(axis=1) / _REACH)
    return free


def _blurred(off: Points, sigma: float, mode: str) -> Points:
    real, imag = (gaussian_filter1d(part, sigma, mode=mode) for part in (off.real, off.imag))
    blurred: Points = real + 1j * imag
    return blurred
