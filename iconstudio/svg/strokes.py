"""Hairlines made thick enough to be seen, and dashes and patterns that are too fine, coarser."""

import copy
import re
import xml.etree.ElementTree as ET
from typing import NamedTuple

import numpy as np

from iconstudio.algorithms.tones.paints import near_white
from iconstudio.model import CANVAS
from iconstudio.svg.geometry import SHAPES, path_data, slender
from iconstudio.svg.lengths import (
    IDENTITY,
    Box,
    Matrix,
    length,
    multiplied,
    numbers,
    scale_of,
    transform,
    written,
)

_WIDTH = 3.7
"""Canvas units of the thinnest stroke of a drawing of hairlines."""
_HEX = re.compile(r"#([0-9a-f]{2})([0-9a-f]{2})([0-9a-f]{2})", re.IGNORECASE)
_FINE = 0.25
"""Canvas units: what repeats more closely is no more than a tone."""
_TILE = 1.0
"""Canvas units of the smallest tile of a pattern."""

_HAIR, _LONG = 0.55, 16
"""How wide a filled shape as thin as a hair is at most, as part of the thinnest stroke; so many
times as long as wide it is at least."""
_SHEEN = 0.5
"""What is less opaque is the light or the shade along an edge, and no line."""
_FEW = 400
"""Characters of the outline of such a shape at most."""

_BESIDE_FILL = 0.1
"""A stroke around a fill is no line if it is narrower than this part of the thinnest stroke."""
_UNSEEN = 0.5
"""Canvas units: a narrower stroke is never ink, so around a fill in a colour it is no line."""
_DEFINITIONS = ("clipPath", "mask", "marker", "pattern")
"""What is measured by itself, or by what it serves."""

FINE_DASHES = "Its dashes are too fine to be seen; the lines were drawn whole."
FINE_PATTERNS = "A pattern in it is too fine to be seen; it was drawn coarser."


class _Stroke(NamedTuple):
    """What shapes inherit."""

    fill: str = "#000000"
    stroke: str = "none"
    width: float = 1.0
    opacity: float = 1.0
    fill_opacity: float = 1.0
    stroke_opacity: float = 1.0

    def of(self, element: ET.Element, page: Box) -> "_Stroke":
        said = (element.get(name, "inherit") for name in ("fill", "stroke"))
        fill, stroke = (
            before if now == "inherit" else now
            for before, now in zip((self.fill, self.stroke), said, strict=True)
        )
        width = length(element.get("stroke-width"), max(page[2:]), self.width)
        opacity = self.opacity * length(element.get("opacity"), 1, 1)
        of_fill, of_stroke = (
            length(element.get(f"{name}-opacity"), 1, before)
            for name, before in (("fill", self.fill_opacity), ("stroke", self.stroke_opacity))
        )
        return _Stroke(fill, stroke, width, opacity, of_fill, of_stroke)

    @property
    def is_drawn(self) -> bool:
        """Whether there is a stroke to be seen, however thin."""
        return self.stroke != "none" and self.width > 0 and self.stroke_opacity > 0

    @property
    def is_beside_colour(self) -> bool:
        """Whether there is a fill of another colour, which is not as white as paper."""
        is_plain = self.fill != "none" and self.fill_opacity * self.opacity >= _SHEEN
        match = _HEX.fullmatch(self.fill)
        white = match and near_white(np.array([int(one, 16) for one in match.groups()], np.uint8))
        return is_plain and self.fill != self.stroke and not white


def bare(content: ET.Element, size: float, page: Box) -> ET.Element:
    """Return a drawing without strokes that nobody sees, around fills in colours.

    ``size`` is the side of the canvas in user space; ``page`` is what percentages refer to.
    """
    content = copy.deepcopy(content)
    _strip(content, IDENTITY, _Stroke(), _UNSEEN * size / CANVAS, page)
    return content


def _strip(element: ET.Element, outer: Matrix, inherited: _Stroke, least: float, page: Box) -> None:
    if element.tag in _DEFINITIONS:
        return
    matrix = multiplied(outer, transform(element.get("transform")) or IDENTITY)
    own = inherited.of(element, page)
    thin = own.is_drawn and 0 < own.width * scale_of(matrix) < least
    if element.tag in SHAPES and thin and own.is_beside_colour:
        element.set("stroke", "none")
    for child in element:
        _strip(child, matrix, own, least, page)


def thickened(content: ET.Element, size: float, page: Box) -> ET.Element:
    """Return a drawing whose strokes, and shapes, measure at least 3.7 canvas units.

    ``size`` is the side of the canvas in user space; ``page`` is what percentages refer to.
    """
    content = copy.deepcopy(content)
    _thicken(content, IDENTITY, _Stroke(), _WIDTH * size / CANVAS, page, fills=True)
    return content


