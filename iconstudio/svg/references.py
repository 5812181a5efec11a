"""What the elements of a document refer to, and which of them are drawn at all.

Browsers take the first element of an id, renderers the last; an id may name a shape and a gradient.
Here every reference goes to the first element of a kind that it can mean, by an id of its own.
"""

import re
import xml.etree.ElementTree as ET
from collections.abc import Callable, Container, Iterator, Mapping
from urllib.parse import unquote

from iconstudio.svg.geometry import DEFINITIONS, SHAPES

GRADIENTS = ("linearGradient", "radialGradient")
_KINDS: Mapping[str, tuple[str, ...]] = {
    "fill": (*GRADIENTS, "pattern"),
    "stroke": (*GRADIENTS, "pattern"),
    "clip-path": ("clipPath",),
    "mask": ("mask",),
    "filter": ("filter",),
    "marker-start": ("marker",),
    "marker-mid": ("marker",),
    "marker-end": ("marker",),
}
"""Which elements each attribute may name."""
_TARGETS: Mapping[str, tuple[str, ...]] = {
    "use": (*SHAPES, "g", "a", "svg", "symbol", "use", "text", "switch", "image"),
    "linearGradient": GRADIENTS,
    "radialGradient": GRADIENTS,
    "pattern": ("pattern",),
    "filter": ("filter",),
    "textPath": ("path",),
}
"""Which elements the ``href`` of each may name."""
_UNREAD = {
    "meshgradient": "A mesh gradient",
    "meshGradient": "A mesh gradient",
    "hatch": "A hatching",
}
_IN_PLACE = "#808080"
_URL = re.compile(r"url\(\s*[\"']?([^)\"']*)[\"']?\s*\)\s*(.*)", re.DOTALL)
_EACH_URL = re.compile(r"url\(\s*[\"']?([^)\"']*)[\"']?\s*\)")
_OWN_URL = re.compile(r"url\(#([^)]*)\)")

CIRCLE = "A reference that leads back to where it is was left out."

Ids = Mapping[str, list[ET.Element]]


def unquote_targets(root: ET.Element) -> None:
    """Let every ``href`` within a document name an id as it is written there, in place."""
    ids = {one.attrib["id"] for one in root.iter() if "id" in one.attrib}
    for element in root.iter():
        address = element.get("href", "").strip()
        if address.startswith("#"):
            element.set("href", f"#{_id_in(address, ids)}")


def _id_in(address: str, ids: Container[str]) -> str:
    """Return the id that ``#id`` names, as browsers do: as it is written, or else unquoted."""
    written = address[1:]
    return written if written in ids else unquote(written)


def resolve(
    root: ET.Element,
) -> tuple[dict[str, ET.Element], list[str], list[tuple[ET.Element, str]]]:
    """Give every element that is referred to an id of its own, and take out other references.

    Returns
    -------
    The elements by their new ids, sentences about what lies outside the document, and about what is
    nowhere, each with the element that refers to it.
    """
    ids: dict[str, list[ET.Element]] = {}
    for element in root.iter():
        if "id" in element.attrib:
            ids.setdefault(element.attrib.pop("id"), []).append(element)
    named: dict[ET.Element, str] = {}
    remarks: list[str] = []

    def name_of(address: str, kinds: tuple[str, ...]) -> str | None:
        if not address.startswith("#"):
            if address:
                remarks.append(
                    f"It refers to “{address[:60]}” outside of itself, which was left out."
                )
            return None
        found = next((one for one in ids.get(_id_in(address, ids), ()) if one.tag in kinds), None)
        return None if found is None else named.setdefault(found, f"r{len(named)}")

    missing = [(one, sentence) for one in root.iter() for sentence in _unread(one, ids)]
    missing += [(one, sentence) for one in root.iter() for sentence in _missing(one, ids)]
    for element in root.iter():
        _resolve(element, name_of)
    for element, name in named.items():
        element.set("id", name)
    return {name: element for element, name in named.items()}, remarks, missing


def _unread(element: ET.Element, ids: Ids) -> Iterator[str]:
    """Let a plain colour stand for paints of Inkscape's; yield what to say of each."""
    for attribute in ("fill", "stroke"):
        match = _URL.match(element.get(attribute, ""))
        named = ids.get(_id_in(match[1].strip(), ids), ()) if match else ()
        paint = next((_UNREAD[one.tag] for one in named if one.tag in _UNREAD), None)
        if paint is not None:
            element.set(attribute, _IN_PLACE)
            yield f"{paint} was not read; what it paints was drawn in one colour."


def _missing(element: ET.Element, ids: Ids) -> Iterator[str]:
    """Yield what to say of what an element shows, or is filled with, that is nowhere."""
    shown = [element.get("href", "").strip()] if element.tag == "use" else []
    for attribute in ("fill", "stroke"):
        match = _URL.match(element.get(attribute, ""))
        if match is not None and not match[2].strip():
            shown.append(match[1].strip())
    for address in shown:
        if address.startswith("#") and _id_in(address, ids) not in ids:
            yield (
                f"“#{_id_in(address, ids)[:60]}” is not in the file, so what refers to it was left "
                "out. Save the whole drawing in one file."
            )


