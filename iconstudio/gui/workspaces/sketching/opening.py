"""Bring photos and sketches into the document: from files, the clipboard, a drop, the examples."""

from collections.abc import Callable, Generator
from pathlib import Path
from typing import Any

from PySide6.QtCore import QMimeData, QObject, Signal
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QFileDialog, QWidget

from iconstudio.gui.photo import Photo, photo_from_image, read_photo
from iconstudio.gui.worker import Worker
from iconstudio.gui.workspaces.sketching import page
from iconstudio.gui.workspaces.sketching.page import SketchDocument
from iconstudio.inputs.sketch import SketchFile, read_sketch
from iconstudio.model import IconstudioError

_PHOTOS = "Photos (*.png *.jpg *.jpeg *.webp *.tif *.tiff *.gif *.bmp);;All files (*)"
_SKETCHES = "Sketches (*.json);;All files (*)"


class Opener(QObject):
    """Opens things in the background and then puts them on the page, by one command each.

    Signals
    -------
    failed(str)
        Something could not be opened; a sentence for the user. The page is as it was.
    opened(str)
        What has been opened, for the status line.
    """

    failed = Signal(str)
    opened = Signal(str)

    def __init__(self, document: SketchDocument, worker: Worker, owner: QWidget) -> None:
        super().__init__(owner)
        self._owner = owner
        self._document = document
        self._worker = worker

    def choose_photo(self) -> None:
        """Ask for a photo."""
        path, _ = QFileDialog.getOpenFileName(
            self._owner, "Open a photo to trace over", "", _PHOTOS
        )
        if path:
            self.open_photo(path)

    def choose_sketch(self) -> None:
        """Ask for a sketch file."""
        path, _ = QFileDialog.getOpenFileName(self._owner, "Open a sketch", "", _SKETCHES)
        if path:
            self.open_sketch(path)

    def open_photo(self, path: str) -> None:
        """Put the photo of a file under the drawing."""
        self._work(lambda: _once(read_photo, path))

    def open_image(self, image: QImage) -> None:
        """Put an image from the clipboard or a drop under the drawing."""
        self._work(lambda: _once(photo_from_image, image))

    def open_sketch(self, path: str) -> None:
        """Open a sketch file, with the photo that it names."""
        self._work(lambda: _sketch_and_photo(lambda: read_sketch(Path(path))))

    def open_example(self, example: SketchFile) -> None:
        """Open an example."""
        self._work(lambda: _sketch_and_photo(lambda: example))

    def open_mime(self, data: QMimeData) -> None:
        """Open what was dropped or pasted."""
        files = [url.toLocalFile() for url in data.urls() if url.isLocalFile()]
        if files and files[0].lower().endswith(".json"):
            self.open_sketch(files[0])
        elif files:
            self.open_photo(files[0])
        elif data.hasImage():
            self.open_image(QImage(data.imageData()))
        elif data.hasUrls():
            self.failed.emit("Only files on this computer can be opened. Save the photo first.")
        else:
            self.failed.emit("There is no photo to paste. Copy an image first.")

    def _work(self, make: Callable[[], Generator[Any]]) -> None:
        job = self._worker.submit(make)
        job.event.connect(self._put)
        job.failed.connect(self.failed)

    def _put(self, found: object) -> None:
        match found:
            case Photo():
                page.set_photo(self._document, found)
                self.opened.emit(_about(found))
            case (SketchFile() as file, photo):
                page.load_sketch(self._document, file.sketch, photo, "open sketch")
                self.opened.emit(f"Opened “{file.title}”.")
            case str():
                self.failed.emit(found)


def _once(function: Callable[[Any], Any], argument: Any) -> Generator[Any]:
    yield function(argument)


def _sketch_and_photo(read: Callable[[], SketchFile]) -> Generator[object]:
    """Yield a sketch with its photo; if only the photo is missing, no photo, then a remark."""
    file, photo, remark = read(), None, ""
    if file.photo is not None:
        try:
            photo = read_photo(str(file.photo))
        except IconstudioError as error:
            remark = f"The sketch was opened without its photo: {error}"
    yield file, photo
    if remark:
        yield remark


def _about(photo: Photo) -> str:
    size = f"{photo.width:,} × {photo.height:,} pixels"
    kept = ", shown smaller" if photo.scaled_down else ""
    return f"Photo opened ({size}{kept})."
