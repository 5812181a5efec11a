"""The runs of a workspace: started by hand, or in live mode by every change of the page."""

from collections.abc import Generator
from dataclasses import replace

from PySide6.QtCore import QObject, QTimer, Signal

from iconstudio.gui.gallery.pictures import Picture, pictured
from iconstudio.gui.jobs.coalescing import Coalescing
from iconstudio.gui.jobs.preparation import Preparation
from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.window.preferences import prefer, preferred
from iconstudio.model import Remix
from iconstudio.workflows.criteria import CriteriaDocument, CriteriaPage
from iconstudio.workflows.events import Event, Progress, StyleSkipped
from iconstudio.workflows.grid import ModelSettings
from iconstudio.workflows.workflow import FINE as FINE_SIDE

LIVE, FINE = "live", "fine"
"""Under which it is remembered whether live mode is on, and fine quality."""

PATIENCE = 700
"""Milliseconds that a run which is out of date may take until it shows something."""

CALM = 800
"""Milliseconds that a run of live mode may take before its progress is shown: those that the next
movement of the hand puts an end to are shorter."""


class LiveSource:
    """A workspace, as far as it says what its page wants."""

    document: CriteriaDocument

    def inputs(self) -> object:
        """Return what the results depend on, to be compared."""
        raise NotImplementedError

    def problem(self) -> str:
        """Return what is missing before the page can be remixed, as a sentence; else nothing."""
        raise NotImplementedError

    def settings(self) -> ModelSettings:
        """Return which results to make. Called only if there is no problem."""
        raise NotImplementedError

    def focus(self) -> tuple[str, float] | None:
        """Return style and lambda_S of the result that the user looks at."""
        raise NotImplementedError

    def events(self, inputs: object, settings: ModelSettings) -> Generator[Event]:
        """Return the run that makes the results. Called in the worker's thread."""
        raise NotImplementedError


class Runs(QObject):
    """Remixes what a page says, one run at a time.

    In live mode every change of what is wanted starts a run by itself, once the page is complete
    and its icons are ready; a page that is not says nothing about it. While the hand moves, a run
    gives way to the next one as soon as it has shown something: see ``Newest``.

    Signals
    -------
    began(ModelSettings, bool)
        A run starts; whether it is of something else than the one before.
    event(object)
        What it has come to: events, results as Pictures.
    progressed(Progress)
        It takes so long that the user should know.
    failed(str)
        A sentence for the user.
    ended(bool, bool)
        It is over, and no other one has taken its place: whether it came to its end, and whether
        the user himself had asked for it.
    """

    began = Signal(object, bool)
    event = Signal(object)
    progressed = Signal(object)
    failed = Signal(str)
    ended = Signal(bool, bool)

    def __init__(
        self, page: LiveSource, preparation: Preparation, worker: Worker, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._page = page
        self._preparation = preparation
        self.runner = Runner(worker, self)
        self.coalescing = Coalescing(self.runner, self._follow, PATIENCE)
        self.live = preferred(LIVE, True)
        """Whether results follow by themselves."""
        self.fine = preferred(FINE, False)
        """Whether results are joined on a finer canvas."""
        self.ran: object = None
        """What the results are of."""
        self._ran_page: CriteriaPage | None = None
        self._ran_fine = self.fine
        self._focus: tuple[str, float] | None = None
        self._by_hand = False
        self._calm = QTimer(self, singleShot=True, interval=CALM)
        self.runner.event.connect(self._show)
        self.runner.progress.connect(self._tell)
        self.runner.failed.connect(self._fail)
        self.runner.ended.connect(self._end)
        preparation.settled.connect(self.renew)

    @property
    def running(self) -> bool:
        """Whether something runs."""
        return self.runner.running

    @property
    def stale(self) -> bool:
        """Whether the results are of something else than what is wanted."""
        same = self.ran == self._page.inputs() and self._ran_fine == self.fine
        return self.ran is not None and not same

    def set_live(self, on: bool) -> None:
        """Let results follow by themselves, or not; remember which."""
        self.live = on
        prefer(LIVE, on)
        self.coalescing.discard()
        self.renew()

    def set_fine(self, on: bool) -> None:
        """Join results on a finer canvas, or not; remember which."""
        self.fine = on
        prefer(FINE, on)
        self.renew()

    def adopt(self) -> bool:
        """Return whether what the page says is under way; if so, the user has asked for it."""
        here = self.running and not self.stale
        self._by_hand = self._by_hand or here
        return here

    def run(self) -> None:
        """Remix what the page says, which has no problem, because the user asks for it."""
        self.coalescing.discard()
        self._calm.stop()
        self._preparation.hurry()
        self._begin(by_hand=True)

    def renew(self) -> None:
        """In live mode, remix what the page says now, unless that is done or cannot be done yet."""
        if not self.live:
            return
        if self.ran is not None and not self.stale:
            self.coalescing.discard()
        elif self._preparation.ready and not self._page.problem():
            self.coalescing.request()
        else:
            self._drop()

    def leave(self) -> bool:
        """Stop, and forget what ran before, if the page is of something else by now.

        Returns
        -------
        Whether it is.
        """
        page, before = self._page.document.page, self._ran_page
        blank = page == type(page)()
        if before is None or not (blank or page.elsewhere(before)):
            return False
        self.cancel()
        self.ran = self._ran_page = None
        return True

    def cancel(self) -> None:
        """Stop; in live mode, until the next change."""
        self.coalescing.discard()
        self.runner.cancel()

    def _follow(self) -> None:
        self._calm.start()
        self._begin(by_hand=False)

    def _begin(self, by_hand: bool) -> None:
        page, sheet, before = self._page, self._page.document.page, self._ran_page
        inputs, settings, title = page.inputs(), page.settings(), sheet.criteria.keyword.strip()
        afresh = not self.live or before is None or sheet.elsewhere(before)
        focus = page.focus() if self.live and not afresh else None
        self._focus = focus if focus and focus[0] in settings.styles else None
        if self.fine:
            settings = replace(settings, side=FINE_SIDE)
        if self.live:
            settings = replace(settings, focus=self._focus or _middle(settings), previews=True)
        self.ran, self._ran_page, self._by_hand = inputs, sheet, by_hand
        self._ran_fine = self.fine
        self.runner.start(lambda: pictured(page.events(inputs, settings), title))
        self.began.emit(settings, afresh)

    def _drop(self) -> None:
        """Stop a run that is out of date, though nothing can take its place."""
        self.coalescing.discard()
        if self.running:
            self.ran = None
            self.runner.cancel()

    def _show(self, event: object) -> None:
        self.event.emit(event)
        match event:
            case StyleSkipped(style) if self._focus and style == self._focus[0]:
                self._focus = None
            case Picture(icon) if self._focus in (None, _place(icon)):
                self.coalescing.release()

    def _fail(self, message: str) -> None:
        if not self.coalescing.pending:
            self.failed.emit(message)

    def _tell(self, progress: Progress) -> None:
        if not self._calm.isActive():
            self.progressed.emit(progress)

    def _end(self, whole: bool) -> None:
        if not self.running:
            self._calm.stop()
            self.ended.emit(whole, self._by_hand)


def _middle(settings: ModelSettings) -> tuple[str, float]:
    """Return style and lambda_S in the middle of the grid."""
    styles, lambdas = settings.styles, settings.lambdas
    return styles[len(styles) // 2], lambdas[len(lambdas) // 2]


def _place(icon: Remix) -> tuple[str, float]:
    return icon.composite.style, icon.composite.lambda_s
