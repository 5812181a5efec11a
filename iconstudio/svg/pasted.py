"""Finds SVG drawings in text: by themselves, in the middle of HTML, or in data addresses."""

import base64
import re
from urllib.parse import unquote_to_bytes

# No pattern looks twice at the same characters: whoever fills a clipboard may wish us ill.
_TAG = re.compile(
    r"<!--.*?(?:-->|\Z)|<!\[CDATA\[.*?(?:\]\]>|\Z)"
    r"|<(?P<open>(?:[\w.-]+:)?svg)(?=[\s/>])(?:[^>\"']|\"[^\"]*\"|'[^']*')*+(?:>|\Z|(?=[\"']))"
    r"|</(?P<close>(?:[\w.-]+:)?svg)\s*>",
    re.DOTALL | re.IGNORECASE,
)
_DOCTYPE = re.compile(r"<!DOCTYPE\s+(?:[\w.-]+:)?svg\b", re.IGNORECASE)
_PROLOG = re.compile(
    r"<!DOCTYPE[^\[>]*+(?:\[.*?\]\s*)?>(?:\s|<!--(?:(?!-->).)*+-->)*+", re.DOTALL | re.IGNORECASE
)
_ADDRESS = re.compile(r"data:(image/[\w.+-]+)((?:;[\w=.+-]*)*),([^\s\"'()<>]*)", re.IGNORECASE)

_PART = re.compile(
    r"<(?:path|rect|circle|ellipse|line|poly(?:gon|line))\s[^<>]*=|&lt;svg\s|%3csvg(?:%20|\+)"
    r"|\\u003csvg|[\"']path[\"']\s*,|\bd[\"']?\s*[:=]\s*[\"'`][Mm]\s*[-+.\d]|\bImageVector\b"
    r"|\A\s*+[Mm]\s*+[-+.\d][\d\s,.eE+\-Mm]*+[LlHhVvCcSsQqTtAaZz][\d\s,.eE+\-MmLlHhVvCcSsQqTtAaZz]*+\Z",
    re.IGNORECASE,
)
"""What only a part of a drawing has, or one in code."""


def is_part(text: str) -> bool:
    """Whether a text is a part of a drawing, or code that draws, which its reader may know."""
    return _PART.search(text) is not None


def drawings_in(text: str) -> tuple[bytes, ...]:
    """Return the SVG drawings in a text, in UTF-8, each with its document type if it has one.

    What XML declares of its encoding is left out: it is not that of the text. A drawing that is
    cut short is returned to the end of the text, so that its reader may say so.
    """
    found, depth, start, end = [], 0, 0, 0
    for tag in _TAG.finditer(text):
        if tag["open"] and depth == 0:
            start = _with_doctype(text, end, tag.start())
        if tag["open"] and not tag[0].endswith("/>"):
            depth += 1
        elif depth and tag["close"]:
            depth -= 1
        elif not (tag["open"] and depth == 0):
            continue
        if depth == 0:
            end = tag.end()
            found.append(text[start:end])
    if depth:
        found.append(text[start:])
    return tuple(one.encode("utf-8", "replace") for one in found)


def data_images(text: str) -> tuple[tuple[str, bytes], ...]:
    """Return the images that stand in a text as data addresses: type, ``image/png``, and bytes."""
    return tuple(
        (kind.lower(), _decoded(content, "base64" in how.lower()))
        for kind, how, content in _ADDRESS.findall(text)
    )


def _with_doctype(text: str, end: int, start: int) -> int:
    """Return where a drawing begins whose first tag is at ``start``; nothing before ``end``."""
    types = list(_DOCTYPE.finditer(text, end, start))
    return (
        types[-1].start() if types and _PROLOG.fullmatch(text, types[-1].start(), start) else start
    )


def _decoded(content: str, in_base_64: bool) -> bytes:
    data = unquote_to_bytes(content)
    if not in_base_64:
        return data
    try:
        return base64.b64decode(data + b"=" * (-len(data) % 4))
    except ValueError:
        return b""
