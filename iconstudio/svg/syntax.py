"""Code in JavaScript and TypeScript as a tree: the adapter of tree-sitter.

It only reads: no code is run.
"""

from collections.abc import Iterator
from functools import cache

import tree_sitter_typescript
from tree_sitter import Language, Node, Parser

__all__ = [
    "Node", "UnknownError", "are_alike", "below", "by_default", "expression", "name_of", "parsed",
    "piece", "text_of",
]  # fmt: skip

_ESCAPES = {"n": "\n", "t": "\t", "r": "\r", "b": "\b", "f": "\f", "v": "\v", "0": "\0"}


class UnknownError(Exception):
    """A value is not written out."""


@cache
def _parser() -> Parser:
    return Parser(Language(tree_sitter_typescript.language_tsx()))


def parsed(text: str) -> Node:
    """Return the tree of a file."""
    return _parser().parse(text.encode(errors="replace")).root_node


def expression(code: str) -> Node:
    """Return the one expression of a piece of code.

    Raises
    ------
    UnknownError
        If it is none.
    """
    root = parsed(f"({code}\n)")
    if root.has_error or root.named_child_count != 1:
        raise UnknownError
    return root.named_children[0]


def below(root: Node) -> Iterator[Node]:
    """Yield all named nodes, in their order."""
    open_ = [root]
    while open_:
        node = open_.pop()
        yield node
        open_ += reversed(node.named_children)


def text_of(node: Node | None) -> str:
    """Return what is written there."""
    return "" if node is None or node.text is None else node.text.decode()


def name_of(node: Node) -> str:
    """Return the name that a node gives something."""
    for field in ("name", "left", "key", "pattern"):
        if found := node.child_by_field_name(field):
            return text_of(found).strip("\"'")
    return ""


def by_default(value: Node) -> Node:
    """Return what ``{type: Number, default: 24}`` says, and others as they are."""
    for pair in value.named_children if value.type == "object" else ():
        if name_of(pair) == "default":
            return pair.child_by_field_name("value") or value
    return value


def are_alike(nodes: list[Node]) -> bool:
    """Whether the same is written everywhere."""
    return len({node.text for node in nodes}) == 1


def piece(node: Node) -> str:
    """Return a piece of a string."""
    text = text_of(node)
    if node.type != "escape_sequence":
        return text
    if text[1] in "ux":
        return chr(int(text[2:].strip("{}"), 16))
    return "" if text[1] == "\n" else _ESCAPES.get(text[1], text[1:])
