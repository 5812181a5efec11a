"""MONTAGE.json: icons on one canvas, and scribbles over the parts to keep (section 4.4)."""

from pathlib import Path
from typing import Annotated, Self

from msgspec import Meta

from iconstudio.inputs.formats import MOST_POINTS, Many, Reference, StrictRecord
from iconstudio.inputs.lines import line, meets_canvas, rounded
from iconstudio.model import CANVAS, IconstudioError, Layer, Montage, Placement, Stroke
from iconstudio.workflows.files import open_file
from iconstudio.workflows.montage.montage import LARGEST, SMALLEST
from iconstudio.workflows.workflow import File, Find, Refer

FAR = 20.0 * CANVAS
"""No coordinate of a layer or a stroke is larger."""

Length = Annotated[float, Meta(ge=-FAR, le=FAR)]
"""In canvas units (0 to 256), y down."""


class StrokeFile(StrictRecord, frozen=True):
    """A scribble."""

    width: Annotated[float, Meta(gt=0, le=2 * CANVAS)]
    points: Annotated[tuple[tuple[Length, Length], ...], Meta(max_length=MOST_POINTS)]

    @classmethod
    def of(cls, stroke: Stroke) -> Self:
        """Return a stroke as it is written: a dot as a very short line, as older versions read."""
        points = rounded(stroke.points)
        if len(set(points)) == 1:
            x, y = points[0]
            points = ((x, y), (round(x + 0.1, 2), y))
        return cls(width=stroke.width, points=points)

    @property
    def stroke(self) -> Stroke:
        """The value."""
        is_dot = len(set(self.points)) == 1
        return Stroke(self.width, self.points[:1] if is_dot else line(self.points))

    @property
    def meets_canvas(self) -> bool:
        """Whether the box around it has a part of the canvas."""
        return meets_canvas(self.points, self.width)

    def check(self) -> None:
        """Refuse what is neither a line nor a dot."""
        if not self.points:
            raise IconstudioError("The stroke has no point.")


class LayerFile(StrictRecord, frozen=True):
    """An icon: mirrored left to right if ``flip``, scaled about the canvas's centre, shifted."""

    icon: Reference
    scale: Annotated[float, Meta(ge=SMALLEST, le=LARGEST)] = 1.0
    flip: bool = False
    dx: Length = 0.0
    dy: Length = 0.0
    strokes: Many[StrokeFile] = ()

    @classmethod
    def of(cls, layer: Layer, refer: Refer) -> Self:
        """Return a layer as it is written."""
        at, strokes = layer.placement, tuple(map(StrokeFile.of, layer.strokes))
        return cls(refer(layer.icon), at.scale, at.flip, at.dx, at.dy, strokes)

    @property
    def meets_canvas(self) -> bool:
        """Whether the square that its icon is drawn in has a part of the canvas."""
        return max(abs(self.dx), abs(self.dy)) < CANVAS / 2 * (1 + self.scale)

    def resolved(self, find: Find) -> Layer:
        """Return the layer, its icon found by ``find``."""
        placement = Placement(self.scale, self.flip, round(self.dx), round(self.dy))
        return Layer(find(self.icon), placement, tuple(one.stroke for one in self.strokes))

    def check(self) -> None:
        """Refuse strokes that cannot be seen."""
        if self.strokes and not any(one.meets_canvas for one in self.strokes):
            its = "Its stroke lies" if len(self.strokes) == 1 else "All its strokes lie"
            raise IconstudioError(f"{its} outside the canvas. Draw between 0 and {CANVAS}.")


class MontageFile(File[Montage], frozen=True):
    """A MONTAGE.json."""

    layers: Many[LayerFile] = ()

    @classmethod
    def of(cls, montage: Montage, refer: Refer) -> Self:
        """Return the file of a montage."""
        return cls(layers=tuple(LayerFile.of(one, refer) for one in montage.layers))

    @property
    def remarks(self) -> tuple[str, ...]:
        """Which icons lie where they cannot be seen, or have nothing marked though others have."""
        some_marked = any(one.strokes for one in self.layers)
        told = []
        for number, one in enumerate(self.layers, 1):
            if not one.meets_canvas:
                told.append(
                    f"Layer {number}, “{one.icon}”, lies outside the canvas, 0 to {CANVAS}: "
                    'nothing of it can be kept. Give a smaller "dx" or "dy".'
                )
            elif some_marked and not one.strokes:
                told.append(
                    f"Layer {number}, “{one.icon}”, has no strokes: nothing of it is marked. "
                    'Give "strokes" over the part to keep.'
                )
        return tuple(told)

    def resolved(self, find: Find) -> Montage:
        """Return the montage, its icons found by ``find``."""
        return Montage(tuple(one.resolved(find) for one in self.layers))


def read_montage(path: Path) -> MontageFile:
    """Read a MONTAGE.json.

    Raises
    ------
    IconstudioError
        If the file cannot be read or does not hold a montage.
    """
    return open_file(path, MontageFile)
