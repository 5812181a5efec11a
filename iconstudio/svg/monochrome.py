"""A plain drawing in black: by its own curves where these are enough, and else traced.

How a coloured drawing becomes black is decided on its picture (``algorithms.tone``). If the
drawing's own shapes, painted black and white, give the same picture, they are kept: a line icon
stays one. Whatever else there is (filters, text, colours side by side) is traced, so that what
comes out is always simple to draw.
"""

import copy
import re
import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterator
from time import perf_counter

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.tone import pictogram
from iconstudio.algorithms.vectorize import trace
from iconstudio.model import CANVAS, Frame, IconstudioError
from iconstudio.resources import resource
from iconstudio.svg.fitting import fitted, square
from iconstudio.svg.lengths import Box, mapped
from iconstudio.svg.near import brought_near
from iconstudio.svg.plain import Plain, document
from iconstudio.svg.resvg import render_colours, render_coverage
from iconstudio.svg.strokes import thickened

_SIDE = 4 * CANVAS
"""Side of the picture that decides, unless the drawing has filters, masks or patterns."""
_SLOW = 0.7
"""Seconds from which such a drawing is drawn no larger than the canvas: its time grows with the cube
of its side. All but the oddest are far from it on any machine."""
_COMPARED = 512
_ALIKE = 0.004
"""Part of the ink by which the shapes painted black may differ from the picture."""
_THIN = 1.2
"""Canvas units that the thickest lines must measure."""
_PALE = 208
"""Grey level from which a colour is paper beside a darker one."""
_COLOUR = re.compile(r"#([0-9a-f]{6})|rgba\((\d+),(\d+),(\d+),([\d.e-]+)\)|currentColor")
_PAINTS = ("fill", "stroke", "color", "stop-color")
_OPACITIES = ("opacity", "fill-opacity", "stroke-opacity", "stop-opacity")

OFF_PAGE = "It lies outside of its page; all of it was taken."
THIN = "Its lines are too thin to be seen at the size of an icon; they were drawn thicker."
FONTS = "Its text was drawn in Inter, whatever its font. To keep its look, turn text into shapes."


def in_black(drawing: Plain, rdf: ET.Element | None) -> tuple[str, tuple[str, ...]]:
    """Return a document that shows a drawing in black, and what to say of it, in sentences.

    ``rdf`` are the metadata that go along.

    Raises
    ------
    IconstudioError
        If there is nothing to be seen.
    """
    remarks = list(drawing.remarks)
    if drawing.texts:
        remarks.append(FONTS)
    fonts = [str(resource(f"fonts/Inter-{one}.otf")) for one in ("Regular", "SemiBold")]
    fonts = fonts if drawing.texts else []
    if drawing.bounds is None:
        raise _nothing(drawing.remarks)
    content, matrix = brought_near(drawing.content, drawing.page, drawing.bounds)
    drawn = mapped(matrix, drawing.bounds)
    box = drawn if drawing.page is None else mapped(matrix, drawing.page)
    frame = fitted(document(content, box), _common(box, drawn), fonts)
    if frame is None and drawing.page is not None:
        frame = fitted(document(content, drawn), drawn, fonts)
        if frame is not None:
            box = drawn
            remarks.append(OFF_PAGE)
    around = frame or square(drawn)
    coverage = frame and _picture(document(content, box), frame, fonts, drawing.heavy)
    if coverage is None or _is_thin(coverage):
        content = thickened(content, around.size, box)
        frame = fitted(document(content, box), _common(box, drawn), fonts)
        if frame is None:
            raise _nothing(drawing.remarks)
        coverage = _picture(document(content, box), frame, fonts, drawing.heavy)
        if _is_thin(coverage):
            raise IconstudioError(
                "Its lines are too thin to be seen at the size of an icon. Make them thicker."
            )
        remarks.append(THIN)
    box = _common(box, (frame.x, frame.y, frame.size, frame.size))
    own = None if fonts or drawing.heavy else _own_shapes(content, box, frame, coverage)
    if own is None:
        own, box = _traced(coverage), (0.0, 0.0, float(CANVAS), float(CANVAS))
    return document(own, box, rdf), tuple(dict.fromkeys(remarks))


def _nothing(remarks: "list[str] | tuple[str, ...]") -> IconstudioError:
    said = " ".join(dict.fromkeys(remarks))
    return IconstudioError(
        f"There is nothing to be seen in it. {said}".strip()
        if said
        else "There is nothing to be seen in it: it is empty, or all of it is transparent."
    )


