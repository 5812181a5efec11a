"""Strokes that do not scale (SVG 2, section 8.10), for a renderer that scales all."""

import re
import xml.etree.ElementTree as ET

from iconstudio.svg.bounds import viewport
from iconstudio.svg.geometry import SHAPES, moved, path_data
from iconstudio.svg.lengths import (
    IDENTITY,
    Box,
    Matrix,
    inverse,
    multiplied,
    pixels,
    transform,
    written,
)

_OF_SHAPES = re.compile(r"d|x|y|x1|y1|x2|y2|cx|cy|r|rx|ry|width|height|points|vector-effect")


def keep_strokes(root: ET.Element, page: Box | None) -> None:
    """Give strokes that do not scale the width that they have on the screen, in place.

    Nothing is repeated any more, and nothing within has a viewport of its own.
    """
    if all(one.get("vector-effect") != "non-scaling-stroke" for one in root.iter()):
        return
    width, height = pixels(root.get("width")), pixels(root.get("height"))
    outer = IDENTITY
    if width and height and page:
        outer = viewport(root, (0, 0, width, height), (str(width), str(height)))
    for child in root:
        _keep(child, outer, page or (0.0, 0.0, 100.0, 100.0))


def _keep(element: ET.Element, outer: Matrix, page: Box) -> None:
    """Draw shapes whose strokes do not scale in the space of the screen, and map it back."""
    matrix = multiplied(outer, transform(element.get("transform")) or IDENTITY)
    if element.tag in SHAPES:
        back = inverse(outer)
        if element.get("vector-effect") == "non-scaling-stroke" and back is not None:
            data = moved(path_data(element, page), matrix)
            if data:
                _as_path(element, data, back)
        return
    for child in element:
        _keep(child, matrix, page)


def _as_path(element: ET.Element, data: str, matrix: Matrix) -> None:
    for name in [name for name in element.attrib if _OF_SHAPES.fullmatch(name)]:
        del element.attrib[name]
    element.tag = "path"
    element.set("d", data)
    element.set("transform", f"matrix({written(matrix)})")
