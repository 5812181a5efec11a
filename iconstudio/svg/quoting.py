"""Drawings that other texts quote: JSON, strings of code, style sheets, escaped markup."""

import html
import json
import re
from collections.abc import Iterator
from urllib.parse import unquote

from iconstudio.svg.decode import decode
from iconstudio.svg.lenient import SEVERAL

_ROOT = re.compile(r"<(?:[\w.-]+:)?svg[\s>/]", re.IGNORECASE)
_ADDRESS = re.compile(
    r"\"(data:image/svg[^\"]+)\"|'(data:image/svg[^']+)'|\b(data:image/svg[^,]{0,99},[^\s\"'()<>]+)",
    re.IGNORECASE,
)
_BETWEEN_QUOTES = re.compile(r"<(?:[\w.-]+:)?svg\b[^>]*?=\s*\\[\"']", re.IGNORECASE)
_AS_NUMBER = re.compile(r"\\(?:u003c|x3c)(?:[\w.-]+:)?svg\b", re.IGNORECASE)
_ESCAPE = re.compile(r"\\(?:u([0-9a-fA-F]{4})|x([0-9a-fA-F]{2})|(.))", re.DOTALL)
_BLANKS = {"n": "\n", "t": "\t", "r": "\r"}
_ENTITY = re.compile(r"&(?:amp;)?(?:lt|#60|#x3c);(?:[\w.-]+:)?svg\b", re.IGNORECASE)
_PERCENT = re.compile(r"%3Csvg(?:%20|\+|%3E)", re.IGNORECASE)
_DEEPEST = 3


def unquoted(text: str, depth: int = 0) -> tuple[str, list[str]]:
    """Return the drawing that a text quotes, and a sentence if it quotes several.

    A text that quotes none is returned as it is.

    Raises
    ------
    IconstudioError
        If a ``data:`` address in it is cut short.
    """
    found = _quoted(text) if depth < _DEEPEST else []
    if not found:
        return text, []
    inner, remarks = unquoted(found[0], depth + 1)
    return inner, remarks or ([SEVERAL] if len(set(found)) > 1 else [])


def _quoted(text: str) -> list[str]:
    """Return the drawings that a text quotes, in their order."""
    if text[:1] in ("{", "[", '"') and (found := list(_in_json(text))):
        return found
    root = _ROOT.search(text)
    address = _ADDRESS.search(text)
    if address is not None and (root is None or address.start() < root.start()):
        found = ["".join(filter(None, one)) for one in _ADDRESS.findall(text, address.start())]
        return [decode(one.encode()) for one in dict.fromkeys(found)][:2]
    if root is not None:
        between = _BETWEEN_QUOTES.match(text, root.start())
        return [_ESCAPE.sub(_character, text[root.start() :])] if between else []
    for pattern, plain in (
        (_AS_NUMBER, lambda quoted: _ESCAPE.sub(_character, quoted)),
        (_ENTITY, html.unescape),
        (_PERCENT, unquote),
    ):
        if match := pattern.search(text):
            return [plain(text[match.start() :])]
    return []


def _in_json(text: str) -> Iterator[str]:
    """Yield the strings of JSON in which there are drawings."""
    try:
        open_ = [json.loads(text)]
    except (ValueError, RecursionError):
        return
    while open_:
        one = open_.pop()
        if isinstance(one, str) and (_ROOT.search(one) or _quoted(one)):
            yield one
        elif isinstance(one, dict):
            open_ += reversed(one.values())
        elif isinstance(one, list):
            open_ += reversed(one)


def _character(match: re.Match[str]) -> str:
    number = match[1] or match[2]
    return chr(int(number, 16)) if number else _BLANKS.get(match[3], match[3])
