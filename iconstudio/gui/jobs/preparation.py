"""Looks up a keyword's icons while the user still draws."""

from dataclasses import astuple, dataclass

from PySide6.QtCore import QObject, QTimer, Signal

from iconstudio.algorithms.iconification.matching import SCALES
from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.jobs.worker import Worker
from iconstudio.session import Session
from iconstudio.workflows.events import Event, Retrieved

_KEPT = 3
"""Icons of how many keywords are kept, as many as a session keeps ready."""

DEBOUNCE = 300
"""Milliseconds without a keystroke after which a keyword counts as typed."""


@dataclass(frozen=True, slots=True)
class Query:
    """What the retrieved icons depend on."""

    keyword: str = ""
    exclude: frozenset[str] = frozenset()
    scales: tuple[float, ...] = SCALES

    @classmethod
    def of(
        cls, keyword: str, exclude: frozenset[str], scales: tuple[float, ...] = SCALES
    ) -> "Query":
        """Return the query; blanks around the keyword mean nothing."""
        return cls(keyword.strip(), exclude, scales)


class Preparation(QObject):
    """Has the icons of a keyword retrieved and prepared once the user has stopped typing it.

    Signals
    -------
    started(str)
        Another keyword is being looked up; empty if there is none.
    retrieved(Retrieved)
        The exemplars of the keyword are there.
    failed(str)
        The keyword cannot be used; a sentence for the user.
    remarked(str)
        Something that the user should know, though the work goes on.
    settled()
        The icons are ready for a run.
    """

    started = Signal(str)
    retrieved = Signal(object)
    failed = Signal(str)
    remarked = Signal(str)
    settled = Signal()

    def __init__(self, session: Session, worker: Worker, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self.runner = Runner(worker, self)
        """Does the work; its ``progress`` and ``ended`` may be listened to."""
        self._query = self._wanted = self._ready = Query()
        self._known: dict[Query, Retrieved] = {}
        self._troubled = False
        self._timer = QTimer(self, singleShot=True, interval=DEBOUNCE)
        self._timer.timeout.connect(self._look_up)
        self.runner.event.connect(self._show)
        self.runner.failed.connect(self.failed)
        self.runner.ended.connect(self._end)

    @property
    def ready(self) -> bool:
        """Whether the icons of what was wanted last are ready for a run."""
        return bool(self._wanted.keyword) and self._wanted == self._ready

    def request(self, query: Query) -> None:
        """Look up ``query`` soon, unless it is the last one or yet another comes."""
        self._wanted = query
        if query == self._query:
            self._timer.stop()
        else:
            self._timer.start()

    def hurry(self) -> None:
        """Look up at once what waits to be looked up."""
        self._timer.stop()
        if self._wanted != self._query:
            self._look_up()

    def cancel(self) -> None:
        """Stop; a keyword that was still being looked up is forgotten."""
        self._timer.stop()
        if self.runner.running:
            self._query = Query()
            self.started.emit("")
        self.runner.cancel()

    def _show(self, event: Event) -> None:
        if isinstance(event, Retrieved):
            self._known.pop(self._query, None)
            self._known[self._query] = event
            while len(self._known) > _KEPT:
                del self._known[next(iter(self._known))]
            self.retrieved.emit(event)

    def _look_up(self) -> None:
        query = self._wanted
        if query.keyword != self._query.keyword:
            self.started.emit(query.keyword)
        self._query = query
        if query in self._known:  # a run may keep the worker from saying so for long
            self.retrieved.emit(self._known[query])
        if query.keyword:
            self.runner.start(lambda: self._session.prepare(*astuple(query)))
        else:
            self.runner.cancel()

    def _end(self, whole: bool) -> None:
        if whole:
            self._ready = self._query
            self.settled.emit()
        if self._session.trouble and not self._troubled:
            self._troubled = True
            self.remarked.emit(self._session.trouble)
