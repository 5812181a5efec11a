"""What operators and methods of JavaScript give, as far as drawings need them."""

import math
from collections.abc import Callable
from typing import Any

from iconstudio.svg.syntax import UnknownError

Value = Any
"""None, bool, float, str, list, dict, or a function, or an element, of code."""
Call = Callable[..., Value]
MOST = 20_000
"""Entries of a list."""
_LONGEST = 2_000_000
"""Characters of a text."""
MATH: dict[str, Callable[..., float]] = {
    "sin": math.sin, "cos": math.cos, "tan": math.tan, "atan2": math.atan2, "sqrt": math.sqrt,
    "abs": abs, "floor": math.floor, "ceil": math.ceil, "min": min, "max": max, "pow": pow,
    "hypot": math.hypot, "round": lambda x: math.floor(x + 0.5), "trunc": math.trunc,
}  # fmt: skip

ARITHMETIC: dict[str, Callable[[float, float], float]] = {
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: a / b,
    "%": math.fmod,
    "**": lambda a, b: float(a) ** b,
}

COMPARISONS: dict[str, Callable[[Value, Value], bool]] = {
    "===": lambda a, b: a == b,
    "==": lambda a, b: a == b,
    "!==": lambda a, b: a != b,
    "!=": lambda a, b: a != b,
    "<": lambda a, b: a < b,
    ">": lambda a, b: a > b,
    "<=": lambda a, b: a <= b,
    ">=": lambda a, b: a >= b,
}


def number(text: str) -> float:
    """Return a number."""
    return float(int(text, 0)) if text[:2].lower() in ("0x", "0b", "0o") else float(text)


def shortened(text: str) -> str:
    """Return a text that is not too long."""
    if len(text) > _LONGEST:
        raise UnknownError
    return text


def key_of(value: Value) -> Value:
    """Return the key by which a list, or an object, is asked."""
    return int(value) if isinstance(value, float) else value


def truth(value: Value) -> bool:
    """Whether JavaScript takes a value for true."""
    return value not in (None, False, 0, "") and value == value


def unary(operator: str, value: Value) -> Value:
    """Return ``-a`` and alike."""
    match operator:
        case "!":
            return not truth(value)
        case "-":
            return -float(value)
        case "+":
            return float(value)
    raise UnknownError


def listing(value: dict[str, Value], name: str) -> list[Value]:
    """Return what ``Object.keys`` and alike give."""
    match name:
        case "keys":
            return list(value)
        case "values":
            return list(value.values())
        case "entries":
            return [list(pair) for pair in value.items()]
    raise UnknownError


def mapped(items: list[Value], function: Call) -> list[Value]:
    """Return a list each of whose entries is mapped, with its number."""
    return [function(item, float(number)) for number, item in enumerate(items)]


def sequence(items: Value = 0.0, function: Call | None = None, *rest: Value) -> list[Value]:
    """Return a new list, of so many items or of these, each mapped."""
    if isinstance(items, dict):
        items = items["length"]
    if isinstance(items, float) and not 0 <= items <= MOST:
        raise UnknownError
    found = [None] * int(items) if isinstance(items, float) else list(items)
    return found if function is None else mapped(found, function)


def method(value: Value, name: str, given: list[Value]) -> Value:
    """Return what a method of a list, a text or a number gives."""
    if isinstance(value, list):
        match name:
            case "map" | "flatMap":
                found = mapped(value, given[0])
                return found if name == "map" else [one for some in found for one in some]
            case "filter":
                kept = mapped(value, given[0])
                return [one for one, keep in zip(value, kept, strict=True) if truth(keep)]
            case "join":
                return shortened((said(given[0]) if given else ",").join(map(said, value)))
            case "fill":
                return [given[0]] * len(value)
            case "keys":
                return [float(number) for number in range(len(value))]
            case "entries":
                return [[float(number), one] for number, one in enumerate(value)]
            case "concat":
                return [*value, *(one for some in given for one in some)]
            case "slice":
                return value[slice(*map(key_of, given))] if given else value
            case "reverse" | "toReversed":
                return value[::-1]
    match name:
        case "toFixed":
            return f"{float(value):.{int(given[0]) if given else 0}f}"
        case "toString":
            return said(value)
        case "trim":
            return str(value).strip()
    raise UnknownError


def said(value: Value) -> str:
    """Return a value as JavaScript writes it."""
    if value is None or isinstance(value, bool):
        return {None: "undefined", True: "true", False: "false"}[value]
    if isinstance(value, float | int):
        return str(int(value)) if float(value).is_integer() else repr(float(value))
    if isinstance(value, list):
        return ",".join(map(said, value))
    if isinstance(value, str):
        return value
    raise UnknownError
