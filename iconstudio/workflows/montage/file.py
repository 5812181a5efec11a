"""MONTAGE.json: icons on one canvas, and scribbles over the parts to keep (section 4.4).

``{"layers": [{"icon": "set:name", "scale": 1, "flip": false, "dx": 0, "dy": 0,
"strokes": [{"width": 12, "points": [[x, y], ...]}]}]}``.

``icon`` may be the path of an SVG or a scan, from the file's folder.
A layer is mirrored left to right if ``flip``, scaled about the canvas's centre, and shifted by
``dx``, ``dy``; all but ``icon`` may be left out. Lengths are in canvas units (0 to 256), y down.
There may be a ``title``.
"""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from iconstudio.inputs.fields import Fields, written
from iconstudio.model import CANVAS, Layer, Montage, Pictogram, Placement, Point, Stroke
from iconstudio.workflows.files import open_file
from iconstudio.workflows.montage.montage import LARGEST, SMALLEST

FAR = 20.0 * CANVAS
"""No coordinate of a layer or a stroke is larger."""


@dataclass(frozen=True, slots=True)
class LayerFile:
    """A layer; ``icon`` is a reference, ``set:name`` or a path."""

    icon: str
    placement: Placement
    strokes: tuple[Stroke, ...] = ()


@dataclass(frozen=True, slots=True)
class MontageFile:
    """What a MONTAGE.json says."""

    layers: tuple[LayerFile, ...]
    title: str = ""

    @classmethod
    def of(cls, montage: Montage, refer: Callable[[Pictogram], str]) -> "MontageFile":
        """Return the file of a montage; ``refer`` returns the reference of an icon."""
        return cls(
            tuple(LayerFile(refer(one.icon), one.placement, one.strokes) for one in montage.layers)
        )

    def resolved(self, find: Callable[[str], Pictogram]) -> Montage:
        """Return the montage, its icons found by ``find``."""
        return Montage(
            tuple(Layer(find(one.icon), one.placement, one.strokes) for one in self.layers)
        )


def read_montage(path: Path) -> MontageFile:
    """Read a MONTAGE.json.

    Raises
    ------
    IconstudioError
        If the file cannot be read or does not hold a montage.
    """
    return montage_in(open_file(path, "montage"))


def montage_in(fields: Fields) -> MontageFile:
    """Return what the fields of a MONTAGE.json say.

    Raises
    ------
    IconstudioError
        If they are not what they must be.
    """
    fields.check_keys(("layers", "title"))
    layers = tuple(map(_layer, fields.objects("layers", "layer")))
    return MontageFile(layers, fields.text("title"))


def montage_data(montage: MontageFile) -> dict[str, object]:
    """Return what the file of a montage says."""
    layers = [
        {
            "icon": layer.icon,
            "scale": layer.placement.scale,
            "flip": layer.placement.flip,
            "dx": layer.placement.dx,
            "dy": layer.placement.dy,
            "strokes": [
                {"width": stroke.width, "points": _line(stroke.points)} for stroke in layer.strokes
            ],
        }
        for layer in montage.layers
    ]
    return {"title": montage.title or None, "layers": layers}


def _line(points: tuple[Point, ...]) -> list[list[float]]:
    """Return the points of a stroke; a dot becomes a very short line, which a reader accepts."""
    line = written(points)
    x, y = line[0]
    return line if any(point != [x, y] for point in line) else [[x, y], [round(x + 0.1, 2), y]]


def _layer(fields: Fields) -> LayerFile:
    fields.check_keys(("icon", "scale", "flip", "dx", "dy", "strokes"))
    placement = Placement(
        fields.number("scale", 1.0, SMALLEST, LARGEST),
        fields.flag("flip"),
        round(fields.number("dx", 0, -FAR, FAR)),
        round(fields.number("dy", 0, -FAR, FAR)),
    )
    strokes = tuple(map(_stroke, fields.objects("strokes", "stroke")))
    if strokes and not any(map(_meets_canvas, strokes)):
        its = "Its stroke lies" if len(strokes) == 1 else "All its strokes lie"
        raise fields.mistake(f"{its} outside the canvas, 0 to {CANVAS}.")
    return LayerFile(fields.reference(), placement, strokes)


def _stroke(fields: Fields) -> Stroke:
    fields.check_keys(("width", "points"))
    width = fields.number("width", None, 0, 2 * CANVAS, above=True)
    points = fields.line("points", FAR)
    if len(set(points)) < 2:
        count = "no point" if not points else "one point"
        raise fields.mistake(f"The stroke has {count}; it needs at least 2 different ones.")
    return Stroke(width, points)


def _meets_canvas(stroke: Stroke) -> bool:
    """Whether the box around a stroke has a part of the canvas."""
    reach = stroke.width / 2
    return all(
        -reach < max(values) and min(values) < CANVAS + reach
        for values in zip(*stroke.points, strict=True)
    )
