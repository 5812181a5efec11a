"""The middle of an area: its medial axis (Blum 1967), from the Voronoi diagram of its outline."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import Voronoi

from iconstudio.algorithms.areas import Area, Points, along_outline, from_outline, hold

Numbers = NDArray[np.float64]

_OPPOSITE = 0.6
"""Of the way across, what lies between the two places of the outline that are nearest to a side of
the axis, at least: else it leads into a corner, or into the roundness of an end."""


@dataclass(frozen=True, eq=False)
class Axis:
    """Straight sides between points; those of corners are left out."""

    points: Points
    """(n, 2)"""
    radii: Numbers
    """How far the outline is from each point, (n,)."""
    sides: NDArray[np.intp]
    """(m, 2), indices of points."""

    @property
    def lengths(self) -> Numbers:
        """The length of each side, (m,)."""
        first, last = self.points[self.sides[:, 0]], self.points[self.sides[:, 1]]
        lengths: Numbers = np.hypot(*(last - first).T)
        return lengths


def axis_of(polygon: Area, step: float) -> Axis:
    """Return the medial axis of a polygon, of whose outline a point is taken every ``step``."""
    outline = along_outline(polygon, step)
    diagram = Voronoi(outline)
    sides, nearest = np.array(diagram.ridge_vertices), diagram.ridge_points
    points = diagram.vertices
    here = (sides >= 0).all(axis=1) & hold(polygon, points)[sides].all(axis=1)
    sides, nearest = sides[here], nearest[here]
    away = outline[nearest[:, 0], None] - points[sides]
    across = np.hypot(*(outline[nearest[:, 0]] - outline[nearest[:, 1]]).T)
    opposite = across > _OPPOSITE * 2 * np.hypot(away[..., 0], away[..., 1]).max(axis=1)
    used, sides = np.unique(sides[opposite], return_inverse=True)
    return Axis(points[used], from_outline(polygon, points[used]), sides.reshape(-1, 2))
