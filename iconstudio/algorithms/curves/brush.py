"""The outline of a round brush whose width changes along a line."""

import numpy as np
from numpy.typing import NDArray

Row = NDArray[np.complex128]
Numbers = NDArray[np.float64]

_FINE = 0.02
"""Canvas units by which the sides of a join may stray from its arc."""
_SHARP = np.radians(60)
"""A turn at which the whole disc is drawn."""
_STEEPEST = 0.95
"""How much a radius may grow with each unit of the line, for the brush to have sides there."""


def sides(points: Row, closed: bool, radii: Numbers) -> list[Row]:
    """Return contours that enclose, by the nonzero rule, what a round brush covers.

    ``points`` (n,), no two in a row the same, and the brush's ``radii`` there (n,). The discs at
    ``turns`` are not part of it. A side touches the discs of both its ends, and turns outside of a
    bend along the disc there; inside it folds, which the rule ignores: what is covered is gone
    round once more forwards than backwards.
    """
    if len(points) < 2:
        return []
    if closed:
        points, radii = np.append(points, points[0]), np.append(radii, radii[0])
    steps = np.diff(points)
    slopes = np.clip(np.diff(radii) / np.abs(steps), -_STEEPEST, _STEEPEST)
    left = _side(np.angle(steps), np.arccos(-slopes), points, radii, closed)
    right = _side(np.angle(steps), -np.arccos(-slopes), points, radii, closed)
    if closed:
        return [left, right[::-1]]
    return [np.concatenate([left, right[::-1]])]


def turns(points: Row, closed: bool) -> NDArray[np.intp]:
    """Return at which points the disc of the brush shows by itself: at ends and sharp turns."""
    steps = np.diff(points, append=points[:1])
    sharp: NDArray[np.bool_] = abs(np.angle(steps * np.roll(steps, 1).conj())) > _SHARP
    if not closed or len(points) < 2:
        sharp[0] = sharp[-1] = True
    return np.flatnonzero(sharp)


def _side(ways: Numbers, away: Numbers, points: Row, radii: Numbers, closed: bool) -> Row:
    """Return the points of one side, which is ``away`` from the line's ways, in radians."""
    before, after = ways + away, ways + away
    if closed:
        before, after = np.append(before[-1:], before), np.append(after, after[:1])
    else:
        before, after = np.append(before[:1], before), np.append(after, after[-1:])
    turn = (after - before + np.pi) % (2 * np.pi) - np.pi
    outside = turn * away[0] < 0
    bulge = radii * (1 - np.cos(turn / 2))
    step = 2 * np.sqrt(2 * _FINE / np.maximum(radii, _FINE))
    counts = np.where(
        bulge <= _FINE, 1, np.where(outside, 1 + np.ceil(abs(turn) / step), 2)
    ).astype(int)
    vertex = np.repeat(np.arange(len(points)), counts)
    number = np.arange(len(vertex)) - np.repeat(np.cumsum(counts) - counts, counts)
    part = np.where(counts[vertex] > 1, number / np.maximum(counts[vertex] - 1, 1), 0.5)
    side: Row = points[vertex] + radii[vertex] * np.exp(1j * (before[vertex] + part * turn[vertex]))
    return side
