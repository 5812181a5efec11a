"""What every workspace offers to the window."""

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import Any, ClassVar

from PySide6.QtCore import QMimeData, Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QWidget

from iconstudio.gui.canvas.outlines import IconOutlines
from iconstudio.gui.canvas.tools.base import Tool
from iconstudio.gui.canvas.view import CanvasView
from iconstudio.gui.document.document import Document
from iconstudio.gui.exchange.opening import Opener
from iconstudio.gui.exchange.saving import Saver
from iconstudio.gui.gallery import display
from iconstudio.gui.gallery.sending import Destination
from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.panels.canvas import CanvasPanel, together
from iconstudio.gui.workspaces.actions import (
    COMMON,
    EXAMPLES,
    REDO,
    UNDO,
    Actions,
    Entry,
    examples_menu,
)
from iconstudio.gui.workspaces.results import ResultsWidget
from iconstudio.images.photo import file_beside
from iconstudio.model import Photo, Pictogram
from iconstudio.session import Session
from iconstudio.workflows.files import write_file
from iconstudio.workflows.workflow import Workflow, load_object


class Workspace(ResultsWidget):
    """One workflow: its page, its work and its results, all its own.

    A subclass declares its ``page_type`` and its ``entries``; in ``build`` it makes a ``detail``
    and an ``opener`` and calls ``make_actions``; and it overrides what it needs. It has a thread,
    ``worker``, for its runs, and may have more; ``files`` reads and writes files without waiting
    for them, and ``saver`` asks where to. The window shows what the signals tell.

    Signals
    -------
    remarked(str)
        A remark for the status line; messages that were in sight are dealt with.
    failed(str)
        Something could not be done; a sentence for the user, which stays until it is read.
    hinted(str)
        What the user should do next, or know; no mistake was made.
    progressed(Progress), counted(int)
        How far the work is, and how many results are finished.
    idle(str)
        Nothing is under way any more; what came out of it, if anything.
    project(str)
        The project in the file of that path is to be opened.
    """

    remarked = Signal(str)
    failed = Signal(str)
    hinted = Signal(str)
    progressed = Signal(object)
    counted = Signal(int)
    idle = Signal(str)
    project = Signal(str)

    page_type: ClassVar[Callable[[], Any]]
    """Makes the page to begin with: its type, or a method."""
    entries: ClassVar[tuple[Entry, ...]] = ()
    """All that can be done here, beside what can be done everywhere."""
    sends_to_itself: ClassVar[bool] = True
    """Whether results can be worked on here again."""
    opener: Opener | None = None
    """Brings onto the page what is opened, dropped and pasted, if anything can be."""
    remarks: Sequence[str] = ()
    """What the user should know of the page, beside the remarks on its icons."""
    view: CanvasView | None = None
    """Shows the page, if it lies on a canvas."""
    tools: Mapping[str, Tool]
    """The tools of the canvas, by the names of the actions that take them."""

    def __init__(self, workflow: Workflow, session: Session, files: Worker, saver: Saver) -> None:
        super().__init__()
        self.workflow = workflow
        self.session = session
        self.files = files
        self.saver = saver
        self.blank = self.page_type()
        """The page to begin with."""
        self.document = Document(self.blank)
        self.pages = load_object(workflow.page_format)(workflow)
        """Writes its pages into projects."""
        self.document.setParent(self)
        self.worker = Worker(self)
        self.examples: QMenu | None = None
        """The menu of examples, if there are any."""
        self.busy = False
        """Whether the window shows that something is under way."""
        self._followed: list[Runner] = []
        self.progressed.connect(lambda _: self.note_busy(True))
        self.idle.connect(lambda _: self.note_busy(False))
        self.build()

    @staticmethod
    def get_ready() -> None:
        """Read what the first visit would wait for; called in another thread, some time before."""

    def build(self) -> None:
        """Make all that is to be seen, and connect it with the work."""

    @property
    def page(self) -> Any:
        """What lies on the canvas now."""
        return self.document.page

    @property
    def icons(self) -> tuple[Pictogram, ...]:
        """The icons on the page."""
        return ()

    def enter(self) -> None:
        """The user has come here: put the focus where work goes on."""

    def take(self, pictogram: Pictogram) -> None:
        """Begin with an icon that was sent here, or add it."""
        if self.opener is not None:
            self.opener.take(pictogram)

    def open_mime(self, data: QMimeData) -> None:
        """Open what was dropped where nothing else is made of it."""
        if self.opener is not None:
            self.opener.open_mime(data)

    def open_example(self, path: Path) -> None:
        """Open an example, which is a file of work."""
        self.opener.open_work(str(path))

    def set_destinations(self, destinations: tuple[Destination, ...]) -> None:
        """Say where icons can be sent to; called once."""
        title = self.workflow.title
        own = self.sends_to_itself
        self.destinations = tuple(one for one in destinations if own or one.title != title)
        if self.detail is not None:
            self.detail.set_destinations(
                self.destinations,
                lambda title: self.send_picture(self.picture, title),
                lambda title: self.send_sources_of(self.picture, title),
            )

    def run(self) -> None:
        """Do the work for what lies on the canvas."""

    def cancel(self) -> None:
        """Stop the work, and open nothing more; results that are finished stay."""
        for runner in self._followed:
            runner.cancel()
        if self.opener is not None:
            self.opener.cancel()

    def close_work(self) -> None:
        """Stop all work and wait until all threads of the workspace have ended; for good."""
        self.cancel()
        for worker in self.findChildren(Worker):
            worker.close(self.session.close)

    # -- for subclasses ------------------------------------------------------------------------

    def make_actions(self) -> None:
        """Make ``actions_by_name``, once all is there that they work on."""
        stack = self.document.undo_stack
        self.actions_by_name = Actions(self, (*self.entries, *COMMON))
        self.actions_by_name.add(UNDO, stack.createUndoAction(self, "&Undo"))
        self.actions_by_name.add(REDO, stack.createRedoAction(self, "&Redo"))
        if (detail := self.detail) is not None:
            for name, button in detail.buttons.items():
                button.clicked.connect(self.actions_by_name[name].trigger)
        if (opener := self.opener) is not None:
            opener.began.connect(lambda: self.remarked.emit(""))
            opener.failed.connect(self.failed)
            opener.opened.connect(self.remarked)
            opener.project.connect(self.project)
            opener.progressed.connect(self.progressed)
            opener.rested.connect(self.rest)
            if self.view is not None:
                self.view.dropped.connect(opener.open_mime)
            if self.workflow.examples is not None:
                self.examples = examples_menu(self, self.workflow.examples, self.open_example)
                self.actions_by_name.add(EXAMPLES, self.examples.menuAction())
        self.document.page_changed.connect(self.show_page)
        self.document.page_changed.connect(self.actions_by_name.refresh)
        self.picked.connect(self.actions_by_name.refresh)
        display.setting.changed.connect(self._refresh_actions)
        self.actions_by_name.refresh()

    def canvas_panel_of(
        self, *groups: str, more: Sequence[QWidget | QAction] = (), trailing: Sequence[QWidget] = ()
    ) -> CanvasPanel:
        """Return the canvas below its tool bar, whose ``groups`` name actions.

        Of some with bars between them, as ``hole|line``, one button is made.
        """
        named = self.actions_by_name
        bar = [
            [together([named[name] for name in names.split("|")]) for names in group.split()]
            for group in groups
        ]
        return CanvasPanel(self.view, [*bar, more] if more else bar, trailing)

    @cached_property
    def finder(self) -> Worker:
        """Looks icons up and draws them also while a run goes on."""
        return Worker(self)

    @cached_property
    def outlines(self) -> IconOutlines:
        """The outlines of icons, for a canvas that shows some."""
        return IconOutlines(self.session, self.finder, self)

    def show_page(self) -> None:
        """Show what the page says."""

    def follow(self, runner: Runner, show: Callable[[Any], object] | None = None) -> None:
        """Show the progress of a runner, and what came out once all of them are at rest.

        If something is there to ``show`` its events, tell of its failures, too.
        """
        self._followed.append(runner)
        runner.progress.connect(self.progressed)
        runner.ended.connect(self.rest)
        if show is not None:
            runner.event.connect(show)
            runner.failed.connect(self.failed)

    def rest(self) -> None:
        """Tell what came out, unless something is still under way."""
        if any(runner.running for runner in self._followed):
            return
        self.idle.emit(self.outcome())
        if self.opener is not None and self.opener.patience.asked:
            self.opener.patience.ask()

    def outcome(self) -> str:
        """Return what came out, in a few words."""
        return ""

    def use_tool(self, name: str) -> None:
        """Take the tool of that name."""
        self.view.set_tool(self.tools[name])

    def save_work(
        self, work: object, name: str, photos: Mapping[str, Photo] = {}, **more: Any
    ) -> None:
        """Ask for a file, and write work into it, beside its ``photos``; see ``write_file``."""

        def write(path: Path) -> None:
            files = {field: file_beside(photo, path) for field, photo in photos.items()}
            write_file(path, self.workflow, work, **files, **more)

        self.saver.save_work(self.workflow.noun, name, write)

    def _refresh_actions(self) -> None:
        self.actions_by_name.refresh()

    def note_busy(self, busy: bool) -> None:
        """Let the work be cancelled, or not."""
        if busy != self.busy:
            self.busy = busy
            self.actions_by_name.refresh()
