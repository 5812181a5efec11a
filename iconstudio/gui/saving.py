"""Take icons and work out of the window: to files and to the clipboard."""

from collections.abc import Callable, Generator
from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QApplication, QFileDialog, QWidget

from iconstudio.gui.pictures import Picture
from iconstudio.gui.worker import Worker
from iconstudio.model import IconstudioError

PNG_SIZE = 1024
"""Side of a saved PNG in pixels."""


class Saver(QObject):
    """Asks where to, and writes in the background.

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

    def save_svg(self, picture: Picture) -> None:
        """Save a result as SVG."""
        self._save_icon(picture, "svg", lambda: _svg(picture))

    def save_png(self, picture: Picture, coded: bool = False) -> None:
        """Save a result as PNG, coded by source or not."""
        self._save_icon(picture, "png", lambda: _png(picture, coded))

    def copy_svg(self, picture: Picture) -> None:
        """Put a result on the clipboard as SVG."""
        try:
            QApplication.clipboard().setText(_svg(picture).decode())
        except IconstudioError as error:
            self.failed.emit(str(error))
        else:
            self.saved.emit("The icon is on the clipboard as SVG, with its credits.")

    def save_work(self, what: str, title: str, write: Callable[[Path], None]) -> None:
        """Save what lies on a canvas as JSON: ``what`` it is; ``write`` writes it to a path."""
        self._save(what, title, "json", write)

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

    def _save(self, what: str, name: str, kind: str, write: Callable[[Path], None]) -> None:
        path = self.ask_path(what, _file_name(name), kind)
        if path is None:
            return
        job = self._worker.submit(lambda: _writing(path, write))
        job.event.connect(self._tell)
        job.failed.connect(self.failed)

    def _save_icon(self, picture: Picture, kind: str, content: Callable[[], bytes]) -> None:
        name = f"{picture.title}-{picture.result.composite.style}"
        self._save("icon", name, kind, lambda path: _write(path, content()))

    def _tell(self, path: Path) -> None:
        self.saved.emit(f"Saved “{path}”.")


def _writing(path: Path, write: Callable[[Path], None]) -> Generator[Path]:
    write(path)
    yield path


def _write(path: Path, content: bytes) -> None:
    from iconstudio.output import png

    png.write(path, content)


def _svg(picture: Picture) -> bytes:
    from iconstudio.output.svg import svg_document

    result = picture.result
    return svg_document(result.drawing, result.composite, picture.title).encode()


def _png(picture: Picture, coded: bool) -> bytes:
    from iconstudio.output import png
    from iconstudio.output.colours import colour_code

    result = picture.result
    if coded:
        return png.encoded(colour_code(result.composite, result.drawing, PNG_SIZE))
    return png.encoded(png.drawing_pixels(result.drawing, PNG_SIZE))


def _file_name(title: str) -> str:
    """Return a title as the beginning of a file name."""
    words = "".join(c if c.isalnum() else "-" for c in title.strip().lower()).strip("-")
    return words or "icon"
