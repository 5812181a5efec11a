"""Shadows and glows: filters that draw a blur behind a shape, which is no part of an icon."""

import re
import xml.etree.ElementTree as ET
from collections.abc import Collection

from iconstudio.svg.lengths import numbers

LEFT_OUT = "A shadow was left out."

_DROP_SHADOW = re.compile(r"drop-shadow\((?:[^()]|\([^()]*\))*\)")
_REFERENCE = re.compile(r"""\s*url\(\s*["']?#(.*?)["']?\s*\)\s*""")
_MERGING = ("feMergeNode", "feBlend", "feComposite")


def leave_out(drawn: Collection[ET.Element]) -> list[str]:
    """Take the shadows off the elements that are drawn, in place; return what to say of it."""
    shadows = {one.get("id") for one in drawn if one.tag == "filter" and _is_shadow(one)}
    found = False
    for element in drawn:
        said = element.get("filter")
        if said is None:
            continue
        left = _REFERENCE.sub(lambda match: "" if match[1] in shadows else match[0], said)
        left = _DROP_SHADOW.sub("", left).strip()
        if left == said.strip():
            continue
        found = True
        element.attrib.pop("filter")
        if left:
            element.set("filter", left)
    return [LEFT_OUT] if found else []


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
