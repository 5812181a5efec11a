"""Icons as data: what the packages of icon sets hold in JSON, JavaScript and TypeScript.

Path data as constants (Material Design Icons), bodies of elements (Iconify), Font Awesome's lists,
nodes of elements (Lucide, Tabler, Ant Design, react-icons), and path data alone, as it is copied.
"""

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from typing import Any
from xml.sax.saxutils import quoteattr

from iconstudio.svg.bounds import union
from iconstudio.svg.created import Created, elements, tag_created
from iconstudio.svg.geometry import SHAPES, data_bounds, path_data
from iconstudio.svg.javascript import Names
from iconstudio.svg.methods import said
from iconstudio.svg.names import attribute_name
from iconstudio.svg.syntax import Node, UnknownError, below, name_of, parsed, text_of

_PATH = re.compile(
    r"\s*[Mm]\s*[-+.\d][\d\s,.eE+\-MmLlHhVvCcSsQqTtAaZz]*[HhVvLlCcSsQqTtAaZz][\d\s,.eE+-]*"
)
_BODY = re.compile(
    r"\s*(?:<(?:path|rect|circle|ellipse|line|poly\w+|g)\b[^<>]*>\s*(?:</\w+>\s*)*)+", re.DOTALL
)
"""The shapes of an icon without its root, as Feather has them."""
_PLAUSIBLE = re.compile(
    r"[\"'`]\s*[Mm]\s*[-+.\d]|[\"'`]<?(?:path|circle|rect|line|body|poly\w+)\b|[\"'`]<g\b"
)
_VALID = re.compile(r"[A-Za-z_][\w.:-]*")
_NAMED = ("variable_declarator", "pair", "function_declaration", "public_field_definition")
_TAGS = ("g", *SHAPES)
_SIDE = 24.0
"""The side of a page of which nothing is said, if the drawing lies in it."""
_PAGE = (0.0, 0.0, _SIDE, _SIDE)
_BY_DEFAULT = 16.0
"""The side of Iconify's pages of which nothing is said."""
_LINES = {
    "fill": "none", "stroke": "currentColor", "stroke-width": "2", "stroke-linecap": "round",
    "stroke-linejoin": "round",
}  # fmt: skip
"""How sets of lines are drawn whose nodes say nothing of it."""
_LINED = "lined"
"""Whether some bodies hold lines by themselves, which only strokes show."""
_OF_PAGES = ("viewBox", "width", "height")

Icon = tuple[dict[str, str], str]
"""The attributes of a root, and the markup in it."""


def markup(text: str) -> str | None:
    """Return the icon that a text holds as data, or a sprite sheet of several; None if none."""
    if _PATH.fullmatch(text):
        return _document(*_path(text))
    if "<svg" in text or not _is_plausible(text):
        return None
    found: dict[str, Icon] = {}
    for name, icon in _icons(text):
        unique = name if name not in found else f"{name}-{len(found) + 1}"
        found[unique] = icon
    if len(found) < 2:
        return next((_document(*icon) for icon in found.values()), None)
    return f"<svg>{''.join(_symbol(name, *icon) for name, icon in found.items())}</svg>"


def _is_plausible(text: str) -> bool:
    return _PLAUSIBLE.search(text) is not None


def _document(attributes: dict[str, str], body: str) -> str:
    return f"<svg{_written(attributes)}>{body}</svg>"


def _symbol(name: str, attributes: dict[str, str], body: str) -> str:
    page = {key: value for key, value in attributes.items() if key in _OF_PAGES}
    others = {key: value for key, value in attributes.items() if key not in _OF_PAGES}
    return f"<symbol{_written({'id': name} | page)}><g{_written(others)}>{body}</g></symbol>"


def _written(attributes: dict[str, str]) -> str:
    return "".join(f" {name}={quoteattr(value)}" for name, value in attributes.items())


def _icons(text: str) -> Iterator[tuple[str, Icon]]:
    """Yield the names and drawings of all icons, in their order."""
    names = Names.of(text)
    open_: list[tuple[Node, str, dict[str, float]]] = [(parsed(f"({text}\n)"), "icon", {})]
    if text[:1] not in "{[":
        open_ = [(parsed(text), "icon", {})]
    if re.search("<(?:poly)?line ", text):
        open_[0][2][_LINED] = 1.0
    rooted = any(tag_created(one) == "svg" for one in below(open_[0][0]))
    while open_:
        node, name, page = open_.pop()
        if node.type.startswith("jsx"):
            continue  # a part of a drawing
        if _creates(node):
            icon = _read(node, names, page)
            if icon is not None and (tag_created(node) == "svg" or not rooted):
                yield name, icon
            continue
        if node.type in _NAMED:
            own = name_of(node)
            name = own if own not in ("icon", "default", "icons", "d", "path") else name
        if node.type == "array" and [one.type for one in node.named_children[:1]] == ["string"]:
            name = text_of(node.named_children[0]).strip("\"'")  # of Phosphor's maps
        if node.type in ("object", "array", "string", "template_string"):
            icon = _read(node, names, page)
            if icon is not None:
                yield name, icon
                continue
        if node.type == "object":
            name, page = _about(node, name, page)
        open_ += [(child, name, page) for child in reversed(node.named_children)]


