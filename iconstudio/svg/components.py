"""Drawings in the code of web pages and apps (React, Vue, Svelte, Angular, React Native) as markup.

Values that are written out are read, and so are the ones that a property has by default; lists
that are written out are gone through. Nothing of the code is run.
"""

import html
import re
from collections.abc import Generator, Iterator
from typing import Any
from xml.sax.saxutils import escape

from iconstudio.model import IconstudioError
from iconstudio.svg import loops
from iconstudio.svg.attributes import Attributes, short
from iconstudio.svg.conditions import CHOSEN, REPEATED, Choices, closing, first_branches, ternary
from iconstudio.svg.geometry import SHAPES
from iconstudio.svg.javascript import Element, Names, called
from iconstudio.svg.methods import said, truth
from iconstudio.svg.syntax import UnknownError, expression, text_of

_CODE = re.compile(
    r"[\w:-]=\s*\{|\{\s*\.\.\.|\{/\*|=\"\{|\s[@*#][\w.:-]+=|\sv-[a-z]+[\s=:>]|\s:[a-z][\w:-]*=[\"']"
    r"|\s\[[\w.-]+\]=|\{[#@:/]\w|\{\{|>\s*\{\s*[`\"']|\{%|<%|<\?(?:php\b|=)|@(?:if|switch|for\w*|unless)\b"
    r"|\sx-(?:for|if|show|bind|data)[=:]|</?>|=\"[^\"<>{]*\{|/>\s*\{|</[\w.:]+>\s*\{|<(?:svg|g)\b[^>]*>\s*\{|<(?:motion|[aA]nimated)\.|<Animated[A-Z]|>\s*\{[^{}<]*[?&]\s*\(?\s*<"
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
_LOOP = re.compile(r"\s(?:v-for|x-for|\*ngFor)\s*=\s*(\"[^\"]*\"|'[^']*'|\{)")
_WORD = re.compile(r"[\w$.?]+(?:\[.*\])?", re.DOTALL)
_EACH = re.compile(r"\s(?:each|of)\s*=\s*\{")
_TITLED = re.compile(r"<(?:title|desc|style)\b[^<]*$", re.IGNORECASE)
_GIVEN = re.compile(r"(?:[\w$]+\.)*(?:children|slots?|title|titleId|desc|default)\b.*", re.DOTALL)
"""What others put into a drawing."""
_DRAWN = re.compile(r"<(?:path|rect|circle|ellipse|line|poly\w+|use|g|text)\b", re.IGNORECASE)
_SHAPE = re.compile(r"<(?:path|rect|circle|ellipse|line|poly\w+|use|text)\b", re.IGNORECASE)
_CONDITION = re.compile(
    r"\s(v-if|v-else-if|v-else|v-show|x-if|x-show|\*ngIf|\[ngIf\]|\*ngSwitchCase|\[ngSwitchCase\]"
    r"|\*ngSwitchDefault|when)(?:\s*=\s*(\"[^\"]*\"|'[^']*'|\{))?(?=[\s>/\w(!])"
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
_READ = 10
"""Steps for an element."""

LEFT_OUT = "What its code draws by “{}” was left out. Save the SVG that it draws."
TOO_OFTEN = "Its code draws too many elements. Save the SVG that it draws, and simplify it."


def is_code(markup: str) -> bool:
    """Whether there may be code within a drawing."""
    return _CODE.search(markup) is not None


def without_code(markup: str, text: str) -> tuple[str, list[str]]:
    """Return a drawing without the code in it, and what could not be read, in sentences.

    ``text`` is the whole file, which may say what properties are by default.

    Raises
    ------
    IconstudioError
        If it repeats its elements without end.
    """
    names = Names.of(text)
    choices = Choices(lambda condition: _known(condition, names))
    markup, remarks = first_branches(markup, choices)
    reader = _Reader(markup, names, choices)
    return "".join(reader.parts()), list(dict.fromkeys([*remarks, *reader.remarks]))


def _known(condition: str, names: Names) -> bool | None:
    """Whether a condition holds; None if that is not written out."""
    try:
        return truth(names.value(condition))
    except UnknownError:
        return None


class _Reader:
    def __init__(self, markup: str, names: Names, choices: Choices, root: bool = True) -> None:
        self._markup = markup
        self._names = names
        self._choices = choices
        self._chains: dict[int, bool] = {}
        """Where elements end that others may stand in for, and whether one of these was taken."""
        self._conditional = bool(_CONDITION.search(markup) or _LOOP.search(markup))
        self._root = root
        self.remarks: list[str] = []
        self._attributes = Attributes(markup, names, choices, self.remarks)

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
                place = yield from self._element(match[0], place)
            else:
                end = closing(self._markup, place)
                if not _TITLED.search(self._markup, max(0, place - 200), place - 1):
                    yield self._text(self._markup[place:end])
                place = end + 1
        yield _renamed(self._markup[place:])

    def _element(self, head: str, place: int) -> Generator[str, None, int]:
        """Yield an element's tag, up to its end; return where that is.

        A shape whose place is not known is left out as a whole.
        """
        tag = head[1:].lower()
        self._attributes.misplaced = False
        attributes: list[str] = []
        end = _exhausted(self._attributes.read(place, tag), attributes)
        if self._attributes.misplaced and tag in SHAPES:
            return self._end_of_element(head[1:], min(end + 1, len(self._markup)))
        yield _renamed(head)
        yield from attributes
        return end

    def _read(self, element: str, names: Names) -> str:
        """Return what an element comes to where names mean something else."""
        if not names.count(_READ):
            raise IconstudioError(TOO_OFTEN)
        reader = _Reader(element, names, self._choices, root=False)
        found = "".join(reader.parts())
        self.remarks += reader.remarks
        return found

    def _drawn(self, value: Any) -> str:
        """Return the markup of what code has for a value."""
        match value:
            case Element():
                return self._read(value.source, value.names)
            case list():
                return "".join(map(self._drawn, value))
            case str() | float():
                return escape(said(value)) if not isinstance(value, bool) else ""
        return ""

    def _repeated(self, element: str, loop: str) -> str:
        """Return an element for every turn of a loop; once if its list is not written out."""
        try:
            turns = loops.turns(loop, self._names)
        except UnknownError:
            found = self._read(element, loops.unknown_turn(loop, self._names))
            if _SHAPE.search(found):
                self.remarks.append(REPEATED)
            return found
        return "".join(self._read(element, names) for names in turns)

    def _passed_over(self, start: int, tag: str, place: int) -> tuple[int, str]:
        """Return where an element ends whose condition does not hold, and what is there instead.

        Where it holds, or there is none, it ends at 0.
        """
        plain = tag[0].islower() and tag != "ng-template"
        if self._root or (plain and not self._conditional):
            return 0, ""
        head_end = self._end_of_tag(place)
        head = self._markup[place:head_end]
        looped = self._looped(tag, start, place, head_end)
        if looped is not None:
            return looped
        head = f" {head.strip()}"
        fallback = _FALLBACK.search(head)
        instead = "" if fallback is None else head[fallback.end() : closing(head, fallback.end())]
        found = _CONDITION.search(head[: fallback.start()] if fallback else head)
        if tag == "ng-template" and found is None:
            end = self._end_of_element(tag, head_end)
            self._tell_choice(self._markup[start:end])
            return end, ""
        if found is None or (found[1] == "when" and tag not in ("Show", "Match")):
            return 0, ""
        end = self._end_of_element(tag, head_end)
        if self._holds(tag, found, head, start, end):
            self._tell_choice(instead)
            return 0, ""
        self._tell_choice(self._markup[start:end])
        return end, self._branch(instead)

    def _looped(self, tag: str, start: int, place: int, head_end: int) -> tuple[int, str] | None:
        """Return where an element ends, and what is there instead, if code makes it several."""
        markup, head = self._markup, self._markup[place:head_end]
        end = self._end_of_element(tag, head_end)
        if loop := _LOOP.search(head):
            last = loop.end() if loop[1] != "{" else closing(head, loop.end()) + 1
            list_ = loop[1][1:-1] if loop[1] != "{" else head[loop.end() : last - 1]
            without = markup[start:place] + head[: loop.start()] + head[last:]
            return end, self._repeated(without + markup[head_end:end], html.unescape(list_).strip())
        if tag in ("For", "Index") and (each := _EACH.search(head)):
            items = head[each.end() : closing(head, each.end())]
            inner = markup[head_end:end].rpartition("</")[0].strip()
            return end, self._text(f"({items}).map({inner[1:-1]})")
        if tag[0].isupper() and tag.isalnum():
            try:
                return end, self._drawn(_component(markup[start:end], self._names))
            except UnknownError:
                return None
        return None

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
            trial = _Reader(self._markup[start:end], self._names, Choices())
            holds = _DRAWN.search("".join(trial.parts())) is not None and not any(
                "computed" in remark for remark in trial.remarks
            )
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
        return self._read(code, self._names)

    def _end_of_tag(self, place: int) -> int:
        """Return where the tag ends in which ``place`` is."""
        silent = Attributes(self._markup, self._names, self._choices, [])
        end = _exhausted(silent.read(place, ""), [])
        return min(end + 1, len(self._markup))

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
        found = ternary(code)
        if found is None or not all(map(_DRAWN.search, found[1:])):
            return None
        self.remarks.append(CHOSEN)
        return self._branch(found[1 if self._choices.takes(found[0]) else 2])

    def _text(self, code: str) -> str:
        """Return what code between elements comes to."""
        code = code.strip()
        if code.startswith("{") and code.endswith("}"):
            code = code[1:-1].strip()
        try:
            return self._drawn(self._names.value(code))
        except UnknownError:
            pass
        if code.startswith(("/*", "//")) or not code or _GIVEN.fullmatch(code):
            return ""
        if _DRAWN.search(code):
            chosen = self._choice(code)
            if chosen is not None:
                return chosen
        if _DRAWN.search(code) or ("<" not in code and ("(" in code or _WORD.fullmatch(code))):
            self.remarks.append(LEFT_OUT.format(short(code)))
        return ""


def _exhausted(pieces: Generator[str, None, int], into: list[str]) -> int:
    """Add what a generator yields to a list; return what it returns."""
    while True:
        try:
            into.append(next(pieces))
        except StopIteration as stop:
            return int(stop.value)


def _renamed(piece: str) -> str:
    """Return markup in which elements of code are those of SVG that draw the same."""
    return _ANIMATED.sub(r"\1", _WRAPPER.sub(r"\1g", piece))


def _component(code: str, names: Names) -> Any:
    """Return what an element draws whose name is that of a function in the file.

    Raises
    ------
    UnknownError
        If there is no such function, or it is not written out what it draws.
    """
    element = expression(code)
    while element.type in ("expression_statement", "parenthesized_expression"):
        element = element.named_children[0]
    tag = element.child_by_field_name("open_tag") or element
    function = names[text_of(tag.child_by_field_name("name"))]
    properties: dict[str, Any] = {}
    for one in tag.named_children:
        if one.type == "jsx_attribute":
            name, *values = map(text_of, one.named_children)
            said = values[0] if values else "true"
            try:
                properties[name] = names.value(said[1:-1] if said.startswith("{") else said)
            except UnknownError:
                continue
    if tag is not element:
        inner = "".join(map(text_of, element.named_children[1:-1]))
        properties["children"] = Element(f"<>{inner}</>", names)
    return called(function, properties)
