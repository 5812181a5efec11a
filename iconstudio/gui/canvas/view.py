"""The canvas widget: shows the page through a camera and hands the pointer to a tool."""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import (
    QInputDevice,
    QKeyEvent,
    QMouseEvent,
    QNativeGestureEvent,
    QPainter,
    QPaintEvent,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QWidget

from iconstudio.gui import theme
from iconstudio.gui.canvas import painters
from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.canvas.tools.base import Pointer, Tool
from iconstudio.gui.canvas.tools.pan import PanTool
from iconstudio.gui.document import Document
from iconstudio.gui.theme import UNIT
from iconstudio.model import Point

ZOOM_STEP = 1.25


class CanvasView(QWidget):
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
        self._camera = Camera()
        self._fitted = True
        self.setMouseTracking(True)
        self.setAcceptDrops(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMinimumSize(40 * UNIT, 30 * UNIT)
        self.setAccessibleName("Canvas")
        self.setAccessibleDescription("Trace the outline of an object here")
        document.page_changed.connect(self._page_changed)
        document.opened.connect(self.fit)

    # -- what is shown -------------------------------------------------------------------------

    @property
    def camera(self) -> Camera:
        """Which part of the page is shown."""
        return self._camera

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

    def fit(self) -> None:
        """Show the whole page."""
        self._camera = self._fitting()
        self._fitted = True
        self.update()

    def zoom_by(self, factor: float, anchor: QPointF | None = None) -> None:
        """Zoom about ``anchor``, by default the middle."""
        middle = QPointF(self.width() / 2, self.height() / 2)
        base = self._fitting().zoom
        self._camera = self._camera.zoomed(factor, anchor or middle, base)
        self._fitted = False
        self.update()

    def zoom_in(self) -> None:
        """Zoom in by a step."""
        self.zoom_by(ZOOM_STEP)

    def zoom_out(self) -> None:
        """Zoom out by a step."""
        self.zoom_by(1 / ZOOM_STEP)

    def pan(self, by: QPointF) -> None:
        """Move the page by view pixels."""
        self._camera = self._camera.panned(by)
        self._fitted = False
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

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom with a wheel; with a touch pad pan, and zoom while Ctrl is down."""
        touch = event.pointingDevice().type() == QInputDevice.DeviceType.TouchPad
        if touch and not event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            delta = event.pixelDelta() if not event.pixelDelta().isNull() else event.angleDelta()
            self.pan(QPointF(delta))
        else:
            self.zoom_by(1.0015 ** event.angleDelta().y(), event.position())
        event.accept()

    def event(self, event: QEvent) -> bool:
        """Zoom with a pinch."""
        if (
            isinstance(event, QNativeGestureEvent)
            and event.gestureType() == Qt.NativeGestureType.ZoomNativeGesture
        ):
            self.zoom_by(1 + event.value(), event.position())
            return True
        return super().event(event)

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

    def dragEnterEvent(self, event) -> None:
        """Welcome files and images."""
        if event.mimeData().hasUrls() or event.mimeData().hasImage():
            event.acceptProposedAction()

    def dropEvent(self, event) -> None:
        """Pass on what was dropped."""
        event.acceptProposedAction()
        self.files_dropped.emit(event.mimeData())

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Keep the page fitted, or its middle in the middle."""
        if self._fitted or not event.oldSize().isValid():
            self.fit()
        else:
            change = event.size() - event.oldSize()
            self._camera = self._camera.panned(QPointF(change.width(), change.height()) / 2)

    # -- helpers -------------------------------------------------------------------------------

    def _pointer(self, event: QMouseEvent) -> Pointer:
        view = event.position()
        return Pointer(
            self._camera.to_page(view), view, self._camera, event.button(), event.modifiers()
        )

    def _fitting(self) -> Camera:
        return Camera.fitting(self._document.page.bounds(), self.size().toSizeF(), 3 * UNIT)

    def _page_changed(self) -> None:
        if not self._document.page.vertices:
            self._regions = ()
        self._refresh()

    def _refresh(self) -> None:
        self.setCursor(self.tool.cursor)
        self.update()
