"""The contact sheet of a whole set: small icons in many columns, each with its name."""

import math
from collections.abc import Generator, Sequence
from pathlib import Path

from PIL import Image

from iconstudio.grammar import counted
from iconstudio.output.figure import MUTED, Figure
from iconstudio.svg.rasterise import page_frame
from iconstudio.svg.resvg import render_coverage

PER_SHEET = 2000
"""Most icons of a sheet."""
_EDGE, _HEAD = 40, 110
_SIDE, _GAP = 64, 28
_BELOW = 20
"""Room for a name."""
_FEWEST = 12
"""Columns."""


def set_sheet(title: str, count: int, files: Sequence[Path]) -> Generator[float, None, Image.Image]:
    """Return a picture of icons that this program wrote, yielding how far it is.

    ``count`` is how many there are on all sheets together.
    """
    step_x, step_y = _SIDE + _GAP, _SIDE + _GAP + _BELOW
    across = max(_FEWEST, math.ceil(math.sqrt(1.5 * len(files))))
    lines = -(-len(files) // across)
    figure = Figure(2 * _EDGE + across * step_x, _HEAD + lines * step_y + _EDGE)
    right = figure.picture.width - _EDGE
    figure.text(_EDGE, 36, title, 34, bold=True, width=right - _EDGE - 160)
    figure.text(right, 48, counted(count, "icon"), 20, colour=MUTED, anchor="ra")
    for number, file in enumerate(files):
        x, y = _EDGE + number % across * step_x, _HEAD + number // across * step_y
        svg = file.read_text("utf-8")
        ink = render_coverage(svg, page_frame(svg), 2 * _SIDE)
        figure.stencil(x + _GAP / 2, y, _SIDE, ink)
        middle, width = x + step_x / 2, step_x - 6
        figure.text(middle, y + _SIDE + 4, file.stem, 12, colour=MUTED, width=width, anchor="ma")
        yield (number + 1) / len(files)
    return figure.picture
