"""The adapter of resvg: draws a square of an SVG document as an array.

The document is nested in a new root whose ``viewBox`` is the square to show. Clipping to the
document's own canvas is done in the array, which takes a third off resvg's time.
"""

import io
import math
import xml.etree.ElementTree as ET
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from resvg_py import __version__, svg_to_bytes

from iconstudio.model import Frame, IconstudioError
from iconstudio.svg.lengths import Box, numbers, pixels
from iconstudio.svg.mark import PAGE

if TYPE_CHECKING:
    from PIL.Image import Image

__all__ = [
    "VERSION",
    "Window",
    "render_colours",
    "render_coverage",
    "render_png",
    "view_box",
]

VERSION = __version__
"""Of resvg-py: another version may draw differently."""

Window = tuple[int, int, int, int]
"""Left, top, right and bottom in pixels."""

_SVG = "http://www.w3.org/2000/svg"
_LARGEST = 1e6
_FAMILY = "Inter"
"""Of the fonts that come with the program."""


def view_box(svg: str) -> Box:
    """Return the canvas of a document, in the user space that a ``Frame`` refers to.

    That is its ``viewBox``; where ``width`` and ``height`` have another ratio, the height
    is changed to theirs. Without ``viewBox``, it is (0, 0, width, height) in CSS pixels.

    Raises
    ------
    IconstudioError
        If the document has no size, or none that can be drawn.
    """
    return _view_box(_root(svg))


def page_of(svg: str) -> Box:
    """Return the box in which the lines of a document keep their scale: its ``view_box``, mostly.

    Raises
    ------
    IconstudioError
        If the document is not well-formed, or its size is missing or out of all scale.
    """
    root = _root(svg)
    said = numbers(root.get(PAGE, ""))
    if len(said) == 4:
        x, y, width, height = said
        if _is_in_scale((x, y, width, height)):
            return x, y, width, height
    return _view_box(root)


def render_coverage(
    svg: str, frame: Frame, size: int, window: Window | None = None
) -> NDArray[np.uint8]:
    """Draw ``frame`` of a document, ``currentColor`` being black.

    Parameters
    ----------
    svg:
        A complete document that has passed ``check.check``.
    frame:
        The square of its user space to show; what lies outside its ``view_box`` stays empty.
    size:
        Side of the picture in pixels.
    window:
        The part of the picture to draw, which may reach beyond it; by default all. The time that
        drawing takes grows with its area.

    Returns
    -------
    (size, size) uint8, or as large as the window: alpha times darkness, 255 = opaque black.

    Raises
    ------
    IconstudioError
        If resvg cannot read the document.
    """
    # Over white, 255 - grey is alpha times darkness.
    image, box, corner, unit = _drawn(svg, frame, size, window, background="#ffffff")
    coverage = 255 - np.asarray(image.convert("L"))
    # A layer of half opacity comes out as 127 or 128; it is not *more* than half dark.
    coverage[coverage == 128] = 127
    _clip(coverage, box, corner, unit)
    return coverage


def render_colours(
    svg: str, frame: Frame, size: int, fonts: Sequence[str] = ()
) -> NDArray[np.uint8]:
    """Draw ``frame`` of a document in its colours, over nothing.

    ``fonts`` are files, of which the first is for all text whose font is not there.

    Returns
    -------
    (size, size, 4) uint8: red, green, blue, and alpha that is not multiplied into them.

    Raises
    ------
    IconstudioError
        If resvg cannot read the document.
    """
    image, box, corner, unit = _drawn(svg, frame, size, None, fonts=fonts)
    colours = np.array(image.convert("RGBA"))
    _clip(colours[:, :, 3], box, corner, unit)
    return colours


def render_png(
    svg: str, frame: Frame, size: int, window: Window, background: str | None = None
) -> bytes:
    """Draw a window of ``frame`` of a document as a PNG, bitmaps and what is off its canvas, too.

    ``background`` is the colour that it is drawn over; None for nothing.

    Raises
    ------
    IconstudioError
        If resvg cannot read the document.
    """
    root = _root(svg)
    return _png(root, _view_box(root), frame, size, window, background, ())