def _resolve(element: ET.Element, name_of: Callable[[str, tuple[str, ...]], str | None]) -> None:
    if "href" in element.attrib:
        kinds = _TARGETS.get(element.tag)
        name = name_of(element.attrib["href"].strip(), kinds) if kinds else None
        if name is not None:
            element.set("href", f"#{name}")
        elif element.tag not in ("image", "feImage"):
            del element.attrib["href"]
    for attribute, kinds in _KINDS.items():
        if attribute == "filter" and attribute in element.attrib:
            _resolve_filters(element, name_of)
            continue
        match = _URL.match(element.get(attribute, ""))
        if match is None:
            continue
        name = name_of(match[1].strip(), kinds)
        fallback = match[2].strip() if attribute in ("fill", "stroke") else ""
        if name is not None:
            element.set(attribute, f"url(#{name}) {fallback}".strip())
        elif attribute in ("fill", "stroke"):
            element.set(attribute, fallback or "none")
        else:
            del element.attrib[attribute]


def _resolve_filters(
    element: ET.Element, name_of: Callable[[str, tuple[str, ...]], str | None]
) -> None:
    """Give each reference of a list of filters its new id; those that lead nowhere are gone."""

    def resolved(match: re.Match[str]) -> str:
        name = name_of(match[1].strip(), _KINDS["filter"])
        return "" if name is None else f"url(#{name})"

    left = " ".join(_EACH_URL.sub(resolved, element.attrib.pop("filter")).split())
    if left:
        element.set("filter", left)


def without_circles(root: ET.Element, ids: Mapping[str, ET.Element]) -> list[str]:
    """Take out every reference that leads back to where it is, in place; return what to say of it.

    Browsers draw nothing in its place.
    """
    remarks: list[str] = []
    open_: dict[ET.Element, bool] = {root: True}
    """Elements that were come to, and whether they are still being gone through."""
    way = [(root, _next(root, ids))]
    while way:
        element, following = way[-1]
        attribute, target = next(following, ("", None))
        if target is None:
            open_[element] = False
            way.pop()
        elif target not in open_:
            open_[target] = True
            way.append((target, _next(target, ids)))
        elif open_[target] and attribute in ("fill", "stroke"):
            element.set(attribute, "none")
            remarks.append(CIRCLE)
        elif open_[target]:
            element.attrib.pop(attribute, None)
            remarks.append(CIRCLE)
    return remarks


def _next(
    element: ET.Element, ids: Mapping[str, ET.Element]
) -> Iterator[tuple[str, ET.Element | None]]:
    """Yield what is in an element, and what each attribute of it refers to."""
    for child in list(element):
        yield "", child
    for attribute in ("href", *_KINDS):
        value = element.get(attribute, "")
        names = [value[1:]] if attribute == "href" else _OWN_URL.findall(value)
        for target in (ids[name] for name in names if name in ids):
            yield attribute, target


def referred(element: ET.Element) -> Iterator[str]:
    """Yield the new ids to which an element refers where it shows."""
    if element.get("href", "").startswith("#"):
        yield element.attrib["href"][1:]
    for attribute in _KINDS:
        value = element.get(attribute, "")
        if "url(#" in value and element.get(f"{attribute}-opacity") != "0":
            yield from _OWN_URL.findall(value)


def drawn(root: ET.Element, ids: Mapping[str, ET.Element]) -> set[ET.Element]:
    """Return the elements that take part in what is seen."""
    found: set[ET.Element] = set()
    waiting = [(root, True)]
    while waiting:
        element, visible = waiting.pop()
        if element.get("display") == "none" or element.get("opacity") == "0":
            continue
        visible = element.get("visibility", "visible" if visible else "hidden") == "visible"
        if element in found:
            continue
        if visible or element.tag not in ("text", "image", "foreignObject"):
            found.add(element)
        for name in referred(element):
            target = ids.get(name)
            if target is not None:
                waiting.append((target, visible))
        children = _children(element)
        waiting += [(child, visible) for child in reversed(children)]
    return found


def _children(element: ET.Element) -> list[ET.Element]:
    """Return the children that are drawn, or used, with an element."""
    if element.tag == "defs":
        return []
    if element.tag == "switch":
        return [child for child in element if _eligible(child)][:1]
    return [child for child in element if child.tag not in DEFINITIONS and _is_english(child)]


def _is_english(child: ET.Element) -> bool:
    """Whether an element is for readers of English, as we are, or for all."""
    languages = child.get("systemLanguage")
    return languages is None or any(
        one.strip().lower().startswith("en") for one in languages.split(",")
    )


def _eligible(child: ET.Element) -> bool:
    """Whether a ``switch`` may take this child."""
    return (
        _is_english(child) and not child.get("requiredExtensions") and child.tag != "foreignObject"
    )


def prune(root: ET.Element, kept: set[ET.Element]) -> None:
    """Remove what is not ``kept`` and holds nothing that is."""
    for element in list(root):
        prune(element, kept)
        if element in kept:
            element.attrib.pop("systemLanguage", None)  # the renderer knows no language
        if element not in kept and not len(element):
            root.remove(element)
        elif element not in kept and element.tag not in DEFINITIONS:
            element.set("display", "none")  # it only holds what others show
