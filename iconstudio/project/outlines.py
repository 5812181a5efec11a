"""Outlines in a project: contours, and patterns of them in colours."""

from typing import Annotated, Self

from msgspec import Meta

from iconstudio.inputs.formats import MOST_POINTS, Many, Points, Record, Text, plain_text
from iconstudio.model import (
    ColouredLayer,
    Contour,
    Fill,
    Icon,
    IconstudioError,
    Path,
    Patterned,
    Pictogram,
    Point,
)
from iconstudio.model.path import Segment

_Colour = Annotated[str, Meta(pattern="^(#[0-9a-fA-F]{6})?$")]
_Side = Annotated[int, Meta(ge=1, le=100_000)]
_Share = Annotated[float, Meta(ge=0, le=1)]


class StoredContour(Record, frozen=True):
    """A start, a list of one point, and segments: lists of one point, or of three."""

    segments: Many[Points]
    closed: bool = False

    @classmethod
    def of(cls, contour: Contour) -> Self:
        """Return a contour as it is stored."""
        return cls(((contour.start,), *contour.segments), contour.closed)

    @property
    def contour(self) -> Contour:
        """The value."""
        (start,), *segments = self.segments
        return Contour(start, tuple(map(_segment, segments)), self.closed)

    def check(self) -> None:
        """Refuse lists of another number of points."""
        counts = list(map(len, self.segments))
        if counts[:1] != [1] or not {1, 3}.issuperset(counts):
            raise IconstudioError("A contour begins with one point; a segment has one, or three.")


Contours = Annotated[tuple[StoredContour, ...], Meta(max_length=MOST_POINTS)]


class StoredFill(Record, frozen=True):
    """A shape, and its colour."""

    colour: _Colour = ""
    outline: Contours = ()

    @classmethod
    def of(cls, fill: Fill) -> Self:
        """Return a shape as it is stored."""
        return cls(fill.colour, tuple(map(StoredContour.of, fill.path.contours)))

    @property
    def fill(self) -> Fill:
        """The value."""
        return Fill(Path(tuple(one.contour for one in self.outline)), self.colour)


class StoredLayer(Record, frozen=True):
    """A layer, its shapes from back to front."""

    name: Text = ""
    fills: Many[StoredFill] = ()

    @classmethod
    def of(cls, layer: ColouredLayer) -> Self:
        """Return a layer as it is stored."""
        return cls(plain_text(layer.name), tuple(map(StoredFill.of, layer.fills)))

    @property
    def layer(self) -> ColouredLayer:
        """The value."""
        return ColouredLayer(self.name, tuple(one.fill for one in self.fills))


class StoredPattern(Record, frozen=True):
    """A pattern: its layers from back to front, in units of its own size."""

    layers: Many[StoredLayer]
    ground: _Colour
    width: _Side
    height: _Side
    tile: bool = False
    torn: _Share = 0.0

    @classmethod
    def of(cls, icon: Patterned) -> Self:
        """Return a pattern as it is stored."""
        layers = tuple(map(StoredLayer.of, icon.layers))
        return cls(layers, icon.ground, icon.width, icon.height, icon.tile, float(icon.torn))

    def icon(self, path: Path, title: str, credits: tuple[Pictogram, ...]) -> Icon:
        """Return the pattern."""
        return Patterned(
            path,
            title,
            credits,
            layers=tuple(one.layer for one in self.layers),
            ground=self.ground,
            width=self.width,
            height=self.height,
            tile=self.tile,
            torn=self.torn,
        )


def _segment(points: tuple[Point, ...]) -> Segment:
    if len(points) == 1:
        return (points[0],)
    first, second, end = points
    return first, second, end
