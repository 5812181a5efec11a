"""Drawings at far or huge coordinates, brought near: a renderer counts in 24 bits."""

import copy
import xml.etree.ElementTree as ET

from iconstudio.model import CANVAS
from iconstudio.svg.geometry import SHAPES, moved, path_data
from iconstudio.svg.lengths import (
    IDENTITY,
    Box,
    Matrix,
    inverse,
    length,
    multiplied,
    numbers,
    scale_of,
    transform,
    written,
)

_SMALLEST, _LARGEST = 0.1, 20_000.0
"""Sizes of user space with which renderers are at ease."""
_FAR = 100.0
"""How many times its size a drawing may lie away from the origin."""
_OF_SHAPES = (
    "d", "x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "r", "rx", "ry", "width", "height", "points",
    "transform",
)  # fmt: skip
_TRANSFORMED = ("gradientTransform", "patternTransform")


def brought_near(content: ET.Element, page: Box | None, drawn: Box) -> tuple[ET.Element, Matrix]:
    """Return a drawing in coordinates of a usual size, and how it came there.

    ``drawn`` is the box around its shapes, and ``page`` what is seen of them.
    """
    x, y, width, height = page or drawn
    size = max(width, height) or 1.0
    far = max(abs(x), abs(y), abs(drawn[0]), abs(drawn[1])) > _FAR * size
    if _SMALLEST <= size <= _LARGEST and not far:
        return content, IDENTITY
    scale = CANVAS / size
    matrix = scale, 0.0, 0.0, scale, -x * scale, -y * scale
    if not far:
        outer = ET.Element("g", transform=f"matrix({written(matrix)})")
        outer.append(content)
        return outer, matrix
    content = copy.deepcopy(content)
    _move(content, IDENTITY, matrix, 1.0, page or drawn)
    return content, matrix


def _move(element: ET.Element, outer: Matrix, matrix: Matrix, stroke: float, page: Box) -> None:
    """Map the coordinates of an element and all below; ``outer`` is where these were before."""
    here = multiplied(outer, transform(element.attrib.pop("transform", None)) or IDENTITY)
    whole = multiplied(matrix, here)
    scale = scale_of(whole)
    stroke = length(element.attrib.pop("stroke-width", None), page[2], stroke)
    if element.tag in SHAPES:
        data = moved(path_data(element, page), whole)
        for name in _OF_SHAPES:
            element.attrib.pop(name, None)
        element.tag = "path"
        element.set("d", data)
        element.set("stroke-width", f"{stroke * scale:.9g}")
        for name in ("stroke-dasharray", "stroke-dashoffset"):
            if numbers(element.get(name, "")):
                mapped = (one * scale for one in numbers(element.get(name, "")))
                element.set(name, " ".join(f"{one:.9g}" for one in mapped))
        return
    for name in _TRANSFORMED:
        before = transform(element.get(name)) or IDENTITY
        units = "patternUnits" if name == "patternTransform" else "gradientUnits"
        if element.get(units) == "userSpaceOnUse":
            element.set(name, f"matrix({written(multiplied(whole, before))})")
    if element.tag in ("use", "text", "svg", "image"):
        back = inverse(matrix)
        if back is not None and element.tag != "use":
            element.set("transform", f"matrix({written(whole)})")
        elif back is not None:
            # What it repeats has been mapped already.
            shift = length(element.get("x"), page[2]), length(element.get("y"), page[3])
            placed = multiplied(here, (1, 0, 0, 1, *shift))
            element.attrib.pop("x", None)
            element.attrib.pop("y", None)
            element.set(
                "transform", f"matrix({written(multiplied(multiplied(matrix, placed), back))})"
            )
        return
    for child in element:
        _move(child, here, matrix, stroke, page)
