"""Curves as polylines with parameters (section 3, figure 1), evaluated and resampled by arc length.

Points are complex numbers, x + iy.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.curves.interpolation import interpolated

Points = NDArray[np.complex128]
Numbers = NDArray[np.float64]

_SAME = 1e-9
"""Points that are no farther apart are one."""
_MANY = 4
"""A Gaussian is cut off after so many standard deviations."""


@dataclass(frozen=True, eq=False)
class Curve:
    """A polyline of (n,) ``points``, the i-th at parameter ``parameters[i]``; those increase.

    A closed curve goes on from its last point to its first, where its parameter is ``end``; an open
    one ends at its last. Between points, position and parameter are linear.
    """

    points: Points
    parameters: Numbers
    end: float
    closed: bool = False

    @classmethod
    def of(cls, points: Points, closed: bool = False) -> "Curve":
        """Return a curve through points, its parameter the arc length. Repeated points are dropped.

        >>> Curve.of(np.array([0, 3, 3, 3 + 4j])).length
        7.0
        """
        points = np.asarray(points, complex)
        new = np.ones(len(points), bool)
        new[1:] = abs(np.diff(points)) > _SAME
        points = points[new]
        if closed and len(points) > 1 and abs(points[-1] - points[0]) <= _SAME:
            points = points[:-1]
        along = _arc(points, closed)
        return cls(points, along[: len(points)], float(along[-1]), closed)

    @property
    def unit(self) -> "Curve":
        """The curve with parameters from 0 to 1."""
        return replace(self, parameters=self.parameters / self.end, end=1.0)

    @cached_property
    def arc(self) -> Numbers:
        """The arc length up to each point; of a closed curve up to its first, too, (n + 1,)."""
        return _arc(self.points, self.closed)

    @cached_property
    def length(self) -> float:
        """The arc length of the whole curve."""
        return float(self.arc[-1])

    @cached_property
    def _knots(self) -> tuple[Points, Numbers]:
        """Points and parameters up to the very end of a closed curve, which is its start."""
        if not self.closed:
            return self.points, self.parameters
        return np.append(self.points, self.points[0]), np.append(self.parameters, self.end)

    def at(self, parameters: Numbers) -> Points:
        """Return the points at these parameters; a closed curve goes round and round.

        An open curve goes straight on past its ends.
        """
        points, knots = self._knots
        inside = np.mod(parameters, self.end) if self.closed and self.end > 0 else parameters
        return _interpolated(inside, knots, points)

    def at_arc(self, along: Numbers) -> Points:
        """Return the points after so much arc length, see ``at``."""
        points, _ = self._knots
        inside = np.mod(along, self.length) if self.closed and self.length > 0 else along
        return _interpolated(inside, self.arc, points)

    def arc_at(self, parameters: Numbers) -> Numbers:
        """Return the arc length up to these parameters."""
        _, knots = self._knots
        if not self.closed:
            return np.interp(parameters, knots, self.arc)
        turns, inside = np.divmod(parameters, self.end)
        return np.interp(inside, knots, self.arc) + turns * self.length

    def parameters_at(self, along: Numbers) -> Numbers:
        """Return the parameters after so much arc length, which lies on the curve."""
        _, knots = self._knots
        return np.interp(along, self.arc, knots)

    def resampled(self, spacing: float) -> "Curve":
        """Return the curve with points at equal arc lengths, ``spacing`` or a little less apart."""
        count = max(3 if self.closed else 1, int(np.ceil(self.length / spacing - 1e-9)))
        along = np.linspace(0, self.length, count + 1)
        if self.closed:
            along = along[:-1]
        return Curve(self.at_arc(along), self.parameters_at(along), self.end, self.closed)

    def smoothly(self, parameters: Numbers) -> Points:
        """Return the points at these parameters, which lie on the curve, on cubics between points.

        They are Catmull and Rom's, by arc length: polylines cut corners each time that they are
        resampled.
        """
        points, knots = self._knots
        if len(points) < 4:
            return self.at(parameters)
        arc = self.arc
        gaps = np.maximum(arc[1:] - arc[:-1], 1e-12)
        slopes = (points[1:] - points[:-1]) / gaps
        before, after = np.append(slopes[-1:], slopes[:-1]), np.append(gaps[-1:], gaps[:-1])
        inner = (slopes * after + before * gaps) / (gaps + after)
        if not self.closed:
            inner[0] = slopes[0]
        ways = np.append(inner, inner[0] if self.closed else slopes[-1])
        index = np.searchsorted(knots, parameters, "right") - 1
        index = np.minimum(np.maximum(index, 0), len(gaps) - 1)
        width = knots[index + 1] - knots[index]
        u = (parameters - knots[index]) / np.where(width > 0, width, 1)
        p, q, gap = points[index], points[index + 1], gaps[index]
        m, n = ways[index] * gap, ways[index + 1] * gap
        found: Points = p + u * m + u**2 * (3 * (q - p) - 2 * m - n) + u**3 * (2 * (p - q) + m + n)
        return found

    def blurred(self, sigma: float, spacing: float) -> "Curve":
        """Return the curve, its points ``spacing`` apart, blurred by a Gaussian along arc length.

        An open curve keeps its ends: it goes on beyond them, turned half way round.
        """
        fine = self.resampled(spacing)
        if sigma <= 0:
            return fine
        step = fine.length / (len(fine.points) - (not self.closed))
        reach = int(np.ceil(_MANY * sigma / step))
        kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) * step / sigma) ** 2)
        kernel /= kernel.sum()
        points = fine.points
        if self.closed:
            around = points[np.arange(-reach, len(points) + reach) % len(points)]
        else:
            before = 2 * points[0] - points[np.minimum(np.arange(reach, 0, -1), len(points) - 1)]
            after = 2 * points[-1] - points[np.maximum(np.arange(-2, -reach - 2, -1), -len(points))]
            around = np.concatenate([before, points, after])
        blurred = np.convolve(around, kernel, "valid")
        return Curve(blurred, fine.parameters, self.end, self.closed)


def _arc(points: Points, closed: bool) -> Numbers:
    if closed:
        points = np.append(points, points[:1])
    along = np.zeros(len(points))
    np.cumsum(abs(points[1:] - points[:-1]), out=along[1:])
    return along


def _interpolated(places: Numbers, knots: Numbers, points: Points) -> Points:
    """Return the points at places between knots; beyond them, straight on."""
    if len(points) < 2:
        return np.full(np.shape(places), points[0])
    flat = np.ascontiguousarray(places, float)
    found: Points = interpolated(flat.ravel(), knots, points).reshape(flat.shape)
    return found
