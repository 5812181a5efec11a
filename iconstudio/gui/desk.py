"""A workspace with its messages above and its progress below."""

from PySide6.QtWidgets import QVBoxLayout, QWidget

from iconstudio.gui import theme
from iconstudio.gui.panels.notice import Notice
from iconstudio.gui.panels.progress import ProgressStrip
from iconstudio.gui.theme import UNIT
from iconstudio.gui.workspaces.base import Workspace


class Desk(QWidget):
    """Shows what a workspace tells, also what it told while another one was in sight."""

    def __init__(self, workspace: Workspace) -> None:
        super().__init__()
        self.workspace = workspace
        self.notice = Notice()
        self.strip = ProgressStrip()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(UNIT, 0, UNIT, 0)
        layout.setSpacing(UNIT)
        layout.addWidget(self.notice)
        layout.addWidget(workspace, 1)
        layout.addWidget(self.strip)
        workspace.said.connect(self.say)
        workspace.failed.connect(self.notice.say)
        workspace.progressed.connect(self.strip.show_progress)
        workspace.counted.connect(self.strip.set_finished)
        workspace.rested.connect(self.strip.rest)
        workspace.document.page_changed.connect(self.notice.hide)
        self.strip.cancelled.connect(workspace.cancel)

    def say(self, remark: str) -> None:
        """Show a remark for a while; messages are dealt with."""
        self.notice.hide()
        self.strip.say(remark)

    def refresh_icons(self, look: theme.Theme) -> None:
        """Draw all icons in the colours of ``look``."""
        self.notice.refresh_icons(look)
        self.workspace.refresh_icons(look)
