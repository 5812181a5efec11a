"""Whether browsers meet the condition of ``@supports`` (CSS Conditional Rules 3 and 4)."""

from collections.abc import Sequence
from typing import Any

import cssselect2
import tinycss2

from iconstudio.svg.properties import is_known

_PSEUDO_ELEMENTS = (
    "before", "after", "first-line", "first-letter", "selection", "marker", "placeholder",
    "backdrop", "cue", "part", "slotted", "file-selector-button", "target-text", "highlight",
    "view-transition", "details-content",
)  # fmt: skip
_FONT_FORMATS = ("woff", "woff2", "opentype", "truetype", "collection")
_FONT_TECHNIQUES = (
    "variations", "features-opentype", "color-colrv0", "color-colrv1", "color-svg", "color-sbix",
    "color-cbdt", "palettes",
)  # fmt: skip


class _InvalidError(Exception):
    """It is no condition."""


def supported(condition: str) -> bool:
    """Whether a condition holds; one that is not well-formed does not."""
    tokens = tinycss2.parse_component_value_list(condition, skip_comments=True)
    try:
        return _condition(tokens)
    except _InvalidError:
        return False


def _condition(tokens: Sequence[Any]) -> bool:
    """Return what ``not a``, ``a and b and c``, ``a or b or c`` or ``a`` come to."""
    parts = [one for one in tokens if one.type != "whitespace"]
    if not parts:
        raise _InvalidError
    if len(parts) == 2 and _word(parts[0]) == "not":
        return not _enclosed(parts[1])
    found = [_enclosed(one) for one in parts[::2]]
    joined = {_word(one) for one in parts[1::2]}
    if len(parts) % 2 == 0 or len(joined) > 1 or not joined <= {"and", "or"}:
        raise _InvalidError
    return all(found) if joined == {"and"} else any(found)


def _word(token: Any) -> str:
    return str(token.lower_value) if token.type == "ident" else ""


def _enclosed(token: Any) -> bool:
    """Return what a part in parentheses, or a function, comes to; what is unknown is false."""
    if token.type == "function":
        said = tinycss2.serialize(token.arguments).strip()
        match token.lower_name:
            case "selector":
                return _is_selector(said)
            case "font-format":
                return said.strip("\"'").lower() in _FONT_FORMATS
            case "font-tech":
                return said.lower() in _FONT_TECHNIQUES
        return False
    if token.type != "() block":
        raise _InvalidError
    content = [one for one in token.content if one.type != "whitespace"]
    if len(content) > 1 and content[0].type == "ident" and content[1] == ":":
        declaration = tinycss2.parse_one_declaration(token.content, skip_comments=True)
        return declaration.type == "declaration" and is_known(declaration)
    try:
        return _condition(token.content)
    except _InvalidError:
        return False


def _is_selector(said: str) -> bool:
    try:
        found = cssselect2.compile_selector_list(said)
    except cssselect2.SelectorError:
        return False
    elements = (one.pseudo_element for one in found)
    return all(one is None or one in _PSEUDO_ELEMENTS for one in elements)
