"""Hairlines made thick enough to be seen."""

import copy
import xml.etree.ElementTree as ET

from iconstudio.model import CANVAS
from iconstudio.svg.geometry import SHAPES
from iconstudio.svg.lengths import (
    IDENTITY,
    Box,
    Matrix,
    length,
    multiplied,
    scale_of,
    transform,
)

_WIDTH = 3.7
"""Canvas units of the thinnest stroke."""


def thickened(content: ET.Element, size: float, page: Box) -> ET.Element:
    """Return a drawing whose strokes measure at least 3.7 canvas units.

    ``size`` is the side of the canvas in user space; ``page`` is what percentages refer to.
    """
    content = copy.deepcopy(content)
    _thicken(content, IDENTITY, 1.0, _WIDTH * size / CANVAS, page)
    return content


def _thicken(element: ET.Element, outer: Matrix, width: float, least: float, page: Box) -> None:
    matrix = multiplied(outer, transform(element.get("transform")) or IDENTITY)
    width = length(element.get("stroke-width"), max(page[2:]), width)
    if element.tag in SHAPES:
        scale = scale_of(matrix)
        if width and 0 < width * scale < least:
            element.set("stroke-width", f"{least / scale:.6g}")
            element.attrib.pop("stroke-dasharray", None)
        return
    for child in element:
        _thicken(child, matrix, width, least, page)
