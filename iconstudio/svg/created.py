"""Elements that compiled code creates by calls: ``createElement("path", {d: "..."})``.

So do React, Preact, Vue and Solid's ``h``, by whatever name, with children as arguments, in a list
or among the properties.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

from iconstudio.svg.geometry import SHAPES
from iconstudio.svg.methods import said
from iconstudio.svg.names import hyphenated
from iconstudio.svg.syntax import Node, UnknownError, name_of, text_of

Evaluate = Callable[[Node | None], Any]
_TAGS = (
    "svg", "g", "defs", "clipPath", "mask", "use", "symbol", "linearGradient", "radialGradient",
    "stop", "pattern", *SHAPES,
)  # fmt: skip
_FIRST = ("string", "template_string", "identifier", "member_expression")
_NEEDED = {"path": "d", "circle": "r", "polygon": "points", "polyline": "points"}
"""Attributes without which a shape is not known."""
_MERGING = ("assign", "mergeProps", "_extends", "__spreadValues", "_mergeProps")


class Created(NamedTuple):
    """An element, or, without a tag, a fragment."""

    tag: str
    attributes: dict[str, Any]
    nodes: list["Created"]


def tag_created(node: Node) -> str | None:
    """Return the tag of the element that a call creates, "" for a fragment; None if it does not."""
    if node.type != "call_expression":
        return None
    arguments = _arguments(node)
    if not arguments or arguments[0].type not in _FIRST:
        return None
    said_first = text_of(arguments[0])
    if said_first.rpartition(".")[2] in ("Fragment", "_Fragment"):
        return ""
    tag = said_first.strip("\"'`")
    return tag if tag in _TAGS and tag != said_first else None


def created(node: Node, tag: str, value: Evaluate) -> Created:
    """Return the element that a call creates.

    Raises
    ------
    UnknownError
        If a shape in it is not written out.
    """
    first, *rest = [*_arguments(node)[1:], None]
    given = _known(first, value)
    properties = given if isinstance(given, dict) else {}
    nodes = _children(first, value) if first is not None and first.type == "array" else []
    nodes += _children(_pair(first, "children"), value)
    for one in rest:
        nodes += _children(one, value)
    attributes = {key: one for key, one in properties.items() if key != "children"}
    if isinstance(attributes.get("style"), dict):
        style = attributes["style"].items()
        attributes["style"] = ";".join(f"{hyphenated(key)}:{said(one)}" for key, one in style)
    if _NEEDED.get(tag) not in (None, *attributes):
        raise UnknownError
    return Created(tag, attributes, nodes)


def merged(node: Node, value: Evaluate) -> dict[str, Any] | None:
    """Return what ``Object.assign`` and alike give, as far as known; None if it is none of them."""
    function = text_of(node.child_by_field_name("function")).rpartition(".")[2]
    if function not in _MERGING:
        return None
    found: dict[str, Any] = {}
    for one in _arguments(node):
        given = _known(one, value)
        found |= given if isinstance(given, dict) else {}
    return found


def _arguments(node: Node) -> list[Node]:
    arguments = node.child_by_field_name("arguments")
    return [one for one in arguments.named_children if one.type != "comment"] if arguments else []


def _pair(node: Node | None, name: str) -> Node | None:
    """Return the value of a property that is written in an object."""
    pairs = node.named_children if node is not None and node.type == "object" else []
    return next((one.child_by_field_name("value") for one in pairs if name_of(one) == name), None)


def _known(node: Node | None, value: Evaluate) -> Any:
    try:
        return value(node)
    except UnknownError:
        return None


def _children(node: Node | None, value: Evaluate) -> list[Created]:
    """Return the elements that an expression gives; what draws nothing need not be known."""
    if node is None:
        return []
    if node.type == "array":
        return [one for part in node.named_children for one in _children(part, value)]
    if node.type == "spread_element":
        return _children(node.named_children[0], value)
    try:
        return elements(value(node))
    except UnknownError:
        if any(f'"{tag}"' in text_of(node).replace("'", '"') for tag in _TAGS):
            raise
        return []


def elements(found: Any) -> list[Created]:
    """Return the elements in a value: one, those of a fragment, or of a list."""
    if isinstance(found, Created):
        return [found] if found.tag else found.nodes
    return [one for part in found for one in elements(part)] if isinstance(found, list) else []
