"""Gathers the icons to mix: sent, dropped, picked by the program, or named in a file."""

from collections.abc import Generator
from contextlib import closing
from dataclasses import dataclass, replace
from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QFileDialog, QWidget

from iconstudio.gui.runner import Runner
from iconstudio.gui.worker import Worker
from iconstudio.gui.workspaces.hybrids import files
from iconstudio.gui.workspaces.hybrids import page as edits
from iconstudio.gui.workspaces.hybrids.page import Ask, HybridsDocument, HybridsPage
from iconstudio.model import Exemplar, IconstudioError, Pictogram
from iconstudio.session import Session
from iconstudio.workflows.events import Event


@dataclass(frozen=True, slots=True)
class Picked:
    """What the program picked."""

    ask: Ask
    exemplars: tuple[Exemplar, ...]


class Gathering(QObject):
    """Finds icons in the background, and then puts them on the page, by one command each.

    Signals
    -------
    failed(str)
        Something could not be found or opened; a sentence for the user. The page is as it was.
    picked(Ask)
        The icons that the program picked are on the page.
    """

    failed = Signal(str)
    picked = Signal(object)

    def __init__(
        self, session: Session, document: HybridsDocument, worker: Worker, owner: QWidget
    ) -> None:
        super().__init__(owner)
        self._session = session
        self._document = document
        self._worker = worker
        self._owner = owner
        self.runner = Runner(worker, self)
        """Picks and opens; its ``progress`` and ``ended`` may be listened to."""
        self.runner.event.connect(self._put)
        self.runner.failed.connect(self.failed)

    def take(self, pictogram: Pictogram) -> None:
        """Mix an icon that was sent or dropped."""
        job = self._worker.submit(lambda: _drawn(self._session, pictogram))
        job.event.connect(self.add)
        job.failed.connect(self.failed)

    def add(self, exemplar: Exemplar) -> None:
        """Mix an icon that was chosen."""
        try:
            edits.add_icon(self._document, exemplar)
        except IconstudioError as error:
            self.failed.emit(str(error))

    def pick(self, keyword: str, count: int) -> None:
        """Let the program pick icons; once more, the next best ones."""
        page = self._document.page
        ask = Ask(keyword, count, page.symmetry)
        if page.ask is not None and ask == replace(page.ask, group=0):
            ask = replace(ask, group=page.ask.group + 1)
        self.runner.start(lambda: _picked(self._session, ask))

    def choose_mix(self) -> None:
        """Ask for a file that says what to mix."""
        path, _ = QFileDialog.getOpenFileName(
            self._owner, "Open a mix", "", "Mixes (*.json);;All files (*)"
        )
        if path:
            self.open_mix(path)

    def open_mix(self, path: str) -> None:
        """Put the icons that a file names on the page; favourites stay."""
        self.runner.start(lambda: files.read_page(self._session, Path(path)))

    def _put(self, event: Event | Picked | HybridsPage) -> None:
        if isinstance(event, HybridsPage):
            kept = self._document.page.favourites
            self._document.change("open mix", replace(event, favourites=kept))
        elif isinstance(event, Picked):
            edits.set_icons(self._document, event.exemplars, event.ask)
            self.picked.emit(event.ask)


def _drawn(session: Session, pictogram: Pictogram) -> Generator[Exemplar]:
    yield session.exemplar(pictogram)


def _picked(session: Session, ask: Ask) -> Generator[Event | Picked]:
    with closing(session.choose(ask.keyword, ask.count, ask.symmetry, ask.group)) as choosing:
        icons = yield from choosing
    yield Picked(ask, tuple(map(session.exemplar, icons)))
