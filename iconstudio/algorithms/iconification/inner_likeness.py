"""How much of what was drawn inside an outline a picture shows (section 6 wishes for both)."""

from collections.abc import Sequence

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.guidance import points_on
from iconstudio.algorithms.iconification.guide import strokes
from iconstudio.algorithms.raster import Bitmap, fill_polygon
from iconstudio.model import CANVAS, Inner, Point, Stroke

NEAR = 6.0
"""Canvas units by which a stroke may miss a line that it stands for."""


def inner_likeness(inner: Inner, ink: Bitmap) -> float:
    """Return which part of its holes and lines a picture shows, from 0 to 1; 1 if there are none.

    Of a hole, how much of it is paper, times how well its rim is followed; of a line, how well it
    is: by strokes of ink or paper, or by where paper ends. What follows half of it by chance is
    hardly the same, so that part is squared.

    Parameters
    ----------
    inner
        In canvas units.
    ink
        (m, m) bool.
    """
    if inner == Inner():
        return 1.0
    side = len(ink)
    away = scipy.ndimage.distance_transform_edt(~strokes(ink)) * CANVAS / side
    found = []
    for hole in inner.holes:
        inside = fill_polygon(hole, side)
        paper = float((~ink)[inside].mean()) if inside.any() else 0.0
        found.append(paper * _followed((*hole.vertices, hole.vertices[0]), away))
    found += [_followed(line, away) for line in inner.lines]
    return float(np.mean(found))


def _followed(line: Sequence[Point], away: NDArray[np.float64]) -> float:
    """Return how well something ``away`` (m, m) from each point follows a line."""
    along = points_on(Stroke(0, tuple(line)))
    x, y = np.clip(np.floor(along.T * len(away) / CANVAS).astype(int), 0, len(away) - 1)
    return float((away[y, x] <= NEAR).mean() ** 2)
