"""What all workspaces have in common when something is opened."""

from collections.abc import Callable, Generator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

from PySide6.QtCore import QMimeData, QObject, Signal
from PySide6.QtWidgets import QApplication, QFileDialog, QWidget

from iconstudio.gui.document.document import Document
from iconstudio.gui.exchange import mime
from iconstudio.gui.exchange.patience import Patience
from iconstudio.gui.exchange.scanning import ImageInput, ScanDialog, may_be_scan, pictogram_of
from iconstudio.gui.exchange.symbols import SymbolDialog
from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.jobs.worker import Job, Worker
from iconstudio.inputs.items import Drawing, Elsewhere, File, Image, Item, Reference
from iconstudio.inputs.together import ReadTogether, Sprite, quoted_list, read_together, was
from iconstudio.model import IconstudioError, Pictogram
from iconstudio.project.archive import SUFFIX
from iconstudio.session import Session


@dataclass(frozen=True, slots=True)
class Opened:
    """Something that was opened: what to tell the user, once it is on the page."""

    words: str
    put: Callable[[Document], object]
    """Puts it there, by one command."""

    def onto(self, document: Document) -> str:
        """Put it on the page, and return the words."""
        self.put(document)
        return self.words


class Opener(QObject):
    """Opens things in the background and then puts them on the page, by one command each.

    A subclass says in ``opening`` what is in a file of its own. Other things, which may be dropped
    or pasted together, are read each by ``reading``, and put on the page together by ``put``.

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
    project(str)
        A project is to be opened, in the file of that path.
    """

    began = Signal()
    failed = Signal(str)
    opened = Signal(str)
    progressed = Signal(object)
    rested = Signal()
    project = Signal(str)

    question: ClassVar[str] = ""
    """Title of the dialog that asks for a file of this workspace's own, “Open a sketch”."""
    kinds: ClassVar[str] = ""
    """What such files are called there, “Sketches”."""
    other: ClassVar[str] = "drawing"
    """What else can be opened here."""
    forms: ClassVar[str] = "a file, a drawing or its markup"
    """In what forms it can be dropped or pasted."""
    images_first: ClassVar[bool] = False
    """Whether an image of pixels is wanted rather than a drawing of the same."""
    most: ClassVar[int] = 1
    """How many things the page has room for."""
    limit: ClassVar[str] = ""
    """Why there is no room for more, “an edit has one icon”."""

    def __init__(
        self, session: Session, document: Document | None, worker: Worker, owner: QWidget
    ) -> None:
        super().__init__(owner)
        self.session = session
        self.document = document
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

    # -- what a subclass does ------------------------------------------------------------------

    def opening(self, path: Path) -> Generator[Any]:
        """Yield what is in a file of this workspace's own as ``Opened``; in the worker's thread.

        Raises
        ------
        IconstudioError
            If it cannot be opened here.
        """
        raise NotImplementedError

    def open_work(self, path: str) -> None:
        """Open a file of this workspace's own."""
        self.replace(lambda: self.opening(Path(path)))

    def try_example(self, path: str) -> None:
        """Open an example."""
        self.open_work(path)

    def open_file(self, path: str) -> None:
        """Open any other file."""
        self.open_items((File(path),))

    def take(self, pictogram: Pictogram) -> None:
        """Open an icon that is sent, or dropped here."""
        self.open_items((pictogram,))

    def reading(self, item: Item) -> Generator[None, None, Any]:
        """Return what ``put`` puts on the page; in the worker's thread.

        Raises
        ------
        IconstudioError
            If it cannot be opened here.
        """
        raise NotImplementedError

    def put(self, gathered: ReadTogether) -> str:
        """Put all that was read on the page; return what to tell the user.

        Raises
        ------
        IconstudioError
            If there is no room for it.
        """
        raise NotImplementedError

    def choose_symbol(self, sprite: Sprite) -> None:
        """Let the user choose a symbol of a sprite sheet that was opened."""

    # -- ways to open --------------------------------------------------------------------------

    def choose_work(self) -> None:
        """Ask for a file of this workspace's own."""
        self.ask(self.question, f"{self.kinds} (*.json)", self.open_work)

    def ask(self, question: str, kinds: str, use: Callable[[str], None]) -> None:
        """Ask for a file, and ``use`` its path if the user names one."""
        path, _ = QFileDialog.getOpenFileName(self._owner, question, "", f"{kinds};;All files (*)")
        if path:
            use(path)

    def paste(self) -> None:
        """Open what is on the clipboard."""
        self.open_mime(QApplication.clipboard().mimeData(), pasted=True)

    def open_mime(self, data: QMimeData, pasted: bool = False) -> None:
        """Open what was dropped or pasted."""
        self._begin_anew()
        items = mime.items(data, self.images_first)
        if not items and pasted:
            self.complain(f"There is no {self.other} to paste. Copy {self.forms} first.")
        elif not items:
            self.complain(f"There is no {self.other} in what was dropped. Drop {self.forms}.")
        elif len(items) == 1:
            self.open_item(items[0])
        else:
            self.open_items(items)

    def open_item(self, item: Item) -> None:
        """Open a single thing."""
        match item:
            case Pictogram() as pictogram:
                self.take(pictogram)
            case File(path):
                (_way(self, path) if _is_work(item) else self.open_file)(path)
            case Elsewhere():
                self.complain(
                    f"Only files on this computer can be opened. Save the {self.other} first."
                )
            case _:
                self.open_items((item,))

    def open_items(self, items: Sequence[Item]) -> None:
        """Open several things together; what is left over is told."""
        works = [one for one in items if _is_work(one)]
        others = [one for one in items if one not in works]
        start = self.replace if self.most == 1 else self.add
        if others:
            start(lambda: read_together(others, self.reading, self.most, self.no_room))
        else:
            path = works.pop(0).path
            _way(self, path)(path)
        if works:
            self.complain(
                f"{quoted_list(works)} {was(works)} not opened. What such a file holds takes the "
                "place of all that is here: open it by itself."
            )

    def no_room(self, taken: Sequence[str], left: Sequence[Item | str]) -> str:
        """Return the sentence that says for what there was no room."""
        if self.most == 1:
            return f"Only “{taken[0]}” was opened, not {quoted_list(left)}: {self.limit}."
        return f"{quoted_list(left)} {was(left)} not added: {self.limit}."

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
        if isinstance(found, Sprite):
            self.choose_symbol(found)
        if isinstance(found, ReadTogether):
            for complaint in found.complaints:
                self.complain(complaint)
        try:
            match found:
                case Opened():
                    done = found.onto(self.document)
                case ReadTogether() if found.found:
                    done = self.put(found)
                case _:
                    return
        except IconstudioError as error:
            self.complain(str(error))
            return
        self.opened.emit(done)
        for complaint in self._complaints:  # what was told before has gone from sight with that
            self.failed.emit(complaint)

    def complain(self, message: str) -> None:
        """Tell the user of something that was not opened, until all is opened that is to be."""
        if self._busy:
            self._complaints.append(message)
        self.failed.emit(message)

    @property
    def _busy(self) -> bool:
        return bool(self.adding) or self.runner.running

    def _begin_anew(self) -> None:
        if not self._busy:
            self.began.emit()

    def _added(self) -> None:
        if (job := self.sender()) in self.adding:  # else it was cancelled
            self.adding.remove(job)
        self._rest()

    def _rest(self) -> None:
        if not self._busy:
            self._complaints.clear()
            self.patience.end()


