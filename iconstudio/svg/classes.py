"""Classes that paint by rules which the file does not hold, as those of Tailwind do.

The plainest are read: no paint, black, white, the current colour, one of Tailwind's palette or one
that is written out, widths and opacities. All that the document says itself is stronger. Colours of
themes are not known: what is of such a colour is drawn, and told.

Most classes of icons say nothing of paint (“lucide lucide-home”), and many that do repeat what
attributes say. Only what nothing else says, and what would show in black, is told.
"""

import re
import xml.etree.ElementTree as ET
from collections.abc import Collection, Iterator, Mapping

from iconstudio.svg.geometry import SHAPES
from iconstudio.svg.lettering import TEXTS
from iconstudio.svg.tailwind import PALETTE, colour

WITHOUT_RULES = (
    "Classes such as “{}” have no rules in the file: colours, widths of lines and opacities may be "
    "wrong. Save the drawing with its styles embedded."
)

_NAMED = {
    "current": "currentColor", "black": "#000000", "white": "#ffffff", "none": "none",
    "transparent": "none",
}  # fmt: skip
_PAINT = rf"({'|'.join(_NAMED)}|\[#[^\]]*\]|{PALETTE})"
_READ = {
    "fill": re.compile(rf"fill-{_PAINT}"),
    "stroke": re.compile(rf"stroke-{_PAINT}"),
    "color": re.compile(rf"text-(black|white|\[#[^\]]*\]|{PALETTE})"),
    "stroke-width": re.compile(r"stroke-(\d+(?:\.\d+)?|\[[\d.]+(?:px)?\])"),
    "opacity": re.compile(r"opacity-(\d{1,2})"),
}
"""Classes of Tailwind that are read, by properties, and what they say."""
_UNKNOWN = r"(?:[a-z]+-\d{2,3}(?:/\d+)?|primary|secondary|accent|muted|foreground|background)"
_UNREAD = {
    "fill": re.compile(f"fill-(?!{PALETTE}){_UNKNOWN}"),
    "stroke": re.compile(f"stroke-(?!{PALETTE}){_UNKNOWN}"),
    "any": re.compile(r"(?:st|cls-|fil|str)\d+"),
}
"""Of Tailwind, by properties; and of Illustrator and CorelDRAW, which name any."""
_SOME = "currentColor"
"""In place of a colour that is not known."""
_OF_PALETTE = re.compile(PALETTE)
_RULE = re.compile(r"\.((?:[\w-]|\\.)+)")

Classes = Mapping[ET.Element, Mapping[str, str]]


def read(root: ET.Element) -> Classes:
    """Give elements the attributes that their classes without rules stand for, in place.

    Returns
    -------
    For each element its classes that paint in a way that is not known, by what they would say.
    """
    styles = " ".join("".join(one.itertext()) for one in root.iter("style"))
    ruled = {name.replace("\\", "") for name in _RULE.findall(styles)}
    unread: dict[ET.Element, dict[str, str]] = {}
    for element in root.iter():
        own = dict(element.attrib)
        for name in sorted(set(own.get("class", "").split()) - ruled):
            for kind, pattern in _READ.items():
                if kind not in own and (match := pattern.fullmatch(name)):
                    element.set(kind, _value(kind, match[1]))
            for kind, pattern in _UNREAD.items():
                if kind not in own and pattern.fullmatch(name):
                    unread.setdefault(element, {})[kind] = name
                    if kind != "any":
                        element.set(kind, _SOME)
    return unread


def _value(kind: str, said: str) -> str:
    """Return the value of an attribute that a class stands for."""
    said = said.strip("[]")
    if kind == "opacity":
        return str(int(said) / 100)
    return colour(said) if _OF_PALETTE.fullmatch(said) else _NAMED.get(said, said)


def missed(root: ET.Element, kept: Collection[ET.Element], classes: Classes) -> list[str]:
    """Return what to say of classes that were not read once all other styles are attributes."""
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
    for kind in _UNREAD:
        value = element.get(kind, "inherit")
        if kind in own and value in ("inherit", _SOME):
            said[kind] = f".{own[kind]}"
        elif value != "inherit":
            said[kind] = value
    if element.tag in (*SHAPES, *TEXTS) and element in kept:
        yield said
    for child in element:
        yield from _shapes(child, said, kept, classes)


def _amiss(said: Mapping[str, str]) -> str | None:
    """Return the class that a shape lacks; None if it is drawn as it should be, in black."""
    fill, stroke = said.get("fill", ""), said.get("stroke", "none")
    if "any" in said and not fill and stroke == "none":
        return said["any"][1:]
    return stroke[1:] if stroke.startswith(".") else None


def _unlike(shapes: Collection[Mapping[str, str]]) -> str | None:
    """Return a class that fills a shape otherwise than another is filled."""
    fills = {said.get("fill", "") for said in shapes} - {"none"}
    names = sorted(one[1:] for one in fills if one.startswith("."))
    return names[0] if names and len(fills) > 1 else None
