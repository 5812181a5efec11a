"""Lines: what is restyled, and what comes of it."""

from dataclasses import dataclass

from iconstudio.model.polygon import Point


@dataclass(frozen=True, slots=True)
class Line:
    """A contour of a filled shape, or the centre line of a stroke; straight between its points.

    All contours of a drawing together are filled, by the nonzero rule.
    """

    points: tuple[Point, ...]
    """In canvas units; a closed line goes on from the last to the first."""
    closed: bool = False
    width: float = 0.0
    """Of the stroke, in canvas units; 0 for a contour."""
    widths: tuple[float, ...] = ()
    """Of the stroke at each point, where it is not the same all along."""
    filled: bool = False
    """Whether what a closed stroke encloses is filled, too."""
