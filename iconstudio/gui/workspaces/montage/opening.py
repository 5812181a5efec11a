"""Bring icons and montages onto the canvas, and save montages, without the window waiting."""

from collections.abc import Callable, Generator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image
from PySide6.QtCore import QMimeData, QObject, Signal
from PySide6.QtWidgets import QFileDialog, QWidget

from iconstudio.gui.dragging import dropped_file, unpacked
from iconstudio.gui.vector import painter_path
from iconstudio.gui.worker import Worker
from iconstudio.gui.workspaces.montage.page import (
    Icon,
    MontageDocument,
    MontagePage,
)
from iconstudio.inputs.montage import LayerFile, MontageFile, read_montage, write_montage
from iconstudio.model import CANVAS, Exemplar, IconstudioError, Layer, Montage, Pictogram
from iconstudio.resources import resource
from iconstudio.session import Session

_FILES = "Montages (*.json);;All files (*)"

_FINER = 2
"""The outline of an icon is traced at so many times the canvas's resolution."""


class Opener(QObject):
    """Opens things in the background and then puts them on the page, by one command each.

    Signals
    -------
    failed(str)
        Something could not be opened; a sentence for the user. The page is as it was.
    opened(str)
        What is there now, for the status line.
    """

    failed = Signal(str)
    opened = Signal(str)

    def __init__(
        self, session: Session, document: MontageDocument, worker: Worker, owner: QWidget
    ) -> None:
        super().__init__(owner)
        self._session = session
        self._document = document
        self._worker = worker
        self._owner = owner

    def add(self, pictogram: Pictogram) -> None:
        """Add an icon on top."""
        self._work(lambda: self._drawn(lambda: pictogram))

    def add_file(self, path: str) -> None:
        """Add the icon of an SVG file on top."""
        self._work(lambda: self._drawn(lambda: self._session.icon(path)))

    def add_mime(self, data: QMimeData) -> None:
        """Add, or open, what was dropped or pasted."""
        pictogram, path = unpacked(data), dropped_file(data)
        if pictogram is not None:
            self.add(pictogram)
        elif path is None:
            self.failed.emit("Only SVG files on this computer can be used. Save the drawing first.")
        elif path.lower().endswith(".json"):
            self.open_montage(path)
        else:
            self.add_file(path)

    def choose_montage(self) -> None:
        """Ask for a montage file."""
        path, _ = QFileDialog.getOpenFileName(self._owner, "Open a montage", "", _FILES)
        if path:
            self.open_montage(path)

    def open_montage(self, path: str) -> None:
        """Put the montage of a file in place of what is there."""
        self._work(lambda: self._read(Path(path)))

    # -- in the worker's thread ----------------------------------------------------------------

    def _drawn(self, find: Callable[[], Pictogram]) -> Generator[Icon]:
        exemplar = self._session.exemplar(find())
        yield traced(exemplar)
        # Draws it in a worker process too, so that these have started when the first stroke comes.
        self._session.drawing(exemplar)

    def _read(self, path: Path) -> Generator[tuple[str, Montage, Sequence[Icon]]]:
        montage = read_montage(path).resolved(self._session.icon)
        yield (
            path.name,
            montage,
            [traced(self._session.exemplar(one.icon)) for one in montage.layers],
        )

    # -- in the window's thread ----------------------------------------------------------------

    def _work(self, make: Callable[[], Generator[Any]]) -> None:
        job = self._worker.submit(make)
        job.event.connect(self._put)
        job.failed.connect(self.failed)

    def _put(self, found: Icon | tuple[str, Montage, Sequence[Icon]]) -> None:
        try:
            if isinstance(found, Icon):
                self._document.change("add icon", self._document.page.with_icons([found]))
                self.opened.emit(f"Added “{found.pictogram.id}”.")
            else:
                name, montage, icons = found
                self._document.change("open montage", page_of(montage.layers, icons))
                self.opened.emit(f"Opened “{name}”.")
        except IconstudioError as error:
            self.failed.emit(str(error))


def examples() -> list[Path]:
    """Return the files of the example montages."""
    return sorted((resource("examples") / "montages").glob("*.json"))


def traced(exemplar: Exemplar) -> Icon:
    """Return an exemplar with its outline, smooth between pixels."""
    from iconstudio.algorithms.vectorize import trace

    side = _FINER * CANVAS
    fine = Image.fromarray(exemplar.coverage).resize((side, side), Image.Resampling.BICUBIC)
    return Icon(exemplar, painter_path(trace(np.asarray(fine))))


def page_of(layers: Sequence[Layer], icons: Sequence[Icon]) -> MontagePage:
    """Return a page with ``layers``; where strokes of two icons overlap, the upper one's stay."""
    page = MontagePage().with_icons(icons)
    for layer, one in zip(layers, page.layers, strict=True):
        page = page.placed(one.number, layer.placement).drawn(one.number, layer.strokes)
    return page


def write_page(path: Path, page: MontagePage) -> None:
    """Write a montage; icons that are not the collection's go into SVG files beside it.

    Raises
    ------
    IconstudioError
        If a file cannot be written.
    """
    from iconstudio.output import png

    layers = []
    for layer in page.montage().layers:
        reference, svg = layer.icon.id, layer.icon.svg
        if reference.startswith(("own:", "made:")):
            name = "".join(c if c.isalnum() or c == "-" else "-" for c in reference.split(":")[1])
            file = path.resolve().with_name(f"{path.stem}-{name}.svg")
            png.write(file, svg.encode())
            reference = str(file)
        layers.append(LayerFile(reference, layer.placement, layer.strokes))
    write_montage(path, MontageFile(tuple(layers)))