def _creates(node: Node) -> bool:
    """Whether compiled code creates elements there: ``jsx("path", {d: "..."})``, or a list."""
    if node.type == "array" and node.named_children:
        return all(tag_created(one) is not None for one in node.named_children)
    return tag_created(node) is not None


def _about(node: Node, name: str, page: dict[str, float]) -> tuple[str, dict[str, float]]:
    """Return what an object says of the icons in it: how they are called, and their page."""
    page = dict(page)
    for pair in node.named_children:
        value = pair.child_by_field_name("value")
        match name_of(pair), value.type if value else "":
            case "width" | "height" as side, "number":
                page[side] = float(text_of(value))
            case "iconName" | "slug", "string":
                name = text_of(value).strip("\"'")
    return name, page


def _read(node: Node, names: Names, page: dict[str, float]) -> Icon | None:
    """Return the icon that a value is; None if it is none."""
    if node.type == "object" and not {"body", "tag", "path", "d"} & set(
        map(name_of, node.named_children)
    ):
        return None
    try:
        return _icon(names.at(node), page)
    except (UnknownError, ET.ParseError, LookupError, TypeError, ValueError):
        return None


def _icon(value: Any, page: dict[str, float]) -> Icon | None:
    parts = value if isinstance(value, list) else [value]
    drawn = elements(value) if all(isinstance(one, Created) for one in parts) else []
    if drawn and drawn[0].tag != "svg":
        body = "".join(map(_element, drawn))
        return _page_around(body), body
    match value:
        case str() if _BODY.fullmatch(value):
            lines = _LINES if page.get(_LINED) and "fill" not in value else {}
            return _page_around(value) | lines, value
        case str() if _PATH.fullmatch(value):
            return _path(value)
        case {"body": str(body)}:
            return _page(page | _numbers(value)), body
        case {"tag": "svg"} | ["svg", dict(), *_]:
            return _attributes(value), _below(value)
        case {"path": str(data)} | {"d": str(data)} if _PATH.fullmatch(data):
            attributes, body = _path(data)
            given = _attributes({"attrs": value})
            return {name: given[name] for name in ("viewBox",) if name in given} or attributes, body
        case [int() | float() as width, int() | float() as height, list(), str(), drawn]:
            paths = drawn if isinstance(drawn, list) else [drawn]
            body = "".join(f"<path d={quoteattr(one)}/>" for one in paths)
            return {"viewBox": f"0 0 {said(width)} {said(height)}"}, body
        case [[str(tag), dict(), *_], *_] if tag in _TAGS:
            return {"viewBox": f"0 0 {_SIDE:g} {_SIDE:g}"} | _LINES, "".join(map(_element, value))
    return None


def _path(data: str) -> Icon:
    """Return path data alone: on a usual page if it lies in it."""
    body = f"<path d={quoteattr(data)}/>"
    return _page_around(body), body


def _page_around(body: str) -> dict[str, str]:
    """Return the usual page if shapes lie in it; no page if they do not."""
    shapes = ET.fromstring(f"<g>{body}</g>").iter()
    box = union(list(filter(None, (data_bounds(path_data(one, _PAGE)) for one in shapes))))
    fits = box and box[0] > -1 and box[1] > -1 and max(box[0] + box[2], box[1] + box[3]) < _SIDE + 1
    return {"viewBox": f"0 0 {_SIDE:g} {_SIDE:g}"} if fits else {}


def _numbers(value: dict[str, Any]) -> dict[str, float]:
    return {name: one for name, one in value.items() if isinstance(one, int | float)}


def _page(said_of: dict[str, float]) -> dict[str, str]:
    width = said_of.get("width", said_of.get("height", _BY_DEFAULT))
    height = said_of.get("height", width)
    corner = said_of.get("left", 0), said_of.get("top", 0)
    return {"viewBox": " ".join(map(said, (*corner, width, height)))}


def _element(value: Any) -> str:
    """Return the markup of a node: a list of tag, attributes and nodes, or an object of these."""
    tag = value["tag"] if isinstance(value, dict) else value[0]
    if not _VALID.fullmatch(tag):
        raise ValueError
    return f"<{tag}{_written(_attributes(value))}>{_below(value)}</{tag}>"


def _attributes(value: Any) -> dict[str, str]:
    keyed = isinstance(value, dict)
    given = value.get("attrs", value.get("attr", {})) if keyed else value[1]
    return {
        attribute_name(name): said(one)
        for name, one in given.items()
        if isinstance(one, str | int | float) and _VALID.fullmatch(name) and name != "key"
    }


def _below(value: Any) -> str:
    if isinstance(value, dict):
        nodes = value.get("children") or value.get("child") or []
    else:
        nodes = value[2] if len(value) > 2 else []
    return "".join(map(_element, nodes))
