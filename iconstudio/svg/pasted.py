"""Finds SVG drawings in text: by themselves, amid HTML or code, or in data addresses."""

import base64
import re
from collections.abc import Iterator, Sequence
from urllib.parse import unquote_to_bytes

from iconstudio.svg.decode import MAX_BYTES
from iconstudio.svg.pages import sheets_in, with_sheets

# No pattern looks twice at the same characters: whoever fills a clipboard may wish us ill.
_TAG = re.compile(
    r"<!--.*?(?:-->|\Z)|<!\[CDATA\[.*?(?:\]\]>|\Z)"
    r"|<(?P<open>(?:[\w.-]+:)?svg)(?=[\s/>])(?:[^>\"']|\"[^\"]*\"|'[^']*')*+(?:>|\Z|(?=[\"']))"
    r"|</(?P<close>(?:[\w.-]+:)?svg)\s*>",
    re.DOTALL | re.IGNORECASE,
)
_DOCTYPE = re.compile(r"<!DOCTYPE\s++(?:(?:[\w.-]+:)?svg\b|[^>\[]*+\[)", re.IGNORECASE)
_PROLOG = re.compile(
    r"<!DOCTYPE[^\[>]*+(?:\[.*?\]\s*)?>(?:\s|<!--(?:(?!-->).)*+-->)*+", re.DOTALL | re.IGNORECASE
)
_ADDRESS = re.compile(
    r"(?:(?<=\")(?P<double>)|(?<=')(?P<single>))?data:(image/[\w.+-]+)((?:;[\w=.+-]*)*),"
    r"((?(double)[^\"]*|(?(single)[^']*|[^\s\"'()<>]*)))",
    re.IGNORECASE,
)
"""An address in quotes goes on to the closing one."""
_DECLARATION = re.compile(r"[\s\ufeff]*<\?xml\s[^>]*\?>", re.IGNORECASE)
_SVG = "image/svg+xml"

_PART = re.compile(
    r"<(?:path|rect|circle|ellipse|line|poly(?:gon|line))\s[^<>]*=|&lt;svg\s|%3csvg(?:%20|\+)"
    r"|\\u003csvg|[\"']path[\"']\s*,|\bd[\"']?\s*[:=]\s*[\"'`][Mm]\s*[-+.\d]|\bImageVector\b"
    r"|\A\s*+[Mm]\s*+[-+.\d][\d\s,.eE+\-Mm]*+[LlHhVvCcSsQqTtAaZz][\d\s,.eE+\-MmLlHhVvCcSsQqTtAaZz]*+\Z",
    re.IGNORECASE,
)
"""What only a part of a drawing has, or one in code."""


def files_in(text: str) -> tuple[bytes, ...]:
    """Return the files of drawings that a text is, in UTF-8; nothing if it holds no drawing.

    A text with one drawing is a file: what is around it, style sheets and code, may paint it. Of
    several, each is one, with the style sheets around it. What XML declares of its encoding is left
    out: it is not that of the text.
    """
    spans = _spans(text)
    if len(spans) > 1:
        return tuple(_encoded(one) for one in _with_sheets(text, spans))
    found = bool(spans)
    if not found:
        addressed = tuple(data for kind, data in data_images(text) if kind == _SVG)
        if len(addressed) > 1:
            return addressed
        found = bool(addressed)
    whole = _DECLARATION.sub("", text, count=1) if _DECLARATION.match(text) else text
    return (_encoded(whole),) if found or is_part(text) else ()


def is_part(text: str) -> bool:
    """Whether a text is a part of a drawing, or code that draws, which its reader may know."""
    return _PART.search(text) is not None


def drawings_in(text: str) -> tuple[bytes, ...]:
    """Return the SVG drawings in a text, in UTF-8, each with its document type if it has one.

    What XML declares of its encoding is left out: it is not that of the text. A drawing that is
    cut short is returned to the end of the text, so that its reader may say so.
    """
    return tuple(_encoded(text[start:end]) for start, end in _spans(text))


def _spans(text: str) -> list[tuple[int, int]]:
    """Return where the drawings in a text begin and end."""
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
            found.append((start, end))
    if depth:
        found.append((start, len(text)))
    return found


def _with_sheets(text: str, spans: Sequence[tuple[int, int]]) -> Iterator[str]:
    """Yield the drawings at ``spans`` of a page, each with the style sheets elsewhere on it."""
    sheets, left = sheets_in(text), MAX_BYTES
    for start, end in spans:
        elsewhere = [one for one in sheets if one.end <= start or one.start >= end]
        drawing = with_sheets(text[start:end], elsewhere)
        left -= len(drawing)
        yield drawing if left > 0 else text[start:end]


def _encoded(text: str) -> bytes:
    return text.encode("utf-8", "replace")


def data_images(text: str) -> tuple[tuple[str, bytes], ...]:
    """Return the images that stand in a text as data addresses: type, ``image/png``, and bytes."""
    return tuple(
        (kind.lower(), _decoded(content, "base64" in how.lower()))
        for *_, kind, how, content in _ADDRESS.findall(text)
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
