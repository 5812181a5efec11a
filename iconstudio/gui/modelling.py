"""Sketch-based modelling in the window: keeps the session at work for the document."""

from dataclasses import dataclass

from PySide6.QtCore import QObject, QTimer, Signal

from iconstudio.gui import commands
from iconstudio.gui.document import Document, Page
from iconstudio.gui.pictures import Picture, pictured
from iconstudio.gui.worker import Job, Worker
from iconstudio.model import IconstudioError, Sketch
from iconstudio.session import ModelSettings, Session
from iconstudio.workflows.events import (
    Event,
    Progress,
    RegionsFound,
    Retrieved,
    StyleMatched,
    StyleSkipped,
)

DEBOUNCE = 400
"""Milliseconds without a keystroke after which a keyword counts as typed."""


@dataclass(frozen=True, slots=True)
class Query:
    """What the retrieved icons depend on."""

    keyword: str = ""
    exclude: frozenset[str] = frozenset()

    @classmethod
    def of(cls, sketch: Sketch) -> "Query":
        """Return the query of a sketch."""
        return cls(sketch.keyword.strip(), sketch.exclude)


class Modelling(QObject):
    """Prepares the keyword's icons while the user draws, and runs the remixing.

    Signals
    -------
    preparing(str)
        A keyword is being looked up; empty if there is none.
    retrieved(tuple)
        The exemplars of the keyword.
    prepare_failed(str)
        The keyword cannot be used; a sentence for the user.
    started(Sketch, ModelSettings), regions(tuple), matched(StyleMatched), skipped(StyleSkipped)
    finished_icon(Picture)
        One of the results of a run.
    progress(Progress)
        Of whatever is under way.
    failed(str)
        A run could not be started or finished; a sentence for the user.
    ended(bool)
        A run is over; whether it came to its end.
    remarked(str)
        Something that the user should know, though the work goes on.
    idle()
        Nothing is under way any more.
    """

    preparing = Signal(str)
    retrieved = Signal(tuple)
    prepare_failed = Signal(str)
    started = Signal(object, object)
    regions = Signal(tuple)
    matched = Signal(object)
    skipped = Signal(object)
    finished_icon = Signal(object)
    progress = Signal(object)
    failed = Signal(str)
    ended = Signal(bool)
    remarked = Signal(str)
    idle = Signal()

    def __init__(
        self, document: Document, session: Session, worker: Worker, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._session = session
        self._worker = worker
        self._query = Query()
        self._opening: Job | None = None
        self._preparation: Job | None = None
        self._run: Job | None = None
        self._failed = False
        self._troubled = False
        self._timer = QTimer(self, singleShot=True, interval=DEBOUNCE)
        self._timer.timeout.connect(self._prepare)
        document.page_changed.connect(self._page_changed)

    @property
    def running(self) -> bool:
        """Whether a run is under way."""
        return self._run is not None

    def open(self) -> None:
        """Open the collection ahead of the first search."""
        job = self._worker.submit(self._session.open)
        job.event.connect(self._handle)
        job.failed.connect(self.failed)
        job.finished.connect(self._ended_opening)
        self._opening = job

    def run(self, settings: ModelSettings | None = None) -> bool:
        """Remix for the document's sketch; an outline that is still open is closed first.

        Return whether the run has begun; if something is missing, ``failed`` says what.
        """
        page = self._document.page
        if not page.closed and len(page.vertices) >= 3:
            self._document.undo_stack.push(commands.CloseOutline(self._document))
        sketch = self._document.sketch
        problem = _problem(sketch)
        if problem:
            self.failed.emit(problem)
            return False
        self.cancel_run()
        if self._timer.isActive() or Query.of(sketch) != self._query:
            self._timer.stop()
            self._prepare()
        settings = settings or ModelSettings()
        job = self._worker.submit(lambda: pictured(self._session.model(sketch, settings)))
        job.event.connect(self._handle)
        job.failed.connect(self._fail)
        job.finished.connect(self._ended_run)
        self._run, self._failed = job, False
        self.started.emit(sketch, settings)
        return True

    def cancel(self) -> None:
        """Stop the run and the preparation."""
        if self._preparation is not None:
            self._query = Query()
            self.preparing.emit("")
        self._cancel_preparation()
        self.cancel_run()

    def cancel_run(self) -> None:
        """Stop the run; results that are finished stay."""
        job, self._run = self._run, None
        if job is not None:
            job.cancel()
            self.ended.emit(False)
            self._tell_idle()

    # -- preparation ---------------------------------------------------------------------------

    def _page_changed(self, page: Page) -> None:
        query = Query.of(page.sketch)
        if query == self._query:
            self._timer.stop()
        else:
            self._timer.start()

    def _prepare(self) -> None:
        query = Query.of(self._document.sketch)
        if query.keyword != self._query.keyword:
            self.preparing.emit(query.keyword)
        self._query = query
        self._cancel_preparation()
        if not query.keyword:
            return
        job = self._worker.submit(lambda: self._session.prepare(query.keyword, query.exclude))
        job.event.connect(self._handle)
        job.failed.connect(self._prepare_failed)
        job.finished.connect(self._ended_preparation)
        self._preparation = job

    def _cancel_preparation(self) -> None:
        job, self._preparation = self._preparation, None
        if job is not None:
            job.cancel()
            self._tell_idle()

    def _prepare_failed(self, message: str) -> None:
        self.prepare_failed.emit(message)

    def _ended_preparation(self) -> None:
        if self.sender() is self._preparation:
            self._preparation = None
            self._tell_idle()
        if self._session.trouble and not self._troubled:
            self._troubled = True
            self.remarked.emit(self._session.trouble)

    def _ended_opening(self) -> None:
        self._opening = None
        self._tell_idle()

    # -- run -----------------------------------------------------------------------------------

    def _handle(self, event: "Event | Picture") -> None:
        match event:
            case Progress():
                self.progress.emit(event)
            case Retrieved():
                # A run may look for a keyword that has been edited since.
                if event.keyword.strip() == self._query.keyword:
                    self.retrieved.emit(event.exemplars)
            case RegionsFound():
                self.regions.emit(event.centres)
            case StyleMatched():
                self.matched.emit(event)
            case StyleSkipped():
                self.skipped.emit(event)
            case Picture():
                self.finished_icon.emit(event)

    def _fail(self, message: str) -> None:
        self._failed = True
        self.failed.emit(message)

    def _ended_run(self) -> None:
        if self.sender() is self._run:
            self._run = None
            self.ended.emit(not self._failed)
            self._tell_idle()

    def _tell_idle(self) -> None:
        if self._run is self._preparation is self._opening is None:
            self.idle.emit()


def _problem(sketch: Sketch) -> str:
    """Return what is missing before ``sketch`` can be remixed, as a sentence; else nothing."""
    if not sketch.polygon.vertices:
        return "There is no outline yet. Click around the object on the canvas to trace it."
    try:
        sketch.polygon.fitted()
    except IconstudioError as error:
        return str(error)
    if not sketch.keyword.strip():
        return "The object has no name yet. Type what it is below the canvas, for example “dog”."
    return ""
