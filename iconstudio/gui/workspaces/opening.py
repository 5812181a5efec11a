"""What all workspaces have in common when something is opened."""

from collections.abc import Callable, Generator
from typing import Any, ClassVar

from PySide6.QtCore import QMimeData, QObject, Signal
from PySide6.QtWidgets import QApplication, QFileDialog, QWidget

from iconstudio.gui.document import Document
from iconstudio.gui.dragging import dropped_file, unpacked
from iconstudio.gui.runner import Runner
from iconstudio.gui.worker import Worker
from iconstudio.model import IconstudioError, Pictogram
from iconstudio.session import Session


class Opener(QObject):
    """Opens things in the background and then puts them on the page, by one command each.

    A subclass says how each thing is opened, by generators that ``replace`` or ``add`` runs, and
    in ``put`` what becomes of what they yield.

    Signals
    -------
    failed(str)
        Something could not be opened, or not all of it; a sentence for the user.
    opened(str)
        What is there now, for the status line.
    """

    failed = Signal(str)
    opened = Signal(str)

    question: ClassVar[str] = ""
    """Title of the dialog that asks for a file of this workspace's own, “Open a sketch”."""
    kinds: ClassVar[str] = ""
    """What such files are called there, “Sketches”."""
    other: ClassVar[str] = "SVG file"
    """What else can be opened here."""

    def __init__(
        self, session: Session, document: Document, worker: Worker, owner: QWidget
    ) -> None:
        super().__init__(owner)
        self.session = session
        self.document = document
        self._worker = worker
        self._owner = owner
        self.runner = Runner(worker, self)
        """Does what ``replace`` starts; its ``progress`` and ``ended`` may be listened to."""
        self.runner.event.connect(self.receive)
        self.runner.failed.connect(self.failed)

    # -- what a subclass does ------------------------------------------------------------------

    def open_work(self, path: str) -> None:
        """Open a file of this workspace's own."""

    def open_file(self, path: str) -> None:
        """Open any other file."""

    def take(self, pictogram: Pictogram) -> None:
        """Open an icon that is sent, or dropped here."""

    def put(self, found: Any) -> str:
        """Put what was found on the page; return what to tell the user.

        Raises
        ------
        IconstudioError
            If there is no room for it.
        """
        raise NotImplementedError

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
        self.open_mime(QApplication.clipboard().mimeData())

    def open_mime(self, data: QMimeData) -> None:
        """Open what was dropped or pasted."""
        pictogram, path = unpacked(data), dropped_file(data)
        if pictogram is not None:
            self.take(pictogram)
        elif path is not None:
            (self.open_work if path.lower().endswith(".json") else self.open_file)(path)
        elif data.hasUrls():
            self.failed.emit(
                f"Only files on this computer can be opened. Save the {self.other} first."
            )
        else:
            self.failed.emit(f"There is no {self.other} to paste. Copy one first.")

    # -- in the background ---------------------------------------------------------------------

    def replace(self, make: Callable[[], Generator[Any]]) -> None:
        """Put what ``make()`` yields on the page, unless something else replaces it before."""
        self.runner.start(make)

    def add(self, make: Callable[[], Generator[Any]]) -> None:
        """Put what ``make()`` yields on the page, whatever else is opened meanwhile."""
        job = self._worker.submit(make)
        job.event.connect(self.receive)
        job.failed.connect(self.failed)

    def receive(self, found: object) -> None:
        """Put something on the page, and tell."""
        try:
            self.opened.emit(self.put(found))
        except IconstudioError as error:
            self.failed.emit(str(error))