def widened(page: Box, size: float) -> Box:
    """Return a page that is high and wide enough for a stroke: a strip may be slimmer."""
    x, y, width, height = page
    least = 2 * _WIDTH * size / CANVAS
    across, down = max(width, least), max(height, least)
    return x - (across - width) / 2, y - (down - height) / 2, across, down


def evened(content: ET.Element, size: float, page: Box, least: float) -> ET.Element | None:
    """Return a drawing whose strokes measure at least ``least`` canvas units; None if they do.

    So do filled shapes that are lines as thin as a hair.
    """
    before, content = content, copy.deepcopy(content)
    changed = _thicken(content, IDENTITY, _Stroke(), least * size / CANVAS, page, fills=False)
    return content if changed and content is not before else None


def _thicken(
    element: ET.Element, outer: Matrix, inherited: _Stroke, least: float, page: Box, fills: bool
) -> bool:
    """Thicken strokes in place; return whether there were some to be."""
    if element.tag in _DEFINITIONS:
        return False
    matrix = multiplied(outer, transform(element.get("transform")) or IDENTITY)
    own = inherited.of(element, page)
    if element.tag not in SHAPES:
        found = [_thicken(child, matrix, own, least, page, fills) for child in element]
        return any(found)
    scale = scale_of(matrix)
    if own.is_drawn:
        if own.width * scale >= least or not scale:
            return False
        is_filled = own.fill != "none" and not fills
        if is_filled and (own.fill == own.stroke or own.width * scale < _BESIDE_FILL * least):
            return False
        element.attrib.pop("stroke-dasharray", None)
        width = least
    elif own.fill != "none" and scale:
        if not fills and own.opacity * own.fill_opacity < _SHEEN:
            return False
        width = least if fills else _missing(path_data(element, page), scale, least)
        if not width:
            return False
        element.set("stroke", own.fill)
        element.set("stroke-dasharray", "none")
        element.set("stroke-opacity", f"{own.fill_opacity:.6g}")
    else:
        return False
    element.set("stroke-width", f"{width / scale:.6g}")
    return True


def _missing(data: str, scale: float, least: float) -> float:
    """Return how much wider a filled shape must be that is a line as thin as a hair; else 0."""
    if len(data) > _FEW or data.count("M") + data.count("m") != 1:
        return 0.0
    long, wide = slender(data)
    thin = 0 < wide * scale < _HAIR * least and long > _LONG * wide
    thin = thin and long * scale > _LONG * _HAIR * least  # and no crumb
    return least - wide * scale if thin else 0.0


def coarsened(content: ET.Element, size: float, page: Box) -> tuple[ET.Element, list[str]]:
    """Return a drawing without dashes and patterns that are too fine to be drawn, and remarks.

    ``size`` is the side of the canvas in user space; ``page`` is what percentages refer to.
    """
    unit = size / CANVAS
    coarse = copy.deepcopy(content)
    dashes = _join_dashes(coarse, IDENTITY, None, _FINE * unit)
    patterns = [_enlarge(one, size) for one in coarse.iter("pattern")]
    remarks = [
        said for said, found in ((FINE_DASHES, dashes), (FINE_PATTERNS, any(patterns))) if found
    ]
    return (coarse, remarks) if remarks else (content, [])


def _join_dashes(element: ET.Element, outer: Matrix, dashes: str | None, least: float) -> bool:
    if element.tag in _DEFINITIONS:
        return False
    matrix = multiplied(outer, transform(element.get("transform")) or IDENTITY)
    dashes = element.get("stroke-dasharray", dashes)
    if element.tag not in SHAPES:
        return any([_join_dashes(child, matrix, dashes, least) for child in element])
    period = sum(numbers(dashes or ""))
    if not 0 < period * scale_of(matrix) < least:
        return False
    element.set("stroke-dasharray", "none")
    return True


def _enlarge(pattern: ET.Element, size: float) -> bool:
    """Enlarge a pattern whose tiles are too small, in place; return whether they are."""
    before = transform(pattern.get("patternTransform")) or IDENTITY
    whole = 1.0 if pattern.get("patternUnits") == "userSpaceOnUse" else size
    sides = [length(pattern.get(name), size) * whole for name in ("width", "height")]
    tile = min(sides) * scale_of(before)
    unit = size / CANVAS
    if not 0 < tile < _FINE * unit:
        return False
    factor = _TILE * unit / tile
    larger = multiplied(before, (factor, 0, 0, factor, 0, 0))
    pattern.set("patternTransform", f"matrix({written(larger)})")
    return True
