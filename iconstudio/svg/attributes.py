"""Attributes in the code of web pages and apps, as SVG writes them."""

import html
import re
from collections.abc import Generator
from typing import Any
from xml.sax.saxutils import quoteattr

from iconstudio.svg.conditions import CHOSEN, Choices, closing, ternary
from iconstudio.svg.geometry import SHAPES
from iconstudio.svg.javascript import Names
from iconstudio.svg.methods import said
from iconstudio.svg.names import hyphenated
from iconstudio.svg.syntax import UnknownError

_NAME = re.compile(r"[^\s=>{/\"']+")
_QUOTED = re.compile(r"\s*=\s*(\"[^\"]*\"|'[^']*')")
_BRACED = re.compile(r"\s*=\s*\{")
_VALID = re.compile(r"[A-Za-z_][\w.:-]*")
_BARE = re.compile(r"\s*=\s*([^\s>{\"']+)")
_MUSTACHE = re.compile(r"\{\{(.*?)\}\}|\$?\{([^{}]*)\}", re.DOTALL)
_BOUND = re.compile(r"(?::|[vx]-bind:|\[attr\.|\[)([A-Za-z][\w:-]*)\]?")
_PAINTS = ("fill", "stroke", "color", "stop-color", "stopColor")
_SHAPING = re.compile(
    r"d|x|y|[xyr][12xy]|c[xy]|r|points|transform|viewBox|offset|href|xlink:?[hH]ref|clip-?[pP]ath"
    r"|mask|(?:fill|stroke|clip)(?:-?[a-zA-Z]+)"
)
"""Names of attributes without which a drawing is another one."""
_SIZES = ("width", "height")
_PLACING = re.compile(
    r"d|x|y|[xyr][12xy]|c[xy]|r|points|transform|width|height|href|xlink:?[hH]ref"
)
"""Names of attributes without which a shape is elsewhere."""
_LONGEST = 60

COMPUTED = "is computed by its code, and was left out."
MISPLACED = "A <{}> whose “{}” is computed by its code was left out. Save the SVG that it draws."
COLOURED = "Colours that its code chooses were drawn in black."


class Attributes:
    """Reads the attributes of elements."""

    def __init__(self, markup: str, names: Names, choices: Choices, remarks: list[str]) -> None:
        self._markup = markup
        self._names = names
        self._choices = choices
        self.remarks = remarks
        self.misplaced = False
        """Whether the place of the shape that was read is not known."""

    def read(self, place: int, tag: str) -> Generator[str, None, int]:
        """Yield the attributes of an element as SVG writes them; return where they end."""
        markup = self._markup
        while place < len(markup) and markup[place] != ">":
            if markup[place] == "{":
                end = closing(markup, place + 1)
                code = markup[place + 1 : end].strip()  # {...props}, or Svelte's {x} for x={x}
                short = _VALID.fullmatch(code) is not None
                yield self._computed(code, code, tag) if short else self._spread(code)
                place = end + 1
                continue
            name = _NAME.match(markup, place)
            if name is None:
                yield markup[place]
                place += 1
                continue
            place = name.end()
            if quoted := _QUOTED.match(markup, place):
                place = quoted.end()
                yield self._quoted(name[0], quoted[1], tag)
            elif braced := _BRACED.match(markup, place):
                end = closing(markup, braced.end())
                yield self._computed(name[0], markup[braced.end() : end], tag)
                place = end + 1
            else:
                bare = _BARE.match(markup, place)
                bound = None if bare else _BOUND.fullmatch(name[0])
                if bound is not None:  # Vue's :x for :x="x"
                    yield self._computed(bound[1], bound[1], tag)
                elif _VALID.fullmatch(name[0]):
                    yield name[0] + (bare[0] if bare else "")
                place = bare.end() if bare else place
        return place

    def _quoted(self, name: str, value: str, tag: str) -> str:
        """Return an attribute with a value in quotes, which may be code, too."""
        inner = value[1:-1].strip()
        name = name.removeprefix("attr.")
        bound = _BOUND.fullmatch(name)
        if bound is not None and not name.startswith("xml"):
            return self._computed(bound[1], html.unescape(inner), tag)
        if name == "v-bind":
            return self._spread(html.unescape(inner))
        if name[0] in "@(*#[:" or name.startswith(("v-", "x-on", "x-data")):
            return ""
        if "{" not in inner or name == "class" or name.startswith("data-"):
            return f"{name}={value}"
        if inner.startswith("{") and closing(inner, 1) == len(inner) - 1:
            return self._computed(name, inner.strip("{}"), tag)
        pieces = _MUSTACHE.sub(lambda match: f"${{{match[1] or match[2]}}}", inner)
        return self._computed(name, f"`{pieces}`", tag)

    def _spread(self, code: str) -> str:
        """Return the attributes that an object gives an element."""
        try:
            given = self._names.value(code.removeprefix("..."))
        except UnknownError:
            return ""
        pairs = given.items() if isinstance(given, dict) else ()
        return " ".join(_attribute(name, value) for name, value in pairs if name != "children")

    def _computed(self, name: str, code: str, tag: str) -> str:
        """Return an attribute whose value is code."""
        code = code.strip()
        try:
            return _attribute(name, self._value(name, code))
        except UnknownError:
            pass
        if name in _PAINTS:
            self.remarks.append(COLOURED)
            return f'{name}="currentColor"'
        if _SHAPING.fullmatch(name) or (name in _SIZES and tag != "svg"):
            said = f"{name}: {short(code)}"
            self.misplaced |= _PLACING.fullmatch(name) is not None
            if self.misplaced and tag in SHAPES:
                self.remarks.append(MISPLACED.format(tag, said))
            else:
                self.remarks.append(f"“{said}” {COMPUTED}")
        return ""

    def _value(self, name: str, code: str) -> Any:
        """Return the value of an attribute; of two that its code chooses between, one."""
        try:
            return self._names.value(code)
        except UnknownError:
            branches = None if name in _PAINTS else ternary(code)
            if branches is None:
                raise
        found = self._names.value(branches[1 if self._choices.takes(branches[0]) else 2])
        self.remarks.append(CHOSEN)
        return found


def _attribute(name: str, value: Any) -> str:
    """Return an attribute of this value; nothing if it says that there is none."""
    if isinstance(value, dict) and name == "style":
        value = ";".join(
            f"{hyphenated(key)}:{said(one)}" for key, one in value.items() if one is not None
        )
    if value is None or isinstance(value, bool | dict) or not _VALID.fullmatch(name):
        return ""
    return f"{name}={quoteattr(said(value))}"


def short(code: str) -> str:
    """Return the beginning of a piece of code, to be quoted."""
    words = " ".join(code.split())
    return words if len(words) <= _LONGEST else f"{words[:_LONGEST]}…"
