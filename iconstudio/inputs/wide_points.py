"""Points in files that may have a width each, as where a pen's pressure changed: [x, y, width]."""

from collections.abc import Sequence
from typing import Annotated

import numpy as np
from msgspec import Meta
from numpy.typing import NDArray

from iconstudio.inputs.formats import MOST_POINTS
from iconstudio.inputs.lines import rounded
from iconstudio.model import CANVAS, IconstudioError, Point

FAR = 20.0 * CANVAS
"""No coordinate is larger."""

Length = Annotated[float, Meta(ge=-FAR, le=FAR)]
_Point = Annotated[tuple[Length, ...], Meta(min_length=2, max_length=3, title="point")]
WidePoints = Annotated[tuple[_Point, ...], Meta(max_length=MOST_POINTS)]


def wide_points(points: Sequence[Point], widths: Sequence[float]) -> WidePoints:
    """Return points as they are written, with their widths if they have some."""
    plain = rounded(tuple(points))
    if not widths:
        return plain
    return tuple((x, y, round(width, 2)) for (x, y), width in zip(plain, widths, strict=True))


def parted(points: WidePoints) -> tuple[tuple[Point, ...], tuple[float, ...]]:
    """Return the places of points, and their widths; none if they have none."""
    places = tuple((point[0], point[1]) for point in points)
    return places, tuple(point[2] for point in points if len(point) == 3)


def carried(
    widths: Sequence[float], points: Sequence[Point], kept: Sequence[Point]
) -> tuple[float, ...]:
    """Return the widths of points (n,) at those that were kept of them, as far along the line."""
    if len(kept) == len(points):
        return tuple(widths)
    found: list[float] = np.interp(_along(kept), _along(points), widths).tolist()
    return tuple(found)


def _along(points: Sequence[Point]) -> NDArray[np.float64]:
    """Return how far along a line its points are, from 0 to 1."""
    steps = np.hypot(*np.diff(np.array(points), axis=0).T)
    along: NDArray[np.float64] = np.append(0.0, np.cumsum(steps))
    along /= max(along[-1], 1e-12)
    return along


def check_widths(points: WidePoints, what: str) -> None:
    """Refuse points of which only some have a width, and widths that are none.

    Raises
    ------
    IconstudioError
        If they are so; ``what`` they are of is named.
    """
    if len({len(point) for point in points}) > 1:
        raise IconstudioError(
            f"Some points of the {what} have a width, and some have none. "
            "Give all of them one, or none."
        )
    widths = [point[2] for point in points if len(point) == 3]
    if not all(0 <= width <= CANVAS for width in widths):
        raise IconstudioError(f"Widths of the {what} are from 0 to {CANVAS}.")
    if widths and not any(widths):
        raise IconstudioError(
            f"All widths of the {what} are 0, and nothing of it would be seen. "
            "Give some of them more, or leave the widths out."
        )
