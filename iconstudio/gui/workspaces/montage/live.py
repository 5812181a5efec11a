"""The result of the montage, always of what was drawn last."""

from collections.abc import Generator
from contextlib import closing
from dataclasses import replace

from PySide6.QtCore import QObject, Signal

from iconstudio.gui.gallery.pictures import Picture, picture_of
from iconstudio.gui.jobs.coalescing import Coalescing
from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.jobs.worker import Worker
from iconstudio.model import Montage, Remix
from iconstudio.output.colours import Palette
from iconstudio.session import Session
from iconstudio.workflows.events import Event, Result
from iconstudio.workflows.montage.spec import MONTAGE

TITLE = "montage"
"""What results are called in files."""

PATIENCE = 1000
"""Milliseconds that a run may go on though its result is out of date."""


class LiveResult(QObject):
    """Makes the montage again and again; of those wanted meanwhile, only the newest is made.

    Signals
    -------
    shown(Picture)
        The newest result that there is.
    progress(Progress)
        A run takes so long that the user should know.
    failed(str)
        A sentence for the user.
    idle()
        The last result is that of what was wanted last.
    """

    shown = Signal(object)
    progress = Signal(object)
    failed = Signal(str)
    idle = Signal()

    def __init__(self, session: Session, worker: Worker, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._wanted: tuple[Montage, Palette] | None = None
        self.runner = Runner(worker, self)
        self.coalescing = Coalescing(self.runner, self._begin, PATIENCE)
        self.runner.event.connect(self._show)
        self.runner.progress.connect(self._tell)
        self.runner.failed.connect(self._fail)
        self.runner.ended.connect(self._go_on)

    @property
    def busy(self) -> bool:
        """Whether the result of what was wanted last is still to come."""
        return self.runner.running

    def request(self, montage: Montage, palette: Palette) -> None:
        """Make this one, as soon as the run under way, if there is one, is over."""
        if self._wanted is not None and self._wanted[0] == montage:
            return
        self._wanted = montage, palette
        self.coalescing.request()

    def discard(self) -> None:
        """Want nothing: a run under way is of no interest."""
        self._wanted = None
        self.coalescing.discard()

    def cancel(self) -> None:
        """Stop at once."""
        self.discard()
        self.runner.cancel()

    def _begin(self) -> None:
        montage, palette = self._wanted
        self.runner.start(lambda: self._made(montage, palette))

    def _made(self, montage: Montage, palette: Palette) -> Generator[Event | Picture]:
        """Pass the events of a run on, its result as a picture; in the worker's thread."""
        with closing(self._session.run(MONTAGE, montage)) as events:
            for event in events:
                if isinstance(event, Result):
                    icon = replace(event.icon, title=TITLE)
                    yield picture_of(icon, colours=_coloured(montage, icon, palette))
                else:
                    yield event

    def _show(self, event: object) -> None:
        if isinstance(event, Picture) and self._wanted is not None:
            self.shown.emit(event)

    def _fail(self, message: str) -> None:
        if not self.coalescing.pending:
            self.failed.emit(message)

    def _tell(self, progress: object) -> None:
        if not self.coalescing.holding:
            self.progress.emit(progress)

    def _go_on(self, whole: bool) -> None:
        if self.runner.running:
            return
        if not whole:
            self._wanted = None
        self.idle.emit()


def _coloured(montage: Montage, icon: Remix, palette: Palette) -> Palette:
    """Return the colours of an icon's sources, which may lie elsewhere than their layers."""
    from iconstudio.output.colours import key_of

    pairs = zip(icon.composite.sources, montage.layers, strict=True)
    return {key_of(source): palette[layer.icon.id, layer.placement] for source, layer in pairs}
