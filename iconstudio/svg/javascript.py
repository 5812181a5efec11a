"""What code in JavaScript and TypeScript says of values that are written out in it.

No code is run. Literals, constants, arithmetic, and lists that are mapped have values; all that the
program learns while it runs has none.
"""

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from iconstudio.svg.created import created, merged, tag_created
from iconstudio.svg.methods import (
    MATH,
    MOST,
    Value,
    key_of,
    listing,
    method,
    number,
    said,
    sequence,
    shortened,
    truth,
    unary,
)
from iconstudio.svg.operators import binary, entries, listed
from iconstudio.svg.syntax import (
    Node,
    UnknownError,
    are_alike,
    below,
    by_default,
    expression,
    name_of,
    parsed,
    piece,
    text_of,
)

_STEPS = 10 * MOST
_DEEPEST = 60
_SCRIPT = re.compile(r"<script\b[^>]*>(.*?)</script\s*>", re.DOTALL | re.IGNORECASE)
_DATA = re.compile(r"\sx-data\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")
_ELEMENTS = ("jsx_element", "jsx_self_closing_element", "jsx_fragment")
_FUNCTIONS = (
    "arrow_function", "function_expression", "function_declaration", "method_definition",
)  # fmt: skip
_TRANSPARENT = (
    "parenthesized_expression", "as_expression", "satisfies_expression", "non_null_expression",
    "expression_statement", "jsx_expression",
)  # fmt: skip
_WRAPPERS = (
    "ref", "shallowRef", "reactive", "readonly", "computed", "signal", "input", "useMemo", "memo",
    "useState", "freeze", "$state", "$derived",
)  # fmt: skip
"""Functions of frameworks that return what they are given."""
_CONSTANTS = {"undefined": None, "Infinity": math.inf, "NaN": math.nan}


@dataclass(frozen=True)
class Element:
    """An element of a drawing, as it is written in code, and what names mean in it."""

    source: str
    names: "Names"


@dataclass(frozen=True)
class Function:
    """A function that is written out."""

    node: Node
    names: "Names"

    def __call__(self, *given: Value) -> Value:
        """Return what it gives, so far as this is written out."""
        return called(self, *given)


@dataclass(frozen=True)
class _Written:
    """A value as it is written."""

    node: Node
    names: "Names"


class Names:
    """What names mean at some place of the code."""

    def __init__(self, outer: "Names | None" = None) -> None:
        self._outer = outer
        self._known: dict[str, Value] = {}
        self._open: set[str] = set()
        self._steps: list[int] = outer._steps if outer else [0]

    @classmethod
    def of(cls, text: str) -> "Names":
        """Return what a file declares, and has by default, with the scripts of a page."""
        scripts = [one[1] for one in _SCRIPT.finditer(text)]
        data = [f"({one[1] or one[2]});" for one in _DATA.finditer(text)]
        names = cls()
        names._declare(parsed("\n;".join([*scripts, *data]) or text))
        return names

    def bound(self, values: Mapping[str, Value]) -> "Names":
        """Return names that mean these values, whatever they mean elsewhere."""
        inner = Names(self)
        inner._known.update(values)
        return inner

    def __getitem__(self, name: str) -> Value:
        """Return the value of a name.

        Raises
        ------
        UnknownError
            If it is not written out.
        """
        if name not in self._known:
            if self._outer is None:
                raise UnknownError
            return self._outer[name]
        found = self._known[name]
        if isinstance(found, UnknownError) or name in self._open:
            raise UnknownError
        if isinstance(found, _Written):
            self._open.add(name)
            try:
                found = self._known[name] = _value(found.node, found.names)
            finally:
                self._open.discard(name)
        return found

    def count(self, steps: int) -> bool:
        """Count what is read, with all that names mean; false if that was too much."""
        self._steps[0] += steps
        return self._steps[0] <= _STEPS

    def binds(self, name: str) -> bool:
        """Whether a name means something here, known or not."""
        return name in self._known or (self._outer is not None and self._outer.binds(name))

    def value(self, code: str) -> Value:
        """Return the value of an expression.

        Raises
        ------
        UnknownError
            If it is not written out.
        """
        try:
            return _value(expression(code), self)
        except (ArithmeticError, IndexError, KeyError, TypeError, ValueError):
            raise UnknownError from None  # no drawing depends on what these are in JavaScript

    def at(self, node: Node) -> Value:
        """Return the value of what is written at a place of the code, counted for itself.

        Raises
        ------
        UnknownError
            If it is not written out.
        """
        self._steps[0] = 0
        return _value(node, self)

    def _declare(self, root: Node) -> None:
        """Take down what is declared, and, of less weight, what something is by default."""
        declared: dict[str, list[Node]] = {}
        paired: dict[str, list[Node]] = {}
        others: dict[str, Node] = {}
        changed = set()
        for node in below(root):
            name, value = name_of(node), node.child_by_field_name("value")
            match node.type:
                case "variable_declarator" | "public_field_definition" if value is not None:
                    declared.setdefault(name, []).append(value)
                case "function_declaration":
                    declared.setdefault(name, []).append(node)
                case "object_assignment_pattern" | "assignment_pattern":
                    others.setdefault(name, node.child_by_field_name("right") or node)
                case "required_parameter" if value is not None:
                    others.setdefault(name, value)
                case "pair" if value is not None:
                    paired.setdefault(name, []).append(by_default(value))
                case "assignment_expression" | "augmented_assignment_expression":
                    changed.add(name)
                case "update_expression":
                    changed.add(text_of(node.child_by_field_name("argument")))
        for name, nodes in paired.items():
            if are_alike(nodes):
                self._known[name] = _Written(nodes[0], self)
        for name, node in others.items():
            self._known[name] = _Written(node, self)
        for name, nodes in declared.items():
            known = are_alike(nodes) and name not in changed
            self._known[name] = _Written(nodes[0], self) if known else UnknownError()


