"""The shorthand of fonts in style sheets (CSS Fonts 4, section 2.7)."""

from typing import Any

from iconstudio.svg.stylesheet import tokens_of

_WEIGHTS = ("bold", "bolder", "lighter")
_STYLES = ("italic", "oblique")
_STRETCHES = (
    "ultra-condensed", "extra-condensed", "condensed", "semi-condensed", "semi-expanded",
    "expanded", "extra-expanded", "ultra-expanded",
)  # fmt: skip
_SIZES = (
    "xx-small", "x-small", "small", "medium", "large", "x-large", "xx-large", "xxx-large",
    "smaller", "larger",
)  # fmt: skip
_LONGHANDS = ("font-style", "font-variant", "font-weight", "font-stretch", "font-size",
              "font-family")  # fmt: skip
_OF_ALL = ("inherit", "initial", "unset", "revert", "revert-layer")


def font(value: str) -> dict[str, str]:
    """Return what ``font: bold 12px/1.5 Inter, sans-serif`` sets; nothing if it is not valid."""
    if value.strip().lower() in _OF_ALL:
        return dict.fromkeys(_LONGHANDS, value.strip())
    found = dict.fromkeys(_LONGHANDS[:4], "normal")
    tokens = tokens_of(value)
    for place, token in enumerate(tokens):
        word = token.serialize().strip().lower()
        if token.type in ("dimension", "percentage", "function") or word in _SIZES:
            family = _family(tokens[place + 1 :])
            return found | {"font-size": word, "font-family": family} if family else {}
        if token.type == "number" or word in _WEIGHTS:
            found["font-weight"] = word
        elif word in _STYLES:
            found["font-style"] = word
        elif word in _STRETCHES:
            found["font-stretch"] = word
        elif word == "small-caps":
            found["font-variant"] = word
        elif word not in ("", "normal"):
            return {}
    return {}


def _family(tokens: list[Any]) -> str:
    """Return what follows the size, without the height of lines."""
    rest = [one for one in tokens if one.type not in ("whitespace", "comment")]
    if rest and rest[0] == "/":
        rest = rest[2:]
    return "".join(str(one.serialize()) for one in rest)
