"""The folder that a run without a window fills."""

import json
import tempfile
from pathlib import Path
from typing import Any

from PIL import Image

from iconstudio.model import IconstudioError
from iconstudio.output import png
from iconstudio.output.colours import Palette, colour_code
from iconstudio.output.svg import svg_document
from iconstudio.workflows.events import Result


class Folder:
    """Writes files, each in one step.

    Raises
    ------
    IconstudioError
        On construction and from every method, if the folder cannot be written.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        try:
            path.mkdir(parents=True, exist_ok=True)
            with tempfile.TemporaryFile(dir=path) as file:
                file.write(b"0")
        except OSError as error:
            raise IconstudioError(
                f"The folder “{path}” cannot be written: {error.strerror}. Choose another one."
            ) from None
        if (path / "results.json").is_dir():
            raise IconstudioError(
                f"“{path / 'results.json'}” is a folder. Choose another output folder."
            )

    def write(self, name: str, content: bytes) -> None:
        """Write a file."""
        png.write(self._path / name, content)

    def write_picture(self, name: str, picture: Image.Image) -> None:
        """Write a picture as PNG."""
        self.write(name, png.encoded(picture))

    def write_report(self, report: dict[str, Any]) -> None:
        """Write ``results.json``."""
        text = json.dumps(report, indent=1, ensure_ascii=False, allow_nan=False)
        self.write("results.json", text.encode())

    def write_icon(
        self, name: str, result: Result, title: str, colours: Palette | None = None
    ) -> None:
        """Write a result: ``NAME.svg``, ``NAME.png``, and coded by source ``NAME-sources.png``."""
        composite, drawing = result.composite, result.drawing
        self.write(f"{name}.svg", svg_document(drawing, composite, title).encode())
        self.write(f"{name}.png", png.encoded(png.drawing_pixels(drawing, png.SIZE)))
        code = colour_code(composite, drawing, png.SIZE // 2, colours)
        self.write(f"{name}-sources.png", png.encoded(code))
