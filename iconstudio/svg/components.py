"""Drawings in the code of web pages and apps (React, Vue, Svelte, Angular, React Native) as markup.

Values that are written out are read, and so are the ones that a property has by default. Nothing
of the code is run.
"""

import re
from collections.abc import Generator, Iterator
from xml.sax.saxutils import quoteattr

_CODE = re.compile(
    r"[\w:-]=\s*\{|\{\s*\.\.\.|\{/\*|=\"\{|\s[@*#][\w.:-]+=|\sv-[a-z]+[\s=:>]|\s:[a-z][\w:-]*=[\"']"
    r"|\s\[[\w.-]+\]=|\{[#@:/]\w|\{\{|>\s*\{\s*[`\"']"
)
"""What no SVG has, but code around it and within it."""
_TOKEN = re.compile(
    r"(?P<verbatim><!--.*?-->|<!\[CDATA\[.*?\]\]>|<\?.*?\?>|<!DOCTYPE[^>\[]*(?:\[.*?\]\s*)?>"
    r"|<(?P<raw>style|script)\b[^>{]*(?<!/)>.*?</(?P=raw)\s*>)"
    r"|(?P<tag><[A-Za-z][\w.:-]*)|(?P<brace>\{)",
    re.DOTALL | re.IGNORECASE,
)
_TEMPLATE = re.compile(r">\s*\{\s*`(.*)`\s*\}\s*</", re.DOTALL)
"""A style sheet that is written as a string."""
_NAME = re.compile(r"[^\s=>{/\"']+")
_QUOTED = re.compile(r"\s*=\s*(\"[^\"]*\"|'[^']*')")
_BRACED = re.compile(r"\s*=\s*\{")
_BARE = re.compile(r"\s*=\s*([^\s>{\"']+)")
_LITERAL = re.compile(r"[\"'`]([^\"'`$]*)[\"'`]|([+-]?[\d.]+(?:e[+-]?\d+)?)")
_ALTERNATIVE = re.compile(r".*(?:\|\||\?\?)\s*([^|?:]+)", re.DOTALL)
_WORD = re.compile(r"(?:\w+\.)?([A-Za-z_$][\w$]*)")
_PAIR = re.compile(
    r"[\"']?([\w-]+)[\"']?\s*:\s*(\"[^\"]*\"|'[^']*'|`[^`$]*`|[+-]?[\d.]+)\s*(?:,|$)"
)
_BOUND = re.compile(r"(?::|v-bind:|\[attr\.|\[)([A-Za-z][\w:-]*)\]?")
_DRAWN = re.compile(r"<(?:path|rect|circle|ellipse|line|poly\w+|use|g|text)\b", re.IGNORECASE)
_CAPITAL = re.compile(r"[A-Z]")
_PAINTS = ("fill", "stroke", "color", "stop-color", "stopColor")
_SHAPING = re.compile(
    r"d|x|y|[xyr][12xy]|c[xy]|r|points|transform|viewBox|offset|href|xlink:?[hH]ref|clip-?[pP]ath"
    r"|mask|(?:fill|stroke|clip)(?:-?[a-zA-Z]+)"
)
"""Names of attributes without which a drawing is another one."""
_SIZES = ("width", "height")
_QUOTES = "\"'`"
_LONGEST = 60

COLOURED = "Colours that its code chooses were drawn in black."


def is_code(markup: str) -> bool:
    """Whether there may be code within a drawing."""
    return _CODE.search(markup) is not None


def without_code(markup: str, around: str) -> tuple[str, list[str]]:
    """Return a drawing without the code in it, and what could not be read, in sentences.

    ``around`` is the rest of the file, which may say what properties are by default.
    """
    reader = _Reader(markup, around)
    return "".join(reader.parts()), list(dict.fromkeys(reader.remarks))


