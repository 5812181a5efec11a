"""Text on a path (SVG 2, section 11.8): letters beyond its ends are not drawn, which is told."""

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator, Mapping

from iconstudio.svg.geometry import data_length, path_data
from iconstudio.svg.lengths import Box, length
from iconstudio.svg.lettering import Lettering

CUT_OFF = "Letters that have no room on the path of their text were left out."
_HALF_A_LETTER = 0.4
"""Of the em: a letter is drawn if its middle is on the path, and a little less is not told."""


def letters_beyond(root: ET.Element, page: Box | None, ids: Mapping[str, ET.Element]) -> list[str]:
    """Return what to say of texts that are longer than their paths: surely, not by a hair."""
    box = page or (0.0, 0.0, 100.0, 100.0)
    texts = _texts(root, Lettering().of(root, box), box)
    return [CUT_OFF] if any(_goes_beyond(*text, box, ids) for text in texts) else []


def _texts(
    element: ET.Element, outer: Lettering, page: Box
) -> Iterator[tuple[ET.Element, Lettering]]:
    for child in element:
        lettering = outer.of(child, page)
        if child.tag == "textPath":
            yield child, lettering
        elif child.get("display") != "none":
            yield from _texts(child, lettering, page)


def _goes_beyond(
    element: ET.Element, lettering: Lettering, page: Box, ids: Mapping[str, ET.Element]
) -> bool:
    path = ids.get(element.get("href", "").removeprefix("#"))
    way = data_length(element.get("path", "") if path is None else path_data(path, page))
    text = re.sub(r"\s+", " ", "".join(element.itertext())).strip()
    if not way or not text or "textLength" in element.attrib:
        return False
    advance = lettering.advance(text, at_least=True) - lettering.size * _HALF_A_LETTER
    start = length(element.get("startOffset"), way)
    before = {"middle": advance / 2, "end": advance}.get(lettering.anchor, 0.0)
    return start - before < 0 or start - before + advance > way
