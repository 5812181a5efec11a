"""All that a project holds, as it is in the window now."""

from collections.abc import Callable, Mapping

from PySide6.QtCore import QObject, Signal

from iconstudio.gui.gallery.recent import RecentResults
from iconstudio.gui.pictures.picture import picture_of
from iconstudio.gui.workspaces.base import Workspace
from iconstudio.project.archive import Project
from iconstudio.project.contents import Contents, Formats
from iconstudio.workflows.pages import Page
from iconstudio.workflows.workflow import Workflow


class Work(QObject):
    """The pages of all workspaces, and the recent results.

    A page that was opened waits until its workspace is first used, and so made.

    Parameters
    ----------
    current, show
        Returns the name of the workflow in sight; brings another one into sight.

    Signals
    -------
    changed()
        An edit, an undo or a redo, or another recent result.
    """

    changed = Signal()

    def __init__(
        self,
        workflows: Mapping[str, Workflow],
        recent: RecentResults,
        current: Callable[[], str],
        show: Callable[[str], None],
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self.formats = Formats(workflows)
        self._workflows = workflows
        self._recent = recent
        self._current = current
        self._show = show
        self._made: dict[str, Workspace] = {}
        self._waiting: dict[str, Page] = {}
        """The pages of workspaces that have not been made, or have not put them in sight yet."""
        self._unread: Project | None = None
        """Pages that are not in sight, but kept."""
        recent.changed.connect(self.changed)

    def watch(self, workspace: Workspace) -> None:
        """Count a workspace in that has been made, and put the page there that waits for it."""
        name = workspace.workflow.name
        self._made[name] = workspace
        workspace.document.page_changed.connect(lambda: self._note(name))
        self._put(workspace)

    @property
    def opening(self) -> bool:
        """Whether something is being opened that is not on its page yet."""
        return any(one.opener.busy for one in self._made.values() if one.opener is not None)

    def contents(self) -> Contents:
        """Return what is there now."""
        pages = self._waiting | {
            name: one.page
            for name, one in self._made.items()
            if not one.pages.alike(one.page, one.blank)
        }
        recent = tuple(one.icon for one in self._recent.pictures)
        return Contents(self._current(), pages, recent, unread=self._unread)

    def load(self, contents: Contents) -> None:
        """Put a project in place of all that is there."""
        for workspace in self._made.values():
            workspace.cancel()
            workspace.document.load(workspace.blank)  # results of other work go from sight, too
        self._unread, self._waiting = contents.unread, dict(contents.pages)
        for workspace in self._made.values():
            self._put(workspace)
        if contents.current in self._workflows:
            self._show(contents.current)
        self._recent.show_entries(tuple(map(picture_of, contents.recent)))

    def _put(self, workspace: Workspace) -> None:
        page = self._waiting.get(workspace.workflow.name)
        if page is not None:
            workspace.document.load(page)

    def _note(self, name: str) -> None:
        self._waiting.pop(name, None)
        self.changed.emit()