def _is_work(item: Item) -> bool:
    """Whether something is a file of the program's own."""
    return isinstance(item, File) and item.path.lower().endswith((".json", SUFFIX))


def _way(opener: Opener, path: str) -> Callable[[str], object]:
    """Return how a file of the program's own is opened: a project is none of the page's."""
    return opener.project.emit if path.lower().endswith(SUFFIX) else opener.open_work


class IconOpener(Opener):
    """Opens icons: those of the window or the collection, files, and markup."""

    def open_item(self, item: Item) -> None:
        """Open a single thing; of an image of pixels, an icon is made while the user looks on."""
        match item:
            case File(path) if may_be_scan(path):
                self._scan(item, Path(path))
            case Image(image):
                self._scan(item, image)
            case _:
                super().open_item(item)

    def open_drawing(self, path: str) -> None:
        """Open a file as a drawing, whatever it is called."""
        item = File(path)
        if may_be_scan(path):
            self._scan(item, Path(path))
        else:
            self.replace(lambda: read_together([item], self.reading, self.most, self.no_room))

    def reading(self, item: Item) -> Generator[None, None, Any]:
        """Return an icon, drawn."""
        return self.drawn((yield from self._pictogram(item)))

    def drawn(self, pictogram: Pictogram) -> Any:
        """Return what is put on the page for an icon; in the worker's thread."""
        return self.session.exemplar(pictogram)

    def _pictogram(self, item: Item) -> Generator[None, None, Pictogram]:
        match item:
            case Pictogram() as pictogram:
                return pictogram
            case File(name) | Reference(name):
                return self.session.icon(name)
            case Drawing(data, name):
                return self.session.icon_from(data, name)
            case Image(image, name):
                return (yield from pictogram_of(self.session, image, name))
        raise IconstudioError(f"“{item.name}” is nothing that can be used here.")

    def choose_symbol(self, sprite: Sprite) -> None:
        """Let the user choose a symbol of a sprite sheet, and open that."""
        session = self.session

        def find(name: str) -> Pictogram:
            match sprite.item:
                case Drawing(data, title):
                    return session.icon_from(data, title, name)
                case File(reference) | Reference(reference):
                    return session.icon(f"{reference}#{name}")
            raise IconstudioError(f"“{sprite.item.name}” is nothing that can be used here.")

        dialog = SymbolDialog(session, self._worker, find, sprite.names, self._owner)
        dialog.chosen.connect(self.take)
        dialog.open()

    def _scan(self, item: Item, source: ImageInput) -> None:
        dialog = ScanDialog(self.session, self._worker, source, item.name, self._owner)
        dialog.chosen.connect(self.take)
        dialog.failed.connect(self.complain)
        dialog.no_image.connect(lambda: self.open_items((item,)))
        dialog.open()
