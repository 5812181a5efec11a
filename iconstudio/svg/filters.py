"""Filters that are lists of functions and references (Filter Effects, 5); those that distort."""

import re
import xml.etree.ElementTree as ET
from collections.abc import Collection

from iconstudio.svg.lengths import length

UNDISTORTED = "A filter that distorts shapes (feDisplacementMap) was left out."

_OCTAVES = 16
"""The amplitude of each is half of that before it: what more would add is not seen."""

_NUMBER = r"\+?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?"
_SIGNED = rf"-?{_NUMBER}"
_FUNCTION = re.compile(
    rf"""\s*+(?:
    (?P<url>url\(\s*(?P<quote>["']?)\#(?P<id>[^"')]*?)(?P=quote)\s*\))
    | (?:brightness|contrast|grayscale|invert|opacity|saturate|sepia)\(\s*(?:{_NUMBER}%?)?\s*\)
    | hue-rotate\(\s*(?:{_SIGNED}(?:deg|grad|rad|turn)|[+-]?0)?\s*\)
    | blur\(\s*(?:{_NUMBER}(?:px|em)?)?\s*\)
    | drop-shadow\((?:[^()]|\([^()]*\))*\)
    )""",
    re.IGNORECASE | re.VERBOSE,
)


def written(value: str) -> str | None:
    """Return a list of filters as renderers read it; None if one of them is not understood."""
    found, place = [], 0
    value = value.strip()
    while place < len(value):
        match = _FUNCTION.match(value, place)
        if match is None:
            return None
        found.append(f"url(#{match['id']})" if match["url"] else match[0].strip().lower())
        place = match.end()
    return " ".join(found) or None


def bound_octaves(drawn: Collection[ET.Element]) -> None:
    """Let no noise have octaves that add nothing to be seen: each takes as long."""
    for one in drawn:
        if one.tag == "feTurbulence" and length(one.get("numOctaves"), 1.0) > _OCTAVES:
            one.set("numOctaves", str(_OCTAVES))


def leave_out_distortions(drawn: Collection[ET.Element]) -> list[str]:
    """Let no filter move pixels about, in place, as renderers differ in how far; say so."""
    found = [
        one for one in drawn if one.tag == "feDisplacementMap" and one.get("scale", "0") != "0"
    ]
    for one in found:
        one.set("scale", "0")
    return [UNDISTORTED] if found else []