class _Reader:
    def __init__(self, markup: str, around: str) -> None:
        self._markup = markup
        self._around = around
        self.remarks: list[str] = []

    def parts(self) -> Iterator[str]:
        """Yield the markup, piece by piece."""
        place = 0
        while match := _TOKEN.search(self._markup, place):
            yield self._markup[place : match.start()]
            place = match.end()
            if match["verbatim"]:
                yield _TEMPLATE.sub(r">\1</", match[0])
            elif match["tag"]:
                yield match[0]
                place = yield from self._attributes(place, match[0][1:].lower())
            else:
                end = _closing(self._markup, place)
                yield self._text(self._markup[place:end])
                place = end + 1
        yield self._markup[place:]

    def _text(self, code: str) -> str:
        """Return what code between elements comes to."""
        literal = _LITERAL.fullmatch(code.strip())
        if literal is not None:
            return (literal[1] or literal[2] or "").replace("<", "&lt;")
        if _DRAWN.search(code) and not code.lstrip().startswith("/*"):
            self.remarks.append(
                "What its code draws, or does not, as the case may be, is left out."
            )
        return ""

    def _attributes(self, place: int, tag: str) -> Generator[str, None, int]:
        """Yield the attributes of an element as SVG writes them; return where they end."""
        markup = self._markup
        while place < len(markup) and markup[place] != ">":
            if markup[place] == "{":
                place = _closing(markup, place + 1) + 1  # {...props}
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
                end = _closing(markup, braced.end())
                yield self._computed(name[0], markup[braced.end() : end], tag)
                place = end + 1
            else:
                bare = _BARE.match(markup, place)
                yield name[0] + (bare[0] if bare else "")
                place = bare.end() if bare else place
        return place

    def _quoted(self, name: str, value: str, tag: str) -> str:
        """Return an attribute with a value in quotes, which may be code, too."""
        inner = value[1:-1].strip()
        bound = _BOUND.fullmatch(name)
        if bound is not None and not name.startswith("xml"):
            return self._computed(bound[1], inner, tag)
        if name[0] in "@(*#[:" or name.startswith("v-"):
            if name == "v-for" or name.startswith("*ngFor"):
                self.remarks.append("What its code draws again and again was drawn once.")
            return ""
        if inner.startswith("{") and _closing(inner, 1) == len(inner) - 1:
            return self._computed(name, inner.strip("{}"), tag)
        return f"{name}={value}"

    def _computed(self, name: str, code: str, tag: str) -> str:
        """Return an attribute whose value is code."""
        code = code.strip()
        if name == "style":
            return self._style(code)
        value = self._value(code, 0)
        if value is not None:
            return f"{name}={quoteattr(value)}"
        if name in _PAINTS:
            self.remarks.append(COLOURED)
            return f'{name}="currentColor"'
        if _SHAPING.fullmatch(name) or (name in _SIZES and tag != "svg"):
            said = " ".join(code.split())[:_LONGEST]
            self.remarks.append(f"“{name}: {said}” is computed by its code, and was left out.")
        return ""

    def _value(self, code: str, depth: int) -> str | None:
        """Return the value of a literal, or of a property that has one by default."""
        literal = _LITERAL.fullmatch(code.strip())
        if literal is not None:
            return literal[1] if literal[1] is not None else literal[2]
        if depth > 2:
            return None
        alternative = _ALTERNATIVE.fullmatch(code)
        if alternative is not None:
            return self._value(alternative[1], depth + 1)
        word = _WORD.fullmatch(code.strip())
        if word is None or word[1] in ("true", "false", "null", "undefined"):
            return None
        said = re.search(
            rf"\b{re.escape(word[1])}\b[\"']?(?:\s*:\s*[\w\[\]|. ]+?)?\s*"
            rf"(?:=(?![=>{{])|:|:\s*\{{[^}}]*?\bdefault\s*:)\s*({_LITERAL.pattern})",
            self._around,
        )
        return None if said is None else self._value(said[1], depth + 1)

    def _style(self, code: str) -> str:
        """Return a style that is written as an object."""
        inner = code.removeprefix("{").removesuffix("}").strip()
        pairs = _PAIR.findall(inner)
        literal = _LITERAL.fullmatch(code)
        if not pairs and literal is not None and literal[1]:
            return f"style={quoteattr(literal[1])}"
        said = ";".join(f"{hyphenated(name)}:{value.strip(_QUOTES)}" for name, value in pairs)
        return f"style={quoteattr(said)}" if said else ""


def hyphenated(name: str) -> str:
    """Return a property's name as CSS writes it: ``strokeWidth`` is ``stroke-width``."""
    return _CAPITAL.sub(lambda match: f"-{match[0].lower()}", name)


def _closing(code: str, place: int) -> int:
    """Return where the brace that is open at ``place`` closes; strings in between are skipped."""
    depth, quote = 1, ""
    while place < len(code):
        letter = code[place]
        if quote:
            if letter == "\\":
                place += 1
            elif letter == quote:
                quote = ""
        elif code.startswith("/*", place):
            end = code.find("*/", place)
            place = len(code) if end < 0 else end + 1
        elif letter in "\"'`":
            quote = letter
        else:
            depth += {"{": 1, "}": -1}.get(letter, 0)
            if not depth:
                return place
        place += 1
    return len(code)