def _common(page: Box, drawn: Box) -> Box:
    """Return what two boxes have in common; the first if that is nothing."""
    left, top = max(page[0], drawn[0]), max(page[1], drawn[1])
    right = min(page[0] + page[2], drawn[0] + drawn[2])
    bottom = min(page[1] + page[3], drawn[1] + drawn[3])
    if right <= left and bottom <= top:
        return page
    return left, top, max(right - left, 0.0), max(bottom - top, 0.0)


def _picture(svg: str, frame: Frame, fonts: list[str], heavy: bool) -> NDArray[np.uint8]:
    """Return the pictogram of a document; ``heavy`` ones are drawn smaller, by how slow they are."""
    size = _SIDE
    if heavy:
        start = perf_counter()
        render_colours(svg, frame, CANVAS, fonts)
        slow = perf_counter() - start > _SLOW
        size = CANVAS if slow else 2 * CANVAS
    return pictogram(render_colours(svg, frame, size, fonts))


def _is_thin(coverage: NDArray[np.uint8]) -> bool:
    """Whether nearly all lines are so thin that they would hardly show on the canvas."""
    ink = coverage > 127
    if not ink.any():
        return True
    depths = scipy.ndimage.distance_transform_edt(ink)[ink]
    return 2 * np.quantile(depths, 0.95) * CANVAS / len(coverage) < _THIN


def _own_shapes(
    content: ET.Element, box: Box, frame: Frame, coverage: NDArray[np.uint8]
) -> ET.Element | None:
    """Return the drawing's own shapes in black and white; None if they give another picture."""
    factor = max(1, len(coverage) // _COMPARED)
    side = len(coverage) // factor
    wanted = coverage.reshape(side, factor, side, factor).mean(axis=(1, 3))
    ink = (wanted > 127).sum()
    for painted in _painted(content):
        drawn = render_coverage(document(painted, box), frame, side).astype(float)
        # An edge may come out a shade lighter; ink and paper may not change places.
        differs = (abs(drawn - wanted) > 100).sum()
        if differs <= _ALIKE * ink:
            return painted
    return None


def _painted(content: ET.Element) -> Iterator[ET.Element]:
    """Yield a drawing in black and white, in the ways that may be right."""
    black: Callable[[int], str] = lambda _: "#000000"  # noqa: E731
    holes: Callable[[int], str] = lambda grey: "#ffffff" if grey >= _PALE else "#000000"  # noqa: E731
    tile: Callable[[int], str] = lambda grey: "#000000" if grey >= _PALE else "#ffffff"  # noqa: E731
    for opaque in (False, True):
        for colour_of in (black, holes, tile):
            yield _recoloured(copy.deepcopy(content), colour_of, opaque)


def _recoloured(element: ET.Element, colour_of: Callable[[int], str], opaque: bool) -> ET.Element:
    """Paint an element by the grey levels of its colours, in place, and return it."""
    if element.tag == "mask":
        return element  # whose colours say how much shows
    for name in _PAINTS:
        if name in element.attrib:
            painted = _COLOUR.sub(lambda m: _paint(m, colour_of, opaque), element.attrib[name])
            element.set(name, painted)
    if opaque:
        for name in _OPACITIES:
            if float(element.get(name, "0").replace("inherit", "0")) > 0:
                element.set(name, "1")
    for child in element:
        _recoloured(child, colour_of, opaque)
    return element


def _paint(match: re.Match[str], colour_of: Callable[[int], str], opaque: bool) -> str:
    if match[0] == "currentColor":
        return match[0]
    parts = (
        [int(match[1][at : at + 2], 16) for at in (0, 2, 4)]
        if match[1]
        else [int(match[at]) for at in (2, 3, 4)]
    )
    painted = colour_of(round(0.299 * parts[0] + 0.587 * parts[1] + 0.114 * parts[2]))
    if match[5] is None or (opaque and float(match[5]) > 0):
        return painted
    level = 0 if painted == "#000000" else 255
    return f"rgba({level},{level},{level},{match[5]})"


def _traced(coverage: NDArray[np.uint8]) -> ET.Element:
    path = trace(coverage)
    if not path:
        raise _nothing(())
    content = ET.Element("g")
    ET.SubElement(content, "path", d=path)
    return content
