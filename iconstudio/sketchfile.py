"""SKETCH.json: a sketch in a file, and the examples that come with the program.

``{"keyword": "dog", "polygon": [[x, y], ...], "exclude": ["set:name", ...]}``; the polygon is in
any unit, y down. ``keyword`` and ``exclude`` are optional, and so are ``title`` and ``photo``, the
file that the polygon was traced over.
"""

import json
from dataclasses import dataclass
from pathlib import Path

from iconstudio.files import write_atomically
from iconstudio.model import IconstudioError, Polygon, Sketch
from iconstudio.resources import resource


@dataclass(frozen=True, slots=True)
class SketchFile:
    """What a SKETCH.json says."""

    title: str
    sketch: Sketch
    photo: Path | None = None
    """The photo that the polygon was traced over."""


def examples() -> list[SketchFile]:
    """Return the example sketches, by title."""
    files = resource("examples").glob("*.json")
    return sorted(map(read_sketch, files), key=lambda example: example.title)


def example(name: str) -> SketchFile:
    """Return the example of this file name, for instance ``motorbike``.

    Raises
    ------
    IconstudioError
        If there is none.
    """
    path = resource("examples") / f"{name}.json"
    if not path.is_file():
        known = sorted(file.stem for file in path.parent.glob("*.json"))
        raise IconstudioError(f"There is no example {name!r}. There are {', '.join(known)}.")
    return read_sketch(path)


def read_sketch(path: Path) -> SketchFile:
    """Read a SKETCH.json.

    Raises
    ------
    IconstudioError
        If the file cannot be read or does not hold a sketch.
    """
    try:
        data = json.loads(path.read_text("utf-8"))
    except OSError as error:
        raise IconstudioError(f"“{path}” cannot be read: {error.strerror}.") from None
    except (ValueError, RecursionError) as error:
        raise IconstudioError(
            f"“{path.name}” is not valid JSON: {error}. Save it again, or mend it in an editor."
        ) from None
    if not isinstance(data, dict) or not isinstance(data.get("polygon"), list):
        raise IconstudioError(
            f'“{path.name}” is no sketch: it needs a "polygon", a list of [x, y] points.'
        )
    keyword, exclude = data.get("keyword") or "", data.get("exclude") or []
    if not isinstance(keyword, str) or not isinstance(exclude, list):
        raise IconstudioError(
            f'“{path.name}” is no sketch: "keyword" must be a text, "exclude" a list of texts.'
        )
    sketch = Sketch(Polygon.of(data["polygon"]), keyword, frozenset(map(str, exclude)))
    photo = (path.parent / str(data["photo"])).resolve() if data.get("photo") else None
    return SketchFile(str(data.get("title") or path.stem), sketch, photo)


def write_sketch(path: Path, sketch: Sketch, photo: Path | None = None) -> None:
    """Write a SKETCH.json.

    Raises
    ------
    IconstudioError
        If the file cannot be written.
    """
    data: dict[str, object] = {
        "keyword": sketch.keyword,
        "polygon": [[round(x, 2), round(y, 2)] for x, y in sketch.polygon.vertices],
        "exclude": sorted(sketch.exclude),
    }
    if photo:
        data["photo"] = str(photo)
    try:
        write_atomically(path, (json.dumps(data, ensure_ascii=False, indent=2) + "\n").encode())
    except OSError as error:
        raise IconstudioError(f"“{path}” cannot be written: {error.strerror}.") from None
