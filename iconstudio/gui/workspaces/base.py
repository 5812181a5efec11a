"""What every workspace offers to the window."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

from PySide6.QtCore import QMimeData, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QMenu, QWidget

from iconstudio.gui.canvas.view import CanvasView
from iconstudio.gui.document.document import Document
from iconstudio.gui.exchange.opening import Opener
from iconstudio.gui.exchange.saving import Saver
from iconstudio.gui.gallery.browser import ResultsBrowser
from iconstudio.gui.gallery.detail import DetailPanel
from iconstudio.gui.gallery.pictures import Display, Picture
from iconstudio.gui.gallery.sending import Destination
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.window.actions import ENTRIES, Actions, Entry
from iconstudio.gui.window.preferences import prefer, preferred
from iconstudio.inputs.examples import examples
from iconstudio.model import Pictogram
from iconstudio.session import Session
from iconstudio.workflows.workflow import Workflow, named

DISPLAY = "display"
"""Under which it is remembered how results are shown."""


class Workspace(QWidget):
    """One workflow of section 4: its page, its work and its results, all its own.

    A subclass calls ``make_actions`` in ``__init__``, and overrides what it needs. It has a
    thread, ``worker``, for its runs, and may have more; ``files`` reads and writes files without
    waiting for them, and ``saver`` asks where to. The window shows what the signals tell.

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
    picked(object)
        The Picture that the user looks at, or None.
    kept(Picture)
        A result worth keeping in sight.
    send(Pictogram, str)
        An icon is to go to the workspace of that title.
    project(str)
        The project in the file of that path is to be opened.
    """

    remarked = Signal(str)
    failed = Signal(str)
    hinted = Signal(str)
    progressed = Signal(object)
    counted = Signal(int)
    idle = Signal(str)
    picked = Signal(object)
    kept = Signal(object)
    send = Signal(object, str)
    project = Signal(str)

    opener: Opener | None = None
    """Brings onto the page what is opened, dropped and pasted, if anything can be."""
    actions_by_name: Actions
    """All that can be done here; see ``make_actions``. The menus show these, and their shortcuts
    work while this workspace is in sight. What makes no sense at the moment is disabled."""

    def __init__(
        self,
        workflow: Workflow,
        session: Session,
        files: Worker,
        saver: Saver,
        document: Document,
    ) -> None:
        super().__init__()
        self.workflow = workflow
        self.session = session
        self.files = files
        self.saver = saver
        self.document = document
        self.blank = document.page
        """The page to begin with."""
        self.pages = named(workflow.page_format)(workflow)
        """Writes its pages into projects."""
        document.setParent(self)
        self.worker = Worker(self)
        self.displays: Sequence[Any] = ()
        """What shows results; each has a method ``show_display``."""
        self.progressed.connect(lambda _: self._allow_cancel(True))
        self.idle.connect(lambda _: self._allow_cancel(False))

    @property
    def picture(self) -> Picture | None:
        """The picked result, which Save SVG, Save PNG and Copy take."""
        return None

    @property
    def icons(self) -> tuple[Pictogram, ...]:
        """The icons on the page."""
        return ()

    def enter(self) -> None:
        """The user has come here: put the focus where work goes on."""

    def take(self, pictogram: Pictogram) -> None:
        """Begin with an icon that was sent here, or add it."""

    def open_mime(self, data: QMimeData) -> None:
        """Open what was dropped where nothing else is made of it."""
        if self.opener is not None:
            self.opener.open_mime(data)

    def set_destinations(self, destinations: tuple[Destination, ...]) -> None:
        """Say where icons can be sent to; called once."""

    def run(self) -> None:
        """Do the work for what lies on the canvas."""

    def cancel(self) -> None:
        """Stop the work; results that are finished stay."""

    def close_work(self) -> None:
        """Stop all work and wait until all threads of the workspace have ended; for good."""
        self.cancel()
        for worker in self.findChildren(Worker):
            worker.close(self.session.close)

    # -- for subclasses ------------------------------------------------------------------------

    def make_actions(
        self,
        slots: Mapping[str, Callable[..., object]],
        own: Mapping[str, Sequence[Entry]] | None = None,
    ) -> None:
        """Make ``actions_by_name``: ``slots`` (see ``Actions``), and what all workspaces have."""
        shown = {one.value: partial(self._choose_display, one) for one in Display}
        common = {
            "svg": lambda: self._keep(self.saver.save_svg),
            "png": lambda: self._keep(self.saver.save_png),
            "code_png": lambda: self._keep(self.saver.save_code),
            "copy": lambda: self._keep(self.saver.copy_svg),
            "cancel": self.cancel,
            **shown,
        }
        actions = self.actions_by_name = Actions(self, common | dict(slots), own)
        stack = self.document.undo_stack
        actions.add(ENTRIES["undo"], stack.createUndoAction(self, "&Undo"))
        actions.add(ENTRIES["redo"], stack.createRedoAction(self, "&Redo"))
        actions.choose_between(*shown)
        self._show_picked(None)
        self.picked.connect(self._show_picked)

    def showEvent(self, event: QShowEvent) -> None:
        """Show results as the user prefers by now, perhaps since another workspace."""
        super().showEvent(event)
        preference = preferred(DISPLAY, Display.BOTH.value)
        if preference in [one.value for one in Display]:
            self.actions_by_name[preference].setChecked(True)
            self.show_display(Display(preference))

    def show_display(self, display: Display) -> None:
        """Show results as icons, by their colour code, or both."""
        for one in self.displays:
            one.show_display(display)

    def _choose_display(self, display: Display, on: bool) -> None:
        if on and self.isVisible():
            prefer(DISPLAY, display.value)
            self.show_display(display)

    def add_examples(self, folder: str, use: Callable[[str], object]) -> QMenu:
        """Return a menu of the examples in a folder; ``use`` is called with the path of one.

        Call it after ``make_actions``: the menu is an action, too.
        """
        menu = QMenu(ENTRIES["examples"].text, self)
        for one in examples(folder):
            menu.addAction(one.title, lambda path=str(one.path): use(path))
        self.actions_by_name.add(ENTRIES["examples"], menu.menuAction())
        return menu

    @staticmethod
    def opener_slots(opener: Opener) -> dict[str, Callable[..., object]]:
        """Return what the actions that open things do."""
        return {"open": opener.choose_work, "paste": opener.paste}

    def connect_opener(self, opener: Opener) -> None:
        """Let an opener open what is dropped, and pass on what it tells."""
        self.opener = opener
        opener.began.connect(lambda: self.remarked.emit(""))
        opener.failed.connect(self.failed)
        opener.opened.connect(self.remarked)
        opener.project.connect(self.project)

    @staticmethod
    def view_slots(view: CanvasView) -> dict[str, Callable[..., object]]:
        """Return what the actions that look at a canvas do."""
        return {
            "pan": lambda on: None,
            "zoom_in": view.zoom_in,
            "zoom_out": view.zoom_out,
            "fit": view.fit,
        }

    def connect_browser(self, browser: ResultsBrowser) -> None:
        """Pass on what happens in a browser of results."""
        browser.picked.connect(self.picked)
        browser.kept.connect(self.kept)
        browser.counted.connect(self.counted)
        browser.sent.connect(self.send_picture)
        browser.results.switch.chosen.connect(self.choose_display)
        self.connect_detail(browser.detail)

    def choose_display(self, display: Display) -> None:
        """Show results in another way, as if the user had chosen it in the menu."""
        self.actions_by_name[display.value].setChecked(True)

    def connect_detail(self, detail: DetailPanel) -> None:
        """Let the buttons of the details do what the menus do."""
        detail.save_svg.connect(self.actions_by_name["svg"].trigger)
        detail.save_png.connect(self.actions_by_name["png"].trigger)
        detail.copy_svg.connect(self.actions_by_name["copy"].trigger)

    def send_picture(self, picture: Picture, title: str) -> None:
        """Send a result to the workspace of that title."""
        self.kept.emit(picture)
        self.send.emit(picture.pictogram(), title)

    def _keep(self, save: Callable[[Picture], None]) -> None:
        if self.picture is not None:
            self.kept.emit(self.picture)
            save(self.picture)

    def _show_picked(self, picture: Picture | None) -> None:
        for name in ("svg", "png", "code_png", "copy"):
            self.actions_by_name[name].setEnabled(picture is not None)

    def _allow_cancel(self, allowed: bool) -> None:
        self.actions_by_name["cancel"].setEnabled(allowed)
