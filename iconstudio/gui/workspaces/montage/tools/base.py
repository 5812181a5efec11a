"""What all tools of a montage have in common."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent

from iconstudio.gui.canvas.tools.base import Tool
from iconstudio.gui.workspaces.montage.scene import MontageScene
from iconstudio.workflows.montage.page import MontageDocument, choose

_STEPS = {Qt.Key.Key_PageUp: 1, Qt.Key.Key_PageDown: -1}


class LayerTool(Tool):
    """Shows on the scene what a gesture will make of the page, and does it when that ends.

    Page Up and Down choose the icon above or below, Delete takes it out.
    """

    def __init__(self, document: MontageDocument, scene: MontageScene) -> None:
        self._document = document
        self._scene = scene
        document.page_changed.connect(self._page_changed)

    @property
    def busy(self) -> bool:
        """Whether a gesture is under way."""
        return False

    def key(self, event: QKeyEvent) -> bool:
        """Choose another icon, or take one out."""
        page, step = self._document.page, _STEPS.get(event.key())
        current = page.current
        if current is None:
            return False
        if event.key() == Qt.Key.Key_Delete:
            self._document.change("delete icon", page.without(current.number))
        elif step is not None:
            at = (page.index(current.number) + step) % len(page.layers)
            choose(self._document, page.layers[at].number)
        else:
            return False
        return True

    def _page_changed(self) -> None:
        """Let go: what the gesture is about may be gone, by an undo in the middle of it."""
        if self.busy:
            self.cancel()
