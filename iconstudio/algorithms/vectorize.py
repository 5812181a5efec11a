"""Tracing a bitmap to curves (section 3.4, post-processing): the adapter of potracer."""

from typing import Any

import numpy as np
import potrace
from numpy.typing import NDArray

from iconstudio.model import CANVAS

SPECK = 2.0
"""Pieces and holes smaller than this many square canvas pixels are left out."""
TOLERANCE = 0.2
"""How far, in traced pixels, joining curves may stray."""


def trace(coverage: NDArray[np.uint8]) -> str:
    """Return the outline of a drawing as the ``d`` attribute of one SVG path, in canvas units.

    ``coverage`` is (n, n) uint8, 255 = ink; n canvas pixels to CANVAS. Outlines run around ink,
    holes the other way round. The path is empty if there is no ink.
    """
    unit = CANVAS / coverage.shape[0]
    bitmap = potrace.Bitmap(coverage <= 127)  # potracer inverts arrays
    curves = bitmap.trace(turdsize=int(SPECK / unit**2), opttolerance=TOLERANCE)

    def at(point: Any) -> str:
        return f"{_number(point.x * unit)} {_number(point.y * unit)}"

    parts: list[str] = []
    for curve in curves:
        parts.append(f"M{at(curve.start_point)}")
        for segment in curve.segments:
            if segment.is_corner:
                parts.append(f"L{at(segment.c)}L{at(segment.end_point)}")
            else:
                parts.append(f"C{at(segment.c1)} {at(segment.c2)} {at(segment.end_point)}")
        parts.append("Z")
    return "".join(parts)


def _number(value: float) -> str:
    return f"{value:.2f}".rstrip("0").rstrip(".")
