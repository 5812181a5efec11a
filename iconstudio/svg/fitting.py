"""Where the drawing is on its page: a hairline in the corner of a poster is found, too."""

import numpy as np

from iconstudio.model import CANVAS, MARGIN, Frame
from iconstudio.svg.lengths import Box
from iconstudio.svg.resvg import render_colours

_SIDE = 256
_FAINT = 2
"""Alpha from which a pixel may be part of the drawing."""
_ROUNDS = 6
_LARGE = 0.6
"""Part of the frame that a drawing fills for its bounds to be known well."""


def fitted(svg: str, box: Box, fonts: list[str]) -> Frame | None:
    """Return the square around what a document shows within ``box``; None if that is nothing.

    The longer side of the drawing measures ``CANVAS - 2 * MARGIN`` of ``CANVAS``.
    """
    frame = square(box)
    for _ in range(_ROUNDS):
        alpha = render_colours(svg, frame, _SIDE, fonts)[:, :, 3]
        seen = alpha >= _FAINT
        rows, columns = np.flatnonzero(seen.any(axis=1)), np.flatnonzero(seen.any(axis=0))
        if not len(rows):
            return None
        unit = frame.size / _SIDE
        left, top = int(columns[0]), int(rows[0])
        right, bottom = int(columns[-1]) + 1, int(rows[-1]) + 1
        extent = max(right - left, bottom - top)
        side = (extent if extent > _LARGE * _SIDE else extent + 2) * unit
        size = side * CANVAS / (CANVAS - 2 * MARGIN)
        frame = Frame(
            frame.x + (left + right) / 2 * unit - size / 2,
            frame.y + (top + bottom) / 2 * unit - size / 2,
            size,
        )
        if extent > _LARGE * _SIDE:
            break
    return frame


def square(box: Box) -> Frame:
    """Return a square around a box, a little larger."""
    x, y, width, height = box
    size = max(width, height) * 1.1 or 1.0
    return Frame(x + (width - size) / 2, y + (height - size) / 2, size)
