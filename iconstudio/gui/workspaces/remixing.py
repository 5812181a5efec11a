"""What modelling and editing share: name the object, remix, look at a grid of results."""

from collections.abc import Callable, Generator, Sequence
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from iconstudio.grammar import counted
from iconstudio.gui.document.document import Document
from iconstudio.gui.gallery.browser import ResultsBrowser
from iconstudio.gui.jobs.preparation import Preparation, Query
from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.panels.keyword import KeywordPanel
from iconstudio.gui.panels.symmetry import SymmetryButton, SymmetryHint
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.preferences import preferred
from iconstudio.gui.theme.layout import row, splitter
from iconstudio.gui.workspaces.actions import CANVAS, Entry
from iconstudio.gui.workspaces.base import Workspace
from iconstudio.gui.workspaces.grid_runner import FINE, LARGER, LIVE, GridRunner, Place
from iconstudio.gui.workspaces.inner_pictures import INNER_PICTURES
from iconstudio.gui.workspaces.symmetry import SymmetryDetection
from iconstudio.workflows import criteria as edits
from iconstudio.workflows.criteria import CriteriaPage
from iconstudio.workflows.events import Event, Remark
from iconstudio.workflows.grid import GridSettings


def _set_scales(place: "RemixWorkspace", on: bool) -> None:
    """Try larger scales, too, or not."""
    place.runner.set_larger(on)
    place.actions_by_name.refresh()
    place.show_page()


def _set_fine(place: "RemixWorkspace", on: bool) -> None:
    """Join results on a finer canvas, or not."""
    place.runner.set_fine(on)
    place.actions_by_name.refresh()
    place.show_page()


GRID = (
    Entry("live", "Li&ve", "Live: results follow while you draw", "Ctrl+L", "live",
          do="set_live", checked=lambda place: place.runner.live),
    Entry("fine", "F&ine quality", "Fine: smoother joins, five times as slow",
          do=_set_fine, checked=lambda place: place.runner.fine),
    INNER_PICTURES,
    Entry("scales", "Lar&ger scales",
          "Also try icons at 0.8 and 1.25 of their size: fits unusual proportions, but takes "
          "longer, and results may be less plausible",
          do=_set_scales, checked=lambda place: place.runner.larger),
    *CANVAS,
)  # fmt: skip
"""What every workspace with a grid of results does."""


