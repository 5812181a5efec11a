"""Conditions in templates of drawings: of several branches, the first is taken.

Blocks of Svelte, Angular, Handlebars, Mustache, Go, Jinja, Twig, Liquid, Blade, ERB, EJS and PHP
are known. Conditions are not computed, but no two branches are taken that exclude each other.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass

from iconstudio.svg.loops import is_loop

CHOSEN = (
    "Its code chooses between several drawings, of which the first that its values allow was taken."
)
REPEATED = "What its code draws again and again was drawn once."

_DIRECTIVE = re.compile(
    r"\{%[-+]?\s*(?P<percent>.*?)\s*[-+]?%\}"
    r"|<%[-_]?(?P<shown>[=#]?)\s*(?P<ruby>.*?)\s*[-_]?%>"
    r"|<\?(?:php\b|(?P<echo>=))\s*(?P<php>.*?);?\s*\?>"
    r"|\{\{[~-]?\s*(?P<bars>[^{}]*?)\s*[~-]?\}\}"
    r"|\{\s*(?P<svelte>[#:/][a-z](?:[^{}]|\{[^{}]*\})*)\}",
    re.DOTALL,
)
_ELSE = re.compile(
    r"(?:[:}]\s*)?(?:(?:else\s*if|elsif|elif|elseif|when|case)\b(?P<condition>.*)"
    r"|(?:else|default|then|catch|empty)\b.*|\^)",
    re.DOTALL,
)
_CLOSE = re.compile(r"/\s*(?P<name>[\w.-]+)|end(?P<word>[a-z]*)|\}.*[^{]|\}")
_OPEN = re.compile(
    r"[#^]?\s*(?P<word>if|unless|for|case|switch|foreach|while|each|range|with|await|block|define"
    r"|key|snippet)\b(?P<condition>.*)|(?P<section>[#^])\s*(?P<name>[\w.-]+).*",
    re.DOTALL,
)
_OPEN_IN_CODE = re.compile(
    r"(?P<word>if|unless|case|switch)\b(?P<condition>.*?)(?:\bthen|:|\{)?|.*(?:\bdo(?:\s*\|.*\|)?|\{|:)",
    re.DOTALL,
)
_DEFINING = re.compile(
    r"(?:\w+\s+)*(?:function|class|def|namespace)\b|\$\w+\s*=\s*(?:function|fn)\b"
)
"""Code whose block is not repeated."""
_AT = re.compile(
    r"(?<![\w.@])@(if|elseif|else|unless|for|foreach|forelse|while|switch|case|default|empty|break"
    r"|end[a-z]+)\b[ \t]*(?=(\()?)"
)
_NEXT_BRACE = re.compile(
    r"\s*(?:@?(else)(?:\s+(if)\s*(?=(\()))?|@(empty)|@(case|default)\s*(?=(\()?))"
)
_LOOPS = ("for", "foreach", "forelse", "while", "each", "range", "do")
_SELECTING = ("case", "switch")
_COMPARED = re.compile(r"(.+?)\s*(==|!=)\s*(.+)")
_UNTOLD = re.compile(r"\s*(?:<(title|desc)\b[^>]*>.*</\1\s*>)?\s*", re.DOTALL)


class Choices:
    """Which conditions were taken to hold."""

    def __init__(self, known: Callable[[str], bool | None] = lambda _: None) -> None:
        self._held: list[str] = []
        self._known = known

    def takes(self, condition: str) -> bool:
        """Whether a condition may hold beside those taken before; from now on it, or its opposite.

        An empty one holds.
        """
        said = _normal(condition)
        if not said:
            return True
        known = self._known(said)
        if known is not None:
            return known
        holds = not any(_exclude(said, held) for held in self._held)
        self._held.append(said if holds else _opposite(said))
        return holds


def _normal(condition: str) -> str:
    said = re.sub(r"\s+", " ", condition).strip(" :;")
    while said.startswith("(") and closing(said, 1) == len(said) - 1:
        said = said[1:-1].strip()
    said = re.sub(r"^(?:not\b|unless\b|!(?!=))\s*", "!", said)
    said = re.sub(r"\s+is\s+not\s+|!==", "!=", re.sub(r"===", "==", said))
    if said.startswith("!("):
        said = f"!{_normal(said[1:])}"
    return said.removeprefix("!!").replace("'", '"')


def _opposite(said: str) -> str:
    return said[1:] if said.startswith("!") else f"!{said}"


def _exclude(one: str, other: str) -> bool:
    """Whether two conditions cannot hold at once."""
    if one == _opposite(other):
        return True
    if any(sign in said for sign in ("&&", "||", " and ", " or ") for said in (one, other)):
        return False
    first, second = _COMPARED.fullmatch(one), _COMPARED.fullmatch(other)
    if not first or not second or first[1] != second[1]:
        return False
    if first[2] == second[2]:
        return first[2] == "==" and first[3] != second[3]
    return first[3] == second[3]


@dataclass
class _Block:
    word: str
    subject: str
    active: bool
    """Whether the branch at hand is taken."""
    taken: bool
    """Whether one was."""
    loop: str = ""
    """Over what it is repeated."""


def first_branches(text: str, choices: Choices) -> tuple[str, list[str]]:
    """Return a template's markup with the first branch of every block, and what to say of it."""
    source = _with_percents(text)
    blocks: list[_Block] = []
    parts, remarks, place = [], [], 0

    def add(piece: str) -> None:
        if all(block.active for block in blocks):
            parts.append(piece)
        elif not _UNTOLD.fullmatch(piece):
            remarks.append(CHOSEN)

    for match in _DIRECTIVE.finditer(source):
        add(source[place : match.start()])
        place = match.end()
        before = blocks[:]
        if not _follow(match, blocks, choices, remarks):
            add(_shown(match))
        elif len(blocks) > len(before) and blocks[-1].loop:
            add(f"<g v-for={{{blocks[-1].loop}}}>")
        elif len(blocks) < len(before) and before[-1].loop:
            add("</g>")
    add(source[place:])
    if blocks:
        return text, []  # it is no template, or one that is not understood
    return "".join(parts), remarks


