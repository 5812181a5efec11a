"""The runs of a grid of results: started by hand, or in live mode by every change of the page."""

from collections.abc import Generator
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal

from iconstudio.algorithms.iconification.matching import LARGER_SCALES, SCALES
from iconstudio.gui.jobs.live import LiveRunner
from iconstudio.gui.jobs.preparation import Preparation
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.pictures.picture import Picture, pictured
from iconstudio.gui.preferences import prefer, preferred
from iconstudio.model import Remix
from iconstudio.workflows.criteria import CriteriaPage
from iconstudio.workflows.events import Event, StyleSkipped
from iconstudio.workflows.grid import GridSettings
from iconstudio.workflows.remixing import FINE as FINE_SIDE

if TYPE_CHECKING:
    from iconstudio.gui.workspaces.remixing import RemixWorkspace

LIVE, FINE, LARGER = "live", "fine", "larger_scales"
"""Under which it is remembered whether live mode is on, fine quality, and larger scales."""

Place = tuple[str, float]
"""Style and lambda_S of a result."""


@dataclass(frozen=True, slots=True)
class _Request:
    """What is to run; equal to another one if it gives the same results."""

    inputs: object
    fine: bool
    larger: bool
    page: CriteriaPage = field(compare=False)
    settings: GridSettings = field(compare=False)
    afresh: bool = field(compare=False)
    """Whether nothing that is there is of the same object."""
    focus: Place | None = field(compare=False)
    """Of the result that the user looks at."""


class GridRunner(QObject):
    """Remixes what a page says, one run at a time.

    In live mode every change of what is wanted starts a run by itself, once the page is complete
    and its icons are ready; a page that is not says nothing about it. While the hand moves, a run
    gives way to the next one as soon as it has shown the result that the user looks at.

    Signals
    -------
    began(GridSettings, bool)
        A run starts; whether it is of something else than the one before.
    event(object)
        What it has come to: events, results as Pictures.
    ended(bool, bool)
        It is over, and no other one has taken its place: whether it came to its end, and whether
        the user himself had asked for it.
    """

    began = Signal(object, bool)
    event = Signal(object)
    ended = Signal(bool, bool)

    def __init__(
        self, page: "RemixWorkspace", preparation: Preparation, worker: Worker, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._page = page
        self._preparation = preparation
        self.live_runner = LiveRunner(worker, self._made, self)
        """Its ``progress`` and ``failed`` may be listened to."""
        self.live = preferred(LIVE, True)
        """Whether results follow by themselves."""
        self.fine = preferred(FINE, False)
        """Whether results are joined on a finer canvas."""
        self.larger = preferred(LARGER, False)
        """Whether icons are tried at larger scales, too."""
        self._ran: _Request | None = None
        self._cut_short = False
        """Whether the last run was, as the page became something that cannot run."""
        self._focus: Place | None = None
        self._by_hand = False
        self.live_runner.began.connect(self._begin)
        self.live_runner.event.connect(self._show)
        self.live_runner.ended.connect(self._end)
        preparation.settled.connect(self.renew)

    @property
    def running(self) -> bool:
        """Whether something runs."""
        return self.live_runner.running

    @property
    def ran(self) -> Any:
        """What the results are of."""
        return None if self._ran is None else self._ran.inputs

    @property
    def stale(self) -> bool:
        """Whether the results are of something else than what is wanted."""
        if self._ran is None:
            return self._cut_short
        wanted = self._page.inputs(), self.fine, self.larger
        return (self._ran.inputs, self._ran.fine, self._ran.larger) != wanted

    @property
    def scales(self) -> tuple[float, ...]:
        """The scales at which icons are tried."""
        return LARGER_SCALES if self.larger else SCALES

    def set_live(self, on: bool) -> None:
        """Let results follow by themselves, or not; remember which."""
        self.live = on
        prefer(LIVE, on)
        self.live_runner.discard()
        self.renew()

    def set_fine(self, on: bool) -> None:
        """Join results on a finer canvas, or not; remember which."""
        self.fine = on
        prefer(FINE, on)
        self.renew()

    def set_larger(self, on: bool) -> None:
        """Try icons at larger scales, too, or not; remember which."""
        self.larger = on
        prefer(LARGER, on)
        self.renew()

    def adopt(self) -> bool:
        """Return whether what the page says is under way; if so, the user has asked for it."""
        here = self.running and not self.stale
        self._by_hand = self._by_hand or here
        return here

    def run(self, following: bool = False) -> None:
        """Remix what the page says, which has no problem, because the user asks for it.

        ``following``: as in live mode, also if that is off, the result in focus first.
        """
        self._preparation.hurry()
        self.live_runner.run(self._request(following))
        self._by_hand = True

    def renew(self) -> None:
        """Show what the page says now if its results are known; in live mode, else remix it.

        Unless that is done or cannot be done yet.
        """
        problem = self._page.problem()
        if self.ran is not None and not self.stale:
            self.live_runner.discard()
        elif not problem and self.live_runner.recall(self._request()):
            pass  # they are in sight
        elif not self.live:
            return
        elif self._preparation.ready and not problem:
            self.live_runner.request(self._request())
        elif self.running:  # out of date, though nothing can take its place
            self._ran, self._cut_short = None, True
            self.live_runner.cancel()
        else:
            self.live_runner.discard()

    def leave(self) -> bool:
        """Stop, and forget what ran before, if the page is of something else by now.

        Returns
        -------
        Whether it is.
        """
        page, before = self._page.document.page, self._ran
        blank = page == type(page)()
        if before is None and not self._cut_short:
            return False
        if not blank and (before is None or not page.elsewhere(before.page)):
            return False
        self.cancel()
        self._ran, self._cut_short = None, False
        return True

    def cancel(self) -> None:
        """Stop; in live mode, until the next change."""
        self.live_runner.cancel()

    def _request(self, following: bool = False) -> _Request:
        live = self.live or following
        page, settings, before = self._page.document.page, self._page.settings(), self._ran
        afresh = not live or before is None or page.elsewhere(before.page)
        focus = self._page.focus() if live and not afresh else None
        if focus is not None and focus[0] not in settings.styles:
            focus = None
        settings = replace(settings, scales=self.scales)
        if self.fine:
            settings = replace(settings, side=FINE_SIDE)
        if live:
            settings = replace(settings, focus=focus or _middle(settings), previews=True)
        inputs = self._page.inputs()
        return _Request(inputs, self.fine, self.larger, page, settings, afresh, focus)

    def _made(self, request: _Request) -> Generator[Event | Picture]:
        title = request.page.criteria.keyword.strip()
        return pictured(self._page.events(request.inputs, request.settings), title)

    def _begin(self, request: _Request) -> None:
        self._ran, self._focus, self._by_hand = request, request.focus, False
        self._cut_short = False
        self.began.emit(request.settings, request.afresh)

    def _show(self, event: object) -> None:
        self.event.emit(event)
        match event:
            case StyleSkipped(style) if self._focus and style == self._focus[0]:
                self._focus = None
            case Picture(icon) if self._focus in (None, _place(icon)):
                self.live_runner.release()

    def _end(self, whole: bool) -> None:
        if not self.running:
            self.ended.emit(whole, self._by_hand)


def _middle(settings: GridSettings) -> Place:
    """Return style and lambda_S in the middle of the grid."""
    styles, lambdas = settings.styles, settings.lambdas
    return styles[len(styles) // 2], lambdas[len(lambdas) // 2]


def _place(icon: Remix) -> Place:
    return icon.composite.style, icon.composite.lambda_s
