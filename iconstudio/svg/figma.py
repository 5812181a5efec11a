"""What Figma writes as parts of web pages: gradients around a point, and blurs of what is behind.

SVG has no angular gradients. Figma puts a web page in their shape's place, and beside it the shape,
which is painted with nothing but says what it should be painted with. Where it has a blurred
backdrop, another empty page lies behind it.
"""

import itertools
import json
import xml.etree.ElementTree as ET

IN_ONE_COLOUR = "An angular or diamond gradient of Figma was drawn as one colour."

_GRADIENT, _INSTEAD = "data-figma-gradient-fill", "data-figma-skip-parse"
_BLURRED = "data-figma-bg-blur-radius"
_UNKNOWN = "#808080"
"""In place of colours that are not told."""


def without_web_pages(root: ET.Element) -> list[str]:
    """Paint shapes with the mean colour of their gradient, in place; return what to say.

    The pages that stand for gradients and for blurs are gone.
    """
    remarks = []
    for parent in list(root.iter()):
        backdrops = []
        for before, element in itertools.pairwise([ET.Element("g"), *parent]):
            if element.tag == "foreignObject":
                backdrops.append(element)
            if _BLURRED in element.attrib and backdrops:
                parent.remove(backdrops.pop())
            if _GRADIENT not in element.attrib or "fill" in element.attrib:
                continue
            stands_for_it = _INSTEAD in before.attrib
            is_page = stands_for_it and any(True for _ in before.iter("foreignObject"))
            if is_page:
                parent.remove(before)
            if is_page or not stands_for_it:  # else other shapes do
                element.attrib |= _paint(element.attrib[_GRADIENT])
                remarks.append(IN_ONE_COLOUR)
    return remarks


def _paint(said: str) -> dict[str, str]:
    """Return the mean colour of a gradient, by how opaque its stops are, at its most opaque."""
    try:
        stops = [one["color"] for one in json.loads(said)["stops"]]
        weights = [float(one["a"]) for one in stops]
        whole = sum(weights)
        mean = [sum(w * one[c] for w, one in zip(weights, stops, strict=True)) for c in "rgb"]
        levels = [min(max(round(255 * value / whole), 0), 255) for value in mean]
    except (ValueError, KeyError, TypeError, ArithmeticError, RecursionError):
        return {"fill": _UNKNOWN}
    return {"fill": "#{:02x}{:02x}{:02x}".format(*levels), "fill-opacity": f"{max(weights):.4g}"}
