"""Lists, objects and operators of JavaScript, of values that are written out."""

from collections.abc import Callable
from typing import Protocol

from iconstudio.svg.methods import ARITHMETIC, COMPARISONS, MOST, Value, said, shortened, truth
from iconstudio.svg.syntax import Node, UnknownError, name_of, text_of


class Named(Protocol):
    """What names mean."""

    def __getitem__(self, name: str) -> Value:
        """Return the value of a name."""


def listed(node: Node, value: Callable[[Node | None], Value]) -> list[Value]:
    """Return the entries of a list."""
    found: list[Value] = []
    for one in node.named_children:
        if one.type == "spread_element":
            found += value(one.named_children[0])
        elif one.type != "comment":
            found.append(value(one))
        if len(found) > MOST:
            raise UnknownError
    return found


def entries(node: Node, names: "Named", value: Callable[[Node | None], Value]) -> dict[str, Value]:
    """Return an object; what is not written out in it is not there."""
    found: dict[str, Value] = {}
    for one in node.named_children:
        try:
            if one.type == "pair":
                found[name_of(one)] = value(one.child_by_field_name("value"))
            elif one.type == "shorthand_property_identifier":
                found[text_of(one)] = names[text_of(one)]
            elif one.type == "spread_element":
                found |= value(one.named_children[0])
        except UnknownError:
            continue
    return found


def binary(node: Node, value: Callable[[Node | None], Value]) -> Value:
    """Return ``a + b`` and alike."""
    left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
    operator = text_of(node.child_by_field_name("operator"))
    if operator in ("||", "??"):
        try:
            found = value(left)
        except UnknownError:  # a property that nobody gives
            return value(right)
        kept = truth(found) if operator == "||" else found is not None
        return found if kept else value(right)
    found = value(left)
    if operator == "&&":
        return value(right) if truth(found) else found
    other = value(right)
    if operator == "+":
        if isinstance(found, str) or isinstance(other, str):
            return shortened(said(found) + said(other))
        return float(found) + float(other)
    if operator in ARITHMETIC:
        return float(ARITHMETIC[operator](float(found), float(other)))
    if operator in COMPARISONS:
        return COMPARISONS[operator](found, other)
    raise UnknownError
