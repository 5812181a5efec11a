"""Drawings in the code of web pages and apps (React, Vue, Svelte, Angular, React Native) as markup.

Values that are written out are read, and so are the ones that a property has by default. Nothing
of the code is run.
"""

import re
from collections.abc import Generator, Iterator
from xml.sax.saxutils import quoteattr

from iconstudio.svg.conditions import CHOSEN, REPEATED, Choices, closing, first_branches

_CODE = re.compile(
    r"[\w:-]=\s*\{|\{\s*\.\.\.|\{/\*|=\"\{|\s[@*#][\w.:-]+=|\sv-[a-z]+[\s=:>]|\s:[a-z][\w:-]*=[\"']"
    r"|\s\[[\w.-]+\]=|\{[#@:/]\w|\{\{|>\s*\{\s*[`\"']|\{%|<%|<\?(?:php\b|=)|@(?:if|switch|for\w*|unless)\b"
    r"|</?>|<(?:motion|[aA]nimated)\.|<Animated[A-Z]|>\s*\{[^{}<]*[?&]\s*\(?\s*<"
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
_VALID = re.compile(r"[A-Za-z_][\w.:-]*")
_BARE = re.compile(r"\s*=\s*([^\s>{\"']+)")
_LITERAL = re.compile(r"[\"'`]([^\"'`$]*)[\"'`]|([+-]?[\d.]+(?:e[+-]?\d+)?)")
_ALTERNATIVE = re.compile(r".*(?:\|\||\?\?)\s*([^|?:]+)", re.DOTALL)
_WORD = re.compile(r"(?:\w+\.)?([A-Za-z_$][\w$]*)")
_PAIR = re.compile(
    r"[\"']?([\w-]+)[\"']?\s*:\s*(\"[^\"]*\"|'[^']*'|`[^`$]*`|[+-]?[\d.]+)\s*(?:,|$)"
)
_BOUND = re.compile(r"(?::|v-bind:|\[attr\.|\[)([A-Za-z][\w:-]*)\]?")
_DRAWN = re.compile(r"<(?:path|rect|circle|ellipse|line|poly\w+|use|g|text)\b", re.IGNORECASE)
_CHOSEN_LITERAL = re.compile(rf"[^?]+\?(?![.?])\s*({_LITERAL.pattern})\s*:.+", re.DOTALL)
_CONDITION = re.compile(
    r"\s(v-if|v-else-if|v-else|v-show|x-if|x-show|\*ngIf|\[ngIf\]|\*ngSwitchCase|\[ngSwitchCase\]"
    r"|\*ngSwitchDefault|when|\*ngFor|v-for)(?:\s*=\s*(\"[^\"]*\"|'[^']*'|\{))?(?=[\s>/\w(!])"
)
_IS_ELSE = re.compile(r"\s*<[\w.-]+[^<>]*?\sv-else\b")
_SWITCHED = re.compile(r"\[ngSwitch\]\s*=\s*[\"']([^\"']*)[\"']")
_FALLBACK = re.compile(r"\sfallback\s*=\s*\{")
_CONJUNCTION = re.compile(r"([^<>&|?]+?)\s*&&\s*(\(?\s*<.*)", re.DOTALL)
_WRAPPER = re.compile(
    r"(</?)(?:(?:Show|Match|Switch|For|Index|Fragment|React\.Fragment|Suspense|ErrorBoundary"
    r"|Transition|TransitionGroup|AnimatePresence|ng-container|ng-template|template)(?![\w.-])"
    r"|(?=>))"
)
"""Elements of code that draw but what is in them."""
_ANIMATED = re.compile(r"(</?)(?:(?:motion|[aA]nimated)\.|Animated(?=[A-Z]))")
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

COMPUTED = "is computed by its code, and was left out."
COLOURED = "Colours that its code chooses were drawn in black."


def is_code(markup: str) -> bool:
    """Whether there may be code within a drawing."""
    return _CODE.search(markup) is not None


def without_code(markup: str, around: str) -> tuple[str, list[str]]:
    """Return a drawing without the code in it, and what could not be read, in sentences.

    ``around`` is the rest of the file, which may say what properties are by default.
    """
    choices = Choices()
    markup, remarks = first_branches(markup, choices)
    reader = _Reader(markup, around, choices)
    return "".join(reader.parts()), list(dict.fromkeys([*remarks, *reader.remarks]))


class _Reader:
    def __init__(self, markup: str, around: str, choices: Choices) -> None:
        self._markup = markup
        self._around = around
        self._choices = choices
        self._chains: dict[int, bool] = {}
        """Where elements end that others may stand in for, and whether one of these was taken."""
        self._conditional = _CONDITION.search(markup) is not None
        self._root = True
        self.remarks: list[str] = []

    def parts(self) -> Iterator[str]:
        """Yield the markup, piece by piece."""
        place = 0
        while match := _TOKEN.search(self._markup, place):
            yield _renamed(self._markup[place : match.start()])
            place = match.end()
            if match["verbatim"]:
                yield _TEMPLATE.sub(r">\1</", match[0])
            elif match["tag"]:
                end, instead = self._passed_over(match.start(), match[0][1:], place)
                self._root = False
                if end:
                    yield instead
                    place = end
                    continue
                yield _renamed(match[0])
                place = yield from self._attributes(place, match[0][1:].lower())
            else:
                end = closing(self._markup, place)
                yield self._text(self._markup[place:end])
                place = end + 1
        yield _renamed(self._markup[place:])

    def _passed_over(self, start: int, tag: str, place: int) -> tuple[int, str]:
        """Return where an element ends whose condition does not hold, and what is there instead.

        Where it holds, or there is none, it ends at 0.
        """
        plain = tag[0].islower() and tag != "ng-template"
        if self._root or (plain and not self._conditional):
            return 0, ""
        head_end = self._end_of_tag(place)
        head = f" {self._markup[place:head_end].strip()}"
        fallback = _FALLBACK.search(head)
        instead = "" if fallback is None else head[fallback.end() : closing(head, fallback.end())]
        found = _CONDITION.search(head[: fallback.start()] if fallback else head)
        if tag == "ng-template" and found is None:
            end = self._end_of_element(tag, head_end)
            self._tell_choice(self._markup[start:end])
            return end, ""
        if found is None or (found[1] == "when" and tag not in ("Show", "Match")):
            return 0, ""
        if found[1] in ("*ngFor", "v-for"):
            return 0, ""
        end = self._end_of_element(tag, head_end)
        if self._holds(tag, found, head, start, end):
            self._tell_choice(instead)
            return 0, ""
        self._tell_choice(self._markup[start:end])
        return end, self._branch(instead)

    def _holds(self, tag: str, found: re.Match[str], head: str, start: int, end: int) -> bool:
        """Whether an element's condition is taken to hold."""
        name, value = found[1], (found[2] or "").strip("\"'")
        if value == "{":
            value = head[found.end() : closing(head, found.end())]
        value = value.partition(";")[0]
        if "ngSwitch" in name:
            subject = _SWITCHED.findall(self._markup, 0, start)[-1:] or ["?"]
            value = f"{subject[0]} == {value or '?'}"
        chained = name.startswith("v-else") or tag == "Match"
        before = self._chains.get(len(self._markup[:start].rstrip())) if chained else None
        if before is None:
            before = name.startswith("v-else")
        holds = not before and self._choices.takes(value)
        if holds and name == "v-if" and _IS_ELSE.match(self._markup[end : end + 2000]):
            trial = _Reader(self._markup[start:end], self._around, Choices())
            "".join(trial.parts())
            holds = not any(COMPUTED in remark for remark in trial.remarks)
        self._chains[end] = before or holds
        return holds

    def _tell_choice(self, left_out: str) -> None:
        if _DRAWN.search(left_out):
            self.remarks.append(CHOSEN)

    def _branch(self, code: str) -> str:
        """Return a branch, which may be an element, in parentheses or not, or code again."""
        code = code.strip()
        if code.startswith("(") and closing(code, 1) == len(code) - 1:
            code = code[1:-1].strip()
        if not code.startswith("<"):
            return self._text(code)
        reader = _Reader(code, self._around, self._choices)
        found = "".join(reader.parts())
        self.remarks += reader.remarks
        return found

    def _end_of_tag(self, place: int) -> int:
        """Return where the tag ends in which ``place`` is."""
        remarks = self.remarks[:]
        attributes = self._attributes(place, "")
        while True:
            try:
                next(attributes)
            except StopIteration as stop:
                self.remarks = remarks
                return min(int(stop.value) + 1, len(self._markup))

    def _end_of_element(self, tag: str, place: int) -> int:
        """Return where an element ends whose first tag ends at ``place``."""
        if self._markup[:place].endswith("/>"):
            return place
        depth, first = 1, place
        for match in re.compile(rf"<(/?){re.escape(tag)}(?![\w.-])").finditer(self._markup, place):
            end = self._end_of_tag(match.end())
            depth += -1 if match[1] else not self._markup[:end].endswith("/>")
            if not depth:
                return end
        return first

    def _choice(self, code: str) -> str | None:
        """Return the branch that is taken of ``a ? <b/> : <c/>``; None if it is nothing such."""
        conjunction = _CONJUNCTION.fullmatch(code.strip())
        if conjunction is not None:
            said = conjunction[1].strip()
            opposite = said[1:].strip() if said.startswith("!") else f"!{said}"
            paired = re.search(rf"(?<![!\w.]){re.escape(opposite)}\s*&&\s*\(?\s*<", self._markup)
            if paired is None:
                return None
            self.remarks.append(CHOSEN)
            return self._branch(conjunction[2]) if self._choices.takes(said) else ""
        found = _ternary(code)
        if found is None or not all(map(_DRAWN.search, found[1:])):
            return None
        self.remarks.append(CHOSEN)
        return self._branch(found[1 if self._choices.takes(found[0]) else 2])

    def _text(self, code: str) -> str:
        """Return what code between elements comes to."""
        literal = _LITERAL.fullmatch(code.strip())
        if literal is not None:
            return (literal[1] or literal[2] or "").replace("<", "&lt;")
        if _DRAWN.search(code) and not code.lstrip().startswith("/*"):
            chosen = self._choice(code)
            if chosen is not None:
                return chosen
            self.remarks.append(
                "What its code draws, or does not, as the case may be, is left out."
            )
        return ""

    def _attributes(self, place: int, tag: str) -> Generator[str, None, int]:
        """Yield the attributes of an element as SVG writes them; return where they end."""
        markup = self._markup
        while place < len(markup) and markup[place] != ">":
            if markup[place] == "{":
                place = closing(markup, place + 1) + 1  # {...props}
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
                if _VALID.fullmatch(name[0]):
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
                self.remarks.append(REPEATED)
            return ""
        if inner.startswith("{") and closing(inner, 1) == len(inner) - 1:
            return self._computed(name, inner.strip("{}"), tag)
        return f"{name}={value}"

    def _computed(self, name: str, code: str, tag: str) -> str:
        """Return an attribute whose value is code."""
        code = code.strip()
        if name == "style":
            return self._style(code)
        value = self._value(code, 0)
        chosen = None if name in _PAINTS else _CHOSEN_LITERAL.fullmatch(code)
        if value is None and chosen is not None:
            value = self._value(chosen[1], 0)
            self.remarks.append(CHOSEN)
        if value is not None:
            return f"{name}={quoteattr(value)}"
        if name in _PAINTS:
            self.remarks.append(COLOURED)
            return f'{name}="currentColor"'
        if _SHAPING.fullmatch(name) or (name in _SIZES and tag != "svg"):
            said = " ".join(code.split())[:_LONGEST]
            self.remarks.append(f"“{name}: {said}” {COMPUTED}")
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


def _renamed(piece: str) -> str:
    """Return markup in which elements of code are those of SVG that draw the same."""
    return _ANIMATED.sub(r"\1", _WRAPPER.sub(r"\1g", piece))


def _ternary(code: str) -> tuple[str, str, str] | None:
    """Return condition and branches of ``a ? b : c``; None if it is nothing such."""
    middle = _outside(code, "?", 0)
    if middle < 0:
        return None
    last = _outside(code, ":", middle + 1)
    return None if last < 0 else (code[:middle], code[middle + 1 : last], code[last + 1 :])


_TAG = re.compile(r"<(/?)[\w.-]*(?:[^<>\"'{]|\"[^\"]*\"|'[^']*'|\{(?:[^{}]|\{[^{}]*\})*\})*?(/?)>")


def _outside(code: str, sign: str, place: int) -> int:
    """Return where a sign is, outside of brackets, strings and elements; -1 if nowhere."""
    depth = nested = 0
    while place < len(code):
        letter = code[place]
        tag = _TAG.match(code, place) if letter == "<" else None
        if tag is not None:
            depth += -1 if tag[1] else not tag[2]
            place = tag.end()
            continue
        if letter in "([{" or (letter in "\"'`" and not depth):
            if letter in "\"'`":
                place = code.find(letter, place + 1)
                if place < 0:
                    return -1
            else:
                place = closing(code, place + 1)
        elif not depth and letter == "?" and code[place + 1 : place + 2] in (".", "?"):
            place += 1
        elif not depth and letter == "?" and sign == ":":
            nested += 1
        elif not depth and letter == sign:
            if not nested:
                return place
            nested -= 1
        place += 1
    return -1


def hyphenated(name: str) -> str:
    """Return a property's name as CSS writes it: ``strokeWidth`` is ``stroke-width``."""
    return _CAPITAL.sub(lambda match: f"-{match[0].lower()}", name)
