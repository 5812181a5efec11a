"""The canvas widget: shows the page through a camera and hands the pointer to a tool."""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QRectF, Qt, Signal
from PySide6.QtGui import (
    QDragEnterEvent,
    QDropEvent,
    QFocusEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
)
from PySide6.QtWidgets import QWidget

from iconstudio.gui import theme
from iconstudio.gui.canvas import painters
from iconstudio.gui.canvas.navigation import CameraView
from iconstudio.gui.canvas.tools.base import Pointer, Tool
from iconstudio.gui.canvas.tools.pan import PanTool
from iconstudio.gui.document import Document
from iconstudio.gui.theme import UNIT
from iconstudio.model import Point


class CanvasView(CameraView):
    """The page, with the tool in use. Space or the middle button pans with any tool.

    Signals
    -------
    files_dropped(object)
        MIME data dropped on the canvas.
    """

    files_dropped = Signal(object)

    def __init__(self, document: Document, tool: Tool, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document = document
        self._tool = tool
        self._pan = PanTool(self.pan)
        self._panning = False
        self._regions: Sequence[Point] = ()
        self._dim = 0.35
        self.setMouseTracking(True)
        self.setAcceptDrops(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMinimumSize(40 * UNIT, 30 * UNIT)
        self.setAccessibleName("Canvas")
        self.setAccessibleDescription("Trace the outline of an object here")
        document.page_changed.connect(self._page_changed)
        document.opened.connect(self.fit)

    # -- what is shown -------------------------------------------------------------------------

    def content(self) -> QRectF:
        """Return the area of the page."""
        return self._document.page.bounds()

    @property
    def tool(self) -> Tool:
        """The tool in use."""
        return self._pan if self._panning else self._tool

    def set_tool(self, tool: Tool) -> None:
        """Use another tool."""
        self._tool.leave()
        self._tool = tool
        self._refresh()

    @property
    def pan_tool(self) -> PanTool:
        """The tool that moves the page."""
        return self._pan

    def set_dim(self, percent: int) -> None:
        """Fade the photo: 0 shows it as it is, 100 hides it."""
        self._dim = percent / 100
        self.update()

    def set_regions(self, centres: Sequence[Point]) -> None:
        """Show the salient regions at these centres (canvas pixels); none hides them."""
        self._regions = centres
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the layers from back to front."""
        page, look, area = self._document.page, theme.current(), QRectF(self.rect())
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painters.paint_backdrop(painter, area, self._camera, look)
            if page.photo is not None:
                ratio = self.devicePixelRatioF()
                painters.paint_photo(painter, page.photo, self._dim, self._camera, ratio, look)
            if page.empty:
                painters.paint_welcome(painter, area, look)
            painters.paint_outline(painter, page, self._camera, look)
            if self._regions and page.closed:
                painters.paint_regions(painter, page, self._regions, self._camera, look)
            self._tool.paint(painter, self._camera, look)
            if not page.empty and self.tool.hint:
                painters.paint_hint(painter, area, self.tool.hint, look)

    # -- pointer and keys ----------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Hand over to the tool; the middle button always pans."""
        if event.button() == Qt.MouseButton.MiddleButton:
            self._panning = True
        self.tool.press(self._pointer(event))
        self._refresh()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Hand over to the tool."""
        self.tool.move(self._pointer(event))
        self._refresh()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Hand over to the tool."""
        self.tool.release(self._pointer(event))
        if event.button() == Qt.MouseButton.MiddleButton:
            self._panning = False
        self._refresh()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Hand over to the tool."""
        self.tool.double_click(self._pointer(event))
        self._refresh()

    def leaveEvent(self, event: QEvent) -> None:
        """Let the tool forget the pointer."""
        self._tool.leave()
        self._refresh()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Space pans while it is down, Escape cancels, the rest goes to the tool."""
        if event.key() == Qt.Key.Key_Space:
            self._panning = True
        elif event.key() == Qt.Key.Key_Escape:
            self._tool.cancel()
        elif not self._tool.key(event):
            super().keyPressEvent(event)
        self._refresh()

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """Stop panning when the space bar goes up."""
        if event.key() == Qt.Key.Key_Space and not event.isAutoRepeat():
            self._pan.cancel()
            self._panning = False
            self._refresh()
        else:
            super().keyReleaseEvent(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """Stop panning: the space bar may go up elsewhere."""
        self._pan.cancel()
        self._panning = False
        super().focusOutEvent(event)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        """Welcome files and images."""
        if event.mimeData().hasUrls() or event.mimeData().hasImage():
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        """Pass on what was dropped."""
        event.acceptProposedAction()
        self.files_dropped.emit(event.mimeData())

    # -- helpers -------------------------------------------------------------------------------

    def _pointer(self, event: QMouseEvent) -> Pointer:
        view = event.position()
        return Pointer(
            self._camera.to_page(view), view, self._camera, event.button(), event.modifiers()
        )

    def _page_changed(self) -> None:
        if not self._document.page.vertices:
            self._regions = ()
        self._refresh()

    def _refresh(self) -> None:
        self.setCursor(self.tool.cursor)
        self.update()
