"""Mathematical functions of CSS (CSS Values and Units, section 10)."""

from collections.abc import Callable, Sequence
from typing import Any

from iconstudio.svg.lengths import pixels
from iconstudio.svg.stylesheet import tokens_of

Quantity = tuple[float, str]
"""A number and its kind: "", "px", "%" or a unit of angles."""
_FUNCTIONS = ("calc", "min", "max", "clamp", "-webkit-calc")
_ANGLES = ("deg", "rad", "grad", "turn")


class _UnknownError(Exception):
    """What is to be computed depends on what is not known here, or means nothing."""


def calculated(value: str, whole: float | None = None) -> str:
    """Return a value with its functions computed; those that cannot be are left as they are.

    ``whole``, in pixels, is what percentages are of where they are added to lengths, if it is
    known.
    """
    if not any(f"{name}(" in value.lower() for name in _FUNCTIONS):
        return value
    return _computed(tokens_of(value), whole)


def _computed(tokens: Sequence[Any], whole: float | None) -> str:
    parts = []
    for token in tokens:
        if token.type == "function" and token.lower_name in _FUNCTIONS:
            parts.append(_written(token, whole))
        elif token.type == "function":
            parts.append(f"{token.name}({_computed(token.arguments, whole)})")
        else:
            parts.append(token.serialize())
    return "".join(parts)


def _written(token: Any, whole: float | None) -> str:
    """Return a function's value; in pixels, if percentages are mixed with lengths."""
    for known in (None, whole):
        try:
            number, kind = _Calculation(known).function(token)
        except (_UnknownError, ArithmeticError):
            continue
        return f"{number:.9g}{kind}"
    return str(token.serialize())


class _Calculation:
    def __init__(self, whole: float | None) -> None:
        self._whole = whole

    def function(self, token: Any) -> Quantity:
        """Return what a function comes to."""
        arguments = [self._sum(one) for one in _split(token.arguments)]
        name = token.lower_name
        if name in ("calc", "-webkit-calc") and len(arguments) == 1:
            return arguments[0]
        if len({kind for _, kind in arguments}) != 1:
            raise _UnknownError
        numbers, kind = [number for number, _ in arguments], arguments[0][1]
        if name in ("min", "max"):
            return (min if name == "min" else max)(numbers), kind
        if name == "clamp" and len(numbers) == 3:
            return max(numbers[0], min(numbers[1], numbers[2])), kind
        raise _UnknownError

    def _sum(self, tokens: Sequence[Any]) -> Quantity:
        return _chain(tokens, "+-", lambda rest: _chain(rest, "*/", self._one))

    def _one(self, tokens: Sequence[Any]) -> Quantity:
        if len(tokens) != 1:
            raise _UnknownError
        (token,) = tokens
        match token.type:
            case "number":
                return token.value, ""
            case "percentage" if self._whole is not None:
                return token.value / 100 * self._whole, "px"
            case "percentage":
                return token.value, "%"
            case "dimension" if token.lower_unit in _ANGLES:
                return token.value, token.lower_unit
            case "dimension":
                found = pixels(f"{token.value}{token.unit}")
                if found is not None:
                    return found, "px"
            case "() block":
                return self._sum(_without_blanks(token.content))
            case "function" if token.lower_name in _FUNCTIONS:
                return self.function(token)
        raise _UnknownError


def _chain(tokens: Sequence[Any], signs: str, inner: Callable[[list[Any]], Quantity]) -> Quantity:
    """Return what operations of one rank come to, from left to right."""
    parts: list[tuple[str, list[Any]]] = [(signs[0], [])]
    for token in tokens:
        if token.type == "literal" and token.value in signs:
            parts.append((token.value, []))
        else:
            parts[-1][1].append(token)
    number, kind = inner(parts[0][1])
    for sign, rest in parts[1:]:
        other, unit = inner(rest)
        if sign in "+-" and kind == unit:
            number += other if sign == "+" else -other
        elif sign == "*" and "" in (kind, unit):
            number, kind = number * other, kind or unit
        elif sign == "/" and not unit:
            number /= other
        else:
            raise _UnknownError
    return number, kind


def _split(tokens: Sequence[Any]) -> list[list[Any]]:
    """Return the arguments of a function, without blanks."""
    found: list[list[Any]] = [[]]
    for token in _without_blanks(tokens):
        if token == ",":
            found.append([])
        else:
            found[-1].append(token)
    return found


def _without_blanks(tokens: Sequence[Any]) -> list[Any]:
    return [one for one in tokens if one.type not in ("whitespace", "comment")]
