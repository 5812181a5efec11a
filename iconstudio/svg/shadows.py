"""What is no part of an icon: shadows and glows, a blur behind a shape, and bevels.

What a bevel is on is drawn as it would be without light. A shadow may also be a shape, of one dark
colour that is hardly opaque where it begins and fades to nothing, as a long shadow does.
"""

import re
import xml.etree.ElementTree as ET
from collections.abc import Collection

from iconstudio.svg.colours import colour
from iconstudio.svg.geometry import SHAPES
from iconstudio.svg.lengths import numbers
from iconstudio.svg.references import GRADIENTS

LEFT_OUT = "A shadow was left out."
UNLIT = "Light on a surface, as on a bevel, was left out."

_DROP_SHADOW = re.compile(r"()drop-shadow\((?:[^()]|\([^()]*\))*\)")
_REFERENCE = re.compile(r"""\s*url\(\s*["']?#(.*?)["']?\s*\)\s*""")
_LIGHTING = {"feDiffuseLighting", "feSpecularLighting"}
_PALE, _GONE = 0.3, 0.05
"""How opaque a shape that is a shadow is at most, and where it ends."""
_DARK = 80
"""Greatest channel of its colour."""
_MERGING = ("feMergeNode", "feBlend", "feComposite")


def leave_out(drawn: Collection[ET.Element]) -> list[str]:
    """Take shadows and light off the elements that are drawn, in place; return what to say."""
    filters = [one for one in drawn if one.tag == "filter"]
    lights = {one.get("id", "") for one in filters if any(part.tag in _LIGHTING for part in one)}
    shadows = {one.get("id", "") for one in filters if _is_shadow(one)} - lights
    cast = _cast(drawn)
    for shape in cast:
        shape.set("display", "none")
    found = [[LEFT_OUT] if cast else []] + [
        _without(element, _REFERENCE, lights, UNLIT)
        + _without(element, _REFERENCE, shadows, LEFT_OUT)
        + _without(element, _DROP_SHADOW, {""}, LEFT_OUT)
        for element in drawn
    ]
    return sorted({one for said in found for one in said})


def _cast(drawn: Collection[ET.Element]) -> list[ET.Element]:
    """Return the shapes that are shadows, unless there is nothing else."""
    fading = {one.get("id", "") for one in drawn if one.tag in GRADIENTS and _is_fading(one)}
    shapes = [one for one in drawn if one.tag in SHAPES]
    cast = [
        one
        for one in shapes
        if (match := _REFERENCE.match(one.get("fill", ""))) and match[1] in fading
        if one.get("stroke", "none") == "none"
    ]
    return cast if len(cast) < len(shapes) else []


def _is_fading(gradient: ET.Element) -> bool:
    """Whether a gradient is that of a shadow."""
    opacities = []
    for stop in gradient.iter("stop"):
        said = colour(stop.get("stop-color", "#000000")) or ""
        values = list(bytes.fromhex(said[1:])) if said[:1] == "#" else numbers(said[5:-1])
        alpha = values[3] if len(values) > 3 else 1.0
        opacities.append(alpha * (*numbers(stop.get("stop-opacity", "1")), 1.0)[0])
        if not 0 <= max(values[:3], default=255) <= _DARK:
            return False
    return bool(opacities) and max(opacities) <= _PALE and min(opacities) <= _GONE


def _without(
    element: ET.Element, effect: re.Pattern[str], names: Collection[str], sentence: str
) -> list[str]:
    """Take the effects of these names off an element; return a sentence if there were any."""
    said = element.get("filter", "")
    left = effect.sub(lambda match: "" if match[1] in names else match[0], said)
    if left == said:
        return []
    element.attrib.pop("filter")
    if left.strip():
        element.set("filter", left.strip())
    return [sentence]


def _is_shadow(described: ET.Element) -> bool:
    """Whether a filter draws something blurred or moved and, over it, the shape as it is."""
    tags = {one.tag for one in described}
    if tags == {"feDropShadow"}:
        return True
    if any(_sharpens(one) for one in described.iter("feColorMatrix")):
        return False
    inputs = {one.get("in") for one in described.iter()}
    merged = any(
        "SourceGraphic" in (one.get("in"), one.get("in2"))
        for one in described.iter()
        if one.tag in _MERGING
    )
    from_alpha = "SourceAlpha" in inputs and "feOffset" in tags
    return merged and (from_alpha or bool(tags & {"feGaussianBlur", "feDropShadow"}))


def _sharpens(effect: ET.Element) -> bool:
    """Whether an effect makes what is blurred sharp again, as where drops run into each other."""
    values = numbers(effect.get("values", ""))
    return len(values) == 20 and values[18] > 1
