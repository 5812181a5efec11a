"""A plain drawing in black: by its own curves where these are enough, and else traced.

How a coloured drawing becomes black is decided on its picture (``algorithms.tone``). If the
drawing's own shapes, painted black and white, give the same picture, they are kept: a line icon
stays one. Whatever else there is (filters, text, colours side by side) is traced, so that what
comes out is always simple to draw.
"""

import copy
import re
import xml.etree.ElementTree as ET
from collections.abc import Sequence
from dataclasses import replace
from string import whitespace
from time import process_time
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import minimum_filter
from iconstudio.algorithms.tones.alternation import Omission
from iconstudio.algorithms.tones.halo import without_halo
from iconstudio.algorithms.tones.layers import flattened, left_out
from iconstudio.algorithms.tones.paints import Paints, near_white, paints
from iconstudio.algorithms.tones.seams import without_seams
from iconstudio.algorithms.tones.tone import pictogram
from iconstudio.algorithms.tracing.vectorize import trace
from iconstudio.model import CANVAS, Frame, IconstudioError
from iconstudio.resources import resource
from iconstudio.svg.fitting import fitted, square
from iconstudio.svg.geometry import missing_letters
from iconstudio.svg.lengths import Box, mapped
from iconstudio.svg.mark import in_black_and_white
from iconstudio.svg.near import brought_near
from iconstudio.svg.omitted import THIN, said_of
from iconstudio.svg.paint import is_of_one_paint
from iconstudio.svg.plain import Plain, document
from iconstudio.svg.resvg import render_colours, render_coverage
from iconstudio.svg.strokes import bare, coarsened, evened, thickened, widened
from iconstudio.svg.white_page import leave_out_page

_SIDE = 4 * CANVAS
"""Side of the picture that decides, unless the drawing has filters, masks or patterns."""
_SLOW = 0.7
"""Seconds of a processor from which such a drawing is drawn no larger than the canvas: all but the
oddest are far from it."""
_APART = 100
"""Grey levels by which ink and paper differ."""
_ALIKE = 0.004
"""Part of the ink by which the shapes painted black may differ from the picture."""
_SPECK = 0.5
"""Square canvas units of the smallest dot, as of an i."""
_THIN = 1.2
"""Canvas units that the thickest lines must measure."""
_EVEN = 1.8
"""Canvas units of the thinnest line beside thicker ones."""
_SMALL = 1 / 12
"""What is a smaller part of its page, as a sketch in the corner of a sheet, is no icon of a set."""
_COLOUR = re.compile(r"#([0-9a-f]{6})|rgba\((\d+),(\d+),(\d+),([\d.e-]+)\)")
_PAINTS = ("fill", "stroke", "color", "stop-color")
_OPACITIES = ("opacity", "fill-opacity", "stroke-opacity", "stop-opacity")
_EFFECTS = ("filter", "style")
"""Filters, and the blending that is left in styles."""

OFF_PAGE = "It lies outside of its page; all of it was taken."
SOME_THIN = (
    "Some of its lines are too thin to be seen at the size of an icon; they were drawn thicker."
)
FONTS = "Text was drawn in Inter, whatever its font. To keep its look, turn text into shapes."
UNKNOWN = "The font Inter has no “{}”, which was left out. Turn text into shapes."


class EmptyError(IconstudioError):
    """A drawing shows nothing."""


class _Picture(NamedTuple):
    colours: NDArray[np.uint8] | None
    """(n, n, 4); None if all is of one paint, and so ink."""
    coverage: NDArray[np.uint8]
    """(n, n), 255 = ink: the pictogram of it."""
    omissions: frozenset[Omission]
    thin: bool
    """Whether nearly all of its lines are too thin."""
    mended: bool = False
    """Whether it has no seams, as the drawing's shapes have."""


