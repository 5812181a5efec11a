"""The style sheets of a page, or of the code, around a drawing: they paint it, too."""

import re

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


def with_sheets(markup: str, around: str) -> str:
    """Return a drawing with those style sheets in the text ``around`` it that speak of it.

    They do if they select a class, an id or an element that it has, or if it uses variables. Its
    own come after them.
    """
    start = _START.search(markup)
    if start is None or start[0].endswith("/>"):
        return markup
    named = {one for match in _NAMED.findall(markup) for one in "".join(match).split()}
    sheets = "".join(
        _element(*sheet)
        for sheet in _SHEET.findall(around)
        if _concerns(sheet[1], named, "var(" in markup)
    )
    return f"{markup[: start.end()]}{sheets}{markup[start.end() :]}"


def _element(attributes: str, sheet: str) -> str:
    kept = " ".join(_KEPT.findall(attributes))
    return f"<style {kept}><![CDATA[{sheet.replace(']]>', '')}]]></style>"


def _concerns(sheet: str, named: set[str], variables: bool) -> bool:
    selectors = " ".join(part.rpartition("}")[2] for part in sheet.split("{")[:-1])
    return (
        not named.isdisjoint(_SELECTED.findall(selectors))
        or _ELEMENT.search(selectors) is not None
        or (variables and "--" in sheet)
    )
