"""The result of the montage, always of what was drawn last."""

from collections.abc import Generator
from contextlib import closing
from time import monotonic

from PySide6.QtCore import QObject, QTimer, Signal

from iconstudio.gui.pictures import Picture, picture_of
from iconstudio.gui.runner import Runner
from iconstudio.gui.worker import Worker
from iconstudio.model import Montage
from iconstudio.output.colours import Palette
from iconstudio.session import Session
from iconstudio.workflows.events import Event, Result

TITLE = "montage"
"""What results are called in files."""

PATIENCE = 1.0
"""Seconds that a run may go on though its result is out of date: to stop one ends a process, and
to start another takes longer than to wait."""


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
    rested()
        The last result is that of what was wanted last.
    """

    shown = Signal(object)
    progress = Signal(object)
    failed = Signal(str)
    rested = Signal()

    def __init__(self, session: Session, worker: Worker, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._wanted: tuple[Montage, Palette] | None = None
        self._waiting = False
        self._began = 0.0
        self.runner = Runner(worker, self)
        self.runner.event.connect(self._show)
        self.runner.progress.connect(self._tell)
        self.runner.failed.connect(self._fail)
        self.runner.ended.connect(self._go_on)
        self._timer = QTimer(self, singleShot=True, interval=round(1000 * PATIENCE))
        self._timer.timeout.connect(self._lose_patience)

    @property
    def busy(self) -> bool:
        """Whether the result of what was wanted last is still to come."""
        return self.runner.running

    def want(self, montage: Montage, palette: Palette) -> None:
        """Make this one, as soon as the run under way, if there is one, is over."""
        if self._wanted is not None and self._wanted[0] == montage:
            return
        self._wanted = montage, palette
        self._waiting = True
        if not self.runner.running:
            self._start()
        elif monotonic() - self._began > PATIENCE:
            self._lose_patience()

    def forget(self) -> None:
        """Want nothing: a run under way is of no interest."""
        self._wanted, self._waiting = None, False

    def cancel(self) -> None:
        """Stop at once."""
        self.forget()
        self.runner.cancel()

    def _start(self) -> None:
        montage, palette = self._wanted
        self._waiting, self._began = False, monotonic()
        self._timer.start()
        self.runner.start(lambda: self._made(montage, palette))

    def _made(self, montage: Montage, palette: Palette) -> Generator[Event | Picture]:
        """Pass the events of a run on, its result as a picture; in the worker's thread."""
        with closing(self._session.montage(montage)) as events:
            for event in events:
                if isinstance(event, Result):
                    yield picture_of(event, TITLE, colours=palette)
                else:
                    yield event

    def _show(self, event: object) -> None:
        if isinstance(event, Picture) and self._wanted is not None:
            self.shown.emit(event)

    def _fail(self, message: str) -> None:
        if not self._waiting:
            self.failed.emit(message)

    def _tell(self, progress: object) -> None:
        if monotonic() - self._began > PATIENCE:
            self.progress.emit(progress)

    def _go_on(self, whole: bool) -> None:
        self._timer.stop()
        if self._waiting:
            self._start()
            return
        if not whole:
            self._wanted = None
        self.rested.emit()

    def _lose_patience(self) -> None:
        """Stop what runs if something newer waits; its end starts that."""
        if self._waiting and self.runner.running:
            self.runner.cancel()
