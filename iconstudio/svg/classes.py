"""Classes that paint by rules which the file does not hold, as those of Tailwind do.

Most classes of icons say nothing of paint (“lucide lucide-home”), and many that do repeat what
attributes say. Only what nothing else says, and what would show in black, is told.
"""

import re
import xml.etree.ElementTree as ET
from collections.abc import Collection, Iterator, Mapping

from iconstudio.svg.geometry import SHAPES
from iconstudio.svg.lettering import TEXTS

WITHOUT_RULES = (
    "Classes such as “{}” have no rules in the file: colours, widths of lines and opacities may be "
    "wrong. Save the drawing with its styles embedded."
)

_COLOUR = r"current|black|white|none|transparent|[a-z]+-\d{2,3}(?:/\d+)?|\[#[^\]]*\]"
_THEME = r"primary|secondary|accent|muted|foreground|background"
_PAINTS = {
    "fill": re.compile(rf"fill-(?:{_COLOUR}|{_THEME})"),
    "stroke": re.compile(rf"stroke-(?:{_COLOUR}|{_THEME})"),
    "stroke-width": re.compile(r"stroke-(?:\d+(?:\.\d+)?|\[[\d.]+(?:px)?\])"),
    "opacity": re.compile(r"opacity-\d{1,2}"),
    "any": re.compile(r"(?:st|cls-|fil|str)\d+"),
}
"""Of Tailwind, by properties; and of Illustrator and CorelDRAW, which name any."""
_USUAL = ("fill-current", "fill-black")
"""What fills as no class at all does."""
_NONE = ("none", "transparent")
_RULE = re.compile(r"\.((?:[\w-]|\\.)+)")

Classes = Mapping[ET.Element, Mapping[str, str]]


def painting(root: ET.Element) -> Classes:
    """Return for each element its classes that paint and have no rules, by what they would say."""
    styles = " ".join("".join(one.itertext()) for one in root.iter("style"))
    ruled = {name.replace("\\", "") for name in _RULE.findall(styles)}
    found: dict[ET.Element, dict[str, str]] = {}
    for element in root.iter():
        for name in set(element.get("class", "").split()) - ruled:
            for kind, pattern in _PAINTS.items():
                if pattern.fullmatch(name):
                    found.setdefault(element, {})[kind] = name
    return found


def missed(root: ET.Element, kept: Collection[ET.Element], classes: Classes) -> list[str]:
    """Return what to say of classes without rules once all other styles are attributes."""
    if not classes:
        return []
    shapes = list(_shapes(root, {}, kept, classes))
    name = next(filter(None, map(_amiss, shapes)), None) or _unlike(shapes)
    return [WITHOUT_RULES.format(name)] if name else []


def _shapes(
    element: ET.Element, outer: Mapping[str, str], kept: Collection[ET.Element], classes: Classes
) -> Iterator[Mapping[str, str]]:
    """Yield what is said of each shape by property; a dot stands before what a class says."""
    said = dict(outer)
    own = classes.get(element, {})
    for kind in _PAINTS:
        value = element.get(kind, "inherit")
        if value != "inherit":
            said[kind] = value
        elif kind in own:
            said[kind] = f".{own[kind]}"
    if element.tag in (*SHAPES, *TEXTS) and element in kept:
        yield said
    for child in element:
        yield from _shapes(child, said, kept, classes)


def _amiss(said: Mapping[str, str]) -> str | None:
    """Return the class that a shape lacks; None if it is drawn as it should be, in black."""
    fill, stroke = said.get("fill", ""), said.get("stroke", "none")
    if "any" in said and not fill and stroke == "none":
        return said["any"][1:]
    if fill.startswith(".") and fill.endswith(_NONE):
        return fill[1:]
    if stroke.startswith(".") and not stroke.endswith(_NONE):
        return stroke[1:]
    width, opacity = said.get("stroke-width", ""), said.get("opacity", "")
    if stroke != "none" and width.startswith("."):
        return width[1:]
    return opacity[1:] if opacity.startswith(".") else None


def _unlike(shapes: Collection[Mapping[str, str]]) -> str | None:
    """Return a class that fills a shape otherwise than another is filled."""
    fills = {said.get("fill", "") for said in shapes}
    fills = {"" if one[1:] in _USUAL else one for one in fills if one != "none"}
    names = sorted(one[1:] for one in fills if one.startswith("."))
    return names[0] if names and len(fills) > 1 else None
