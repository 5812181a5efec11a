"""Lengths in parts of a viewport, written out (SVG 2, section 8.9)."""

import xml.etree.ElementTree as ET

from iconstudio.svg.geometry import SHAPES
from iconstudio.svg.lengths import Box, length, whole_of

_LENGTHS = (
    "x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "r", "rx", "ry", "width", "height", "dx", "dy",
    "stroke-width", "stroke-dasharray", "stroke-dashoffset",
)  # fmt: skip
_MEASURED = (*SHAPES, "g", "a", "defs", "switch", "text", "tspan", "use", "svg")
_AROUND = ("clipPath", "mask", "pattern")
"""What is measured as what is around it, unless it says otherwise."""
_UNITS = ("clipPathUnits", "maskContentUnits", "patternContentUnits")


def write_out(element: ET.Element, page: Box) -> None:
    """Write out the percentages of all that a viewport holds, ``page`` in its own units, in place.

    But for what has a viewport or units of its own, such as gradients, markers and symbols.
    """
    if element.tag in _MEASURED:
        for name in _LENGTHS:
            if "%" in element.get(name, ""):
                whole = whole_of(name, page)
                parts = element.attrib[name].replace(",", " ").split()
                element.set(name, " ".join(f"{length(one, whole):.9g}" for one in parts))
    elif (
        element.tag not in _AROUND
        or "viewBox" in element.attrib
        or any(element.get(units) == "objectBoundingBox" for units in _UNITS)
    ):
        return
    if element.tag != "svg":  # which is the viewport of what it holds
        for child in element:
            write_out(child, page)
