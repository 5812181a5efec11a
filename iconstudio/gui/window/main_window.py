"""The window: what all workspaces share, and the switch between them."""

from collections.abc import Generator, Sequence
from pathlib import Path

from PySide6.QtCore import QMimeData, QTimer, QUrl
from PySide6.QtGui import QCloseEvent, QGuiApplication
from PySide6.QtWidgets import QMainWindow, QMenu, QStackedWidget, QWidget

from iconstudio.gui.exchange.saving import Saver
from iconstudio.gui.gallery import display, symmetric, tidiness
from iconstudio.gui.gallery.recent import RecentResults
from iconstudio.gui.gallery.sending import Destination
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.project import recents
from iconstudio.gui.project.files import ProjectFiles, WorkFile
from iconstudio.gui.project.recovery import RecoveryBar
from iconstudio.gui.project.work import Work
from iconstudio.gui.theme.layout import column, row
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.window.menus import MENUS, RECENT, WINDOW, fill_menu
from iconstudio.gui.window.modes import ModeSwitch
from iconstudio.gui.window.pane import WorkspacePane
from iconstudio.gui.workspaces.actions import Actions
from iconstudio.gui.workspaces.base import Workspace
from iconstudio.model import Pictogram, Remix
from iconstudio.project.journal import LeftBehind
from iconstudio.session import Session
from iconstudio.workflows import registry
from iconstudio.workflows.workflow import Workflow, load_object

_FRAME, _BAR = 16, 48
"""What the system's frame around a window takes of the screen at most, in pixels."""

_TITLE = "Iconstudio"
_PLAIN = "iconstudio.gui.workspaces.plain.workspace:PlainWorkspace"
"""The workspace of workflows that have none of their own."""
_PATIENCE = 300
"""Milliseconds after which what was left behind is looked for, and what may be needed next is
loaded: first the window opens."""


