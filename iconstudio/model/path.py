"""Outlines: contours of lines and cubics, drawn onto any pen of fontTools' pen protocol."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Protocol, cast

from fontTools.misc.transform import Transform as Transform

from iconstudio.model.canvas import CANVAS
from iconstudio.model.polygon import Point

OVERHANG = 0.5
"""Canvas units by which the outline of what fills the canvas may reach out of it: rounding."""

Line = tuple[Point]
"""The end of a straight segment, which begins where the one before ends."""
Cubic = tuple[Point, Point, Point]
"""Two control points and the end of a cubic Bézier segment."""
Segment = Line | Cubic


class Pen(Protocol):
    """What a path is drawn onto: any pen of fontTools, or of skia-pathops."""

    def moveTo(self, pt: Point) -> None:
        """Begin a contour."""

    def lineTo(self, pt: Point) -> None:
        """Go straight to a point."""

    def curveTo(self, *points: Point) -> None:
        """Go along a cubic: two control points and the end."""

    def closePath(self) -> None:
        """End a contour where it began."""

    def endPath(self) -> None:
        """End a contour where it is."""


@dataclass(frozen=True, slots=True)
class Contour:
    """A start, and the segments from there on; a closed one goes back to its start."""

    start: Point
    segments: tuple[Segment, ...] = ()
    closed: bool = True

    @property
    def points(self) -> Iterator[Point]:
        """All its points, control points too, in order."""
        yield self.start
        for segment in self.segments:
            yield from segment


@dataclass(frozen=True, slots=True)
class Path:
    """An outline in canvas units, filled with the nonzero rule.

    >>> square = Path((Contour((0, 0), (((8, 0),), ((8, 8),), ((0, 8),))),))
    >>> square.svg()
    'M0 0H8V8H0Z'
    """

    contours: tuple[Contour, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.contours)

    def draw(self, pen: Pen) -> None:
        """Draw all contours onto a pen."""
        for contour in self.contours:
            pen.moveTo(contour.start)
            for segment in contour.segments:
                if len(segment) == 1:
                    pen.lineTo(segment[0])
                else:
                    pen.curveTo(*segment)
            if contour.closed:
                pen.closePath()
            else:
                pen.endPath()

    def transformed(self, transform: Transform) -> "Path":
        """Return the path moved by an affine map; a closed contour keeps its order.

        >>> Path((Contour((1, 2), (((3, 4),),)),)).transformed(Transform(-1, 0, 0, 1, 8, 0)).svg()
        'M7 2 5 4Z'
        """
        return Path(
            tuple(
                Contour(
                    transform.transformPoint(one.start),
                    tuple(_moved(segment, transform) for segment in one.segments),
                    one.closed,
                )
                for one in self.contours
            )
        )

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Left, top, right and bottom of what it covers; it must not be empty."""
        from fontTools.pens.boundsPen import BoundsPen

        pen = BoundsPen(None)
        self.draw(pen)
        return cast(tuple[float, float, float, float], pen.bounds)

    @property
    def area(self) -> float:
        """What its contours enclose; negative if they run the other way, as holes do.

        >>> Path((Contour((0, 0), (((8, 0),), ((8, 8),), ((0, 8),))),)).area
        64.0
        """
        from fontTools.pens.areaPen import AreaPen

        pen = AreaPen(None)
        self.draw(pen)
        return float(pen.value)

    @property
    def overhang(self) -> float:
        """By how much it reaches out of the canvas at most, in canvas units; 0 if it does not."""
        if not self:
            return 0.0
        left, top, right, bottom = self.bounds
        return max(0.0, -left, -top, right - CANVAS, bottom - CANVAS)

    def svg(self) -> str:
        """Return SVG path data, to a hundredth of a unit."""
        from fontTools.pens.svgPathPen import SVGPathPen

        pen = SVGPathPen(None, _number)
        self.draw(pen)
        data: str = pen.getCommands()
        return data


class PathPen:
    """A pen that makes a ``Path`` of what is drawn onto it: ``path``, once all is drawn."""

    def __init__(self) -> None:
        self._contours: list[Contour] = []
        self._segments: list[Segment] = []
        self._start: Point = (0.0, 0.0)

    @property
    def path(self) -> Path:
        """What has been drawn."""
        return Path(tuple(self._contours))

    def moveTo(self, pt: Point) -> None:
        """Begin a contour."""
        self._start, self._segments = _point(pt), []

    def lineTo(self, pt: Point) -> None:
        """Go straight to a point."""
        self._segments.append((_point(pt),))

    def curveTo(self, *points: Point) -> None:
        """Go along a cubic: two control points and the end."""
        first, second, end = map(_point, points)
        self._segments.append((first, second, end))

    def closePath(self) -> None:
        """End a contour where it began."""
        self._end(closed=True)

    def endPath(self) -> None:
        """End a contour where it is."""
        self._end(closed=False)

    def _end(self, closed: bool) -> None:
        self._contours.append(Contour(self._start, tuple(self._segments), closed))


def _moved(segment: Segment, transform: Transform) -> Segment:
    if len(segment) == 1:
        return (transform.transformPoint(segment[0]),)
    first, second, end = map(transform.transformPoint, segment)
    return first, second, end


def _point(pt: Point) -> Point:
    """Take plain numbers only: those of NumPy would be written out as ``np.float64(0.9)``."""
    return float(pt[0]), float(pt[1])


def _number(value: float) -> str:
    return f"{round(value, 2) + 0:.2f}".rstrip("0").rstrip(".")