def _value(node: Node, names: Names, depth: int = 0) -> Value:
    """Return the value of an expression."""
    if depth > _DEEPEST or not names.count(1):
        raise UnknownError

    def value(one: Node | None) -> Value:
        if one is None:
            raise UnknownError
        return _value(one, names, depth + 1)

    field = node.child_by_field_name
    match node.type:
        case "number":
            return number(text_of(node).replace("_", ""))
        case "string":
            return "".join(map(piece, node.named_children))
        case "template_string":
            return shortened(
                "".join(
                    said(value(one.named_children[0]))
                    if one.type == "template_substitution"
                    else piece(one)
                    for one in node.named_children
                )
            )
        case "true" | "false" | "null":
            return {"true": True, "false": False}.get(node.type)
        case "undefined" | "identifier":
            name = text_of(node)
            return _CONSTANTS[name] if name in _CONSTANTS else names[name]
        case "array":
            return listed(node, value)
        case "object":
            return entries(node, names, value)
        case "ternary_expression":
            holds = truth(value(field("condition")))
            return value(field("consequence" if holds else "alternative"))
        case "unary_expression":
            return unary(text_of(field("operator")), value(field("argument")))
        case "binary_expression":
            return binary(node, value)
        case "member_expression":
            return _member(node, names, value)
        case "subscript_expression":
            return value(field("object"))[key_of(value(field("index")))]
        case "call_expression" | "new_expression":
            return _call(node, names, value)
        case "assignment_expression":
            return value(field("right"))
        case "sequence_expression":
            return value(node.named_children[-1])
        case kind if kind in _TRANSPARENT:
            return value(node.named_children[0] if node.named_children else None)
        case kind if kind in _FUNCTIONS:
            return Function(node, names)
        case kind if kind in _ELEMENTS:
            return Element(text_of(node), names)
    raise UnknownError


def _member(node: Node, names: Names, value: Callable[[Node | None], Value]) -> Value:
    """Return ``a.b``; of properties that nobody gives, what they are by default."""
    name = text_of(node.child_by_field_name("property"))
    owner = node.child_by_field_name("object")
    if text_of(owner) == "Math":
        return {"PI": math.pi, "E": math.e, "SQRT2": math.sqrt(2)}[name]
    try:
        found = value(owner)
    except UnknownError:
        given = owner is not None and owner.type in ("identifier", "this")
        if not given or names.binds(text_of(owner)):
            raise
        return names[name]
    if name == "length":
        return float(len(found))
    if name == "value" and not isinstance(found, dict):
        return found  # of a ref of Vue
    return found[name] if isinstance(found, dict) else names[name]


