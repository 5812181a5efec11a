"""Basic shapes of CSS to which elements are clipped (CSS Shapes; CSS Masking), as clip paths."""

import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Mapping

from iconstudio.svg.bounds import bounds
from iconstudio.svg.lengths import Box, length
from iconstudio.svg.properties import not_understood

_SHAPE = re.compile(r"(polygon|circle|ellipse|inset|path|rect|xywh)\(([^()]*)\)", re.IGNORECASE)
_BOX = re.compile(r"\b([a-z]+-box)\b", re.IGNORECASE)
_STRING = re.compile(r"(?:(evenodd|nonzero)\s*,)?\s*([\"'])(.*)\2", re.DOTALL)
_PLACES = {"left": "0%", "top": "0%", "center": "50%", "right": "100%", "bottom": "100%"}


def is_basic_shape(value: str) -> bool:
    """Whether a value of ``clip-path`` is a shape rather than the address of one."""
    return _SHAPE.search(value) is not None


def clip(root: ET.Element, page: Box | None, ids: dict[str, ET.Element]) -> list[str]:
    """Give elements that are clipped to basic shapes clip paths, in place.

    Returns
    -------
    Sentences about what was not understood.
    """
    remarks: list[str] = []
    shown = page or (0.0, 0.0, 100.0, 100.0)
    clipped = [one for one in root.iter() if is_basic_shape(one.get("clip-path", ""))]
    for number, element in enumerate(clipped):
        value = element.attrib.pop("clip-path")
        match = _SHAPE.search(value)
        assert match is not None
        path = _path(match[1].lower(), match[2].strip(), _reference(element, value, shown, ids))
        if path is None:
            remarks.append(not_understood("clip-path", value))
            continue
        name = f"s{number}"
        shape = ids[name] = ET.SubElement(root, "clipPath", id=name)
        shape.append(path)
        element.set("clip-path", f"url(#{name})")
    return remarks


def _reference(element: ET.Element, value: str, page: Box, ids: Mapping[str, ET.Element]) -> Box:
    """Return the box to which a shape refers, in the space of the element itself."""
    box = _BOX.search(_SHAPE.sub("", value))
    if element.tag == "svg" or (box is not None and box[1].lower() == "view-box"):
        return page
    transform = element.attrib.pop("transform", None)
    stroke = element.get("stroke")
    if box is not None and box[1].lower() in ("fill-box", "content-box", "padding-box"):
        element.set("stroke", "none")
    found = bounds(element, page, ids)
    for name, before in (("transform", transform), ("stroke", stroke)):
        if before is None:
            element.attrib.pop(name, None)
        else:
            element.set(name, before)
    return found or page


def _path(shape: str, arguments: str, box: Box) -> ET.Element | None:
    """Return a shape within a box as an element; None if it is not understood."""
    x, y, width, height = box
    try:
        match shape:
            case "polygon":
                return _polygon(arguments, box)
            case "circle" | "ellipse":
                return _ellipse(shape, arguments, box)
            case "inset":
                sides, _, corner = arguments.partition("round")
                top, right, bottom, left = _sides(sides.split(), height, width)
                inner = width - left - right, height - top - bottom
                return _rectangle((x + left, y + top, *inner), corner.split())
            case "xywh" | "rect":
                sides, _, corner = arguments.partition("round")
                one, two, three, four = sides.split()
                if shape == "xywh":
                    start = x + _length(one, width), y + _length(two, height)
                    inner = _length(three, width), _length(four, height)
                else:
                    start = x + _edge(four, width, 0), y + _edge(one, height, 0)
                    inner = (
                        x + _edge(two, width, width) - start[0],
                        y + _edge(three, height, height) - start[1],
                    )
                return _rectangle((*start, *inner), corner.split())
            case "path":
                found = _STRING.fullmatch(arguments)
                if found is None:
                    return None
                moved = ET.Element("path", d=found[3], transform=f"translate({x} {y})")
                moved.set("clip-rule", found[1] or "nonzero")
                return moved
    except ValueError:  # too few numbers, or none
        return None
    return None


def _length(text: str, whole: float) -> float:
    found = length(text, whole, math.nan)
    if math.isnan(found):
        raise ValueError(text)
    return found


def _edge(text: str, whole: float, default: float) -> float:
    return default if text == "auto" else _length(text, whole)


def _polygon(arguments: str, box: Box) -> ET.Element:
    rule, points = "nonzero", []
    for part in arguments.split(","):
        words = part.split()
        if words and words[0] in ("evenodd", "nonzero"):
            rule, words = words[0], words[1:]
        if words:
            across, down = words
            x, y = box[0] + _length(across, box[2]), box[1] + _length(down, box[3])
            points.append(f"{x:.9g},{y:.9g}")
    return ET.Element("polygon", {"points": " ".join(points), "clip-rule": rule})


def _ellipse(shape: str, arguments: str, box: Box) -> ET.Element:
    x, y, width, height = box
    size, _, place = arguments.partition("at ")
    where = [_PLACES.get(one, one) for one in place.split()] or ["50%", "50%"]
    across, down = [*where, "50%"][:2]
    if place.split()[:1] in (["top"], ["bottom"]):
        across, down = down, across
    left, top = _length(across, width), _length(down, height)
    radii = size.split() or ["closest-side"]
    reach = (abs(left), abs(width - left)), (abs(top), abs(height - top))
    if shape == "circle":
        (radius,) = radii
        sides = {"closest-side": min, "farthest-side": max}
        if radius in sides:
            r = sides[radius](*reach[0], *reach[1])
        else:
            r = _length(radius, math.hypot(width, height) / math.sqrt(2))
        rx = ry = r
    else:
        one, two = radii * 2 if len(radii) == 1 else radii
        rx, ry = _radius(one, width, reach[0]), _radius(two, height, reach[1])
    return ET.Element(
        "ellipse", cx=f"{x + left:.9g}", cy=f"{y + top:.9g}", rx=f"{rx:.9g}", ry=f"{ry:.9g}"
    )


def _radius(text: str, whole: float, reach: tuple[float, float]) -> float:
    if text == "closest-side":
        return min(reach)
    return max(reach) if text == "farthest-side" else _length(text, whole)


def _sides(parts: list[str], height: float, width: float) -> tuple[float, float, float, float]:
    """Return what is cut off at the top, the right, the bottom and the left."""
    if not parts:
        raise ValueError("no sides")
    if len(parts) < 4:
        parts = [parts[0], parts[min(1, len(parts) - 1)], parts[2 if len(parts) == 3 else 0]]
        parts.append(parts[1])
    top, right, bottom, left = parts
    return (
        _length(top, height),
        _length(right, width),
        _length(bottom, height),
        _length(left, width),
    )


def _rectangle(box: Box, corner: list[str]) -> ET.Element:
    x, y, width, height = box
    found = ET.Element(
        "rect", x=f"{x:.9g}", y=f"{y:.9g}", width=f"{max(width, 0):.9g}",
        height=f"{max(height, 0):.9g}",
    )  # fmt: skip
    if corner:  # of several, the first
        found.set("rx", f"{_length(corner[0], width):.9g}")
        found.set("ry", f"{_length(corner[0], height):.9g}")
    return found
