"""All that a project holds, as it is in the window now."""

from collections.abc import Callable, Mapping

from PySide6.QtCore import QObject, Signal

from iconstudio.gui.gallery.recent import RecentResults
from iconstudio.gui.pictures.picture import picture_of
from iconstudio.gui.workspaces.base import Workspace
from iconstudio.project.archive import Project
from iconstudio.project.contents import Contents, Formats
from iconstudio.workflows.workflow import Workflow


class Work(QObject):
    """The pages of all workspaces that have been made, and the recent results.

    Parameters
    ----------
    workspace_of
        Returns the workspace of a workflow, made if need be.
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
        workspace_of: Callable[[str], Workspace],
        current: Callable[[], str],
        show: Callable[[str], None],
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self.formats = Formats(workflows)
        self._workflows = workflows
        self._recent = recent
        self._workspace_of = workspace_of
        self._current = current
        self._show = show
        self._made: dict[str, Workspace] = {}
        self._unread: Project | None = None
        """Pages that are not in sight, but kept."""
        recent.changed.connect(self.changed)

    def watch(self, workspace: Workspace) -> None:
        """Count a workspace in that has been made."""
        self._made[workspace.workflow.name] = workspace
        workspace.document.page_changed.connect(self.changed)

    def contents(self) -> Contents:
        """Return what is there now."""
        pages = {
            name: one.document.page
            for name, one in self._made.items()
            if not one.pages.alike(one.document.page, one.blank)
        }
        recent = tuple(one.icon for one in self._recent.pictures)
        return Contents(self._current(), pages, recent, unread=self._unread)

    def load(self, contents: Contents) -> None:
        """Put a project in place of all that is there."""
        self._unread = contents.unread
        if contents.current in self._workflows:
            self._show(contents.current)
        for name in dict.fromkeys((*self._made, *contents.pages)):
            workspace = self._workspace_of(name)
            workspace.cancel()
            if workspace.opener is not None:
                workspace.opener.cancel()
            workspace.document.load(workspace.blank)  # results of other work go from sight, too
            workspace.document.load(contents.pages.get(name, workspace.blank))
        self._recent.show_entries(tuple(map(picture_of, contents.recent)))
