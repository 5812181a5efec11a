"""The style sheets of a page, or of the code, around a drawing: they paint it, too."""

import re
from collections.abc import Sequence
from typing import NamedTuple

_SHEET = re.compile(
    r"<!--.*?(?:-->|\Z)|<style\b([^>]*)>(.*?)(?:</style|\Z)", re.DOTALL | re.IGNORECASE
)
_KEPT = re.compile(r"\b(?:media|type)\s*=\s*(?:\"[^\"]*\"|'[^']*'|[^\s\"'>]+)", re.IGNORECASE)
_NAMED = re.compile(r"\b(?:class|id)\s*=\s*(?:\"([^\"]*)\"|'([^']*)'|([^\s\"'>/]+))")
_SELECTED = re.compile(r"[.#]([\w-]+)")
_ELEMENT = re.compile(
    r"(?<![\w.#-])(?:svg|g|path|rect|circle|ellipse|line|polyline|polygon|text|use)(?![\w-])"
)
_START = re.compile(r"<(?:[\w.-]+:)?svg\b(?:[^\"'>]|\"[^\"]*\"|'[^']*')*>", re.IGNORECASE)


class Sheet(NamedTuple):
    """A style sheet, and of what it speaks."""

    element: str
    """It, as an element of SVG."""
    start: int
    end: int
    """Where it stands in its text."""
    names: frozenset[str]
    """The classes and ids that it selects."""
    of_elements: bool
    """Whether it selects elements."""
    has_variables: bool

    def concerns(self, names: set[str], uses_variables: bool) -> bool:
        """Whether it speaks of a drawing with such classes and ids."""
        paints = self.of_elements or (uses_variables and self.has_variables)
        return paints or not self.names.isdisjoint(names)


def sheets_in(text: str) -> list[Sheet]:
    """Return the style sheets in a text."""
    return [
        _sheet(match[1], match[2], *match.span())
        for match in _SHEET.finditer(text)
        if match[2] is not None
    ]


def with_sheets(markup: str, sheets: Sequence[Sheet]) -> str:
    """Return a drawing with those of the style sheets around it that speak of it.

    They do if they select a class, an id or an element that it has, or if it or they use
    variables. Its own come after them.
    """
    start = _START.search(markup)
    if start is None or start[0].endswith("/>"):
        return markup
    names = {one for match in _NAMED.findall(markup) for one in "".join(match).split()}
    variables = "var(" in markup or any("var(" in sheet.element for sheet in sheets)
    added = "".join(sheet.element for sheet in sheets if sheet.concerns(names, variables))
    return f"{markup[: start.end()]}{added}{markup[start.end() :]}"


def _sheet(attributes: str, text: str, start: int, end: int) -> Sheet:
    selectors = " ".join(part.rpartition("}")[2] for part in text.split("{")[:-1])
    names = frozenset(_SELECTED.findall(selectors))
    of_elements = _ELEMENT.search(selectors) is not None
    return Sheet(_element(attributes, text), start, end, names, of_elements, "--" in text)


def _element(attributes: str, sheet: str) -> str:
    kept = " ".join(_KEPT.findall(attributes))
    return f"<style {kept}><![CDATA[{sheet.replace(']]>', '')}]]></style>"
