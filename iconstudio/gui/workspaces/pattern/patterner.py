"""Makes the pattern of the page again and again, and with other seeds once the hand rests."""

from functools import partial

from PySide6.QtCore import QObject, QTimer, Signal

from iconstudio.gui.jobs.live import LiveRunner
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.workspaces.made import Made
from iconstudio.gui.workspaces.pattern.live import made, made_with_other_seeds, sheet_of
from iconstudio.model import Patterning
from iconstudio.session import Session
from iconstudio.workflows.events import Remark
from iconstudio.workflows.pattern.page import PatternPage

REST = 300
"""Milliseconds for which a finished pattern stands before others are made."""
_PATIENCE = 3000
"""Milliseconds that a run may take until it shows something while the hand goes on."""
_KEPT = 48
"""Events that are kept, so that going back to a seed shows its pattern at once."""


class Patterner(QObject):
    """The pattern that is wanted comes first; those of other seeds have a thread of their own.

    Signals
    -------
    patterned(Made)
        The pattern is there, or a preview of it.
    sheet_began(Made)
        Patterns of other seeds are made, in place of those before; this one comes first.
    sheet_grew(Made)
        One of them is there.
    remarked(str)
        What the user should know of how the exemplar was read.
    left()
        There is no exemplar any more.
    """

    patterned = Signal(object)
    sheet_began = Signal(object)
    sheet_grew = Signal(object)
    remarked = Signal(str)
    left = Signal()

    def __init__(self, session: Session, worker: Worker, parent: QObject) -> None:
        super().__init__(parent)
        self.live = LiveRunner(worker, partial(made, session), self, _PATIENCE, _KEPT)
        make_others = partial(made_with_other_seeds, session)
        self.others = LiveRunner(Worker(parent), make_others, self, kept=_KEPT)
        self.made: Made | None = None
        """What was shown last."""
        self._work: Patterning | None = None
        self._sheet: tuple[Patterning, ...] = ()
        self._resting = QTimer(self, singleShot=True)
        self._resting.timeout.connect(self._begin_sheet)
        self.live.event.connect(self._tell)
        self.others.event.connect(self._tell_other)

    @property
    def stale(self) -> bool:
        """Whether what is shown is of something else than the page."""
        return self.made is not None and self.made.work != self._work

    def request(self, page: PatternPage) -> None:
        """Make the pattern of a page, unless that is done or under way."""
        work = None if page.empty else page.work
        if work == self._work:
            return
        self._work = work
        if work not in self._sheet:
            self._leave_sheet()
        if work is None:
            self.live.cancel()
            self.made = None
            self.left.emit()
        else:
            self.live.request(work)

    def run(self) -> None:
        """Make all once more, because the user asks for it."""
        if self._work is not None:
            self._leave_sheet()
            self.live.run(self._work)

    def _tell(self, event: object) -> None:
        if isinstance(event, Made):
            self._show(event)
            self.live.release()
        elif isinstance(event, Remark):
            self.remarked.emit(event.sentence)

    def _show(self, made: Made) -> None:
        self.made = made
        self.patterned.emit(made)
        if made.picture.preview or made.work != self._work or made.work in self._sheet:
            return
        if self.others.known(made.work):
            self._begin_sheet()
        else:
            self._resting.start(REST)

    def _begin_sheet(self) -> None:
        made = self.made
        if made is not None and made.work == self._work:
            self._sheet = sheet_of(made.work)
            self.sheet_began.emit(made)
            self.others.request(made.work)

    def _tell_other(self, event: object) -> None:
        if isinstance(event, Made):
            self.live.keep(event.work, [event])
            self.sheet_grew.emit(event)
            self.others.release()

    def _leave_sheet(self) -> None:
        """Make nothing more of what is on the sheet; what there is stays in sight."""
        self._resting.stop()
        self._sheet = ()
        self.others.cancel()
