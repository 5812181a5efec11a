"""Any workflow in the window: choose icons on the left, look at what is made of them on the right.

The results follow every change of the work.
"""

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from iconstudio.grammar import counted
from iconstudio.gui.exchange.opening import Opener
from iconstudio.gui.gallery.detail import DetailPanel
from iconstudio.gui.gallery.display import DisplaySwitch
from iconstudio.gui.gallery.sheet import Sheet
from iconstudio.gui.gallery.sheet_delegate import framed
from iconstudio.gui.gallery.sheet_model import results_with
from iconstudio.gui.jobs.live import LiveRunner
from iconstudio.gui.pictures.picture import Picture, pictured
from iconstudio.gui.theme.layout import card, hidden, label, push_button, row, splitter
from iconstudio.gui.workspaces.actions import Entry, work_entries
from iconstudio.gui.workspaces.base import Workspace
from iconstudio.gui.workspaces.plain.icons import WorkIcons
from iconstudio.importing.works import WorkImporter
from iconstudio.model import Pictogram
from iconstudio.workflows.plain import WorkPage

_SIDE = 112
"""Side of a result on the sheet, in device-independent pixels."""


class PlainWorkspace(Workspace):
    """Icons are chosen, and a workflow runs over them as it declares."""

    sends_to_itself = False

    def page_type(self) -> WorkPage:
        """Return the work to begin with."""
        return WorkPage(self.workflow.work())

    def build(self) -> None:
        """Make panels and runs."""
        workflow, session = self.workflow, self.session
        self.importer = WorkImporter(workflow, session, self.document)
        self.opener = Opener(self.importer, self.finder, self)
        self.work_icons = WorkIcons(session, self.finder) if workflow.with_icons else None
        self.runner = LiveRunner(
            self.worker, lambda work: pictured(session.run(workflow, work)), self
        )
        self.results = Sheet(
            framed(_SIDE, coded=True),
            results_with("Click to see it large"),
            workflow.title,
            hint="The icons appear here",
            draggable=True,
        )
        self.detail = DetailPanel()
        run = Entry("run", workflow.title.replace("&", "&&"), "Make the icons anew", "Ctrl+Return")
        self.entries = (run, *work_entries(workflow.noun, lambda place: True))
        self.make_actions()
        self.switch = hidden(DisplaySwitch())
        shown = card(row((label(workflow.title, "title"), 1), *self._buttons()), (self.results, 1))
        right = splitter(Qt.Orientation.Vertical, (shown, 420, 1), (self.detail, 190, 0))
        row(*filter(None, [self.work_icons]), (right, 1), of=self)
        self._wire()

    def _buttons(self) -> tuple[QWidget, ...]:
        """Return what stands above the results; a workflow without icons begins with a file."""
        if self.work_icons is not None:
            return (self.switch,)
        action = self.actions_by_name["open"]
        words = f"Open {self.workflow.noun}…"
        return self.switch, push_button(words, action.toolTip(), action.trigger)

    def _wire(self) -> None:
        if self.work_icons is not None:
            self.work_icons.chooser.chosen.connect(lambda icon: self.importer.add_icons([icon]))
            self.work_icons.removed.connect(lambda icon: self.importer.remove_icon(icon.id))
        self.pick_from(self.results)
        self.results.asked.connect(self.offer_for)
        self.results.changed.connect(self._show_switch)
        self.runner.began.connect(self._clear)
        self.follow(self.runner, self._show)
        self.follow(self.opener.runner)

    def enter(self) -> None:
        """Begin with looking icons up, if it takes any."""
        (self.results if self.work_icons is None else self.work_icons.chooser).setFocus()

    def run(self) -> None:
        """Make the icons of what is there anew; of an empty page, say what to do first."""
        if self.page == self.blank:
            how = "Choose icons" if self.work_icons else f"Open a file with a {self.workflow.noun}"
            self.hinted.emit(f"There is nothing to run yet. {how} first.")
        self._make(self.runner.run)

    @property
    def icons(self) -> tuple[Pictogram, ...]:
        """The icons of the work."""
        return self.workflow.icons(self.page.work)

    def show_page(self) -> None:
        """Show the icons that are chosen, and make those of what is there now."""
        if self.work_icons is not None:
            self.work_icons.show_icons(self.icons)
        self._make(self.runner.request)

    def _make(self, make: Callable[[Any], None]) -> None:
        page = self.page
        if page == self.blank:
            self.runner.cancel()
            self._clear()
        else:
            make(page.work)

    def _show_switch(self) -> None:
        """Let the user choose between icons and their colour code, if any has one."""
        self.switch.setVisible(any(one.has_code for one in self.results.pictures))

    def _clear(self) -> None:
        self.results.show_entries(())
        self.look_at(None)

    def _show(self, event: object) -> None:
        if isinstance(event, Picture):
            kept = [one for one in self.results.pictures if not one.preview]
            self.results.show_entries([*kept, event])
            self.counted.emit(len(self.results.pictures))
            self.runner.release()
            if self.picture is None:
                self.look_at(event)

    def outcome(self) -> str:
        """Return how many icons there are."""
        count = len(self.results.pictures)
        return counted(count, "icon") if count else ""

    def save(self) -> None:
        """Write the work into a file."""
        self.save_work(self.page.work, self.workflow.noun)
