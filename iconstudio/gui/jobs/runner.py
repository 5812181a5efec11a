"""One run of a workflow at a time, in a workspace's thread."""

from collections.abc import Callable, Generator
from typing import Any

from PySide6.QtCore import QObject, Signal

from iconstudio.gui.jobs.worker import Job, Worker
from iconstudio.workflows.events import Progress


class Runner(QObject):
    """Runs a generator of events; another one that is started takes its place.

    Signals
    -------
    progress(Progress), event(object)
        What the generator yields: its progress, and all the rest.
    failed(str)
        It raised; a sentence for the user.
    ended(bool)
        It is over, in whatever way; whether it came to its end. Once for each ``start``. If
        another one took its place, that is ``running`` already.
    """

    progress = Signal(object)
    event = Signal(object)
    failed = Signal(str)
    ended = Signal(bool)

    def __init__(self, worker: Worker, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._worker = worker
        self._job: Job | None = None
        self._whole = True

    @property
    def running(self) -> bool:
        """Whether something runs, or waits for its turn."""
        return self._job is not None

    def start(self, make: Callable[[], Generator[Any]]) -> None:
        """Cancel what runs, and run the generator ``make()``."""
        before = self._job
        if before is not None:
            before.cancel()
        job = self._worker.submit(make)
        job.event.connect(self._tell)
        job.failed.connect(self._fail)
        job.finished.connect(self._end)
        self._job, self._whole = job, True
        if before is not None:
            self.ended.emit(False)

    def cancel(self) -> None:
        """Stop what runs; nothing more is heard of it but ``ended(False)``, at once."""
        if self._drop():
            self.ended.emit(False)

    def _drop(self) -> bool:
        """Hear nothing more of what runs; return whether anything did."""
        job, self._job = self._job, None
        if job is not None:
            job.cancel()
        return job is not None

    def _tell(self, event: object) -> None:
        (self.progress if isinstance(event, Progress) else self.event).emit(event)

    def _fail(self, message: str) -> None:
        self._whole = False
        self.failed.emit(message)

    def _end(self) -> None:
        if self.sender() is self._job:
            self._job = None
            self.ended.emit(self._whole)
