"""Drawings that show nothing but bitmaps: the picture that is to be read in their place.

A bitmap that is shown as it is is that picture; of those that are turned, cut, stretched or beside
each other, it is drawn as they show it.
"""

import io
import xml.etree.ElementTree as ET
from collections.abc import Sequence
from typing import NamedTuple

from iconstudio.model import BitmapError, Frame
from iconstudio.svg.bitmaps import file_of
from iconstudio.svg.lengths import Box
from iconstudio.svg.plain import Plain, document, plain
from iconstudio.svg.resvg import render_png

WHOLE = "All that it shows is a bitmap, which was traced."
SEEN = "All that it shows is a bitmap, cut or turned, say; it was traced as it is seen there."
TOGETHER = "All that it shows are bitmaps, which were traced as they are seen there."
_LARGEST = 2048
_SMALLEST = 16
"""Pixels of the longer side of what is drawn."""
_FORMATS = ("PNG", "JPEG", "GIF", "WEBP")
"""Those that the renderer draws."""
_BEYOND = 0.02
"""Part of the page that what is seen whole may reach beyond it."""


def bitmap_error(
    what: str, drawing: Plain, root: ET.Element, symbol: str | None
) -> BitmapError | None:
    """Return the error that hands over the bitmaps that a drawing shows; None if it holds none.

    Parameters
    ----------
    what
        Says that it shows no shapes.
    root
        The same document, as parsed; it is changed.
    symbol
        The id of what is wanted of it, if that is not all.
    """
    files = [file_of(one.address) for one in drawing.bitmaps]
    known = [one for one in files if one is not None]
    if not files or len(known) < len(files):
        return None
    seen = plain(root, (), symbol, with_bitmaps=True)
    if len(files) == 1 and drawing.bitmaps[0].whole and not _is_cut(seen):
        return BitmapError(what, known[0], WHOLE)
    found = [one for one in map(_bitmap, known) if one is not None]
    if len(found) < len(known):
        return None
    return BitmapError(what, _drawn(seen, found), SEEN if len(files) == 1 else TOGETHER)


def _is_cut(drawing: Plain) -> bool:
    """Whether the sides of the page run through a drawing."""
    if drawing.page is None or drawing.bounds is None:
        return False
    inside = _common(drawing.page, drawing.bounds)
    missing = [drawing.bounds[axis + 2] - inside[axis] for axis in (0, 1)]
    return min(inside) > 0 and max(missing) > _BEYOND * max(drawing.page[2:])


def _common(page: Box, drawn: Box) -> tuple[float, float]:
    """Return width and height of what two boxes have in common, which are negative if they miss."""
    width, height = (
        min(page[axis] + page[axis + 2], drawn[axis] + drawn[axis + 2])
        - max(page[axis], drawn[axis])
        for axis in (0, 1)
    )
    return width, height


class _Bitmap(NamedTuple):
    """What is known of a file of a bitmap."""

    side: int
    """Pixels of its longer side."""
    opaque: bool
    """Whether all of them are."""


def _drawn(drawing: Plain, bitmaps: Sequence[_Bitmap]) -> bytes:
    """Return a PNG of a drawing with its bitmaps, about as fine as the finest of them.

    The white of those that are opaque is paper, and so is what is around them: it is drawn over
    white.
    """
    drawn = drawing.bounds or (0.0, 0.0, 1.0, 1.0)
    page = drawing.page or drawn
    box = page if min(_common(page, drawn)) > 0 else drawn
    x, y, *sides = box
    longer = max(sides)
    finest = max(one.side for one in bitmaps) / max(drawn[2:])
    side = min(max(round(finest * longer), _SMALLEST), _LARGEST)
    width, height = (max(1, round(side * one / longer)) for one in sides)
    paper = "#ffffff" if all(one.opaque for one in bitmaps) else None
    svg = document(drawing.content, box)
    return render_png(svg, Frame(x, y, longer), side, (0, 0, width, height), paper)


def _bitmap(file: bytes) -> _Bitmap | None:
    """Return what is known of a file; None if the renderer draws no such, or it is damaged."""
    from PIL import Image

    try:
        with Image.open(io.BytesIO(file), formats=_FORMATS) as image:
            image.load()
            clear = image.has_transparency_data
            alpha = image.convert("RGBA").getchannel("A").getextrema() if clear else (255, 255)
            return _Bitmap(max(image.size), alpha == (255, 255))
    except (OSError, ValueError, SyntaxError, Image.DecompressionBombError):
        return None
