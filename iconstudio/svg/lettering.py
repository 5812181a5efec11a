"""Text: in the fonts that come with the program, and how much room it takes.

Where letters lie is estimated from how far each moves the pen, and rather too far: boxes hold all
letters, with room for accents and for what lies off the baseline.
"""

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import NamedTuple

from iconstudio.resources import resource
from iconstudio.svg.geometry import advances, data_bounds, path_data
from iconstudio.svg.lengths import (
    IDENTITY,
    NUMBER,
    Box,
    enlarged,
    length,
    mapped,
    numbers,
    transform,
)

TEXTS = ("text", "tspan", "textPath")
_INITIAL = {
    "font-weight": "normal", "text-transform": "none", "direction": "ltr", "text-anchor": "start",
}  # fmt: skip
_OPPOSITE = {"start": "end", "end": "start"}
_REGULAR, _BOLD = "Inter", "Inter Semi Bold"
_BOLD_FROM = 600
_STRETCHED = 2
"""How many times too far the renderer stretches what is but a part of a text."""
_ABOVE, _BELOW, _BESIDE = 1.1, 0.35, 0.1
"""Of the em, how far letters reach from the baseline, and beyond their advance."""
_OFF = 1.6
"""Of the em, how far they reach if they are turned or not on the baseline."""
_OFF_BASELINE = ("rotate", "baseline-shift", "dominant-baseline", "alignment-baseline")
_KEYWORDS = {
    "xx-small": 9.0, "x-small": 10.0, "small": 13.0, "medium": 16.0, "large": 18.0,
    "x-large": 24.0, "xx-large": 32.0, "xxx-large": 48.0,
}  # fmt: skip
_STEP = 1.2
"""By how much letters are larger that are said to be."""
_BEFORE = {"start": 0.0, "middle": 0.5, "end": 1.0}
"""Which part of a text lies before its anchor."""
_RELATIVE = re.compile(rf"({NUMBER.pattern})(em|ex|ch|%)")


def set_type(root: ET.Element) -> None:
    """Let all text be in the fonts that come with the program, and as styles spell it, in place.

    Text that runs from the right to the left is placed as it is, and not read so.
    """
    _set_type(root, _INITIAL)


def _set_type(element: ET.Element, outer: dict[str, str]) -> None:
    style = dict(outer)
    for name in outer:
        said = element.attrib.pop(name, "inherit")
        if said != "inherit":
            style[name] = said
    element.attrib.pop("font-family", None)
    if element.tag in TEXTS:
        element.set("font-family", _BOLD if _is_bold(style["font-weight"]) else _REGULAR)
        anchor = style["text-anchor"]
        element.set(
            "text-anchor", anchor if style["direction"] == "ltr" else _OPPOSITE.get(anchor, anchor)
        )
        element.text = _spelt(element.text, style["text-transform"])
    for child in element:
        _set_type(child, style)
        if element.tag in TEXTS:
            child.tail = _spelt(child.tail, style["text-transform"])


def _is_bold(weight: str) -> bool:
    if weight in ("bold", "bolder"):
        return True
    return NUMBER.fullmatch(weight) is not None and float(weight) >= _BOLD_FROM


def _spelt(text: str | None, how: str) -> str | None:
    """Return a text in capitals, or not, as ``text-transform`` says."""
    if not text:
        return text
    match how:
        case "uppercase":
            return text.upper()
        case "lowercase":
            return text.lower()
        case "capitalize":
            return re.sub(r"(?<![\w'’])\w", lambda first: first[0].upper(), text)
    return text


class Lettering(NamedTuple):
    """How text is set, which elements inherit; lengths are in user space."""

    size: float = 16.0
    letter_spacing: float = 0.0
    word_spacing: float = 0.0
    anchor: str = "start"
    vertical: bool = False
    preserved: bool = False
    """Whether all blanks count."""
    off: bool = False
    """Whether letters are turned, or not on the baseline."""

    def of(self, element: ET.Element, page: Box) -> "Lettering":
        """Return that of an element."""
        get = element.get
        size = _size(get("font-size", "inherit"), self.size, page)
        spacing, words = (
            before if get(name, "inherit") == "inherit" else _in_em(get(name, ""), size, page[2])
            for name, before in (
                ("letter-spacing", self.letter_spacing),
                ("word-spacing", self.word_spacing),
            )
        )
        anchor = get("text-anchor", self.anchor)
        mode = get("writing-mode", "inherit")
        return Lettering(
            size,
            spacing,
            words,
            anchor if anchor in _BEFORE else self.anchor,
            self.vertical if mode == "inherit" else mode.startswith(("tb", "vertical", "sideways")),
            get("xml:space", "preserve" if self.preserved else "") == "preserve",
            self.off or any(name in element.attrib for name in _OFF_BASELINE),
        )

    def advance(self, text: str, at_least: bool = False) -> float:
        """Return how far a text moves the pen, at most, or else at least."""
        fonts = [advances(resource(f"fonts/Inter-{one}.otf")) for one in ("Regular", "SemiBold")]
        least = 1.0 if self.vertical else 0.0
        extreme, unknown = (min, 0.0) if at_least else (max, 1.0)
        widths = (extreme(font.get(ord(one), unknown) for font in fonts) for one in text)
        em = sum(max(least, width) for width in widths)
        blanks = sum(map(str.isspace, text)) * max(self.word_spacing, 0.0)
        return em * self.size + len(text) * max(self.letter_spacing, 0.0) + blanks


