"""The markup of a drawing, cut out of what was copied or saved with it: a page, mail, or code."""

import re

from iconstudio.model import IconstudioError
from iconstudio.svg import android, pages, quoting, signatures

_ROOT = re.compile(r"<([\w.-]+:)?svg[\s>/]", re.IGNORECASE)
_PROLOG = re.compile(
    r"\s*(?:<\?.*?\?>|<!--.*?-->|<!DOCTYPE\s(?:\s*(?:[\w.-]+:)?svg\b[^>\[]*(?:\[.*?\]\s*)?"
    r"|[^>\[]*\[.*?\]\s*)>)",
    re.DOTALL,
)
"""What declares entities is a part of the document, whatever it is the type of."""
_LONE = re.compile(
    r"(?:\s|<!--.*?-->)*+<(?:path|rect|circle|ellipse|line|polyline|polygon|g|defs|symbol|text)"
    r"(?=[\s/>])(?!.*<(?:[\w.-]+:)?svg[\s>/])",
    re.DOTALL | re.IGNORECASE,
)
"""Elements of a drawing without its root."""


def markup_of(text: str) -> tuple[str, list[str]]:
    """Return the SVG document in a text, and what could not be read around it, in sentences.

    Raises
    ------
    IconstudioError
        If there is none; it says what the text is instead.
    """
    if android.is_vector(text):
        return android.as_svg(text)
    text, remarks = quoting.unquoted(text)
    if _LONE.match(text):
        text = f"<svg>{text}</svg>"
    if _ROOT.search(text) is None:
        from iconstudio.svg import icondata  # loads tree-sitter

        icons = icondata.markup(text)
        if icons is not None:
            return icons, remarks
        what = signatures.text(text)
        if what is not None:
            raise IconstudioError(what)
        return text, remarks
    from iconstudio.svg import components  # loads tree-sitter

    before, markup, after = _cut_out(text)
    around = f"{before} {after}"
    if components.is_code(markup):
        markup, said = components.without_code(markup, text)
        remarks += said
    return pages.with_sheets(markup, pages.sheets_in(around)), remarks


def _cut_out(text: str) -> tuple[str, str, str]:
    """Return the document, from its prolog or its root to its end, between what is around it."""
    place = 0
    while match := _PROLOG.match(text, place):
        place = match.end()
    if _ROOT.match(text[place:].lstrip()):
        return "", text, ""
    root = _ROOT.search(text)
    assert root is not None
    end = f"</{root[1] or ''}svg>".lower()
    closing = text.lower().rfind(end)
    close = closing + len(end) if closing > root.start() else len(text)
    return text[: root.start()], text[root.start() : close], text[close:]
