"""Tracing black and white as smooth curves (P. Selinger, 2003): the adapter of potracer."""

from typing import TYPE_CHECKING, Protocol

import numpy as np
from numpy.typing import NDArray

from iconstudio.model import Point
from iconstudio.model.path import Contour, Path, Segment

if TYPE_CHECKING:
    from potrace import Curve


class _Point(Protocol):
    x: float
    y: float


def traced(ink: NDArray[np.bool_]) -> Path:
    """Return the outline of ``ink``, (h, w), in pixels.

    To be filled with the even-odd rule. It takes a second or so for 512 x 512 pixels.
    """
    from potrace import Bitmap  # pure Python, so slow to trace

    # A bitmap is told where the paper is, not the ink.
    return Path(tuple(map(_contour, Bitmap(~ink).trace(turdsize=0))))


def _contour(curve: "Curve") -> Contour:
    segments: list[Segment] = []
    for one in curve:
        if one.is_corner:
            segments += (_pair(one.c),), (_pair(one.end_point),)
        else:
            segments.append((_pair(one.c1), _pair(one.c2), _pair(one.end_point)))
    return Contour(_pair(curve.start_point), tuple(segments))


def _pair(point: _Point) -> Point:
    return float(point.x), float(point.y)
