"""The lines of a drawing: outlines of what is filled, and centre lines of what is stroked."""

import numpy as np
from numpy.typing import NDArray

from iconstudio.model import CANVAS, Frame, IconstudioError, Line
from iconstudio.model.path import Path

_TRACED = 4 * CANVAS
"""Side of the picture that is traced, in pixels."""
_SPECK = 0.5
"""Square canvas units of the smallest piece that is traced."""


def lines_of(svg: str, frame: Frame, coverage: NDArray[np.uint8]) -> tuple[Line, ...]:
    """Return the lines of a document on the canvas.

    ``frame`` and ``coverage`` are those of its exemplar. Curves are flattened to within 0.02 canvas
    units. Ends and corners of strokes come out round. The document is hostile: call this in a
    worker process.

    Raises
    ------
    IconstudioError
        If there are none.
    """
    # They load libraries, which the window's own process can do without.
    from iconstudio.algorithms.iconification.redraw import binarised
    from iconstudio.algorithms.tracing.vectorize import trace
    from iconstudio.svg.ink import own_lines
    from iconstudio.svg.resvg import render_coverage

    lines = own_lines(svg, frame, coverage)
    if lines is None:
        lines = lines_of_path(trace(binarised(render_coverage(svg, frame, _TRACED)), _SPECK))
    if not lines:
        raise IconstudioError(
            "It has no lines: all of it is too small to be seen. Draw something larger."
        )
    return lines


def lines_of_path(path: Path) -> tuple[Line, ...]:
    """Return the contours of what a path fills by the nonzero rule."""
    from iconstudio.algorithms.contours import contours_of_path

    return contours_of_path(path)
