"""Take sketches and icons out of the window: to files and to the clipboard."""

from collections.abc import Callable, Generator
from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QApplication, QFileDialog, QWidget

from iconstudio.gui.document import Page
from iconstudio.gui.pictures import Picture
from iconstudio.gui.worker import Worker
from iconstudio.model import IconstudioError
from iconstudio.sketchfile import write_sketch

PNG_SIZE = 1024
"""Side of a saved PNG in pixels."""


class Saver(QObject):
    """Asks where to, and writes; icons in the background.

    Signals
    -------
    failed(str)
        Something could not be written; a sentence for the user.
    saved(str)
        What has been saved, for the status line.
    """

    failed = Signal(str)
    saved = Signal(str)

    def __init__(self, worker: Worker, window: QWidget) -> None:
        super().__init__(window)
        self._worker = worker
        self._window = window
        self._picture: Picture | None = None
        self._title = "icon"

    def save_sketch(self, page: Page) -> None:
        """Save the sketch as JSON."""
        path = self.ask_path("sketch", _file_name(page.sketch.keyword), "json")
        if path is None:
            return
        photo = Path(page.photo.path) if page.photo is not None and page.photo.path else None
        try:
            write_sketch(path, page.sketch, photo)
        except IconstudioError as error:
            self.failed.emit(str(error))
        else:
            self._tell(path)

    def pick(self, picture: Picture | None) -> None:
        """Say which result is to be saved from now on."""
        self._picture = picture

    def set_title(self, title: str) -> None:
        """Say what the results show: the title of saved icons, and the start of file names."""
        self._title = title

    def save_svg(self) -> None:
        """Save the picked result as SVG."""
        picture, title = self._picture, self._title
        if picture is not None:
            self._save("icon", self._icon_name(picture), "svg", lambda: _svg(picture, title))

    def save_png(self, coded: bool = False) -> None:
        """Save the picked result as PNG, coded by source or not."""
        picture = self._picture
        if picture is not None:
            self._save("icon", self._icon_name(picture), "png", lambda: _png(picture, coded))

    def copy_svg(self) -> None:
        """Put the picked result on the clipboard as SVG."""
        if self._picture is None:
            return
        try:
            QApplication.clipboard().setText(_svg(self._picture, self._title).decode())
        except IconstudioError as error:
            self.failed.emit(str(error))
        else:
            self.saved.emit("The icon is on the clipboard as SVG, with its credits.")

    def ask_path(self, what: str, name: str, kind: str) -> Path | None:
        """Ask where to save; None if the user thinks better of it."""
        dialog = QFileDialog(self._window, f"Save the {what} as {kind.upper()}")
        dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
        dialog.setNameFilter(f"{kind.upper()} (*.{kind})")
        dialog.setDefaultSuffix(kind)
        dialog.selectFile(f"{name}.{kind}")
        chosen = dialog.selectedFiles() if dialog.exec() else []
        dialog.deleteLater()
        return Path(chosen[0]) if chosen else None

    def _save(self, what: str, name: str, kind: str, content: Callable[[], bytes]) -> None:
        path = self.ask_path(what, name, kind)
        if path is None:
            return
        job = self._worker.submit(lambda: _writing(path, content))
        job.event.connect(self._tell)
        job.failed.connect(self.failed)

    def _tell(self, path: Path) -> None:
        self.saved.emit(f"Saved “{path}”.")

    def _icon_name(self, picture: Picture) -> str:
        return f"{_file_name(self._title)}-{picture.result.composite.style}"


def _writing(path: Path, content: Callable[[], bytes]) -> Generator[Path]:
    from iconstudio.output import png

    png.write(path, content())
    yield path


def _svg(picture: Picture, title: str) -> bytes:
    from iconstudio.output.svg import svg_document

    return svg_document(picture.result.drawing, picture.result.composite, title).encode()


def _png(picture: Picture, coded: bool) -> bytes:
    from iconstudio.output import png
    from iconstudio.output.colours import colour_code

    result = picture.result
    if coded:
        return png.encoded(colour_code(result.composite, result.drawing, PNG_SIZE))
    return png.encoded(png.drawing_pixels(result.drawing, PNG_SIZE))


def _file_name(keyword: str) -> str:
    """Return a keyword as the beginning of a file name."""
    words = "".join(c if c.isalnum() else "-" for c in keyword.strip().lower()).strip("-")
    return words or "icon"
