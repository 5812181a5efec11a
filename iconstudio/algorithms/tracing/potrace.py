"""Tracing black and white as smooth curves (P. Selinger, 2003): the adapter of potracer."""

from typing import TYPE_CHECKING, Protocol

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from potrace import Curve


class _Point(Protocol):
    x: float
    y: float


def traced(ink: NDArray[np.bool_]) -> str:
    """Return the outline of ``ink``, (h, w), as SVG path data in pixels.

    To be filled with the even-odd rule. It takes a second or so for 512 x 512 pixels.
    """
    from potrace import Bitmap  # pure Python, so slow to trace

    # A bitmap is told where the paper is, not the ink.
    return "".join(_subpath(curve) for curve in Bitmap(~ink).trace(turdsize=0))


def _subpath(curve: "Curve") -> str:
    parts = [f"M{_said(curve.start_point)}"]
    for one in curve:
        if one.is_corner:
            parts.append(f"L{_said(one.c)}L{_said(one.end_point)}")
        else:
            parts.append(f"C{_said(one.c1)} {_said(one.c2)} {_said(one.end_point)}")
    return "".join([*parts, "Z"])


def _said(point: _Point) -> str:
    return f"{float(point.x):.2f} {float(point.y):.2f}"
