"""A white page behind a drawing: what is pale upon it is still a part of the drawing."""

import xml.etree.ElementTree as ET
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from iconstudio.svg.bitmaps import is_box
from iconstudio.svg.bounds import bounds, reached
from iconstudio.svg.geometry import DEFINITIONS, SHAPES
from iconstudio.svg.lengths import Box

_WHITE = "#ffffff"
_PAINTS = {"fill": "#000000", "stroke": "none"}
_CHANGES = ("opacity", "fill-opacity", "mask", "clip-path")
_MOST = 2
"""Sides of the page that a drawing on it may reach."""
_MISSED = 0.001
"""Part of the page by which it may miss its sides."""


class _Painted(NamedTuple):
    parent: ET.Element
    element: ET.Element
    paints: tuple[str, ...]
    """What its inside and its line are painted with."""
    plain: bool
    """Whether it is opaque, and shown whole."""


def leave_out_page(content: ET.Element, page: Box | None) -> bool:
    """Take a white page away from under a plain drawing, in place; return whether there was one.

    It stays where anything else is white, which may be there to look like the page; under what has
    one colour, which is told from it in any case; where the drawing reaches its sides, as the
    stripes of a flag do; and under filters.
    """
    if any("filter" in one.attrib or "mix-blend-mode" in one.attrib for one in content.iter()):
        return False
    painted = _painted(content, _PAINTS, True)
    first = next(painted, None)
    if page is None or first is None or first.paints != (_WHITE, "none") or not first.plain:
        return False
    if not _covers(first.element, page):
        return False
    paints = {paint for one in painted for paint in one.paints}
    paints |= {one.get("stop-color", "") for one in content.iter("stop")}
    if (
        len(paints - {"none", ""}) < 2
        or _WHITE in paints
        or any(True for _ in content.iter("image"))
    ):
        return False
    place = list(first.parent).index(first.element)
    first.parent.remove(first.element)
    rest = bounds(content, page, {}, painted=True)
    if rest is None or sum(reached(rest, page, _MISSED)) > _MOST:
        first.parent.insert(place, first.element)
        return False
    return True


def _painted(element: ET.Element, around: Mapping[str, str], plain: bool) -> Iterator[_Painted]:
    """Yield what is drawn in an element, from the back."""
    for child in element:
        paints = {name: child.get(name, usual) for name, usual in around.items()}
        whole = plain and not any(one in child.attrib for one in _CHANGES)
        if child.tag in (*SHAPES, "text", "use"):
            yield _Painted(element, child, tuple(paints.values()), whole)
        if child.tag not in DEFINITIONS:
            yield from _painted(child, paints, whole and "transform" not in child.attrib)


def _covers(element: ET.Element, page: Box) -> bool:
    """Whether a shape is a rectangle that covers the page."""
    if element.tag != "rect" and not is_box(element):
        return False
    box = bounds(element, page, {})
    return box is not None and all(reached(box, page, _MISSED))
