"""Bitmaps that drawings hold: no shapes, but a picture to be traced if there is nothing else."""

import base64
import binascii
import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple
from urllib.parse import unquote_to_bytes

from iconstudio.svg.bounds import bounds, reached
from iconstudio.svg.geometry import DEFINITIONS, SHAPES
from iconstudio.svg.lengths import Box, transform

_ADDRESS = re.compile(r"\s*data:image/[\w.+-]+(?:;[\w=.-]+)*?(;base64)?,", re.IGNORECASE)
_CHANGES = ("clip-path", "mask", "filter", "transform-origin", "rotate", "scale")
_PATTERN = re.compile(r"url\(#([^)]*)\)")
_BOX = re.compile(r"m[\s\d.,+-]*(?:[hv][\s\d.+-]*){3,4}z?", re.IGNORECASE)
_PLACE = "bitmap"
"""An attribute of a rectangle that stands for one: its number."""
_NOT_UNDERSTOOD = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
_MOST = 10_000
"""Elements that are looked at, as often as they are repeated."""
_UNEVEN = 0.02
"""Part by which the scales across and down may differ."""
_MISSED = 0.02
"""Part of the page by which a page that is drawn may miss its sides."""


class Shown(NamedTuple):
    """A bitmap in a place of a document."""

    address: str
    whole: bool
    """Whether it is shown as it is, and not turned, cut or stretched, say."""


def shown(root: ET.Element, ids: Mapping[str, ET.Element]) -> list[Shown]:
    """Return the bitmaps that a document shows, once for each place."""
    budget = iter(range(_MOST))
    parts = [one for one in root if one.tag not in DEFINITIONS]
    return [found for part in parts for found in _shown(part, ids, True, budget)]


def _shown(
    element: ET.Element, ids: Mapping[str, ET.Element], whole: bool, budget: Iterator[int]
) -> Iterator[Shown]:
    if element.get("display") == "none" or next(budget, None) is None:
        return
    a, b, c, d, *_ = transform(element.get("transform")) or _NOT_UNDERSTOOD
    whole = whole and b == c == 0 < min(a, d) and abs(a - d) <= _UNEVEN * a
    whole = whole and not any(one in element.attrib for one in _CHANGES)
    if element.tag == "image":
        aspect = element.get("preserveAspectRatio", "")
        yield Shown(element.get("href", ""), whole and not re.search("none|slice", aspect))
    elif element.tag == "use":
        target = ids.get(element.get("href", "#")[1:])
        if target is not None:
            yield from _shown(target, ids, whole, budget)
    elif element.tag in SHAPES:
        match = _PATTERN.match(element.get("fill", ""))
        pattern = ids.get(match[1]) if match else None
        is_plain = (
            element.tag == "rect" and "rx" not in element.attrib and "ry" not in element.attrib
        )
        for child in () if pattern is None or pattern.tag != "pattern" else pattern:
            yield from _shown(child, ids, whole and is_plain, budget)
    else:
        within = whole and element.tag not in ("svg", "symbol")
        for child in element:
            if child.tag not in DEFINITIONS:
                yield from _shown(child, ids, within, budget)


def stand_for(root: ET.Element) -> list[str]:
    """Let a rectangle stand for each bitmap that a document holds, in place.

    So it is placed, cut and repeated as any shape is, until ``put_back`` puts the bitmap there.

    Returns
    -------
    Their addresses.
    """
    addresses: list[str] = []
    for image in [one for one in root.iter("image") if _ADDRESS.match(one.get("href", ""))]:
        image.tag = "rect"
        image.set(_PLACE, str(len(addresses)))
        image.attrib |= {"fill": "#000000", "stroke": "none"}
        addresses.append(image.attrib.pop("href"))
    return addresses


def put_back(content: ET.Element, addresses: Sequence[str]) -> None:
    """Put bitmaps in the places of the rectangles that stand for them."""
    for one in content.iter():
        if _PLACE in one.attrib:
            one.tag = "image"
            one.set("href", addresses[int(one.attrib.pop(_PLACE))])


def is_page(root: ET.Element, page: Box | None, ids: Mapping[str, ET.Element]) -> bool:
    """Whether each shape of a document covers its page, and nothing else: there is no drawing."""
    if page is None:
        return False
    shapes = list(_shapes(root))
    boxes = [bounds(one, page, ids) for one in shapes if one.tag == "rect" or is_box(one)]
    return len(boxes) == len(shapes) and all(
        box is not None and all(reached(box, page, _MISSED)) for box in boxes
    )


def _shapes(element: ET.Element) -> Iterator[ET.Element]:
    """Yield what is drawn."""
    if element.tag in (*SHAPES, "text"):
        yield element
    elif element.tag not in DEFINITIONS and element.get("display") != "none":
        for child in element:
            yield from _shapes(child)


def is_box(element: ET.Element) -> bool:
    """Whether a path goes along four sides, across and down, as those of pages do."""
    return _BOX.fullmatch(element.get("d", "").strip()) is not None


def file_of(address: str) -> bytes | None:
    """Return the file that the address of an image holds; None if it holds none."""
    match = _ADDRESS.match(address)
    if match is None:
        return None
    data = unquote_to_bytes(address[match.end() :])
    if match[1] is None:
        return data
    try:
        return base64.b64decode(b"".join(data.split()))
    except binascii.Error:
        return None