def in_black(drawing: Plain, rdf: ET.Element | None) -> tuple[str, tuple[str, ...]]:
    """Return a document that shows a drawing in black, and what to say of it, in sentences.

    ``rdf`` are the metadata that go along.

    Raises
    ------
    EmptyError
        If there is nothing to be seen.
    IconstudioError
        If its lines are too thin.
    """
    remarks = list(drawing.remarks)
    fonts, said_of_fonts = fonts_of(drawing.texts)
    remarks += said_of_fonts
    bounds = drawing.bounds
    if bounds is None or not max(bounds[2:]):
        raise _nothing(remarks)
    if drawing.page is not None and _are_apart(drawing.page, bounds):
        drawing = replace(drawing, page=None)
        remarks.append(OFF_PAGE)
    black = _as_it_is(drawing, rdf)
    if black is not None:
        return black, tuple(dict.fromkeys(remarks))
    has_page = leave_out_page(drawing.content, drawing.page)
    shown = drawing.page or bounds
    content, matrix = brought_near(drawing.content, drawing.page, bounds)
    shown = mapped(matrix, shown)
    content, fine = coarsened(content, max(shown[2:]), shown)
    remarks += fine
    drawn = mapped(matrix, bounds)
    box = drawn if drawing.page is None else mapped(matrix, drawing.page)
    frame = fitted(document(content, box), _common(box, drawn), fonts)
    if frame is None and drawing.page is not None:
        frame = fitted(document(content, drawn), drawn, fonts)
        if frame is not None:
            box = drawn
            remarks.append(OFF_PAGE)
    shape = frame or square(drawn)
    picture = None
    if frame is not None:
        content = bare(content, frame.size, box)
        picture = _picture(content, box, frame, fonts, drawing.heavy)
        even = evened(content, frame.size, box, _EVEN)
        if even is not None and not picture.thin:
            content, frame = even, fitted(document(even, box), _common(box, drawn), fonts) or frame
            picture = _picture(content, box, frame, fonts, drawing.heavy)
            remarks.append(SOME_THIN)
    if frame is None or picture is None or picture.thin:
        content = thickened(content, shape.size, box)
        box = widened(box, shape.size)
        frame = fitted(document(content, box), _common(box, drawn), fonts)
        if frame is None:
            raise _nothing(remarks)
        picture = _picture(content, box, frame, fonts, drawing.heavy)
        if picture.thin:
            raise IconstudioError(
                "Its lines are too thin to be seen at the size of an icon. Make them thicker."
            )
        remarks.append(THIN)
    remarks += said_of(picture.omissions | ({Omission.PAGE} if has_page else set()))
    around = frame.x, frame.y, frame.size, frame.size
    is_page = drawing.page is not None and OFF_PAGE not in remarks
    page = box if is_page and frame.size > _SMALL * max(box[2:]) else around
    box = _common(box, around)
    changed = bool(fonts) or drawing.heavy or picture.mended or Omission.FAINT in picture.omissions
    own = None if changed else _own_shapes(content, box, frame, picture)
    if own is None:
        own, box = _traced(picture.coverage), (0.0, 0.0, float(CANVAS), float(CANVAS))
        scale = CANVAS / frame.size
        page = mapped((scale, 0, 0, scale, -frame.x * scale, -frame.y * scale), page)
    return document(own, box, rdf, marked=True, page=page), tuple(dict.fromkeys(remarks))