class MainWindow(QMainWindow):
    """The switch and the recent results above, the workspace in use below.

    A workspace is made when it is first used, so that the window opens fast.
    """

    def __init__(self, session: Session, workflows: Sequence[Workflow] | None = None) -> None:
        super().__init__()
        for setting in (display.setting, tidiness.setting, symmetric.setting):
            setting.recall()
        self._session = session
        self._workflows = tuple(registry.workflows() if workflows is None else workflows)
        self._made: dict[int, WorkspacePane] = {}
        self._files = Worker(self)
        self.saver = Saver(self._files, self)
        self._destinations = tuple(
            Destination(one.title, one.invitation, one.opens_results)
            for one in self._workflows
            if one.invitation
        )
        self.modes = ModeSwitch([one.title for one in self._workflows])
        self.recent = RecentResults(self._destinations, self.saver)
        self.panes = QStackedWidget()
        by_name = {one.name: one for one in self._workflows}
        self.work = Work(by_name, self.recent, self._current, self._show_named, self)
        self.project = ProjectFiles(session, self.work, self._files, self)
        self.recovery = RecoveryBar(by_name)
        self._make_actions()
        self._menus: dict[str, QMenu] = {title: self.menuBar().addMenu(title) for title in MENUS}
        self._lay_out()
        self._wire()
        self.show_workspace(0)

    def _make_actions(self) -> None:
        self.actions_by_name = Actions(self, WINDOW)
        menu = QMenu(RECENT.text, self)
        menu.aboutToShow.connect(lambda: recents.fill(menu, self.project.open))
        self.actions_by_name.add(RECENT, menu.menuAction())

    def _lay_out(self) -> None:
        margins, centre = (UNIT, 0, UNIT, 0), QWidget()
        # In a row of its own, an offer would cut short what is below.
        beside = (self.recent, 1), (self.recovery, 2)
        top = row(self.modes, *beside, spacing=2 * UNIT, margins=margins)
        column(top, (self.panes, 1), of=centre, spacing=UNIT // 2)
        self.setCentralWidget(centre)
        room = QGuiApplication.primaryScreen().availableSize()
        self.resize(min(1360, room.width() - _FRAME), min(860, room.height() - _BAR))

    def _wire(self) -> None:
        self.modes.chosen.connect(self.show_workspace)
        project = self.project
        for remarked in (self.saver.saved, project.remarked):
            remarked.connect(lambda remark: self.pane.say(remark))
        for failed in (self.saver.failed, project.failed):
            failed.connect(lambda message: self.pane.notice.say(message))
        project.changed.connect(self._show_title)
        project.imported.connect(self._import)
        project.progressed.connect(lambda progress: self.workspace.progressed.emit(progress))
        project.rested.connect(self._rest)
        project.restoring.connect(self.recovery.set_restoring)
        project.restored.connect(self.recovery.withdraw)
        project.journaling.found.connect(self.recovery.offer)
        self.recovery.restore.connect(project.restore)
        self.recovery.dismiss.connect(self._dismiss)
        QTimer.singleShot(_PATIENCE, self, project.journaling.look)
        QTimer.singleShot(_PATIENCE, self, lambda: self._files.submit(self._load_workspaces))
        self._show_title()
        self.recent.sent.connect(self._send_picture)

    # -- workspaces ----------------------------------------------------------------------------

    @property
    def pane(self) -> WorkspacePane:
        """The pane in sight."""
        return self.panes.currentWidget()

    @property
    def workspace(self) -> Workspace:
        """The workspace in use."""
        return self.pane.workspace

    def workspace_of(self, title: str) -> Workspace:
        """Return the workspace of that title."""
        return self._pane(self._number(title)).workspace

    def show_workspace(self, number: int) -> None:
        """Switch to a workspace; work that goes on elsewhere goes on."""
        self.panes.setCurrentWidget(self._pane(number))
        self.modes.show_current(number)
        actions = self.workspace.actions_by_name
        for title, menu in self._menus.items():
            fill_menu(menu, title, self.actions_by_name, actions, self.modes.actions_in_order)
        self.workspace.enter()

    def _number(self, title: str) -> int:
        return next(n for n, one in enumerate(self._workflows) if one.title == title)

    def _numbered(self, name: str) -> int:
        return next(n for n, one in enumerate(self._workflows) if one.name == name)

    def _show_named(self, name: str) -> None:
        self.show_workspace(self._numbered(name))

    def _current(self) -> str:
        return self.workspace.workflow.name if self.panes.count() else ""

    def _load_workspaces(self) -> Generator[None]:
        """Load all workspaces, so that the first visit need not wait for it."""
        self._session.libraries.read()
        for workflow in self._workflows:
            load_object(workflow.workspace or _PLAIN).get_ready()
            yield

    def _pane(self, number: int) -> WorkspacePane:
        """Return a workspace's pane, made if it is the first time."""
        if number not in self._made:
            workflow = self._workflows[number]
            kind = load_object(workflow.workspace or _PLAIN)
            workspace = kind(workflow, self._session, self._files, self.saver)
            workspace.set_destinations(self._destinations)
            workspace.kept.connect(self.recent.keep)
            workspace.send.connect(self._send)
            workspace.send_sources.connect(self._send_sources)
            workspace.project.connect(lambda path: self.project.open(Path(path)))
            workspace.actions_by_name["cancel"].triggered.connect(self.project.cancel)
            pane = self._made[number] = WorkspacePane(workspace)
            pane.status.cancelled.connect(self.project.cancel)
            self.panes.addWidget(pane)
            self.work.watch(workspace)
        return self._made[number]

    def _send(self, pictogram: Pictogram, title: str) -> None:
        self.show_workspace(self._number(title))
        self.workspace.take(pictogram)

    def _send_sources(self, result: Remix, title: str) -> None:
        self.show_workspace(self._number(title))
        self.workspace.open_result(result)

    def _send_picture(self, picture: Picture, title: str) -> None:
        self.recent.keep(picture)
        self._send(picture.pictogram(), title)

    # -- the project ---------------------------------------------------------------------------

    def _show_title(self) -> None:
        project = self.project
        untitled = f"Untitled[*] – {_TITLE}" if project.modified else f"{_TITLE}[*]"
        self.setWindowTitle(f"{project.name}[*] – {_TITLE}" if project.name else untitled)
        self.setWindowFilePath("" if project.path is None else str(project.path))
        self.setWindowModified(project.modified)

    def _rest(self) -> None:
        """Say no longer that a project is being read, in whichever pane that is said."""
        for pane in self._made.values():
            pane.workspace.rest()

    def _import(self, file: WorkFile) -> None:
        if file.workflow:
            self._show_named(file.workflow)
        data = QMimeData()
        data.setUrls([QUrl.fromLocalFile(str(file.path))])
        self.workspace.open_mime(data)

    def _dismiss(self, found: LeftBehind) -> None:
        self.recovery.withdraw(found)
        self.project.journaling.dismiss(found)

    # -- the window itself ---------------------------------------------------------------------

    def closeEvent(self, event: QCloseEvent) -> None:
        """Ask about unsaved work; then stop all, and wait until the threads have ended."""
        if not self.project.may_go(self.close):
            event.ignore()
            return
        for pane in self._made.values():
            pane.workspace.cancel()
        for pane in self._made.values():
            pane.workspace.close_work()
        self.project.close()
        self._files.close(self._session.close)
        self._session.close()
        super().closeEvent(event)