def _call(node: Node, names: Names, value: Callable[[Node | None], Value]) -> Value:
    """Return what a function gives: one that is written out, or of the few that are known."""
    function = node.child_by_field_name("function") or node.child_by_field_name("constructor")
    arguments = node.child_by_field_name("arguments")
    if function is None or arguments is None:
        raise UnknownError
    tag, properties = tag_created(node), merged(node, value)
    if tag is not None:
        return created(node, tag, value)
    if properties is not None:
        return properties
    given = listed(arguments, value)
    owner, name = function.child_by_field_name("object"), text_of(function)
    if owner is not None:
        name = text_of(function.child_by_field_name("property"))
        match text_of(owner):
            case "Math":
                return float(MATH[name](*map(float, given)))
            case "Array":
                return sequence(*given)
            case "Object" if name != "freeze":
                return listing(given[0], name)
    if name in _WRAPPERS and given:
        return called(given[0]) if isinstance(given[0], Function) else given[0]
    if name == "Array":
        return sequence(*given)
    if name in ("String", "Number"):
        return said(given[0]) if name == "String" else float(given[0])
    if owner is None:
        found = value(function)
        return called(found, *given) if isinstance(found, Function) else found
    return method(value(owner), name, given)


def called(function: Value, *given: Value) -> Value:
    """Return what a function gives.

    Raises
    ------
    UnknownError
        If it is not written out.
    """
    if not isinstance(function, Function):
        raise UnknownError
    names, body = within(function, *given), function.node.child_by_field_name("body")
    if body is None:
        raise UnknownError
    if body.type != "statement_block":
        return _value(body, names)
    for statement in body.named_children:
        if statement.type == "return_statement" and statement.named_children:
            return _value(statement.named_children[0], names)
        if statement.type not in ("lexical_declaration", "comment"):
            break
        for one in statement.named_children:
            pattern, made = map(one.child_by_field_name, ("name", "value"))
            if pattern is not None and made is not None:
                names = names.bound(_matched(pattern, _Written(made, names), names))
    raise UnknownError


def within(function: Function, *given: Value) -> Names:
    """Return what names mean in a function that is called with so much; the rest is unknown."""
    field = function.node.child_by_field_name
    parameters = field("parameters") or field("parameter")
    patterns = [] if parameters is None else [parameters]
    if parameters is not None and parameters.type == "formal_parameters":
        patterns = [one for one in parameters.named_children if one.type != "comment"]
    values: dict[str, Value] = {}
    for place, pattern in enumerate(patterns):
        value = given[place] if place < len(given) else UnknownError()
        values |= _matched(pattern, value, function.names)
    return function.names.bound(values)


def _matched(pattern: Node, value: Value, names: Names) -> dict[str, Value]:
    """Return what a pattern of names binds to parts of a value, or by default."""
    if isinstance(value, _Written) and pattern.type in ("array_pattern", "object_pattern"):
        value = _value(value.node, value.names)
    inner = pattern.child_by_field_name("pattern") or pattern.child_by_field_name("left")
    if pattern.type not in ("pair_pattern", "object_pattern") and inner is not None:
        default = pattern.child_by_field_name("value") or pattern.child_by_field_name("right")
        if default is not None and (value is None or isinstance(value, UnknownError)):
            value = _Written(default, names)
        return _matched(inner, value, names)
    parts = [one for one in pattern.named_children if one.type != "comment"]
    match pattern.type:
        case "array_pattern":
            some = value if isinstance(value, list) else []
            some = [*some, *[UnknownError()] * (len(parts) - len(some))]
            pairs = list(zip(parts, some, strict=False))
        case "object_pattern":
            keyed = value if isinstance(value, dict) else {}
            pairs = []
            for one in parts:
                target = one.child_by_field_name("value") if one.type == "pair_pattern" else one
                absent = None if isinstance(value, dict) else UnknownError()
                pairs.append((target or one, keyed.get(name_of(one) or text_of(one), absent)))
        case "identifier" | "shorthand_property_identifier_pattern":
            return {text_of(pattern): value}
        case _:
            return {}
    found: dict[str, Value] = {}
    for part, one in pairs:
        found |= _matched(part, one, names)
    return found
