"""Filters that are no part of an icon: shadows and glows, a blur behind a shape, and bevels.

What a bevel is on is drawn as it would be without light.
"""

import re
import xml.etree.ElementTree as ET
from collections.abc import Collection

from iconstudio.svg.lengths import numbers

LEFT_OUT = "A shadow was left out."
UNLIT = "Light on a surface, as on a bevel, was left out."

_DROP_SHADOW = re.compile(r"()drop-shadow\((?:[^()]|\([^()]*\))*\)")
_REFERENCE = re.compile(r"""\s*url\(\s*["']?#(.*?)["']?\s*\)\s*""")
_LIGHTING = {"feDiffuseLighting", "feSpecularLighting"}
_MERGING = ("feMergeNode", "feBlend", "feComposite")


def leave_out(drawn: Collection[ET.Element]) -> list[str]:
    """Take shadows and light off the elements that are drawn, in place; return what to say."""
    filters = [one for one in drawn if one.tag == "filter"]
    lights = {one.get("id", "") for one in filters if any(part.tag in _LIGHTING for part in one)}
    shadows = {one.get("id", "") for one in filters if _is_shadow(one)} - lights
    found = [
        _without(element, _REFERENCE, lights, UNLIT)
        + _without(element, _REFERENCE, shadows, LEFT_OUT)
        + _without(element, _DROP_SHADOW, {""}, LEFT_OUT)
        for element in drawn
    ]
    return sorted({one for said in found for one in said})


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
