"""Sprite sheets: files of several symbols, of which one is shown by its name.

A font (SVG 1.1, section 20) is one, too: of its glyphs.
"""

import xml.etree.ElementTree as ET

from iconstudio.model import IconstudioError, SpriteError
from iconstudio.svg.geometry import SHAPES
from iconstudio.svg.lengths import numbers

_MOST_NAMED = 6
_OF_FRAMES = (
    "viewBox", "preserveAspectRatio", "width", "height", "x", "y", "refX", "refY", "id", "overflow",
)  # fmt: skip
_DRAWN = ("g", "svg", *SHAPES)
_HIDDEN = ("display", "visibility", "opacity")


def turn_glyphs_into_symbols(root: ET.Element) -> None:
    """Make a symbol of every glyph of a font, in place; y is up in fonts."""
    for font in list(root.iter("font")):
        face = font.find("font-face")
        em = _number(face, "units-per-em", 1000.0)
        ascent = _number(face, "ascent", 0.8 * em)
        for number, glyph in enumerate(font.iter("glyph")):
            if not glyph.get("d", "").strip():
                continue
            across = _number(glyph, "horiz-adv-x", _number(font, "horiz-adv-x", em)) or em
            name = glyph.get("glyph-name") or _character(glyph) or f"glyph-{number}"
            symbol = ET.SubElement(root, "symbol", id=name, viewBox=f"0 0 {across:g} {em:g}")
            symbol.set("overflow", "visible")
            flipped = f"matrix(1 0 0 -1 0 {ascent:g})"
            ET.SubElement(symbol, "path", d=glyph.attrib["d"], transform=flipped)


def _character(glyph: ET.Element) -> str:
    """Return the character of a glyph, or its number if it is none that can be typed."""
    text = glyph.get("unicode", "")
    if len(text) == 1 and not text.isalnum():
        return f"{ord(text):x}"
    return text


def _number(element: ET.Element | None, name: str, default: float) -> float:
    found = [] if element is None else numbers(element.get(name, ""))
    return found[0] if found else default


def symbols(root: ET.Element) -> dict[str, ET.Element]:
    """Return by their names what a document defines and does not show: symbols, or hidden parts."""
    found: dict[str, ET.Element] = {}
    for number, one in enumerate(root.iter("symbol"), start=1):
        one.set("id", one.get("id") or f"symbol-{number}")
        found.setdefault(one.attrib["id"], one)
    if not found:
        hidden = [one for one in root if one.get("display") == "none"]
        defined = [one for defs in root.iter("defs") for one in defs if one.tag in _DRAWN]
        found = {one.attrib["id"]: one for one in hidden or defined if one.get("id")}
    return found


def choose(root: ET.Element, name: str) -> None:
    """Let a document show but the element of a name, in place.

    Raises
    ------
    IconstudioError
        If there is none.
    """
    found = next((one for one in root.iter() if one.get("id") == name), None)
    if found is None:
        known = list(symbols(root))
        there = f"There are {_listed(known)}." if known else "It has no symbols."
        raise IconstudioError(f"Nothing in it is called “{name[:60]}”. {there}")
    show(root, found)


def show(root: ET.Element, chosen: ET.Element) -> None:
    """Let a document show but one element, in place; the others are there for references."""
    for one in _HIDDEN:
        root.attrib.pop(one, None)
        chosen.attrib.pop(one, None)
    if chosen.tag == "view":
        root.set("viewBox", chosen.get("viewBox", root.get("viewBox", "")))
        return
    if chosen is root:
        return
    parents = {child: element for element in root.iter() for child in element}
    defs = ET.Element("defs")
    if parents[chosen].tag == "defs":
        parents[chosen].remove(chosen)
        root.append(chosen)
        parents[chosen] = root
    if chosen.tag == "symbol":
        parents[chosen].remove(chosen)
        defs.extend(list(root))
        root[:] = [defs, chosen]
        for name in _OF_FRAMES:
            root.attrib.pop(name, None)
            if name in chosen.attrib:
                root.set(name, chosen.attrib.pop(name))
        chosen.tag = "g"
        return
    inner = chosen
    while inner is not root:
        outer = parents[inner]
        outer.attrib.pop("display", None)
        defs.extend([child for child in outer if child is not inner])
        outer[:] = [inner]
        inner = outer
    root.insert(0, defs)


def several(names: list[str]) -> SpriteError:
    """Return the error that says that one of several symbols is to be chosen."""
    return SpriteError(
        f"It is a sprite sheet of {len(names)} symbols ({_listed(names)}) "
        "and shows none by itself.",
        tuple(names),
    )


def _listed(names: list[str]) -> str:
    return ", ".join(names[:_MOST_NAMED]) + (", …" if len(names) > _MOST_NAMED else "")