class RemixWorkspace(Workspace):
    """Canvas and keyword on the left, results and details on the right.

    A subclass makes in ``build`` a ``view``, an ``opener`` and its actions, calls ``lay_out``, and
    says what its page wants.
    """

    document: Document[CriteriaPage]
    placeholder: ClassVar[str]
    """What to type as the name of the object."""
    tip: ClassVar[str]
    """What the button beside it does."""
    welcome: ClassVar[str]
    """What will appear in the grid."""
    nearer: ClassVar[str]
    """What the results on its left are."""

    def build(self) -> None:
        """Make what is not a subclass's own."""
        self.preparation = Preparation(self.session, self.worker, self)
        self.runner = GridRunner(self, self.preparation, self.worker, self)
        self._opening = Runner(self.worker, self)
        self.keyword_panel = KeywordPanel(self.document, self.placeholder, self.tip)
        self.browser = ResultsBrowser(self.welcome, self.nearer)
        self.detail = self.browser.detail
        self.symmetry = SymmetryButton()

    # -- what the window asks for --------------------------------------------------------------

    def enter(self) -> None:
        """Begin on the canvas, and in the modes that were switched to elsewhere."""
        if self.runner.live != preferred(LIVE, True):
            self.set_live(not self.runner.live)
        if self.runner.fine != preferred(FINE, False):
            _set_fine(self, not self.runner.fine)
        if self.runner.larger != preferred(LARGER, False):
            _set_scales(self, not self.runner.larger)
        self.view.setFocus()

    def run(self) -> None:
        """Remix what lies on the canvas; an outline that is still open is closed first."""
        if self.runner.adopt():
            return
        self.remarked.emit("")
        self.complete()
        if problem := self.problem():
            self.hinted.emit(problem)
            self.help_out()
        else:
            self.runner.run()
            if doubt := self.doubts():
                self.hinted.emit(doubt)

    def cancel(self) -> None:
        """Stop the run and the search, and what is being opened; finished results stay."""
        self.preparation.cancel()
        self.runner.cancel()
        super().cancel()

    # -- what a subclass says ------------------------------------------------------------------

    def inputs(self) -> object:
        """Return what the results depend on, to be compared."""
        raise NotImplementedError

    def problem(self) -> str:
        """Return what is missing before the page can be remixed, as a sentence; else nothing."""
        raise NotImplementedError

    def doubts(self) -> str:
        """Return what the user should know of how the page is read, as a sentence, or nothing."""
        raise NotImplementedError

    def settings(self) -> GridSettings:
        """Return which results to make: all. Called only if there is no problem."""
        return GridSettings()

    def focus(self) -> Place | None:
        """Return style and lambda_S of the picked result."""
        return self.browser.results.focus

    def events(self, inputs: Any, settings: GridSettings) -> Generator[Event]:
        """Return the run of the work that ``inputs`` is; called in the worker's thread."""
        return self.session.run(self.workflow, inputs, settings)

    def complete(self) -> None:
        """Finish what the user is still drawing."""

    def finished(self) -> bool:
        """Whether the user has given all that is needed; if it is no good, he should know."""
        return bool(self.page.criteria.keyword.strip())

    def help_out(self) -> None:
        """Put the focus where what is missing can be given."""
        if not self.page.criteria.keyword.strip():
            self.keyword_panel.field.setFocus()

    # -- for subclasses ------------------------------------------------------------------------

    def lay_out(self, *groups: str, trailing: Sequence[QWidget] = ()) -> None:
        """Put all in its place, and begin; ``groups`` name the actions of the tool bar."""
        live = self.symmetry, self.actions_by_name["live"]
        self.canvas_panel = self.canvas_panel_of(*groups, more=live, trailing=trailing)
        upright, across = Qt.Orientation.Vertical, Qt.Orientation.Horizontal
        left = splitter(upright, (self.canvas_panel, 440, 3), (self.keyword_panel, 190, 1))
        row(splitter(across, (left, 460, 1), (self.browser, 800, 2)), of=self)
        self._wire()

    def offer_symmetry(
        self,
        outline: Callable[[CriteriaPage], object],
        filled: Callable[[object], NDArray[np.bool_]],
    ) -> None:
        """Offer on the canvas to hold to a symmetry: see ``SymmetryDetection``."""
        self.symmetry_hint = SymmetryHint(self.view)
        self.symmetry_hint.accepted.connect(self.hold_to)
        self.symmetry_detection = SymmetryDetection(self.document, outline, filled, self)
        self.symmetry_detection.found.connect(self.symmetry_hint.offer)

    def _wire(self) -> None:
        """Connect the panels with the page and with the work, and open the collection."""
        document, panel, browser = self.document, self.keyword_panel, self.browser
        panel.run.connect(self.run)
        self.symmetry.chosen.connect(self.hold_to)
        preparation, runner = self.preparation, self.runner
        preparation.started.connect(panel.set_searching)
        preparation.retrieved.connect(panel.show_retrieved)
        preparation.failed.connect(panel.show_error)
        preparation.remarked.connect(self.failed)
        self.follow(preparation.runner)
        self.follow(self._opening)
        self._opening.failed.connect(self.failed)
        document.page_changed.connect(self._renew)
        runner.began.connect(self._begin_run)
        runner.event.connect(self.show_event)
        runner.live_runner.progress.connect(self.progressed)
        runner.live_runner.failed.connect(self.failed)
        runner.ended.connect(self._end_run)
        browser.results.picked.connect(self.picked)
        browser.results.asked.connect(self.offer_for)
        browser.kept.connect(self.kept)
        browser.counted.connect(self.counted)
        self.rest()
        self.show_page()
        self._opening.start(self.session.get_ready)

    def show_event(self, event: Event | Picture) -> None:
        """Show what a run has come to."""
        self.browser.show_event(event)
        if isinstance(event, Remark) and event.sentence not in self.remarks:
            self.hinted.emit(event.sentence)

    def show_criteria(self, name: str) -> None:
        """Show the criteria of the page; results of another ``name`` of work are called so."""
        criteria = self.page.criteria
        self.keyword_panel.set_sketch(criteria.keyword, criteria.exclude, criteria.include)
        query = Query.of(criteria.keyword, criteria.exclude, self.runner.scales)
        self.preparation.request(query)
        self.symmetry.set_axis(criteria.symmetry)
        note = ""
        if self.runner.live:
            note = self.problem() if self.finished() else ""
        elif self.runner.stale:
            note = f"of an earlier {name} – press Remix to renew"
        self.browser.results.note.setText(note)

    def hold_to(self, axis: object) -> None:
        """Hold the results to a symmetry, or to none."""
        if axis != self.page.criteria.symmetry:
            edits.set_symmetry(self.document, axis)

    def set_live(self, on: bool) -> None:
        """Let results follow by themselves, or not."""
        self.runner.set_live(on)
        self.actions_by_name.refresh()
        self.show_page()
        self.rest()

    def rest(self) -> None:
        """Tell what came out, unless something is still under way."""
        if not self.runner.running:
            super().rest()

    def outcome(self) -> str:
        """Return whether results follow, and how many there are of the page as it is now."""
        count = 0 if self.runner.stale else self.browser.results.finished
        parts = "Live" if self.runner.live else "", counted(count, "icon") if count else ""
        return " · ".join(filter(None, parts))

    def _renew(self) -> None:
        """Follow a change of the page; results of something else have nothing to do here."""
        if self.runner.leave():
            self.browser.clear()
        self.runner.renew()
        runner = self.runner
        self.browser.results.set_stale(runner.stale and not runner.running)
        self.rest()

    def _begin_run(self, settings: GridSettings, afresh: bool) -> None:
        self.browser.begin(settings, afresh)
        self.browser.results.set_stale(False)
        if self.runner.live:
            self.idle.emit("Live")  # no progress to be seen yet
        self.note_busy(True)
        self.show_page()

    def _end_run(self, whole: bool, by_hand: bool) -> None:
        self.browser.end(whole, by_hand)
        self.rest()
