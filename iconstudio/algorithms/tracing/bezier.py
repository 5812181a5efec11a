"""Fitting cubic Béziers to a row of points, with tangents given or free at its ends.

After Schneider, *An Algorithm for Automatically Fitting Digitized Curves* (Graphics Gems, 1990).
Points and directions are complex numbers, x + iy; directions have length 1.
"""

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.complex128]
Cubic = tuple[complex, complex, complex, complex]
"""First point, two handles, last point."""

_SAMPLES = 40
"""Points of a row that are enough to fit one cubic."""
_ROUNDS = 8
_HOPELESS = 6
"""A fit so many times further off than is allowed will not come near."""
_SLOW = 0.9
"""A round that leaves so much of the error was the last that a good fit needs."""
_LONGEST = 1.2
"""A handle longer than this many times the row would loop."""
_SNAP = 0.03
"""A direction so few radians off an axis is on it."""
_REACH = 16
"""Points to each side that tell a direction, at most."""
_SHORTEST = 8
"""Fewer points are not divided further."""


def fit(
    points: Points, start: complex | None, end: complex | None, tolerance: float
) -> list[Cubic]:
    """Return cubics through a row of points (p,), as few as stay within ``tolerance``.

    ``start`` and ``end`` are the directions in which the curve leaves its first point and, looked
    at backwards, its last; None leaves them free, and the three points there out of account: they
    are a corner's, which pixels round. Where cubics join, the direction is continuous.

    >>> half_circle = 30 * np.exp(1j * np.linspace(0, np.pi, 90))
    >>> [len(fit(half_circle, 1j, 1j, tolerance)) for tolerance in (1, 0.1)]
    [1, 2]
    """
    cubic, error = fit_one(points, start, end, tolerance)
    if error < tolerance or len(points) < _SHORTEST:
        return [cubic]
    middle, reach = _split(points)
    way = direction(points[middle - reach : middle + reach + 1])
    return [
        *fit(points[: middle + 1], start, -way, tolerance),
        *fit(points[middle:], way, end, tolerance),
    ]


def direction(points: Points) -> complex:
    """Return the direction in which a short row of points runs, by least squares."""
    steps = np.arange(len(points)) - (len(points) - 1) / 2
    return snapped(complex(steps @ points), _SNAP)


def snapped(way: complex, margin: float) -> complex:
    """Return the unit vector of ``way``, turned to the nearest axis within ``margin`` radians.

    >>> snapped(0.01 + 1j, 0.03)
    1j
    """
    quarter = np.angle(way) / (np.pi / 2)
    if abs(quarter - round(quarter)) * np.pi / 2 < margin:
        return (1, 1j, -1, -1j)[round(quarter) % 4]
    return way / abs(way) if way else 1


def fit_one(
    points: Points, start: complex | None, end: complex | None, tolerance: float
) -> tuple[Cubic, float]:
    """Return the least-squares cubic between the first and last point, and its largest error."""
    first, last = points[0], points[-1]
    inner = points[3 if start is None else 1 : -3 if end is None else -1]
    chord = (last - first) / 3
    plain = (
        first,
        first + (chord if start is None else start * abs(chord)),
        last - (chord if end is None else -end * abs(chord)),
        last,
    )
    if len(inner) < 4:
        return plain, 0.0
    best, least = plain, np.inf
    if len(inner) > _SAMPLES:
        inner = inner[np.linspace(0, len(inner) - 1, _SAMPLES).astype(int)]
    along = np.cumsum(abs(np.diff(np.concatenate([[first], inner, [last]]))))
    u = along[:-1] / along[-1]
    # A handle is a real combination of these: one direction, or both axes.
    ways = [np.array([1, 1j] if way is None else [way]) for way in (start, end)]
    cut = len(ways[0])
    for turn in range(_ROUNDS):
        v = 1 - u
        b0, b1, b2, b3 = v**3, 3 * v * v * u, 3 * v * u * u, u**3
        design = np.concatenate([b1[:, None] * ways[0], b2[:, None] * ways[1]], axis=1)
        rest = inner - first * (b0 + b1) - last * (b2 + b3)
        turned = design.conj().T
        normal = (turned @ design).real + 1e-9 * np.eye(design.shape[1])
        lengths = np.linalg.solve(normal, (turned @ rest).real)
        handles = ways[0] @ lengths[:cut], ways[1] @ lengths[cut:]
        backwards = (start is not None and lengths[0] < 0) or (end is not None and lengths[-1] < 0)
        if backwards or max(map(abs, handles)) > _LONGEST * along[-1]:
            break
        p1, p2 = first + handles[0], last + handles[1]
        gap = b0 * first + b1 * p1 + b2 * p2 + b3 * last - inner
        error = abs(gap).max()
        slow = min(1.0, error / least)
        if error < least:
            best, least = (first, p1, p2, last), error
        if error < tolerance / 2 or (error < tolerance and slow > _SLOW):
            break
        hoped = error * slow ** (_ROUNDS - 1 - turn)
        if turn > 0 and (error > _HOPELESS * tolerance or hoped > tolerance):
            break
        # A Newton step moves each parameter to the foot of its point.
        speed = 3 * (v * v * (p1 - first) + 2 * v * u * (p2 - p1) + u * u * (last - p2))
        bend = 6 * (v * (p2 - 2 * p1 + first) + u * (last - 2 * p2 + p1))
        slope = abs(speed) ** 2 + (gap.conj() * bend).real
        step = (gap.conj() * speed).real / np.where(slope > 1e-9, slope, np.inf)
        u = np.clip(u - step, 0, 1)
    return best, least


def _split(points: Points) -> tuple[int, int]:
    """Return where to divide a row, and how many points to each side tell the direction there.

    It is at half of the turning, or better where the row is level or upright near that.
    """
    reach = min(_REACH, max(1, len(points) // 6))
    way = points[2 * reach :] - points[: -2 * reach]
    turning = np.cumsum(abs(np.diff(np.unwrap(np.angle(way)), prepend=np.angle(way[0]))))
    off_half = abs(turning - turning[-1] / 2)
    edge = max(3, len(points) // 8)
    low, high = max(0, edge - reach), min(len(way), len(points) - edge - reach) - 1
    axis = (way.real[:-1] * way.real[1:] <= 0) | (way.imag[:-1] * way.imag[1:] <= 0)
    extremes = low + np.flatnonzero(axis[low:high])
    if len(extremes):
        return int(extremes[off_half[extremes].argmin()]) + reach, reach
    return int(np.clip(off_half.argmin(), low, high)) + reach, reach
