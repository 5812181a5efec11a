"""The lines of a drawing: outlines of what is filled, and centre lines of strokes."""

import numpy as np
from numpy.typing import NDArray

from iconstudio.model import CANVAS, Frame, IconstudioError, Line, Transform
from iconstudio.model.path import Path

_TRACED = 4 * CANVAS
"""Side of the picture that is traced, in pixels."""
_HALF = 127
"""Level of the coverage above which a drawing is dark."""
_SPECK = 0.5
"""Square canvas units of the smallest piece that is traced."""


def lines_of(svg: str, frame: Frame, coverage: NDArray[np.uint8]) -> tuple[Line, ...]:
    """Return the lines of a document on the canvas. Outlines of strokes are read as those.

    ``frame`` and ``coverage`` are those of its exemplar. Curves are flattened to within 0.02 canvas
    units. Ends and corners of strokes come out round. The document is hostile: call this in a
    worker process.

    Raises
    ------
    IconstudioError
        If there are none.
    """
    # They load libraries, which the window's own process can do without.
    from iconstudio.algorithms.contours import contours_of_path
    from iconstudio.algorithms.curves.outlined_strokes import with_strokes
    from iconstudio.algorithms.iconification.redraw import binarised
    from iconstudio.algorithms.tracing.vectorize import trace
    from iconstudio.svg.ink import own_lines
    from iconstudio.svg.resvg import render_coverage

    lines = own_lines(svg, frame, coverage)
    if lines is None:
        lines = contours_of_path(trace(binarised(render_coverage(svg, frame, _TRACED)), _SPECK))
    if not lines:
        raise IconstudioError(
            "It has no lines: all of it is too small to be seen. Draw something larger."
        )
    return with_strokes(lines)


def lines_on_page(svg: str) -> tuple[Line, ...]:
    """Return the lines of a document whose page fills the canvas: see ``lines_of``.

    Raises
    ------
    IconstudioError
        If there are none, or the document cannot be drawn.
    """
    from iconstudio.svg.rasterise import rasterise_page

    return lines_of(svg, *rasterise_page(svg))


def said_of_pale_parts(coverage: NDArray[np.uint8]) -> str:
    """Return a sentence about what becomes of the pale parts of a drawing; empty if it has none."""
    from iconstudio.algorithms.iconification.style import has_pale_areas

    left_out = has_pale_areas(coverage, high=_HALF + 1)
    inked = has_pale_areas(coverage, low=_HALF)
    match left_out, inked:
        case True, False:
            return "Its pale parts were left out: only what is dark has lines."
        case False, True:
            return "Its pale parts were drawn as dark as all others."
        case True, True:
            return "Its palest parts were left out, and the others drawn as dark as all else."
    return ""


def warm_up() -> None:
    """Load what reads lines, on a square whose gradient is read as its picture is."""
    gradient = '<linearGradient id="g"><stop/></linearGradient>'
    square = '<path d="M1 1H7V7H1Z" fill="url(#g)"/>'
    lines_on_page(
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 8 8">{gradient}{square}</svg>'
    )


def lines_of_drawing(path: Path, frame: Frame, svg: str) -> tuple[Line, ...]:
    """Return the lines of what a path fills by the nonzero rule.

    ``frame`` of the document fills the path's canvas, and the page fills that of the lines.
    """
    from iconstudio.algorithms.contours import contours_of_path
    from iconstudio.algorithms.curves.outlined_strokes import with_strokes
    from iconstudio.svg.rasterise import page_frame

    page = page_frame(svg)
    scale, unit = frame.size / page.size, CANVAS / page.size
    off = unit * (frame.x - page.x), unit * (frame.y - page.y)
    contours = contours_of_path(path.transformed(Transform(scale, 0, 0, scale, *off)))
    return with_strokes(contours)
