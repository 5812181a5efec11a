"""Any workflow in the window: choose icons on the left, look at what is made of them on the right.

The results follow every change of the work.
"""

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QSplitter, QVBoxLayout

from iconstudio.gui.document.document import Document
from iconstudio.gui.exchange.saving import Saver
from iconstudio.gui.gallery.detail import DetailPanel
from iconstudio.gui.gallery.pictures import Picture, pictured
from iconstudio.gui.gallery.sending import Destination
from iconstudio.gui.gallery.sheet import Sheet
from iconstudio.gui.gallery.sheet_delegate import framed
from iconstudio.gui.gallery.sheet_model import results_with
from iconstudio.gui.jobs.live import LiveRunner
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.panels.chooser import IconChooser
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.window.actions import Entry, work_entries
from iconstudio.gui.workspaces.base import Workspace
from iconstudio.gui.workspaces.plain.opening import WorkOpener, WorkPage
from iconstudio.model import Exemplar
from iconstudio.session import Session
from iconstudio.workflows.files import write_file
from iconstudio.workflows.workflow import Workflow

_SIDE = 112
"""Side of a result on the sheet, in device-independent pixels."""


class PlainWorkspace(Workspace):
    """Icons are chosen, and a workflow runs over them as it declares."""

    def __init__(self, workflow: Workflow, session: Session, files: Worker, saver: Saver) -> None:
        super().__init__(workflow, session, files, saver, Document(WorkPage(workflow.work())))
        self.finder = Worker(self)
        """Looks icons up also while a run goes on."""
        self.opener = WorkOpener(workflow, session, self.document, self.finder, self)
        self.chooser = IconChooser(session, self.finder)
        self.runner = LiveRunner(
            self.worker, lambda work: pictured(session.run(workflow, work)), self
        )
        self.results = Sheet(
            framed(_SIDE),
            results_with("Click to see it large"),
            workflow.title,
            hint="The icons appear here",
            draggable=True,
            removable=True,
        )
        self.detail = DetailPanel()
        self.displays = (self.detail.large,)
        self._make_actions()
        self._lay_out()
        self._wire()

    def _make_actions(self) -> None:
        run = Entry("run", f"&{self.workflow.title}", "Make the icons anew", "Ctrl+Return")
        self.make_actions(
            {
                "new": lambda: self.document.change("start afresh", self._new_page()),
                "save": self._save,
                "run": self.run,
                **self.opener_slots(self.opener),
            },
            {"&File": work_entries(self.workflow.noun), "&Edit": (run,)},
        )
        if self.workflow.examples is not None:
            self.add_examples(self.workflow.examples, self.opener.open_work)

    def _lay_out(self) -> None:
        left, right = (QFrame() for _ in range(2))
        for frame, title, widget in (
            (left, "Icons", self.chooser),
            (right, self.workflow.title, self.results),
        ):
            frame.setProperty("card", True)
            heading = QLabel(title)
            heading.setProperty("title", True)
            column = QVBoxLayout(frame)
            column.addWidget(heading)
            column.addWidget(widget, 1)
        results = QSplitter(Qt.Orientation.Vertical)
        for widget in (right, self.detail):
            results.addWidget(widget)
        results.setHandleWidth(UNIT)
        results.setStretchFactor(0, 1)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(UNIT)
        left.setFixedWidth(44 * UNIT)
        row.addWidget(left)
        row.addWidget(results, 1)

    def _wire(self) -> None:
        self.connect_opener(self.opener)
        self.connect_detail(self.detail)
        self.document.page_changed.connect(self._follow)
        self.runner.began.connect(self._clear)
        self.chooser.chosen.connect(self._take_exemplar)
        self.results.chosen.connect(self._look_at)
        self.detail.sent.connect(lambda title: self.send_picture(self.picture, title))
        for runner in (self.runner, self.opener.runner):
            runner.progress.connect(self.progressed)
            runner.ended.connect(self._rest)
        self.runner.event.connect(self._show)
        self.runner.failed.connect(self.failed)

    @property
    def picture(self) -> Picture | None:
        """The picked result."""
        return self.detail.picture

    def enter(self) -> None:
        """Begin with looking icons up."""
        self.chooser.setFocus()

    def take(self, pictogram) -> None:
        """Add an icon that was sent here."""
        self.opener.take(pictogram)

    def set_destinations(self, destinations: tuple[Destination, ...]) -> None:
        """Say where icons can be sent to."""
        self.detail.set_destinations(
            [one for one in destinations if one.title != self.workflow.title]
        )

    def run(self) -> None:
        """Make the icons of what is there anew; nothing of an empty page."""
        self._make(self.runner.run)

    def cancel(self) -> None:
        """Stop; results that are finished stay."""
        self.runner.cancel()
        self.opener.runner.cancel()

    def _follow(self) -> None:
        self._make(self.runner.request)

    def _make(self, make: Callable[[Any], None]) -> None:
        page = self.document.page
        if page == self._new_page():
            self.runner.cancel()
            self._clear()
        else:
            make(page.work)

    def _clear(self) -> None:
        self.results.show_entries(())
        self.detail.show_picture(None)
        self.picked.emit(None)

    def _new_page(self) -> WorkPage:
        return WorkPage(self.workflow.work())

    def _take_exemplar(self, icon: Exemplar) -> None:
        self.opener.add_icons([icon])

    def _show(self, event: object) -> None:
        if isinstance(event, Picture):
            kept = [one for one in self.results.pictures if not one.preview]
            self.results.show_entries([*kept, event])
            self.counted.emit(len(self.results.pictures))
            self.runner.release()
            if self.picture is None:
                self._look_at(event, kept=False)

    def _look_at(self, picture: Picture, kept: bool = True) -> None:
        self.detail.show_picture(picture)
        self.picked.emit(picture)
        if kept:
            self.kept.emit(picture)

    def _rest(self) -> None:
        if not (self.runner.running or self.opener.runner.running):
            count = len(self.results.pictures)
            self.idle.emit("1 icon" if count == 1 else f"{count} icons" if count else "")

    def _save(self) -> None:
        workflow, work = self.workflow, self.document.page.work
        self.saver.save_work(
            workflow.noun, workflow.noun, lambda path: write_file(path, workflow, work)
        )
