"""Draws the lines of the page again and again, and variations once the hand rests."""

from functools import partial

from PySide6.QtCore import QObject, QTimer, Signal

from iconstudio.gui.jobs.live import LiveRunner
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.workspaces.line_style.live import made, made_variations
from iconstudio.gui.workspaces.made import Made
from iconstudio.model import Restyling
from iconstudio.session import Session
from iconstudio.workflows.line_style.page import RestylePage
from iconstudio.workflows.line_style.restyling import variations

REST = 400
"""Milliseconds without a change after which variations are made."""


class Restyler(QObject):
    """What is wanted now comes first; its variations have a thread of their own.

    Signals
    -------
    restyled(Made)
        The lines are drawn, those of the page or as they are about to become.
    began_varying()
        Variations are made, in place of those before.
    varied(Made)
        One is drawn.
    previewed()
        Something else is to be in sight than the page's own.
    left()
        What was drawn is of something else.
    """

    restyled = Signal(object)
    began_varying = Signal()
    varied = Signal(object)
    previewed = Signal()
    left = Signal()

    def __init__(self, session: Session, worker: Worker, parent: QObject) -> None:
        super().__init__(parent)
        self.live = LiveRunner(worker, partial(made, session), self)
        self.varying = LiveRunner(Worker(parent), partial(made_variations, session), self)
        self.made: Made | None = None
        """What was drawn last."""
        self._work: Restyling | None = None
        self._coming: Restyling | None = None
        """What is to be in sight: the work of the page, or as it is about to become."""
        self._resting = QTimer(self, singleShot=True, interval=REST)
        self._resting.timeout.connect(self._vary)
        self.live.event.connect(self._tell)
        self.varying.event.connect(self._tell_varied)
        self.varying.began.connect(self.began_varying)

    def wants(self, made: Made) -> bool:
        """Whether a result is what is to be in sight, or one of its variations."""
        if made is self.made or self._coming is None:
            return made.work == self._coming
        return made.work in variations(self._coming)

    def request(self, page: RestylePage) -> None:
        """Draw what is on a page, unless that is done or under way."""
        self._work = self._coming = page.work if page.complete else None
        if self._work is None or (self.made and self.made.work.icon != page.work.icon):
            self._leave()
        if self._work is not None and self._work != self.live.ran:
            self.varying.cancel()
            self._resting.start()
            self.live.request(self._work)
            if self.made and self.made.work == self._work and self.varying.recall(self._work):
                self._resting.stop()

    def preview(self, work: Restyling) -> None:
        """Draw work that is not on the page yet, if it is complete."""
        if RestylePage(work).complete:
            self._coming = work
            self.previewed.emit()
            self.live.request(work)

    def run(self) -> None:
        """Draw all once more, because the user asks for it."""
        self.varying.cancel()
        self.live.run(self._work)
        self._resting.start()

    def _tell(self, event: object) -> None:
        if isinstance(event, Made):
            self.made = event
            self.restyled.emit(event)
            self.live.release()

    def _vary(self) -> None:
        if self._work is not None:
            self.varying.request(self._work)

    def _tell_varied(self, event: object) -> None:
        if isinstance(event, Made):
            self.varied.emit(event)
            self.varying.release()

    def _leave(self) -> None:
        self._resting.stop()
        self.live.cancel()
        self.varying.cancel()
        self.made = None
        self.left.emit()
