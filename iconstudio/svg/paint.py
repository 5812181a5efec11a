"""What a plain drawing is painted with."""

import re
import xml.etree.ElementTree as ET
from typing import NamedTuple

_OPAQUE = re.compile(r"#[0-9a-f]{6}")
_OPACITIES = ("opacity", "fill-opacity", "stroke-opacity")
_EFFECTS = ("filter", "style", "mask", "marker-start", "marker-mid", "marker-end")
_CONTAINERS = {"g", "defs", "clipPath", "use"}
_SHAPES = {"path", "rect", "circle", "ellipse", "line", "polyline", "polygon"}


class _Paints(NamedTuple):
    """Those that an element passes on."""

    color: str = "#000000"
    fill: str = "#000000"
    stroke: str = "none"

    def of(self, element: ET.Element) -> "_Paints":
        """Return those of a child."""
        given = (element.get(name, "inherit") for name in self._fields)
        return _Paints(
            *(mine if one == "inherit" else one for one, mine in zip(given, self, strict=True))
        )


def is_of_one_paint(content: ET.Element) -> bool:
    """Whether one opaque colour paints all of a plain drawing, so that all that shows is ink.

    False also if that takes more to know, as with masks, gradients or text.
    """
    found: set[str] = set()
    return _collect(content, _Paints(), found) and len(found) == 1


def _collect(element: ET.Element, inherited: _Paints, found: set[str]) -> bool:
    """Add the colours of an element to those found; return False if it has other paints."""
    if element.tag not in _CONTAINERS | _SHAPES:
        return False
    if any(element.get(name, "none") != "none" for name in _EFFECTS):
        return False
    if any(element.get(name, "1") not in ("1", "1.0", "inherit") for name in _OPACITIES):
        return False
    own = inherited.of(element)
    if element.tag in _SHAPES:
        used = {own.color if one == "currentColor" else one for one in (own.fill, own.stroke)}
        found |= used - {"none"}
    return all(map(_OPAQUE.fullmatch, found)) and (
        element.tag == "clipPath"  # what it is painted with does not show
        or all(_collect(child, own, found) for child in element)
    )
