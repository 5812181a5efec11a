"""Take icons and work out of the window: to files and to the clipboard."""

from collections.abc import Callable, Generator, Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QMimeData, QObject, Signal
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication, QFileDialog, QWidget

from iconstudio.files import write_bytes
from iconstudio.grammar import counted
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.pictures.picture import Picture
from iconstudio.model import Icon, IconstudioError, Patterned
from iconstudio.output import export
from iconstudio.output.filenames import file_name, free_path, suffixed

PNG_SIZE = 1024
"""Side of a saved PNG in pixels."""


class Saver(QObject):
    """Asks where to, and writes in the background.

    Signals
    -------
    failed(str)
        Something could not be written; a sentence for the user.
    saved(str)
        What has been saved, for the status line; nothing when saving begins.
    """

    failed = Signal(str)
    saved = Signal(str)

    def __init__(self, worker: Worker, window: QWidget) -> None:
        super().__init__(window)
        self._worker = worker
        self._window = window

    def save_svg(self, picture: Picture) -> None:
        """Save a result as SVG."""
        icon = picture.icon
        self._export(_kind(icon), _named(picture), "svg", partial(export.svg, icon))

    def save_strokes(self, picture: Picture) -> None:
        """Save a restyled icon as SVG in which strokes are strokes."""
        self._export("icon", _named(picture), "svg", partial(export.svg_of_strokes, picture.icon))

    def save_png(self, picture: Picture) -> None:
        """Save a result as PNG."""
        icon = picture.icon
        # A pattern is saved a pixel a unit, so that it tiles to the pixel.
        side = max(icon.size) if isinstance(icon, Patterned) else PNG_SIZE
        self._export(_kind(icon), _named(picture), "png", partial(export.png, icon, side))

    def save_css(self, picture: Picture) -> None:
        """Save a pattern as the background of a style sheet."""
        from iconstudio.output.pattern import style_sheet

        icon = picture.icon

        def write(path: Path) -> None:
            write_bytes(path, style_sheet(icon, path.stem).encode())

        self._save("pattern", _named(picture), "css", write)

    def save_code(self, picture: Picture) -> None:
        """Save the colour code of a result as PNG."""
        icon, colours, name = picture.icon, picture.colours, f"{_named(picture)}-colour-code"
        content = partial(export.colour_code_png, icon, PNG_SIZE, colours)
        self._export("colour code", name, "png", content)

    def copy_svg(self, picture: Picture) -> None:
        """Put a result on the clipboard: as SVG, as its markup in words, and as a picture."""
        svg, image = export.svg(picture.icon), picture.image(PNG_SIZE)
        data = QMimeData()
        data.setData("image/svg+xml", svg)
        data.setText(svg.decode())
        data.setData("image/png", _as_png(image))
        data.setImageData(image)
        QApplication.clipboard().setMimeData(data)
        self.saved.emit("The icon is on the clipboard, as SVG with its credits and as a picture.")

    def save_work(self, what: str, title: str, write: Callable[[Path], None]) -> None:
        """Save what lies on a canvas as JSON: ``what`` it is; ``write`` writes it to a path."""
        self._save(what, title, "json", write)

    def save_svgs(self, pictures: Sequence[Picture]) -> None:
        """Save several results as SVG into one folder; no file that is there is replaced."""
        folder = self.ask_folder()
        if folder is None:
            return
        self.saved.emit("")
        self._start(lambda: _writing_all(folder, tuple(pictures)))

    def ask_folder(self) -> Path | None:
        """Ask for a folder to save into; None if the user thinks better of it."""
        path = QFileDialog.getExistingDirectory(self._window, "Save all icons as SVG into")
        return Path(path) if path else None

    def ask_path(self, what: str, name: str, kind: str) -> Path | None:
        """Ask where to save; None if the user thinks better of it."""
        title, kinds = f"Save the {what} as {kind.upper()}", kind.upper()
        return ask_path(self._window, title, kinds, f".{kind}", f"{name}.{kind}")

    def _save(self, what: str, name: str, kind: str, write: Callable[[Path], None]) -> None:
        path = self.ask_path(what, file_name(name), kind)
        if path is None:
            return
        self.saved.emit("")
        try:
            path = suffixed(path, f".{kind}")
        except IconstudioError as error:
            self.failed.emit(str(error))
            return
        self._start(lambda: _writing(path, write))

    def _export(self, what: str, name: str, kind: str, content: Callable[[], bytes]) -> None:
        self._save(what, name, kind, lambda path: write_bytes(path, content()))

    def _start(self, make: Callable[[], Generator[str]]) -> None:
        job = self._worker.submit(make)
        job.event.connect(lambda what: self.saved.emit(f"Saved {what}."))
        job.failed.connect(self.failed)


def ask_path(window: QWidget, title: str, kinds: str, suffix: str, name: str) -> Path | None:
    """Ask where to save what is called ``name`` so far; None if the user thinks better of it.

    ``kinds`` is what files with that ``suffix`` are called. See ``suffixed``.
    """
    dialog = QFileDialog(window, title)
    dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
    dialog.setNameFilter(f"{kinds} (*{suffix})")
    dialog.setDefaultSuffix(suffix[1:])
    dialog.selectFile(name)
    chosen = dialog.selectedFiles() if dialog.exec() else []
    dialog.deleteLater()
    return Path(chosen[0]) if chosen else None


def _writing(path: Path, write: Callable[[Path], None]) -> Generator[str]:
    write(path)
    yield f"“{path}”"


def _writing_all(folder: Path, pictures: Sequence[Picture]) -> Generator[str]:
    for done, picture in enumerate(pictures):
        try:
            path = free_path(folder, file_name(_named(picture)), ".svg")
            write_bytes(path, export.svg(picture.icon))
        except IconstudioError as error:
            saved = f"{counted(done, 'icon')} of {len(pictures)} saved."
            raise IconstudioError(f"{saved} {error}") from None
    yield f"{counted(len(pictures), 'icon')} in “{folder}”"


def _as_png(image: QImage) -> QByteArray:
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    image.save(buffer, "PNG")
    return buffer.data()


def _kind(icon: Icon) -> str:
    return "pattern" if isinstance(icon, Patterned) else "icon"


def _named(picture: Picture) -> str:
    return picture.name.replace(", ", "-")
