"""SKETCH.json: a sketch in a file, and the examples that come with the program."""

import dataclasses
from pathlib import Path
from typing import Any, Self

from msgspec.structs import replace

from iconstudio.inputs.formats import Holes, Lines, Many, Points, Share, Text, TextSet
from iconstudio.inputs.lines import inner, outline, rounded, rows, stray_of
from iconstudio.model import Axis, IconstudioError, Polygon, Sketch
from iconstudio.resources import resource
from iconstudio.workflows.files import open_file
from iconstudio.workflows.montage.file import LayerFile
from iconstudio.workflows.workflow import File, Find, Refer


class SketchFile(File[Sketch], frozen=True):
    """A SKETCH.json. The polygon is in any unit, y down."""

    polygon: Points
    keyword: Text = ""
    exclude: TextSet = frozenset()
    include: TextSet = frozenset()
    symmetry: Axis | None = None
    pins: Many[LayerFile] = ()
    """Icons on the canvas of the results, with strokes over the places that must be theirs."""
    holes: Holes = ()
    """Areas of paper inside the polygon."""
    lines: Lines = ()
    """Strokes inside it."""
    detail: Share = 0.0
    """How much fine details count."""
    photo: Path | None = None
    """The photo that the polygon was traced over."""
    best: Any = None
    """What the gallery knows of its results."""

    @classmethod
    def of(cls, sketch: Sketch, refer: Refer) -> Self:
        """Return the file of a sketch."""
        holes, lines = rows(sketch.inner)
        file = cls(
            polygon=rounded(sketch.polygon.vertices),
            keyword=sketch.keyword,
            exclude=sketch.exclude,
            include=sketch.include,
            symmetry=sketch.symmetry,
            pins=tuple(LayerFile.of(pin, refer) for pin in sketch.pins),
            holes=holes,
            lines=lines,
        )
        # A field of another version is refused: of what is not used, nothing is written.
        return replace(file, detail=sketch.detail) if sketch.detail else file

    def resolved(self, find: Find) -> Sketch:
        """Return the sketch, the icons of its pins found by ``find``."""
        return dataclasses.replace(self.sketch, pins=tuple(pin.resolved(find) for pin in self.pins))

    def check(self) -> None:
        """Refuse pins that hold nothing, holes that enclose nothing, and lines without length."""
        inner(self.holes, self.lines).check()
        for pin in self.pins:
            if not pin.strokes:
                raise IconstudioError(
                    f"The pin of “{pin.icon}” has no strokes: draw over the place that it holds."
                )

    @property
    def sketch(self) -> Sketch:
        """The sketch without its pins; of very many points, to simplify it takes a moment."""
        stray = stray_of(Polygon.of(self.polygon)) if self.polygon else 0.0
        return Sketch(
            outline(self.polygon),
            self.keyword,
            self.exclude,
            self.symmetry,
            include=self.include,
            inner=inner(self.holes, self.lines, stray),
            detail=self.detail,
        )


def example(name: str) -> SketchFile:
    """Return the example of this file name, for instance ``motorbike``.

    Raises
    ------
    IconstudioError
        If there is none.
    """
    folder = resource("examples")
    known = sorted(file.stem for file in folder.glob("*.json"))
    if name not in known:
        raise IconstudioError(f"There is no example {name!r}. There are {', '.join(known)}.")
    return read_sketch(folder / f"{name}.json")


def read_sketch(path: Path) -> SketchFile:
    """Read a SKETCH.json; without a title, it is called as the file.

    Raises
    ------
    IconstudioError
        If the file cannot be read or does not hold a sketch.
    """
    file = open_file(path, SketchFile)
    return replace(file, title=file.title or path.stem)
