"""What modelling and editing share: name the object, remix, look at a grid of results."""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QHBoxLayout, QSplitter, QWidget

from iconstudio.gui.canvas.view import CanvasView
from iconstudio.gui.document.document import Document
from iconstudio.gui.exchange.saving import Saver
from iconstudio.gui.gallery.browser import ResultsBrowser
from iconstudio.gui.gallery.pictures import Picture
from iconstudio.gui.gallery.sending import Destination
from iconstudio.gui.jobs.preparation import Preparation, Query
from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.panels.canvas import CanvasPanel
from iconstudio.gui.panels.keyword import KeywordPanel
from iconstudio.gui.panels.symmetry import SymmetryButton, SymmetryHint
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.window.preferences import preferred
from iconstudio.gui.workspaces.base import Workspace
from iconstudio.gui.workspaces.runs import FINE, LIVE, LiveSource, Runs
from iconstudio.gui.workspaces.symmetry import SymmetryDetection
from iconstudio.session import Session
from iconstudio.workflows import criteria as edits
from iconstudio.workflows.criteria import CriteriaPage
from iconstudio.workflows.events import Event
from iconstudio.workflows.grid import ModelSettings
from iconstudio.workflows.workflow import Workflow


class RemixWorkspace(Workspace, LiveSource):
    """Canvas and keyword on the left, results and details on the right.

    A subclass makes a ``view`` and its actions, calls ``lay_out`` and ``wire``, and says what its
    page wants (see ``Wanting``). ``make_actions`` needs only what it has beside ``remix_slots``.
    """

    view: CanvasView

    def __init__(
        self,
        workflow: Workflow,
        session: Session,
        files: Worker,
        saver: Saver,
        document: Document[CriteriaPage],
    ) -> None:
        super().__init__(workflow, session, files, saver, document)
        self.preparation = Preparation(session, self.worker, self)
        self.runs = Runs(self, self.preparation, self.worker, self)
        self._opening = Runner(self.worker, self)
        self.keyword_panel = KeywordPanel()
        self.browser = ResultsBrowser()
        self.displays = (self.browser,)
        self.symmetry = SymmetryButton()

    # -- what the window asks for --------------------------------------------------------------

    @property
    def picture(self) -> Picture | None:
        """The picked result."""
        return self.browser.detail.picture

    def enter(self) -> None:
        """Begin on the canvas, and in the modes that were switched to elsewhere."""
        self._show_modes()
        self.view.setFocus()

    def run(self) -> None:
        """Remix what lies on the canvas; an outline that is still open is closed first."""
        if self.runs.adopt():
            return
        self.remarked.emit("")
        self.complete()
        if problem := self.problem():
            self.hinted.emit(problem)
            self.help_out()
        else:
            self.runs.run()

    def set_destinations(self, destinations: tuple[Destination, ...]) -> None:
        """Say where results can be sent to."""
        self.browser.set_destinations(destinations)

    def cancel(self) -> None:
        """Stop the run and the search; results that are finished stay."""
        self.preparation.cancel()
        self.runs.cancel()

    # -- what a subclass says ------------------------------------------------------------------

    def focus(self) -> tuple[str, float] | None:
        """Return style and lambda_S of the picked result."""
        return self.browser.results.focus

    def show_page(self) -> None:
        """Show what the page says."""
        raise NotImplementedError

    def complete(self) -> None:
        """Finish what the user is still drawing."""

    def finished(self) -> bool:
        """Whether the user has given all that is needed; if it is no good, he should know."""
        return bool(self.document.page.criteria.keyword.strip())

    def help_out(self) -> None:
        """Put the focus where what is missing can be given."""
        if not self.document.page.criteria.keyword.strip():
            self.keyword_panel.field.setFocus()

    # -- for subclasses ------------------------------------------------------------------------

    def remix_slots(self) -> dict[str, Callable[..., object]]:
        """Return what the actions do that modelling and editing share."""
        return {
            "run": self.run,
            "live": self._set_live,
            "fine": self._set_fine,
            **self.view_slots(self.view),
        }

    def lay_out(
        self, groups: Sequence[Sequence[QAction | QWidget]], trailing: Sequence[QWidget] = ()
    ) -> None:
        """Put everything in its place; ``groups`` and ``trailing`` make the tool bar."""
        self.canvas_panel = CanvasPanel(self.view, groups, trailing)
        left = QSplitter(Qt.Orientation.Vertical)
        left.addWidget(self.canvas_panel)
        left.addWidget(self.keyword_panel)
        left.setSizes([440, 190])
        both = QSplitter(Qt.Orientation.Horizontal)
        both.addWidget(left)
        both.addWidget(self.browser)
        both.setSizes([460, 800])
        for splitter, shares in ((left, (3, 1)), (both, (1, 2))):
            splitter.setHandleWidth(UNIT)
            splitter.setChildrenCollapsible(False)
            for part, share in enumerate(shares):
                splitter.setStretchFactor(part, share)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(both)

    def offer_symmetry(
        self,
        outline: Callable[[CriteriaPage], object],
        filled: Callable[[object], NDArray[np.bool_]],
    ) -> None:
        """Offer on the canvas to hold to a symmetry: see ``SymmetryProposal``."""
        self.symmetry_hint = SymmetryHint(self.view)
        self.symmetry_hint.accepted.connect(self.hold_to)
        self.symmetry_detection = SymmetryDetection(self.document, outline, filled, self)
        self.symmetry_detection.found.connect(self.symmetry_hint.offer)

    def wire(self) -> None:
        """Connect the panels with the page and with the work, and open the collection."""
        document, panel, browser = self.document, self.keyword_panel, self.browser
        panel.edited.connect(lambda text: edits.set_keyword(document, text))
        panel.run.connect(self.run)
        panel.toggled.connect(lambda icon: edits.toggle_icon(document, icon))
        panel.restored.connect(lambda: edits.exclude_icons(document, frozenset()))
        self.symmetry.chosen.connect(self.hold_to)
        preparation = self.preparation
        preparation.started.connect(panel.set_searching)
        preparation.retrieved.connect(panel.show_exemplars)
        preparation.failed.connect(panel.show_error)
        preparation.remarked.connect(self.failed)
        for runner in (preparation.runner, self._opening):
            runner.progress.connect(self.progressed)
            runner.ended.connect(self._rest)
        self._opening.failed.connect(self.failed)
        runs = self.runs
        document.page_changed.connect(self._renew)
        runs.began.connect(self._begin_run)
        runs.event.connect(self.show_event)
        runs.runner.progress.connect(self.progressed)
        runs.runner.failed.connect(self.failed)
        runs.ended.connect(self._end_run)
        self.connect_browser(browser)
        self._show_modes()
        self._rest()
        self._opening.start(self.session.get_ready)

    def show_event(self, event: Event | Picture) -> None:
        """Show what a run has come to."""
        self.browser.show_event(event)

    def show_criteria(self, name: str) -> None:
        """Show the criteria of the page; results of another ``name`` of work are called so."""
        criteria = self.document.page.criteria
        self.keyword_panel.set_sketch(criteria.keyword, criteria.exclude)
        self.preparation.request(Query.of(criteria.keyword, criteria.exclude))
        self.symmetry.set_axis(criteria.symmetry)
        note = ""
        if self.runs.live:
            note = self.problem() if self.finished() else ""
        elif self.runs.stale:
            note = f"of an earlier {name} – press Remix to renew"
        self.browser.results.note.setText(note)

    def hold_to(self, axis: object) -> None:
        """Hold the results to a symmetry, or to none."""
        if axis != self.document.page.criteria.symmetry:
            edits.set_symmetry(self.document, axis)

    def _set_live(self, on: bool) -> None:
        self.runs.set_live(on)
        self.show_page()
        self._rest()

    def _set_fine(self, on: bool) -> None:
        self.runs.set_fine(on)
        self.show_page()

    def _show_modes(self) -> None:
        self.actions_by_name["live"].setChecked(preferred(LIVE, True))
        self.actions_by_name["fine"].setChecked(preferred(FINE, False))

    def _renew(self) -> None:
        """Follow a change of the page; results of something else have nothing to do here."""
        if self.runs.leave():
            self.browser.clear()
        self.runs.renew()
        runs = self.runs
        self.browser.results.set_stale(runs.live and runs.stale and not runs.running)
        self._rest()

    def _begin_run(self, settings: ModelSettings, afresh: bool) -> None:
        self.browser.begin(settings, afresh)
        self.browser.results.set_stale(False)
        if self.runs.live:
            self.idle.emit("Live")  # no progress to be seen yet
        self._allow_cancel(True)
        self.show_page()

    def _end_run(self, whole: bool, by_hand: bool) -> None:
        self.browser.end(whole, by_hand)
        self._rest()

    def _rest(self) -> None:
        busy = self.runs.running, self.preparation.runner.running, self._opening.running
        if not any(busy):
            count = 0 if self.runs.stale else self.browser.results.finished
            parts = "Live" if self.runs.live else "", f"{count} icons" if count else ""
            self.idle.emit(" · ".join(part for part in parts if part))
