"""SKETCH.json: a sketch in a file, and the examples that come with the program."""

from pathlib import Path
from typing import Any, Self

from msgspec.structs import replace

from iconstudio.inputs.formats import Points, Text, TextSet
from iconstudio.inputs.lines import outline, rounded
from iconstudio.model import Axis, IconstudioError, Sketch
from iconstudio.resources import resource
from iconstudio.workflows.files import open_file
from iconstudio.workflows.workflow import File, Find, Refer


class SketchFile(File[Sketch], frozen=True):
    """A SKETCH.json. The polygon is in any unit, y down."""

    polygon: Points
    keyword: Text = ""
    exclude: TextSet = frozenset()
    include: TextSet = frozenset()
    symmetry: Axis | None = None
    photo: Path | None = None
    """The photo that the polygon was traced over."""
    best: Any = None
    """What the gallery knows of its results."""

    @classmethod
    def of(cls, sketch: Sketch, refer: Refer) -> Self:
        """Return the file of a sketch."""
        return cls(
            polygon=rounded(sketch.polygon.vertices),
            keyword=sketch.keyword,
            exclude=sketch.exclude,
            include=sketch.include,
            symmetry=sketch.symmetry,
        )

    def resolved(self, find: Find) -> Sketch:
        """Return the sketch, which names no icons to be found."""
        return self.sketch

    @property
    def sketch(self) -> Sketch:
        """The sketch; of very many points, to simplify it takes a moment."""
        polygon = outline(self.polygon)
        return Sketch(polygon, self.keyword, self.exclude, self.symmetry, self.include)


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
