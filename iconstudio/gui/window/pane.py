"""A workspace with its progress below, and its messages floating over it."""

from dataclasses import replace

from PySide6.QtCore import QMimeData
from PySide6.QtWidgets import QWidget

from iconstudio.gui.exchange.dragging import unpacked
from iconstudio.gui.exchange.dropping import DropTarget
from iconstudio.gui.exchange.mime import holds_something
from iconstudio.gui.exchange.patience import OPENING
from iconstudio.gui.theme.layout import OnGeometry, column
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.window.notice import Notice
from iconstudio.gui.window.progress import StatusStrip
from iconstudio.gui.workspaces.base import Workspace
from iconstudio.inputs.together import quoted_list
from iconstudio.workflows.events import Progress


class WorkspacePane(QWidget):
    """Shows what a workspace tells, also what it told while another one was in sight.

    What is dropped from other programs beside the workspace's canvas is for it, too.
    """

    def __init__(self, workspace: Workspace) -> None:
        super().__init__()
        self.workspace = workspace
        self.notice = Notice(self)
        self.status = StatusStrip()
        DropTarget(self, workspace.open_mime, _is_of_others)
        column((workspace, 1), self.status, of=self, margins=(UNIT, 0, UNIT, 0))
        workspace.remarked.connect(self.say)
        workspace.failed.connect(self.notice.say)
        workspace.hinted.connect(self.notice.hint)
        self.notice.resized.connect(self._place_notice)
        OnGeometry(self.status, self._place_notice)
        workspace.progressed.connect(self._show_progress)
        workspace.counted.connect(self.status.set_finished)
        workspace.idle.connect(self.status.rest)
        workspace.document.page_changed.connect(self._show_remarks)
        self.status.cancelled.connect(workspace.cancel)
        stack = workspace.document.undo_stack
        self._steps = stack.index()
        stack.indexChanged.connect(self._note_step)

    def _place_notice(self) -> None:
        """Put the messages over the words of the status line, where there is nothing to click."""
        room = self.workspace.geometry() | self.status.geometry()
        room.setWidth(self.status.words_end)
        self.notice.place(room)

    def say(self, remark: str) -> None:
        """Show a remark for a while; messages are dealt with."""
        self.notice.clear()
        self.status.say(remark)

    def _note_step(self, steps: int) -> None:
        """Say no longer what was done if it is undone."""
        if steps < self._steps:
            self.status.say("")
        self._steps = steps

    def _show_progress(self, progress: Progress) -> None:
        """Show how far work is, and whether something that is being opened waits for it."""
        opener = self.workspace.opener
        if opener is not None and opener.patience.asked and progress.message != OPENING:
            progress = replace(progress, message=f"{OPENING} · {progress.message}")
        self.status.show_progress(progress)

    def _show_remarks(self) -> None:
        """Show the remarks on the page as it is now, and its icons, those on the newest first.

        Messages are dealt with.
        """
        about: dict[tuple[str, ...], list[str]] = {}
        for icon in dict.fromkeys(self.workspace.icons):
            named = about.pop(icon.remarks, [])
            about[icon.remarks] = [*named, icon.credit.title or icon.id]
        about.pop((), None)
        self.notice.clear()
        said = (f"{quoted_list(some)}: {' '.join(each)}" for each, some in reversed(about.items()))
        self.notice.remark((*said, *self.workspace.remarks))


def _is_of_others(data: QMimeData) -> bool:
    """Whether another program gives something."""
    return holds_something(data) and unpacked(data) is None
