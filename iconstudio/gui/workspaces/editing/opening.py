"""Bring icons and edits into the document, and draw the icon crisply, without waiting for it."""

from collections.abc import Callable, Generator
from pathlib import Path
from typing import Any

from PySide6.QtCore import QMimeData, QObject, Signal
from PySide6.QtWidgets import QFileDialog, QWidget

from iconstudio.algorithms.raster import simplified
from iconstudio.gui.dragging import dropped_file, unpacked
from iconstudio.gui.vector import painter_path
from iconstudio.gui.worker import Worker
from iconstudio.gui.workspaces.editing import page
from iconstudio.gui.workspaces.editing.page import EditDocument
from iconstudio.gui.workspaces.editing.scene import EditScene
from iconstudio.inputs.edit import read_edit
from iconstudio.model import Edit, Exemplar, IconstudioError, Pictogram
from iconstudio.resources import resource
from iconstudio.session import Session

_EDITS = "Edits (*.json);;All files (*)"


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

    def __init__(
        self,
        session: Session,
        document: EditDocument,
        scene: EditScene,
        worker: Worker,
        owner: QWidget,
    ) -> None:
        super().__init__(owner)
        self._session = session
        self._document = document
        self._scene = scene
        self._worker = worker
        self._owner = owner
        self._latest: object = None
        self._traced: set[str] = set()
        document.page_changed.connect(self._draw)

    def choose_edit(self) -> None:
        """Ask for an edit file."""
        path, _ = QFileDialog.getOpenFileName(self._owner, "Open an edit", "", _EDITS)
        if path:
            self.open_edit(path)

    def open_edit(self, path: str) -> None:
        """Open an edit file."""
        self._work(lambda: self._read(Path(path)))

    def open_svg(self, path: str) -> None:
        """Begin with an SVG file."""
        self._work(lambda: self._begin(lambda: self._drawn(self._session.icon(path))))

    def take(self, pictogram: Pictogram) -> None:
        """Begin with an icon."""
        self._work(lambda: self._begin(lambda: self._drawn(pictogram)))

    def take_exemplar(self, icon: Exemplar) -> None:
        """Begin with an icon that is drawn already."""
        self._work(lambda: self._begin(lambda: icon))

    def open_mime(self, data: QMimeData) -> None:
        """Open what was dropped or pasted."""
        pictogram, file = unpacked(data), dropped_file(data)
        if pictogram is not None:
            self.take(pictogram)
        elif file is None:
            self.failed.emit("Only SVG files on this computer can be opened. Save the icon first.")
        elif file.lower().endswith(".json"):
            self.open_edit(file)
        else:
            self.open_svg(file)

    # -- in the worker's thread ----------------------------------------------------------------

    def _begin(self, find: Callable[[], Exemplar]) -> Generator[Any]:
        icon = find()
        yield icon, self._session.keyword(icon.pictogram)

    def _read(self, path: Path) -> Generator[Any]:
        edit = read_edit(path).resolved(self._session.icon)
        yield edit, self._drawn(edit.icon)

    def _drawn(self, pictogram: Pictogram) -> Exemplar:
        return self._session.exemplar(pictogram)

    def _trace(self, icon: Exemplar) -> Generator[Any]:
        simplified(((0, 0),), 1)  # loads what it needs before the first line is drawn
        try:
            yield icon, painter_path(self._session.drawing(icon).path)
        except IconstudioError:
            return  # it stays drawn of pixels

    # -- in the window's thread ----------------------------------------------------------------

    def _work(self, make: Callable[[], Generator[Any]]) -> None:
        job = self._worker.submit(make)
        self._latest = job
        job.event.connect(self._put)
        job.failed.connect(self.failed)

    def _put(self, found: tuple[Any, Any]) -> None:
        if self.sender() is not self._latest:
            return  # the user has chosen something else by now
        match found:
            case (Exemplar() as icon, str() as keyword):
                page.begin(self._document, icon, keyword)
            case (Edit() as edit, Exemplar() as icon):
                page.load(self._document, edit, icon)
        self.opened.emit(f"“{icon.pictogram.credit.title}” is on the canvas.")

    def _draw(self) -> None:
        icon = self._document.page.icon
        if icon is not None and icon.pictogram.svg not in self._traced:
            self._traced.add(icon.pictogram.svg)
            job = self._worker.submit(lambda: self._trace(icon))
            job.event.connect(lambda drawn: self._scene.set_path(*drawn))


def examples() -> list[Path]:
    """Return the files of the example edits."""
    return sorted((resource("examples") / "edits").glob("*.json"))
