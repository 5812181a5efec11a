"""The path of a joined drawing (section 3.4, post-processing), of its sources' own curves.

The paper traces the joined picture. Here what is traced is compared with the outlines of the
sources: away from seams these are the path. Sources that nearly meet are moved until they do, and
what lies between two of them is healed.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms import regions
from iconstudio.algorithms.iconification.alignment import alignment, moved
from iconstudio.algorithms.iconification.healing import Examples, healed
from iconstudio.algorithms.regions import RegionError
from iconstudio.algorithms.tidying.sides import Side, Sides
from iconstudio.algorithms.tracing.exact import SourceCurves, joined
from iconstudio.algorithms.tracing.pieces import owned_pieces_of
from iconstudio.algorithms.tracing.vectorize import SPECK, TOLERANCE, contour_of, outlines
from iconstudio.model import CANVAS
from iconstudio.model.path import Path


def joined_path(coverage: NDArray[np.uint8], sources: Sequence[Path], heal: bool = True) -> Path:
    """Return the outline of a joined drawing in canvas units, to a hundredth of one.

    For what it is made of see ``joined_sides``.
    """
    return path_along(joined_sides(coverage, sources, heal))


def joined_sides(
    coverage: NDArray[np.uint8], sources: Sequence[Path], heal: bool = True
) -> list[Sides]:
    """Return the contours of a joined drawing in canvas units; they may cross where it is narrow.

    Parameters
    ----------
    coverage
        (n, n) uint8, 255 = ink; n canvas pixels to CANVAS.
    sources
        The outlines of what was joined, where it was drawn, in canvas units; each overlaps itself
        nowhere. An empty one is not known.
    heal
        Whether sources are moved, by two canvas units at most, and seams are made anew.
    """
    unit = CANVAS / len(coverage)
    drawn = [one.even() for one in outlines(coverage)]
    curves = SourceCurves(sources, unit)
    followed = curves.followed(drawn)
    moves = np.zeros(len(sources), dtype=np.complex128)
    if heal:
        moves = alignment(drawn, followed, len(sources), unit)
        examples = Examples.of(curves.oriented(), unit)
    contours: list[Sides] = []
    for outline, rows in zip(drawn, followed, strict=True):
        outline, rows = moved(outline, rows, moves)
        rows = joined(rows, outline)
        runs = [row.run() for row in rows]
        if heal:
            outline, runs = healed(outline, rows, examples, unit)
        found = owned_pieces_of(outline, TOLERANCE / unit, 1, runs)
        contours.append([Side.of(piece, owner, unit) for piece, owner in found])
    return contours


def path_along(contours: Sequence[Sides]) -> Path:
    """Return contours as a path that overlaps itself nowhere, to a hundredth of a unit."""
    pieces = ([side.piece for side in sides] for sides in contours if sides)
    return _without_overlaps(Path(tuple(contour_of(one, 1.0) for one in pieces)))


def _without_overlaps(path: Path) -> Path:
    """Return a path whose contours do not cross, nor enclose specks where they did."""
    try:
        clean = regions.outline(regions.united([regions.filled(path)]))
    except RegionError:
        return path
    if _segments(clean) == _segments(path):
        return path
    return Path(tuple(one for one in clean.contours if abs(Path((one,)).area) >= SPECK))


def _segments(path: Path) -> int:
    return sum(len(one.segments) for one in path.contours)
