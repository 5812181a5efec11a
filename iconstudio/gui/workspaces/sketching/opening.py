"""Bring photos and sketches into the document: from files, the clipboard, a drop, the examples."""

from collections.abc import Callable, Generator
from pathlib import Path
from typing import Any

from PySide6.QtCore import QMimeData
from PySide6.QtGui import QImage

from iconstudio.gui.dragging import dropped_file
from iconstudio.gui.photo import Photo, photo_from_image, read_photo
from iconstudio.gui.workspaces.opening import Opener
from iconstudio.gui.workspaces.sketching import page
from iconstudio.inputs.sketch import SketchFile, read_sketch
from iconstudio.model import IconstudioError

_PHOTOS = "Photos (*.png *.jpg *.jpeg *.webp *.tif *.tiff *.gif *.bmp)"


class SketchOpener(Opener):
    """Puts a photo under the drawing, or a sketch in its place."""

    question = "Open a sketch"
    kinds = "Sketches"
    other = "photo"

    def choose_photo(self) -> None:
        """Ask for a photo."""
        self.ask("Open a photo to trace over", _PHOTOS, self.open_file)

    def open_file(self, path: str) -> None:
        """Put the photo of a file under the drawing."""
        self.replace(lambda: _once(read_photo, path))

    def open_image(self, image: QImage) -> None:
        """Put an image from the clipboard or a drop under the drawing."""
        self.replace(lambda: _once(photo_from_image, image))

    def open_work(self, path: str) -> None:
        """Open a sketch file, with the photo that it names."""
        self.replace(lambda: _sketch_and_photo(lambda: read_sketch(Path(path))))

    def open_example(self, example: SketchFile) -> None:
        """Open an example."""
        self.replace(lambda: _sketch_and_photo(lambda: example))

    def open_mime(self, data: QMimeData) -> None:
        """Open what was dropped or pasted; it may be an image that is in no file."""
        if dropped_file(data) is None and data.hasImage():
            self.open_image(QImage(data.imageData()))
        else:
            super().open_mime(data)

    def put(self, found: Photo | tuple[SketchFile, Photo | None]) -> str:
        """Show a photo, or a sketch and its photo."""
        if isinstance(found, Photo):
            page.set_photo(self.document, found)
            return _about(found)
        file, photo = found
        page.load_sketch(self.document, file.sketch, photo, "open sketch")
        return f"Opened “{file.title}”."


def _once(function: Callable[[Any], Photo], argument: Any) -> Generator[Photo]:
    yield function(argument)


def _sketch_and_photo(
    read: Callable[[], SketchFile],
) -> Generator[tuple[SketchFile, Photo | None]]:
    """Yield a sketch with its photo; if only the photo is missing, none, and then say so."""
    file = read()
    try:
        photo, trouble = file.photo and read_photo(str(file.photo)), None
    except IconstudioError as error:
        photo, trouble = None, error
    yield file, photo
    if trouble is not None:
        raise IconstudioError(f"The sketch was opened without its photo: {trouble}")


def _about(photo: Photo) -> str:
    size = f"{photo.width:,} × {photo.height:,} pixels"
    kept = ", shown smaller" if photo.scaled_down else ""
    return f"Photo opened ({size}{kept})."
