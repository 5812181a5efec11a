"""Where the shapes of a document lie: the adapter of fontTools, whose pens read path data.

Everything is computed in double precision; the renderer has but 24 bits.
"""

import math
import xml.etree.ElementTree as ET
from collections.abc import Iterable
from functools import lru_cache
from pathlib import Path

import numpy as np
from fontTools.pens.basePen import BasePen
from fontTools.pens.boundsPen import ControlBoundsPen
from fontTools.pens.perimeterPen import PerimeterPen
from fontTools.pens.recordingPen import RecordingPen
from fontTools.pens.svgPathPen import SVGPathPen
from fontTools.pens.transformPen import TransformPen
from fontTools.svgLib.path.parser import parse_path
from fontTools.ttLib import TTFont

from iconstudio.model.path import Path as Outline
from iconstudio.model.path import PathPen
from iconstudio.svg.lengths import (
    Box,
    Matrix,
    length,
    numbers,
)

DEFINITIONS = (
    "defs", "symbol", "clipPath", "mask", "pattern", "marker", "linearGradient", "radialGradient",
    "filter",
)  # fmt: skip
"""Elements that show nothing where they stand."""
SHAPES = ("path", "rect", "circle", "ellipse", "line", "polyline", "polygon")
_STEPS = 24
"""Into which curves are divided."""


def path_data(shape: ET.Element, page: Box) -> str:
    """Return the outline of a shape as path data; percentages are of ``page``."""
    width, height = page[2], page[3]
    diagonal = math.hypot(width, height) / math.sqrt(2)

    def across(name: str, default: float = 0.0) -> float:
        return length(shape.get(name), width, default)

    def down(name: str, default: float = 0.0) -> float:
        return length(shape.get(name), height, default)

    match shape.tag:
        case "path":
            return shape.get("d", "")
        case "rect":
            rx, ry = across("rx", math.nan), down("ry", math.nan)
            rx, ry = ry if math.isnan(rx) else rx, rx if math.isnan(ry) else ry
            corner = (0.0, 0.0) if math.isnan(rx) or math.isnan(ry) else (rx, ry)
            return _rectangle(across("x"), down("y"), across("width"), down("height"), *corner)
        case "circle":
            r = length(shape.get("r"), diagonal)
            return _ellipse(across("cx"), down("cy"), r, r)
        case "ellipse":
            rx, ry = across("rx", math.nan), down("ry", math.nan)
            rx, ry = ry if math.isnan(rx) else rx, rx if math.isnan(ry) else ry
            return "" if math.isnan(rx) else _ellipse(across("cx"), down("cy"), rx, ry)
        case "line":
            return f"M{across('x1')} {down('y1')}L{across('x2')} {down('y2')}"
        case "polyline" | "polygon":
            points = numbers(shape.get("points", ""))
            pairs = zip(points[::2], points[1::2], strict=False)
            joined = "L".join(f"{x} {y}" for x, y in pairs)
            closed = "Z" if shape.tag == "polygon" else ""
            return f"M{joined}{closed}" if joined else ""
    return ""


def _rectangle(x: float, y: float, width: float, height: float, rx: float, ry: float) -> str:
    if width <= 0 or height <= 0:
        return ""
    rx, ry = min(max(rx, 0), width / 2), min(max(ry, 0), height / 2)
    if not rx or not ry:
        return f"M{x} {y}h{width}v{height}h{-width}Z"
    arc = f"a{rx} {ry} 0 0 1 "
    return (
        f"M{x + rx} {y}h{width - 2 * rx}{arc}{rx} {ry}v{height - 2 * ry}{arc}{-rx} {ry}"
        f"h{2 * rx - width}{arc}{-rx} {-ry}v{2 * ry - height}{arc}{rx} {-ry}Z"
    )


def _ellipse(cx: float, cy: float, rx: float, ry: float) -> str:
    if rx <= 0 or ry <= 0:
        return ""
    # From the right clockwise, as SVG says for the sake of dashes.
    return f"M{cx + rx} {cy}a{rx} {ry} 0 1 1 {-2 * rx} 0a{rx} {ry} 0 1 1 {2 * rx} 0Z"


def moved(data: str, matrix: Matrix) -> str:
    """Return path data mapped by a matrix."""
    pen = SVGPathPen(None, ntos=lambda value: f"{value:.9g}")
    _recorded(data).replay(TransformPen(pen, matrix))
    commands: str = pen.getCommands()
    return commands