def _follow(
    match: re.Match[str], blocks: list[_Block], choices: Choices, remarks: list[str]
) -> bool:
    """Open, change or close a block; return false if a directive does nothing of these."""
    kind = match.lastgroup or ""
    said = match[kind]
    if match["shown"] or match["echo"]:
        return False
    branch = _ELSE.fullmatch(said)
    if branch is not None and blocks and (kind != "svelte" or said.startswith(":")):
        _next_branch(branch["condition"] or "", blocks, choices)
        return True
    close = _CLOSE.fullmatch(said)
    if close is not None and (kind != "bars" or not close["word"]):
        name = close["name"] or close["word"]
        if blocks and (not name or name == blocks[-1].word):
            blocks.pop()
        return True
    opened = (_OPEN_IN_CODE if kind in ("ruby", "php") else _OPEN).fullmatch(said)
    if opened is None or (kind == "svelte" and not said.startswith("#")):
        return False
    found = opened.groupdict()
    word = found.get("name") or found["word"] or ("define" if _DEFINING.match(said) else "do")
    condition = found["condition"] or ""
    if found.get("name"):
        condition = found["section"].replace("#", "").replace("^", "!") + word
    loop = ""
    if word in _LOOPS:
        if kind in ("svelte", "percent") and is_loop(condition):
            loop = condition.strip()
        else:
            remarks.append(REPEATED)
    if word == "unless":
        condition = f"!({condition})"
    asked = word in ("if", "unless") or bool(found.get("name"))
    reached = all(block.active for block in blocks)
    holds = not asked or (reached and choices.takes(condition))
    taken = bool(loop) or (holds and word not in _SELECTING)
    blocks.append(_Block(word, _normal(condition), holds, taken, loop))
    return True


def _next_branch(condition: str, blocks: list[_Block], choices: Choices) -> None:
    block = blocks[-1]
    if block.word in _SELECTING and condition:
        condition = f"{block.subject} == {_normal(condition)}"
    reached = all(outer.active for outer in blocks[:-1])
    block.active = not block.taken and reached and choices.takes(condition)
    block.taken |= block.active


def _shown(match: re.Match[str]) -> str:
    """Return a directive that is no block: as code in braces if it shows a value."""
    if match["ruby"] is not None:
        return f"{{{{{match['ruby']}}}}}" if match["shown"] == "=" else ""
    if match["php"] is not None:
        said = match["php"].removeprefix("echo ")
        return f"{{{{{said}}}}}" if match["echo"] or said != match["php"] else ""
    return "" if match["percent"] is not None else match[0]


def _with_percents(text: str) -> str:
    """Write the blocks of Angular and Razor, in braces, and of Blade as Jinja does."""
    parts, place = [], 0
    while match := _AT.search(text, place):
        parts.append(text[place : match.start()])
        word, place = match[1], match.end()
        condition = ""
        if match[2]:
            end = closing(text, place + 1)
            condition, place = text[place + 1 : end], end + 1
        brace = re.compile(r"\s*\{").match(text, place)
        if brace is None:
            said = {"elseif": "elif", "forelse": "for", "endforelse": "endfor"}.get(word, word)
            parts.append("" if word == "break" else f"{{% {said} {condition} %}}")
            continue
        block, place = _in_braces(text, word, condition, brace.end())
        parts.append(block)
    return "".join([*parts, text[place:]])


def _in_braces(text: str, word: str, condition: str, place: int) -> tuple[str, int]:
    """Return a block in braces, whose first is open at ``place``, and where it ends."""
    end = closing(text, place)
    inner = _with_percents(text[place:end])
    if word in ("case", "default"):
        said = f"when {condition}" if word == "case" else "else"
        return f"{{% {said} %}}{inner}", end + 1
    parts = [f"{{% {word} {condition} %}}{inner}"]
    while (match := _NEXT_BRACE.match(text, end + 1)) and not match[5]:
        place, condition = match.end(), ""
        if match[3]:
            closed = closing(text, place + 1)
            condition, place = text[place + 1 : closed], closed + 1
        place = text.find("{", place) + 1
        if not place:
            break
        end = closing(text, place)
        parts.append(f"{{% {'elif ' + condition if match[2] else 'else'} %}}")
        parts.append(_with_percents(text[place:end]))
    return "".join([*parts, f"{{% end{word} %}}"]), end + 1


_PAIRS = {"{": 1, "(": 1, "[": 1, "}": -1, ")": -1, "]": -1}


def closing(code: str, place: int) -> int:
    """Return where the bracket that is open at ``place`` closes; strings in between are skipped."""
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
            depth += _PAIRS.get(letter, 0)
            if not depth:
                return place
        place += 1
    return len(code)


def ternary(code: str) -> tuple[str, str, str] | None:
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