def _size(said: str, outer: float, page: Box) -> float:
    match said:
        case "inherit":
            return outer
        case "larger":
            return outer * _STEP
        case "smaller":
            return outer / _STEP
    return _KEYWORDS.get(said) or _in_em(said, outer, outer, length(said, page[2], outer))


def _in_em(said: str, em: float, whole: float, default: float = 0.0) -> float:
    """Return a length that may be relative to the size of letters."""
    match = _RELATIVE.fullmatch(said.strip().lower())
    if match is None:
        return length(said, whole, default)
    return float(match[1]) * {"em": em, "ex": em / 2, "ch": em * 0.65, "%": whole / 100}[match[2]]


@dataclass
class _Line:
    """Text from one place on that is given."""

    x: tuple[float, float]
    y: tuple[float, float]
    """Between which the anchor and the baseline lie."""
    anchor: str
    vertical: bool
    advance: float = 0.0
    stretched: float = 0.0
    em: float = 0.0
    off: float = 0.0

    def box(self) -> Box:
        """Return the box of its letters."""
        advance = max(self.advance, self.stretched)
        before = _BEFORE[self.anchor] * advance
        above, below = (self.off, self.off) if self.off else (_ABOVE * self.em, _BELOW * self.em)
        if self.vertical:
            above = below = self.off or self.em
        along, across = (self.y, self.x) if self.vertical else (self.x, self.y)
        beside = self.off or _BESIDE * self.em
        ends = along[0] - before - beside, along[1] - before + advance + beside
        sides = across[0] - above, across[1] + below
        (left, right), (top, bottom) = (sides, ends) if self.vertical else (ends, sides)
        return left, top, right - left, bottom - top


def text_boxes(
    text: ET.Element, lettering: Lettering, page: Box, ids: Mapping[str, ET.Element]
) -> list[Box]:
    """Return boxes that hold all letters of a ``text``, set so, within the space of its own."""
    return list(_Setter(page, ids).boxes(text, lettering))


class _Setter:
    """Goes through a text as a typesetter does."""

    def __init__(self, page: Box, ids: Mapping[str, ET.Element]) -> None:
        self._page = page
        self._ids = ids
        self._line = _Line((0.0, 0.0), (0.0, 0.0), "start", False)

    def boxes(self, text: ET.Element, lettering: Lettering) -> Iterator[Box]:
        """Yield the box of every line."""
        self._line = _Line((0.0, 0.0), (0.0, 0.0), lettering.anchor, lettering.vertical)
        yield from self._below(text, lettering)
        if self._line.em:
            yield self._line.box()

    def _below(self, element: ET.Element, lettering: Lettering) -> Iterator[Box]:
        if element.tag == "textPath":
            yield from self._on_path(element, lettering)
            return
        yield from self._move(element, lettering)
        self._write(element.text, lettering)
        for child in element:
            if child.get("display") != "none":
                yield from self._below(child, lettering.of(child, self._page))
            self._write(child.tail, lettering)

    def _move(self, element: ET.Element, lettering: Lettering) -> Iterator[Box]:
        """Begin a line where an element is placed; yield the box of the line before."""
        x, y, dx, dy = (self._lengths(element, name, lettering) for name in ("x", "y", "dx", "dy"))
        line = self._line
        if x or y:
            if line.em:
                yield line.box()
            end = line.advance if not line.vertical else 0.0
            across = (min(x), max(x)) if x else (line.x[0], line.x[1] + end)
            down = (min(y), max(y)) if y else line.y
            self._line = line = _Line(across, down, lettering.anchor, lettering.vertical)
        line.x, line.y = _extended(line.x, dx), _extended(line.y, dy)
        stretched = max(self._lengths(element, "textLength", lettering), default=0.0)
        line.stretched += stretched * (1 if element.tag == "text" else _STRETCHED)
        if lettering.off:
            shift = max(map(abs, numbers(element.get("baseline-shift", ""))), default=0.0)
            line.off = max(line.off, _OFF * lettering.size + shift)

    def _lengths(self, element: ET.Element, name: str, lettering: Lettering) -> list[float]:
        parts = re.split(r"[\s,]+", element.get(name, "").strip())
        whole = self._page[3 if name.endswith("y") else 2]
        return [_in_em(part, lettering.size, whole) for part in parts if part]

    def _write(self, text: str | None, lettering: Lettering) -> None:
        said = text or ""
        if not lettering.preserved:
            said = re.sub(r"\s+", " ", said)
        if said:
            self._line.advance += lettering.advance(said)
            self._line.em = max(self._line.em, lettering.size)

    def _on_path(self, element: ET.Element, lettering: Lettering) -> Iterator[Box]:
        """Yield the box of the path along which an element's text runs."""
        path = self._ids.get(element.get("href", "").removeprefix("#"))
        data = element.get("path", "") if path is None else path_data(path, self._page)
        box = data_bounds(data)
        if box is None:
            return
        if path is not None:
            box = mapped(transform(path.get("transform")) or IDENTITY, box)
        sizes, shifts = [lettering.size], [0.0]
        for one in element.iter():
            own = lettering.of(one, self._page)
            sizes.append(own.size)
            shifts += [abs(by) for name in ("dx", "dy") for by in self._lengths(one, name, own)]
        yield enlarged(box, _OFF * max(sizes) + sum(shifts))


def _extended(interval: tuple[float, float], steps: list[float]) -> tuple[float, float]:
    """Return an interval that is moved by steps, with all places in between."""
    places = [0.0]
    for step in steps:
        places.append(places[-1] + step)
    return interval[0] + min(places), interval[1] + max(places)
