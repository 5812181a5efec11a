"""SKETCH.json: a sketch in a file, and the examples that come with the program.

``{"keyword": "dog", "polygon": [[x, y], ...], "exclude": ["set:name", ...],
"symmetry": "horizontal"}``; the polygon is in any unit, y down, and ``symmetry`` names an ``Axis``.
All but ``polygon`` are optional, and so are ``title`` and ``photo``, the file that the polygon was
traced over.
"""

import os
from dataclasses import dataclass
from pathlib import Path

from iconstudio.inputs.fields import Fields, written
from iconstudio.model import IconstudioError, Sketch
from iconstudio.resources import resource
from iconstudio.workflows.files import open_file


@dataclass(frozen=True, slots=True)
class SketchFile:
    """What a SKETCH.json says."""

    title: str
    sketch: Sketch
    photo: Path | None = None
    """The photo that the polygon was traced over."""


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
    """Read a SKETCH.json.

    Raises
    ------
    IconstudioError
        If the file cannot be read or does not hold a sketch.
    """
    return sketch_in(open_file(path, "model"))


def sketch_in(fields: Fields) -> SketchFile:
    """Return what the fields of a SKETCH.json say.

    Raises
    ------
    IconstudioError
        If they are not what they must be.
    """
    fields.check_keys(("polygon", "keyword", "exclude", "symmetry", "photo", "title", "best"))
    sketch = Sketch(
        fields.outline("polygon"),
        fields.text("keyword"),
        frozenset(fields.texts("exclude")),
        fields.axis(),
    )
    photo = fields.path.parent / fields.text("photo") if fields.has("photo") else None
    title = fields.text("title") or fields.path.stem
    return SketchFile(title, sketch, photo and Path(os.path.realpath(photo)))


def sketch_data(sketch: Sketch) -> dict[str, object]:
    """Return what the file of a sketch says."""
    return {
        "keyword": sketch.keyword,
        "polygon": written(sketch.polygon.vertices),
        "exclude": sorted(sketch.exclude),
        "symmetry": sketch.symmetry,
    }
