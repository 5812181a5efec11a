"""A drawing in its own colours, as pixels of its canvas."""

import xml.etree.ElementTree as ET

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from iconstudio.model import CANVAS, Frame, IconstudioError
from iconstudio.svg.bounds import union
from iconstudio.svg.credits import attributed, metadata
from iconstudio.svg.decode import decode
from iconstudio.svg.lengths import Box, mapped
from iconstudio.svg.markup import markup_of
from iconstudio.svg.monochrome import fonts_of
from iconstudio.svg.near import brought_near
from iconstudio.svg.parse import parse
from iconstudio.svg.pictured import bitmap_error
from iconstudio.svg.plain import document, plain
from iconstudio.svg.resvg import render_colours
from iconstudio.svg.strokes import coarsened

SIDE = 2 * CANVAS
"""Pixels of the longer side of the canvas, and of what is looked at beyond it."""
_FARTHEST = 8.0
"""So many times the side of the canvas is looked at, at most."""
_FAINT = 2
"""Alpha from which a pixel is part of the drawing."""

EMPTY = "There is nothing to be seen in it: it is empty, or all of it is transparent."
OUTSIDE = "Nothing of it lies on its canvas. Move it there, or make the canvas larger."
ONE_OUTSIDE = "An object lies outside its canvas, and was left out."
SOME_OUTSIDE = "{} objects lie outside its canvas, and were left out."


def artwork(
    data: bytes, symbol: str | None = None
) -> tuple[NDArray[np.uint8], ET.Element | None, list[str]]:
    """Return an SVG document in its colours, its metadata, and what could not be read of it.

    The pixels are (h, w, 4): red, green, blue, and alpha. The rest are sentences.

    Parameters
    ----------
    symbol
        The id of what is wanted of it, if that is not all.

    Raises
    ------
    BitmapError
        If all that it shows is a bitmap.
    IconstudioError
        If it is no SVG, shows nothing on its canvas, or is not safe to draw.
    """
    markup, unread = markup_of(decode(data))
    root, left_out = parse(markup)
    rdf = metadata(root)
    drawing = plain(root, [*unread, *left_out], symbol)
    rdf = attributed(rdf, drawing.author, "")
    fonts, said = fonts_of(drawing.texts)
    remarks = [*drawing.remarks, *said]
    if drawing.bounds is None or not max(drawing.bounds[2:]):
        why = " ".join(["There is nothing to be seen in it.", *remarks])
        raise bitmap_error(why, drawing, parse(markup)[0], symbol) or IconstudioError(why)
    page = drawing.page or drawing.bounds
    content, matrix = brought_near(drawing.content, page, drawing.bounds)
    page, bounds = mapped(matrix, page), mapped(matrix, drawing.bounds)
    content, fine = coarsened(content, max(page[2:]), page)
    pixels = _drawn(content, page, SIDE, fonts)
    outside = _outside(content, page, bounds, fonts)
    if (pixels[..., 3] < _FAINT).all():
        raise IconstudioError(OUTSIDE if outside else EMPTY)
    if outside:
        remarks.append(ONE_OUTSIDE if outside == 1 else SOME_OUTSIDE.format(outside))
    return pixels, rdf, list(dict.fromkeys([*remarks, *fine]))


def _drawn(content: ET.Element, box: Box, side: int, fonts: list[str]) -> NDArray[np.uint8]:
    """Return a part of user space, its longer side in so many pixels."""
    x, y, width, height = box
    longer = max(width, height)
    colours = render_colours(document(content, box), Frame(x, y, longer), side, fonts)
    rows, columns = (max(1, round(side * one / longer)) for one in (height, width))
    return np.ascontiguousarray(colours[:rows, :columns])


def _outside(content: ET.Element, page: Box, drawn: Box, fonts: list[str]) -> int:
    """Return how many objects that do not touch each other lie outside the canvas."""
    x, y, width, height = page
    reach = _FARTHEST * max(width, height)
    left, top = max(drawn[0], x - reach), max(drawn[1], y - reach)
    right = min(drawn[0] + drawn[2], x + width + reach)
    bottom = min(drawn[1] + drawn[3], y + height + reach)
    around = union([page, (left, top, max(right - left, 0.0), max(bottom - top, 0.0))])
    assert around is not None
    if max(around[2] / width, around[3] / height) < 1.01:
        return 0
    alpha = _drawn(content, around, SIDE, fonts)[..., 3]
    objects, count = ndimage.label(alpha >= _FAINT, np.ones((3, 3)))
    unit = max(around[2:]) / SIDE
    first = [int((one - corner) / unit) for one, corner in zip((y, x), around[1::-1], strict=True)]
    last = [one + int(side / unit) + 1 for one, side in zip(first, (height, width), strict=True)]
    window = (slice(max(0, a - 1), b + 1) for a, b in zip(first, last, strict=True))
    return int(count) - int((np.unique(objects[tuple(window)]) > 0).sum())
