"""Whether browsers meet the condition of ``@supports`` (CSS Conditional Rules 3 and 4)."""

from collections.abc import Callable, Sequence
from typing import Any

from iconstudio.svg.properties import is_known

_FONT_FORMATS = ("woff", "woff2", "opentype", "truetype", "collection")
_FONT_TECHNIQUES = (
    "variations", "features-opentype", "color-colrv0", "color-colrv1", "color-svg", "color-sbix",
    "color-cbdt", "palettes",
)  # fmt: skip


class _InvalidError(Exception):
    """It is no condition."""


def supported(condition: Sequence[Any], is_selector: Callable[[str], bool]) -> bool:
    """Whether a condition, in tokens, holds; one that is not well-formed does not.

    ``is_selector`` says whether a selector is known.
    """
    try:
        return _Conditions(is_selector).hold(condition)
    except _InvalidError:
        return False


class _Conditions:
    def __init__(self, is_selector: Callable[[str], bool]) -> None:
        self._is_selector = is_selector

    def hold(self, tokens: Sequence[Any]) -> bool:
        """Return what ``not a``, ``a and b and c``, ``a or b or c`` or ``a`` come to."""
        parts = _told(tokens)
        if not parts:
            raise _InvalidError
        if len(parts) == 2 and _word(parts[0]) == "not":
            return not self._enclosed(parts[1])
        found = [self._enclosed(one) for one in parts[::2]]
        joined = {_word(one) for one in parts[1::2]}
        if len(parts) % 2 == 0 or len(joined) > 1 or not joined <= {"and", "or"}:
            raise _InvalidError
        return all(found) if joined == {"and"} else any(found)

    def _enclosed(self, token: Any) -> bool:
        """Return what is in parentheses, or a function, comes to; what is unknown is false."""
        if token.type == "function":
            said = "".join(one.serialize() for one in token.arguments).strip()
            match token.lower_name:
                case "selector":
                    return self._is_selector(said)
                case "font-format":
                    return said.strip("\"'").lower() in _FONT_FORMATS
                case "font-tech":
                    return said.lower() in _FONT_TECHNIQUES
            return False
        if token.type != "() block":
            raise _InvalidError
        parts = _told(token.content)
        if len(parts) > 1 and parts[0].type == "ident" and parts[1] == ":":
            return is_known(parts[0].value, _without_importance(parts[2:]))
        try:
            return self.hold(parts)
        except _InvalidError:
            return False


def _told(tokens: Sequence[Any]) -> list[Any]:
    """Return tokens without blanks and comments."""
    return [one for one in tokens if one.type not in ("whitespace", "comment")]


def _word(token: Any) -> str:
    return str(token.lower_value) if token.type == "ident" else ""


def _without_importance(tokens: list[Any]) -> list[Any]:
    important = len(tokens) > 1 and tokens[-2] == "!" and _word(tokens[-1]) == "important"
    return tokens[:-2] if important else tokens
