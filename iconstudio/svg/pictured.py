"""Drawings that show nothing but bitmaps: the picture that is to be read in their place.

A bitmap that is shown as it is is that picture; of those that are turned, cut, stretched or beside
each other, it is drawn as they show it.
"""

import io
import xml.etree.ElementTree as ET
from collections.abc import Sequence

from iconstudio.model import BitmapError, Frame
from iconstudio.svg.bitmaps import file_of
from iconstudio.svg.plain import Plain, document, plain
from iconstudio.svg.resvg import render_png

WHOLE = "All that it shows is a bitmap, which was traced."
SEEN = "All that it shows are bitmaps, or a part of one; they were traced as they are seen."
_LARGEST = 2048
_SMALLEST = 16
"""Pixels of the longer side of what is drawn."""
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
    return BitmapError(what, _drawn(seen, known), SEEN)


def _is_cut(drawing: Plain) -> bool:
    """Whether the sides of the page run through a drawing."""
    if drawing.page is None or drawing.bounds is None:
        return False
    page, drawn = drawing.page, drawing.bounds
    inside = [
        min(page[axis] + page[axis + 2], drawn[axis] + drawn[axis + 2])
        - max(page[axis], drawn[axis])
        for axis in (0, 1)
    ]
    missing = [drawn[axis + 2] - inside[axis] for axis in (0, 1)]
    return min(inside) > 0 and max(missing) > _BEYOND * max(page[2:])


def _drawn(drawing: Plain, files: Sequence[bytes]) -> bytes:
    """Return a PNG of a drawing with its bitmaps, about as fine as the finest of them.

    The white of those that are opaque is paper, and so is what is around them: it is drawn over
    white.
    """
    box = drawing.page or drawing.bounds or (0.0, 0.0, 1.0, 1.0)
    x, y, *sides = box
    longer = max(sides)
    found = [_side_and_opacity(one) for one in files]
    finest = max(one for one, _ in found) / max((drawing.bounds or box)[2:])
    side = min(max(round(finest * longer), _SMALLEST), _LARGEST)
    width, height = (max(1, round(side * one / longer)) for one in sides)
    paper = "#ffffff" if all(opaque for _, opaque in found) else None
    svg = document(drawing.content, box)
    return render_png(svg, Frame(x, y, longer), side, (0, 0, width, height), paper)


def _side_and_opacity(file: bytes) -> tuple[int, bool]:
    """Return how many pixels the longer side of a bitmap has, 0 if none, and if all are opaque."""
    from PIL import Image

    try:
        with Image.open(io.BytesIO(file)) as image:
            clear = image.has_transparency_data
            alpha = image.convert("RGBA").getchannel("A").getextrema() if clear else (255, 255)
            return max(image.size), alpha == (255, 255)
    except (OSError, ValueError, SyntaxError, Image.DecompressionBombError):
        return 0, False
