"""Parts inside an icon that are wholly enclosed by what is marked to go (section 4.2).

An addition to the paper: such parts, a hub or a window, are no matter of a cut. Their contours are
left out of the icon, which stays exactly as it is elsewhere; what was around them goes on.
"""

from collections.abc import Sequence
from concurrent.futures import Future
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.flattening import flattened
from iconstudio.algorithms.raster import Bitmap, fill_polygon, placed_ink
from iconstudio.model import CANVAS, Exemplar, Placement, Polygon
from iconstudio.model.composite import WHOLE
from iconstudio.model.path import Path
from iconstudio.workers import Workers
from iconstudio.workflows.drawing import MEMORY, SECONDS, Render, svg_of

_FINE = 4 * CANVAS


@dataclass(frozen=True, eq=False)
class Emptied:
    """An icon without the parts that marked areas enclose."""

    icon: Exemplar
    areas: tuple[Polygon, ...]
    """Those in which nothing is left to be done."""


def begin_emptying(
    areas: Sequence[Polygon], icon: Exemplar, workers: Workers, render: Render
) -> "Future[Emptied | None]":
    """Begin to take what ``areas`` enclose out of an icon; None if they enclose no part."""
    return workers.submit(emptied, tuple(areas), icon, render, timeout=SECONDS, memory=MEMORY)


def emptied(areas: Sequence[Polygon], icon: Exemplar, render: Render) -> Emptied | None:
    """Return an icon without the parts that areas within its outline enclose, if there are any.

    What areas reach beyond the outline is a matter of the cut: there nothing is enclosed.

    All are in canvas units. Runs in a worker process.
    """
    outline = render.outline(icon.pictogram.svg, icon.frame)
    rows = [points for points, _ in flattened(outline)]
    _, filled = placed_ink(icon, Placement(), CANVAS)
    inside = [one for one in areas if not (fill_polygon(one) & ~filled).any()]
    marked = [fill_polygon(one, _FINE) for one in inside]
    gone = {n for n, row in enumerate(rows) if any(_hits(row, one).all() for one in marked)}
    if not gone or len(gone) == len(rows):
        return None
    left = Path(tuple(one for n, one in enumerate(outline.contours) if n not in gone))
    others = [row for n, row in enumerate(rows) if n not in gone]
    done = tuple(
        area
        for area, mask in zip(inside, marked, strict=True)
        if not any(_hits(row, mask).any() for row in others)
    )
    return Emptied(_drawn(left, icon, render), done)


def _hits(points: NDArray[np.float64], mask: Bitmap) -> NDArray[np.bool_]:
    """Return which points (n, 2) of a contour lie in a mask."""
    x, y = np.clip((points.T * _FINE / CANVAS).astype(int), 0, _FINE - 1)
    hit: NDArray[np.bool_] = mask[y, x]
    return hit


def _drawn(outline: Path, icon: Exemplar, render: Render) -> Exemplar:
    """Return an icon that has an outline, with the name and the credit of another."""
    svg = svg_of(outline)
    coverage = render(svg, WHOLE, Placement(), CANVAS)
    return Exemplar(replace(icon.pictogram, svg=svg), WHOLE, coverage)
