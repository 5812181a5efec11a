"""Transforms of CSS (SVG 2, section 8.5), in SVG 1.1."""

import re
import xml.etree.ElementTree as ET
from collections.abc import Mapping

from iconstudio.svg.bounds import bounds
from iconstudio.svg.geometry import SHAPES, data_length, path_data
from iconstudio.svg.lengths import (
    IDENTITY,
    Box,
    around,
    length,
    numbers,
    transform,
    written,
)
from iconstudio.svg.properties import not_understood

_ORIGINS = {"left": "0%", "top": "0%", "center": "50%", "right": "100%", "bottom": "100%"}
_OF_SERVERS = ("gradientTransform", "patternTransform")
_TRANSLATION = re.compile(r"(translate(?:[xy]|3d)?)\(([^()]*%[^()]*)\)", re.IGNORECASE)
_DASHES = ("stroke-dasharray", "stroke-dashoffset")
_VIEWPORTS = ("svg", "symbol")
_OF_CSS = ("transform-origin", "transform-box", "translate", "rotate", "scale")


def place(root: ET.Element, page: Box | None, ids: Mapping[str, ET.Element]) -> list[str]:
    """Write every transform as SVG 1.1 does, and give strokes that do not scale their width.

    Returns
    -------
    Sentences about what was not understood.
    """
    remarks: list[str] = []
    _scale_dashes(root, {}, page or (0.0, 0.0, 100.0, 100.0))
    shown = page or (0.0, 0.0, 100.0, 100.0)
    _place_all(root, shown, ids, remarks)
    return remarks


def _place_all(
    element: ET.Element, page: Box, ids: Mapping[str, ET.Element], remarks: list[str]
) -> None:
    """Place an element and all within. ``page`` is that of the nearest viewport."""
    _place(element, page, ids, remarks)
    if element.tag in _VIEWPORTS:
        page = _page_within(element, page)
    for child in element:
        _place_all(child, page, ids, remarks)


def _page_within(element: ET.Element, page: Box) -> Box:
    """Return the box that percentages refer to within a viewport."""
    box = numbers(element.get("viewBox", ""))
    if len(box) == 4 and box[2] > 0 and box[3] > 0:
        return box[0], box[1], box[2], box[3]
    width, height = element.get("width"), element.get("height")
    return 0.0, 0.0, length(width, page[2], page[2]), length(height, page[3], page[3])


def _place(
    element: ET.Element, page: Box, ids: Mapping[str, ET.Element], remarks: list[str]
) -> None:
    if element.tag.startswith("fe"):
        return  # whose scale is that of a displacement
    rotate = element.get("rotate") if element.tag not in ("text", "tspan", "textPath") else None
    said = [
        _call("translate", element.get("translate")),
        _call("rotate", rotate),
        _call("scale", element.get("scale")),
        element.get("transform", ""),
    ]
    for name in _OF_SERVERS:
        matrix = transform(element.get(name))
        if name in element.attrib and matrix is not None:
            element.set(name, f"matrix({written(matrix)})")
    if any(said):
        box = _reference_box(element, page, ids) if any("%" in one for one in said) else page
        matrix = transform(_in_pixels(" ".join(filter(None, said)), box))
        if matrix is None:
            remarks.append(not_understood("transform", " ".join(filter(None, said))))
            matrix = IDENTITY
        element.attrib.pop("transform", None)
        origin = _origin(element, page, ids)
        if origin is not None:
            matrix = around(origin, matrix)
        if matrix != IDENTITY:
            element.set("transform", f"matrix({written(matrix)})")
    for one in _OF_CSS:
        if one != "rotate" or rotate is not None:
            element.attrib.pop(one, None)


def _scale_dashes(element: ET.Element, dashes: Mapping[str, str], page: Box) -> None:
    """Measure dashes by the length that a shape says it has (``pathLength``)."""
    own = {name: element.attrib[name] for name in _DASHES if name in element.attrib}
    dashes = {**dashes, **own}
    if element.tag in SHAPES:
        said = numbers(element.attrib.pop("pathLength", ""))
        if said and said[0] > 0 and dashes:
            factor = data_length(path_data(element, page)) / said[0]
            for name, value in dashes.items():
                if numbers(value):
                    element.set(name, written(tuple(one * factor for one in numbers(value))))
        return
    for child in element:
        _scale_dashes(child, dashes, page)


def _call(function: str, value: str | None) -> str:
    if value is None or value == "none":
        return ""
    return f"{function}({', '.join(value.split())})"


def _origin(
    element: ET.Element, page: Box, ids: Mapping[str, ET.Element]
) -> tuple[float, float] | None:
    """Return the point that a transform leaves where it is; None for the origin."""
    text = element.get("transform-origin")
    kind = element.get("transform-box", "view-box")
    if text is None and kind == "view-box":
        return None
    parts = [_ORIGINS.get(part, part) for part in (text or "50% 50%").lower().split()]
    if text and text.lower().split()[0] in ("top", "bottom"):
        parts = parts[1:2] + parts[:1] if len(parts) > 1 else ["50%", parts[0]]
    parts = [*parts, "50%"][:2]
    box = _reference_box(element, page, ids)
    return box[0] + length(parts[0], box[2]), box[1] + length(parts[1], box[3])


def _reference_box(element: ET.Element, page: Box, ids: Mapping[str, ET.Element]) -> Box:
    """Return the box that percentages of a transform refer to."""
    box = (0.0, 0.0, page[2], page[3])
    if element.get("transform-box", "view-box") == "view-box":
        return box
    still = element.attrib.pop("transform", None)
    found = bounds(element, page, ids) or box
    if still is not None:
        element.set("transform", still)
    return found


def _in_pixels(said: str, box: Box) -> str:
    """Return transforms of CSS without percentages."""

    def replaced(match: re.Match[str]) -> str:
        down = match[1].lower().endswith("y")
        parts = [
            f"{length(part, box[3 if down or number else 2])}px" if "%" in part else part
            for number, part in enumerate(match[2].replace(",", " ").split())
        ]
        return f"{match[1]}({', '.join(parts)})"

    return _TRANSLATION.sub(replaced, said)