def fonts_of(texts: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return the files of the fonts for texts, if there are any, and what to say of them."""
    if not texts:
        return [], []
    files = [str(resource(f"fonts/Inter-{one}.otf")) for one in ("Regular", "SemiBold")]
    missing = missing_letters(texts, resource("fonts/Inter-Regular.otf"))
    others = set("".join(texts)).difference(missing, whitespace)
    unknown = [UNKNOWN.format(missing[:20])] if missing else []
    return files, [*([FONTS] if others else []), *unknown]


def _as_it_is(drawing: Plain, rdf: ET.Element | None) -> str | None:
    """Return the document of a drawing that was made black here; None if it shows no ink."""
    if drawing.page is None or not drawing.marked or not in_black_and_white(drawing.content):
        return None
    svg = document(drawing.content, drawing.page, rdf, marked=True)
    frame = fitted(svg, drawing.page, [])
    if frame is None or not (render_coverage(svg, frame, CANVAS) > 127).any():
        return None
    return svg


def _nothing(remarks: Sequence[str]) -> EmptyError:
    if not remarks:
        return EmptyError(
            "There is nothing to be seen in it: it is empty, or all of it is transparent."
        )
    said = " ".join(dict.fromkeys(remarks))
    return EmptyError(f"There is nothing to be seen in it. {said}")


def _are_apart(one: Box, other: Box) -> bool:
    return any(
        one[axis] + one[axis + 2] < other[axis] or other[axis] + other[axis + 2] < one[axis]
        for axis in (0, 1)
    )


def _common(page: Box, drawn: Box) -> Box:
    """Return what two boxes have in common; the first if that is nothing."""
    left, top = max(page[0], drawn[0]), max(page[1], drawn[1])
    right = min(page[0] + page[2], drawn[0] + drawn[2])
    bottom = min(page[1] + page[3], drawn[1] + drawn[3])
    if right <= left and bottom <= top:
        return page
    return left, top, max(right - left, 0.0), max(bottom - top, 0.0)


def _picture(
    content: ET.Element, box: Box, frame: Frame, fonts: list[str], heavy: bool
) -> _Picture:
    """Return the colours of a drawing and its pictogram.

    ``heavy`` ones are drawn smaller, by how slow they are.
    """
    if not fonts and not heavy and is_of_one_paint(content):
        black = document(_painted(copy.deepcopy(content), Paints.ALL), box)
        coverage = render_coverage(black, frame, _SIDE)
        if not _is_thin(coverage):  # else antialiasing makes it pale, which is judged below
            return _Picture(None, coverage, frozenset(), False)
    svg, size = document(content, box), _SIDE
    if heavy:
        start = process_time()
        render_colours(svg, frame, CANVAS, fonts)
        size = CANVAS if process_time() - start > _SLOW else 2 * CANVAS
    drawn = render_colours(svg, frame, size, fonts)
    bare = without_halo(drawn)
    drawn = drawn if bare is None else bare
    flat = flattened(drawn)
    colours = without_seams(flat)
    coverage, omissions = pictogram(colours)
    if bare is not None:
        omissions |= {Omission.GLOW}
    if left_out(drawn, flat, coverage):
        omissions |= {Omission.DECORATION}
    mended = colours is not flat
    return _Picture(colours, coverage, omissions, _is_thin(coverage), mended)


def _is_thin(coverage: NDArray[np.uint8]) -> bool:
    """Whether nearly all lines are so thin that they would hardly show on the canvas."""
    ink = coverage > 127
    if not ink.any():
        return True
    # Where squares fit into it, nothing needs to be measured.
    side = 2 * int(_THIN / 2 * len(ink) / CANVAS) + 3
    if minimum_filter(ink, side).sum() > 0.06 * ink.sum():
        return False
    depths = scipy.ndimage.distance_transform_edt(ink)[ink]
    return float(2 * np.quantile(depths, 0.95)) * CANVAS / len(coverage) < _THIN


def _own_shapes(
    content: ET.Element, box: Box, frame: Frame, picture: _Picture
) -> ET.Element | None:
    """Return the drawing's own shapes in black and white; None if they give another picture."""
    if picture.colours is None:
        return _painted(copy.deepcopy(content), Paints.ALL)
    choice = paints(picture.colours, picture.coverage)
    if choice is None:
        return None
    side = 2 * CANVAS
    factor = len(picture.coverage) // side
    wanted = picture.coverage.reshape(side, factor, side, factor).mean(axis=(1, 3))
    painted = _painted(copy.deepcopy(content), choice)
    drawn = render_coverage(document(painted, box), frame, side).astype(float)
    # An edge may come out a shade lighter; ink and paper may not change places.
    alike = (abs(drawn - wanted) > _APART).sum() <= _ALIKE * (wanted > 127).sum()
    return painted if alike else None


def _painted(element: ET.Element, choice: Paints) -> ET.Element:
    """Paint an element black and white, opaque and by itself, in place, and return it."""
    if element.tag == "mask":
        return element  # whose colours say how much shows
    for name in _PAINTS:
        if name in element.attrib:
            paint = _COLOUR.sub(lambda match: _tone(match, choice), element.attrib[name])
            element.set(name, paint)
    for name in _OPACITIES:
        if element.get(name, "0") not in ("0", "inherit"):
            element.set(name, "1")
    for name in _EFFECTS:
        element.attrib.pop(name, None)
    for child in element:
        _painted(child, choice)
    return element


def _tone(match: re.Match[str], choice: Paints) -> str:
    """Return the black or white that takes the place of a colour."""
    if match[1]:
        rgb = [int(match[1][at : at + 2], 16) for at in (0, 2, 4)]
    else:
        rgb = [int(match[at]) for at in (2, 3, 4)]
    white = bool(near_white(np.array(rgb, dtype=np.uint8)))
    ink = choice is Paints.ALL or white == (choice is Paints.LIGHT)
    level = 0 if ink else 255
    if match[5] is not None and float(match[5]) == 0:
        return "rgba(0,0,0,0)"
    return f"#{level:02x}{level:02x}{level:02x}"


def _traced(coverage: NDArray[np.uint8]) -> ET.Element:
    path = trace(coverage, _SPECK)
    if not path:
        raise _nothing(())
    content = ET.Element("g")
    ET.SubElement(content, "path", d=path.svg())
    return content