def outline(data: str, matrix: Matrix) -> Outline:
    """Return path data mapped by a matrix, as lines and cubics; arcs are cubics nearly."""
    pen = PathPen()
    _recorded(data).replay(TransformPen(_Cubics(pen), matrix))
    return pen.path


class _Cubics(BasePen):  # type: ignore[misc]  # it has no types
    """Hands on what is drawn, quadratic curves as cubics."""

    def __init__(self, pen: PathPen) -> None:
        super().__init__()
        self._moveTo, self._lineTo, self._curveToOne = pen.moveTo, pen.lineTo, pen.curveTo
        self._closePath, self._endPath = pen.closePath, pen.endPath


def missing_letters(texts: Iterable[str], font: Path) -> str:
    """Return the letters of some texts that a font does not have, each once."""
    with TTFont(font, lazy=True) as opened:
        known = opened.getBestCmap()
    letters = dict.fromkeys(letter for text in texts for letter in text)
    return "".join(one for one in letters if not one.isspace() and ord(one) not in known)


@lru_cache(maxsize=4)
def advances(font: Path) -> dict[int, float]:
    """Return how far each character of a font moves the pen, in em."""
    with TTFont(font, lazy=True) as opened:
        em, metrics = opened["head"].unitsPerEm, opened["hmtx"]
        return {one: metrics[name][0] / em for one, name in opened.getBestCmap().items()}


def data_length(data: str) -> float:
    """Return the length of a path."""
    pen = PerimeterPen(None)
    _recorded(data).replay(pen)
    return float(pen.value)


def slender(data: str) -> tuple[float, float]:
    """Return the length and the mean width of what a path of one contour fills, as of a line."""
    points = np.array(_flattened(data)).reshape(-1, 2)
    sides = np.roll(points, -1, axis=0) - points
    half = float(np.hypot(sides[:, 0], sides[:, 1]).sum()) / 2
    middle = points - points.mean(axis=0) if len(points) else points
    area = abs(float((middle[:, 0] * sides[:, 1] - middle[:, 1] * sides[:, 0]).sum())) / 2
    return half, area / half if half else 0.0


def along(data: str, part: float) -> tuple[float, float, float] | None:
    """Return x, y and direction, in degrees, at a part of a path's length; None if it has none."""
    points = np.array(_flattened(data))
    if not len(points):
        return None
    steps = np.diff(points, axis=0, prepend=points[:1])
    lengths = np.cumsum(np.hypot(steps[:, 0], steps[:, 1]))
    x, y = (float(np.interp(part * lengths[-1], lengths, points[:, axis])) for axis in (0, 1))
    here = min(max(int(np.searchsorted(lengths, part * lengths[-1])), 1), len(points) - 1)
    return x, y, math.degrees(math.atan2(steps[here, 1], steps[here, 0]))


def _flattened(data: str) -> list[tuple[float, float]]:
    """Return the points of the polygon that a path nearly is; jumps are sides of it, too."""
    points: list[tuple[float, float]] = []
    start = (0.0, 0.0)
    for name, ends in _recorded(data).value:
        if name == "closePath":
            points.append(start)
        if not ends:
            continue
        if name == "moveTo":
            start = ends[0]
        if name in ("moveTo", "lineTo"):
            points.append(ends[0])
            continue
        controls = np.array([points[-1], *ends])
        degree = len(controls) - 1
        t = np.linspace(0, 1, _STEPS + 1)[1:, None]
        powers = [math.comb(degree, k) * t**k * (1 - t) ** (degree - k) for k in range(degree + 1)]
        curve = sum(power * control for power, control in zip(powers, controls, strict=True))
        points += map(tuple, curve)
    return points


def corners(data: str) -> list[tuple[float, float]]:
    """Return the ends of all segments of a path, in their order."""
    return [points[-1] for _, points in _recorded(data).value if points and points[-1] is not None]


@lru_cache(maxsize=512)
def data_bounds(data: str) -> Box | None:
    """Return the bounding box of the control points; None if there are none."""
    pen = ControlBoundsPen(None, ignoreSinglePoints=False)
    _recorded(data).replay(pen)
    if pen.bounds is None or not all(map(math.isfinite, pen.bounds)):
        return None
    left, top, right, bottom = pen.bounds
    return left, top, right - left, bottom - top


def _recorded(data: str) -> RecordingPen:
    """Read path data up to its first mistake, as renderers do."""
    pen = RecordingPen()
    try:
        parse_path(data, pen)
    except Exception:  # of many kinds, by whatever the mistake is
        ended = ("endPath", "closePath")
        if pen.value and pen.value[-1][0] not in ended:
            pen.value.append(("endPath", ()))
    return pen
