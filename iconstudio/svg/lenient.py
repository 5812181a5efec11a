"""Markup that is not well-formed, read as browsers read pages: the adapter of ``html.parser``.

Attributes that are doubled, bare or without a value, elements that are not closed or closed twice,
single ampersands: all this is forgiven. What a page would not forgive is not.
"""

import re
from html.parser import HTMLParser
from typing import Protocol

CUT_SHORT = (
    "It ends before its elements do, and what is there was read. If the file is cut short, save, "
    "copy or download it again."
)
SEVERAL = "There are several drawings in the file, of which the first was read."

_TAG = re.compile(r"</?\s*([^\s/>]+)")
_BARE_END = re.compile(r"[^\"'\s]/>$")
_WORD = re.compile(r"[^\s\"'=<>/]+")
_ALONE = (
    "path",
    "rect",
    "circle",
    "ellipse",
    "line",
    "polyline",
    "polygon",
    "use",
    "image",
    "stop",
)
"""Elements that hold no others than those which describe or animate them."""
_WITHIN = ("title", "desc", "metadata", "animate", "animatetransform", "animatemotion", "set")


class Builder(Protocol):
    """What is told of elements and text."""

    remarks: list[str]

    def start(self, name: str, attributes: dict[str, str]) -> None:
        """Open an element."""

    def end(self, name: str) -> None:
        """Close an element."""

    def characters(self, text: str) -> None:
        """Add text to the element that is open."""

    def instruction(self, target: str, data: str) -> None:
        """Take note of an instruction to whoever reads the document."""


def parse_leniently(text: str, builder: Builder) -> None:
    """Tell a builder of the first drawing in a text."""
    reader = _Reader(builder)
    reader.feed(text)
    reader.close()
    reader.finish()


class _Reader(HTMLParser):
    def __init__(self, builder: Builder) -> None:
        super().__init__(convert_charrefs=True)
        self._builder = builder
        self._open: list[str] = []
        self._ended = False

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Open an element, in the case in which its names are written."""
        self._start(tag, attrs)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Open an element, and close it."""
        if self._start(tag, attrs):
            self._close(1)

    def handle_endtag(self, tag: str) -> None:
        """Close an element with all that is open in it; if it is not open, do nothing."""
        if tag in self._open:
            self._close(self._open[::-1].index(tag) + 1)

    def handle_data(self, data: str) -> None:
        """Add text."""
        if self._open:
            self._builder.characters(data.replace("<![CDATA[", "").replace("]]>", ""))

    def unknown_decl(self, data: str) -> None:
        """Add text that is marked as such."""
        self.handle_data(data.removeprefix("CDATA["))

    def handle_pi(self, data: str) -> None:
        """Tell of an instruction to whoever reads the document."""
        target, _, rest = data.rstrip("?").partition(" ")
        self._builder.instruction(target, rest)

    def finish(self) -> None:
        """Close what is still open: the rest of the file is not there."""
        if self._open:
            self._builder.remarks.append(CUT_SHORT)
            self._close(len(self._open))

    def _start(self, tag: str, attrs: list[tuple[str, str | None]]) -> bool:
        """Open an element; return false if it is not wanted, or closed already."""
        if self._ended:
            if tag.rpartition(":")[2] == "svg" and SEVERAL not in self._builder.remarks:
                self._builder.remarks.append(SEVERAL)
            return False
        if self._open and self._open[-1] in _ALONE and tag not in _WITHIN:
            self._close(1)
        raw = self.get_starttag_text() or ""
        spelled: dict[str, str] = {}
        for word in _WORD.findall(raw):
            spelled.setdefault(word.lower(), word)
        given: dict[str, str] = {}
        for name, value in attrs:
            given.setdefault(spelled.get(name, name), value or "")
        closed = bool(attrs) and (attrs[-1][1] or "").endswith("/") and _BARE_END.search(raw)
        if closed:  # d=M0,0h9/> ends the element
            last, value = attrs[-1]
            given[spelled.get(last, last)] = (value or "").removesuffix("/")
        written = _TAG.match(raw)
        self._open.append(tag)
        self._builder.start(written[1] if written else tag, given)
        if closed:
            self._close(1)
        return not closed

    def _close(self, count: int) -> None:
        for _ in range(count):
            self._builder.end(self._open.pop())
        self._ended = not self._open
