"""Opens what is chosen, dropped or pasted, in the background, and puts it on the page."""

from collections.abc import Callable, Generator, Sequence
from pathlib import Path
from typing import Any

from PySide6.QtCore import QMimeData, QObject, Signal
from PySide6.QtWidgets import QApplication, QFileDialog, QWidget

from iconstudio.grammar import was
from iconstudio.gui.exchange import mime
from iconstudio.gui.exchange.patience import Patience
from iconstudio.gui.exchange.scanning import ScanDialog
from iconstudio.gui.exchange.symbols import SymbolDialog
from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.jobs.worker import Job, Worker
from iconstudio.importing.importer import Importer, Opened
from iconstudio.inputs.items import Elsewhere, File, Item
from iconstudio.inputs.together import ReadTogether, Sprite, quoted_list, read_together
from iconstudio.model import IconstudioError, Pictogram
from iconstudio.project.archive import SUFFIX


class Opener(QObject):
    """Reads in the background what ``importer`` can bring onto a page, by one command each.

    Signals
    -------
    began()
        The user opens something, and nothing else is being opened.
    failed(str)
        Something could not be opened, or not all of it; a sentence for the user.
    opened(str)
        What is there now, for the status line.
    progressed(Progress), rested()
        Something is being opened that takes long; that is over.
    choosing()
        The user is to choose a symbol of a sprite sheet.
    project(str)
        A project is to be opened, in the file of that path.
    """

    began = Signal()
    failed = Signal(str)
    opened = Signal(str)
    progressed = Signal(object)
    rested = Signal()
    choosing = Signal()
    project = Signal(str)

    def __init__(self, importer: Importer, worker: Worker, owner: QWidget) -> None:
        """``owner`` is what dialogs stand over."""
        super().__init__(owner)
        self.importer = importer
        self._worker = worker
        self._owner = owner
        self.adding: list[Job] = []
        """Read what is added; what takes the place of all is read by ``runner``."""
        self._complaints: list[str] = []
        self.patience = Patience(self.progressed.emit, self.rested.emit, self)
        """Asks for it while something is being opened."""
        self.runner = Runner(worker, self)
        """Does what ``replace`` starts; its ``progress`` and ``ended`` may be listened to."""
        self.runner.event.connect(self.receive)
        self.runner.failed.connect(self.complain)
        self.runner.ended.connect(self._rest)

    # -- ways to open --------------------------------------------------------------------------

    def choose_work(self) -> None:
        """Ask for a file of this workspace's own."""
        self.ask(self.importer.question, f"{self.importer.kinds} (*.json)", self.open_work)

    def ask(self, question: str, kinds: str, use: Callable[[str], None]) -> None:
        """Ask for a file, and ``use`` its path if the user names one."""
        path, _ = QFileDialog.getOpenFileName(self._owner, question, "", f"{kinds};;All files (*)")
        if path:
            use(path)

    def open_work(self, path: str) -> None:
        """Open a file of this workspace's own."""
        self.replace(lambda: self.importer.opening(Path(path)))

    def open_file(self, path: str) -> None:
        """Open any other file."""
        self.open_items((File(path),))

    def open_drawing(self, path: str) -> None:
        """Open a file as a drawing, whatever it is called."""
        item = File(path)
        if self.importer.becomes_icon(item):
            self._make_icon(item)
        else:
            self.replace(lambda: self._reading([item]))

    def take(self, pictogram: Pictogram) -> None:
        """Open an icon that is sent, or dropped here."""
        self.open_items((pictogram,))

    def paste(self) -> None:
        """Open what is on the clipboard."""
        self.open_mime(QApplication.clipboard().mimeData(), pasted=True)

    def open_mime(self, data: QMimeData, pasted: bool = False) -> None:
        """Open what was dropped or pasted."""
        self._begin_anew()
        items, other = mime.items(data, self.importer.images_first), self.importer.other
        forms = self.importer.forms
        if not items and pasted:
            self.complain(f"There is no {other} to paste. Copy {forms} first.")
        elif not items:
            self.complain(f"There is no {other} in what was dropped. Drop {forms}.")
        elif len(items) == 1:
            self.open_item(items[0])
        else:
            self.open_items(items)

    def open_item(self, item: Item) -> None:
        """Open a single thing; of an image of pixels, an icon may be made while the user looks."""
        importer = self.importer
        if isinstance(item, Elsewhere):
            self.complain(
                f"Only files on this computer can be opened. Save the {importer.other} first."
            )
        elif (reading := importer.alone(item)) is not None:
            self.replace(lambda: reading)
        elif importer.becomes_icon(item):
            self._make_icon(item)
        else:
            self.open_items((item,))

    def open_items(self, items: Sequence[Item]) -> None:
        """Open several things together; what is left over is told."""
        works = [one for one in items if _is_work(one)]
        others = [one for one in items if one not in works]
        start = self.replace if self.importer.most == 1 else self.add
        if others:
            start(lambda: self._reading(others))
        else:
            path = works.pop(0).path  # a project is none of the page's
            (self.project.emit if path.lower().endswith(SUFFIX) else self.open_work)(path)
        if works:
            self.complain(
                f"{quoted_list(works)} {was(works)} not opened. What such a file holds takes the "
                "place of all that is here: open it by itself."
            )

    # -- in the background ---------------------------------------------------------------------

    def replace(self, make: Callable[[], Generator[Any]]) -> None:
        """Put what ``make()`` yields on the page, unless something else replaces it before."""
        self._begin_anew()
        self.patience.begin()
        self.runner.start(make)

    def add(self, make: Callable[[], Generator[Any]]) -> None:
        """Put what ``make()`` yields on the page, whatever else is opened meanwhile."""
        self._begin_anew()
        self.patience.begin()
        job = self._worker.submit(make)
        self.adding.append(job)
        job.event.connect(self.receive)
        job.failed.connect(self.complain)
        job.finished.connect(self._added)

    def cancel(self) -> None:
        """Open nothing any more of what is being opened."""
        self.runner.cancel()
        for job in self.adding:
            job.cancel()
        self.adding.clear()
        self._rest()

    def receive(self, found: object) -> None:
        """Put something on the page, and tell."""
        try:
            match found:
                case Sprite():
                    self._choose_symbol(found)
                    return
                case Opened(words, put):
                    told = words, *(put(self.importer.document) or ())
                case ReadTogether():
                    for complaint in found.complaints:
                        self.complain(complaint)
                    told = self.importer.put(found) if found.found else ()
                case _:
                    return
        except IconstudioError as error:
            self.complain(str(error))
            return
        if told:
            self.opened.emit(told[0])
            for complaint in self._complaints:  # what was told before has gone with that
                self.failed.emit(complaint)
            for complaint in told[1:]:
                self.complain(complaint)

    def complain(self, message: str) -> None:
        """Tell the user of something that was not opened, until all is opened that is to be."""
        if self.busy:
            self._complaints.append(message)
        self.failed.emit(message)

    @property
    def busy(self) -> bool:
        """Whether something is being opened that is not on the page yet."""
        return bool(self.adding) or self.runner.running

    def _reading(self, items: Sequence[Item]) -> Generator[Any]:
        importer = self.importer
        return read_together(items, importer.reading, importer.most, importer.no_room)

    def _begin_anew(self) -> None:
        if not self.busy:
            self.began.emit()

    def _added(self) -> None:
        if (job := self.sender()) in self.adding:  # else it was cancelled
            self.adding.remove(job)
        self._rest()

    def _rest(self) -> None:
        if not self.busy:
            self._complaints.clear()
            self.patience.end()

    # -- dialogs -------------------------------------------------------------------------------

    def _choose_symbol(self, sprite: Sprite) -> None:
        """Let the user choose a symbol of a sprite sheet, and open that."""
        importer, session = self.importer, self.importer.session
        self.choosing.emit()

        def find(name: str) -> Pictogram:
            return importer.symbol(sprite, name)

        dialog = SymbolDialog(session, self._worker, find, sprite.names, self._owner)
        dialog.chosen.connect(self.take)
        dialog.open()

    def _make_icon(self, item: Item) -> None:
        """Let the user see which icon becomes of an image, and open that."""
        source = Path(item.path) if isinstance(item, File) else item.image
        session = self.importer.session
        dialog = ScanDialog(session, self._worker, source, item.name, self._owner)
        dialog.chosen.connect(self.take)
        dialog.failed.connect(self.complain)
        dialog.no_image.connect(lambda: self.open_items((item,)))
        dialog.open()


def _is_work(item: Item) -> bool:
    """Whether something is a file of the program's own."""
    return isinstance(item, File) and item.path.lower().endswith((".json", SUFFIX))
