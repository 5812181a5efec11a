"""Files that the window reads and writes: examples, sketches and icons."""

import json
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QBuffer, QIODevice, QRectF, QSaveFile, Qt
from PySide6.QtGui import QColor, QImage, QPainter

from iconstudio.gui.pictures import Picture
from iconstudio.model import IconstudioError, Polygon, Sketch
from iconstudio.resources import resource

PNG_SIZE = 1024
"""Side of a saved PNG in pixels."""


@dataclass(frozen=True, slots=True)
class SketchFile:
    """What a SKETCH.json says; ``photo`` is the path of the photo it was traced over, or empty."""

    title: str
    sketch: Sketch
    photo: str = ""


def examples() -> list[SketchFile]:
    """Return the example sketches that come with the program, by title."""
    files = sorted(resource("examples").glob("*.json"))
    return sorted((read_sketch(file) for file in files), key=lambda example: example.title)


def example_path(name: str) -> Path | None:
    """Return the file of the example ``name``, if there is one."""
    path = resource("examples") / f"{name}.json"
    return path if path.is_file() else None


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
    except ValueError as error:
        raise IconstudioError(f"“{path.name}” is not valid JSON: {error}.") from None
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
    photo = str((path.parent / str(data["photo"])).resolve()) if data.get("photo") else ""
    return SketchFile(str(data.get("title") or path.stem), sketch, photo)


def write_sketch(path: Path, sketch: Sketch, photo: str = "") -> None:
    """Write a SKETCH.json, the same that the command line reads."""
    data: dict[str, object] = {
        "keyword": sketch.keyword,
        "polygon": [[round(x, 2), round(y, 2)] for x, y in sketch.polygon.vertices],
        "exclude": sorted(sketch.exclude),
    }
    if photo:
        data["photo"] = photo
    _write(path, (json.dumps(data, ensure_ascii=False, indent=2) + "\n").encode())


def svg_text(picture: Picture, title: str) -> str:
    """Return a result as an SVG document with the credits of its sources."""
    from iconstudio.output.svg import svg_document

    return svg_document(picture.result.drawing, picture.result.composite, title)


def write_svg(path: Path, picture: Picture, title: str) -> None:
    """Save a result as SVG."""
    _write(path, svg_text(picture, title).encode())


def write_png(path: Path, picture: Picture, coded: bool) -> None:
    """Save a result as PNG, black on transparent ground, or coded by source."""
    image = QImage(PNG_SIZE, PNG_SIZE, QImage.Format.Format_ARGB32_Premultiplied)
    image.fill(Qt.GlobalColor.transparent)
    with QPainter(image) as painter:
        picture.paint(painter, QRectF(image.rect()), QColor("black"), coded)
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    image.save(buffer, "PNG")
    _write(path, buffer.data().data())


def _write(path: Path, content: bytes) -> None:
    file = QSaveFile(str(path))
    if (
        not file.open(QIODevice.OpenModeFlag.WriteOnly)
        or file.write(content) != len(content)
        or not file.commit()
    ):
        raise IconstudioError(
            f"“{path}” could not be written: {file.errorString()}. Choose another place."
        )