def _drawn(
    svg: str,
    frame: Frame,
    size: int,
    window: Window | None,
    background: str | None = None,
    fonts: Sequence[str] = (),
) -> "tuple[Image, Box, tuple[float, float], float]":
    """Return a picture, the document's canvas, and the picture's corner and unit in user space."""
    root = _root(svg)
    box = _view_box(root)
    window = window or (0, 0, size, size)
    png = _png(root, box, frame, size, window, background, fonts)
    unit = frame.size / size
    corner = frame.x + window[0] * unit, frame.y + window[1] * unit
    from PIL import Image

    with Image.open(io.BytesIO(png)) as image:
        image.load()
        return image, box, corner, unit


def _png(
    root: ET.Element,
    box: Box,
    frame: Frame,
    size: int,
    window: Window,
    background: str | None,
    fonts: Sequence[str],
) -> bytes:
    """Return a PNG of a window of a document, whose canvas is ``box``."""
    for name, value in zip(("x", "y", "width", "height"), box, strict=True):
        root.set(name, repr(float(value)))
    if "viewBox" not in root.attrib:
        root.set("viewBox", _numbers(box))
    root.set("overflow", "visible")
    left, top, right, bottom = window
    width, height = right - left, bottom - top
    unit = frame.size / size
    corner = frame.x + left * unit, frame.y + top * unit
    shown = _numbers((*corner, width * unit, height * unit))
    outer = ET.Element(f"{{{_SVG}}}svg", viewBox=shown, width=str(width), height=str(height))
    outer.append(root)
    family = _FAMILY if fonts else None
    try:
        return bytes(
            svg_to_bytes(
                svg_string=ET.tostring(outer, encoding="unicode"),
                background=background,
                # Without it, sizes in pt or mm raise.
                dpi=96,
                skip_system_fonts=True,
                font_files=list(fonts) or None,
                font_family=family,
                serif_family=family,
                sans_serif_family=family,
                monospace_family=family,
            )
        )
    except ValueError as error:
        raise IconstudioError(f"The SVG cannot be drawn: {error}.") from None
    except BaseException as error:
        if type(error).__name__ != "PanicException":  # it cannot be imported
            raise
        raise IconstudioError("The SVG cannot be drawn: the renderer fails on it.") from None


def _root(svg: str) -> ET.Element:
    try:
        return ET.fromstring(svg)
    except ET.ParseError as error:
        raise IconstudioError(f"The SVG is not well-formed XML: {error}.") from None


def _view_box(root: ET.Element) -> Box:
    across, down = pixels(root.get("width")), pixels(root.get("height"))
    box = numbers(root.get("viewBox", ""))
    if len(box) == 4:
        x, y, width, height = box
        if across is not None and down is not None and across > 0:
            height = width * down / across
    elif across is not None and down is not None:
        x, y, width, height = 0.0, 0.0, across, down
    elif "viewBox" in root.attrib:
        raise IconstudioError(
            "It is out of all scale: its size is no number. Correct the shape, the width of a "
            "stroke or the viewBox that is so large."
        )
    else:
        raise IconstudioError("The SVG has no size: give its root a viewBox.")
    if not _is_in_scale((x, y, width, height)):
        raise IconstudioError(
            f"It is out of all scale: {width:g} by {height:g} units at ({x:g}, {y:g}). Correct the "
            "shape, the width of a stroke or the viewBox that is so large, or so small."
        )
    return x, y, width, height


def _is_in_scale(box: Box) -> bool:
    x, y, width, height = box
    return (
        max(abs(x), abs(y)) <= _LARGEST
        and min(width, height) >= 1 / _LARGEST
        and max(width, height) <= _LARGEST
    )


def _numbers(values: Box) -> str:
    return " ".join(repr(float(value)) for value in values)


def _clip(coverage: NDArray[np.uint8], box: Box, corner: tuple[float, float], unit: float) -> None:
    """Empty what lies outside ``box``, fading the pixels that its edges cross.

    ``corner`` and ``unit`` are the picture's top left corner, and the side of a pixel.
    """
    edges = (
        (coverage.T, (box[0] - corner[0]) / unit, (box[0] + box[2] - corner[0]) / unit),
        (coverage, (box[1] - corner[1]) / unit, (box[1] + box[3] - corner[1]) / unit),
    )
    for rows, low, high in edges:
        size = len(rows)
        low, high = min(max(low, 0.0), size), min(max(high, 0.0), size)
        first, last = math.floor(low), math.ceil(high)
        rows[:first] = 0
        rows[last:] = 0
        if first < size and low > first:
            rows[first] = rows[first] * (first + 1 - low)
        if last > 0 and high < last:
            rows[last - 1] = rows[last - 1] * (high - last + 1)
