"""The canvas widget: shows a scene through a camera and hands the pointer to a tool."""

from PySide6.QtCore import QEvent, QRectF, Qt, Signal
from PySide6.QtGui import (
    QFocusEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPixmap,
    QPointingDevice,
    QTabletEvent,
)

from iconstudio.gui.canvas import painters
from iconstudio.gui.canvas.navigation import CameraView
from iconstudio.gui.canvas.scene import Scene
from iconstudio.gui.canvas.tools.base import Pointer, Tool
from iconstudio.gui.canvas.tools.pan import PanTool
from iconstudio.gui.exchange.dropping import DropTarget
from iconstudio.gui.theme import theme
from iconstudio.gui.theme.theme import UNIT


class CanvasView(CameraView):
    """A scene, with the tool in use. Space or the middle button pans with any tool.

    Signals
    -------
    dropped(QMimeData)
        Something was dropped on the canvas.
    """

    dropped = Signal(object)

    covered = painters.OFFER_ROOM, painters.HINT_ROOM

    def __init__(self, scene: Scene, tool: Tool, description: str = "") -> None:
        """``description`` says what is done here. The scene belongs to the view."""
        super().__init__()
        scene.setParent(self)
        self.setAccessibleDescription(description)
        self.scene = scene
        self._tool = tool
        self.pan_tool = PanTool(self.pan)
        """The tool that moves the page."""
        self._panning = False
        self._backdrop_pixmap = QPixmap()
        self._backdrop_seen: object = None
        self.setMouseTracking(True)
        self.setTabletTracking(True)
        DropTarget(self, self.dropped.emit)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMinimumSize(40 * UNIT, 30 * UNIT)
        self.setAccessibleName("Canvas")
        scene.changed.connect(self.refresh)
        scene.document.page_changed.connect(self.refresh)
        scene.document.opened.connect(self.fit)

    # -- what is shown -------------------------------------------------------------------------

    def content(self) -> QRectF:
        """Return the area of the page."""
        return self.scene.bounds()

    @property
    def tool(self) -> Tool:
        """The tool in use."""
        return self.pan_tool if self._panning else self._tool

    def set_tool(self, tool: Tool) -> None:
        """Use another tool."""
        self._tool.leave()
        self._tool = tool
        self.refresh()

    def refresh(self) -> None:
        """Draw again what the scene and the tool show now."""
        self.setCursor(self.tool.cursor)
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the layers from back to front."""
        scheme, area = theme.current(), QRectF(self.rect())
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.drawPixmap(0, 0, self._backdrop(scheme))
            self.scene.paint(painter, self._camera, self.devicePixelRatioF(), scheme)
            if self.scene.empty:
                painters.paint_welcome(painter, area, *self.scene.welcome, scheme)
            self._tool.paint(painter, self._camera, scheme)
            if not self.scene.empty and self.tool.hint:
                painters.paint_hint(painter, area, self.tool.hint, scheme)

    # -- pointer and keys ----------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Hand over to the tool; the middle button always pans."""
        self._press(_pointer(event, self))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Hand over to the tool."""
        self._move(_pointer(event, self))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Hand over to the tool."""
        self._release(_pointer(event, self))

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Hand over to the tool."""
        self.tool.double_click(_pointer(event, self))
        self.refresh()

    def tabletEvent(self, event: QTabletEvent) -> None:
        """Hand the pen over to the tool; accepted, so that Qt makes no mouse events of it."""
        pointer = _pointer(event, self)
        match event.type():
            case QEvent.Type.TabletPress:
                self.setFocus(Qt.FocusReason.MouseFocusReason)
                self._press(pointer)
            case QEvent.Type.TabletMove:
                self._move(pointer)
            case QEvent.Type.TabletRelease:
                self._release(pointer)
        event.accept()

    def leaveEvent(self, event: QEvent) -> None:
        """Let the tool forget the pointer."""
        self._tool.leave()
        self.refresh()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Space pans while it is down, Escape cancels, the rest goes to the tool."""
        if event.key() == Qt.Key.Key_Space:
            self._panning = True
        elif event.key() == Qt.Key.Key_Escape:
            self._tool.cancel()
        elif not self._tool.key(event):
            super().keyPressEvent(event)
        self.refresh()

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """Stop panning when the space bar goes up."""
        if event.key() == Qt.Key.Key_Space and not event.isAutoRepeat():
            self.pan_tool.cancel()
            self._panning = False
            self.refresh()
        else:
            super().keyReleaseEvent(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """Stop panning: the space bar may go up elsewhere."""
        self.pan_tool.cancel()
        self._panning = False
        super().focusOutEvent(event)

    # -- helpers -------------------------------------------------------------------------------

    def _backdrop(self, scheme: theme.Theme) -> QPixmap:
        """Return the empty canvas, painted anew only if it is seen in another way."""
        ratio = self.devicePixelRatioF()
        seen = self.size(), self._camera, ratio, scheme
        if self._backdrop_seen != seen:
            pixmap = QPixmap((self.size().toSizeF() * ratio).toSize())
            pixmap.setDevicePixelRatio(ratio)
            with QPainter(pixmap) as painter:
                painter.setRenderHint(QPainter.RenderHint.Antialiasing)
                painters.paint_backdrop(painter, QRectF(self.rect()), self._camera, scheme)
            self._backdrop_pixmap, self._backdrop_seen = pixmap, seen
        return self._backdrop_pixmap

    def _press(self, pointer: Pointer) -> None:
        if pointer.button == Qt.MouseButton.MiddleButton:
            self._panning = True
        self.tool.press(pointer)
        self.refresh()

    def _move(self, pointer: Pointer) -> None:
        self.tool.move(pointer)
        self.refresh()

    def _release(self, pointer: Pointer) -> None:
        self.tool.release(pointer)
        if pointer.button == Qt.MouseButton.MiddleButton:
            self._panning = False
        self.refresh()


def _pointer(event: QMouseEvent | QTabletEvent, view: CanvasView) -> Pointer:
    spot, camera = event.position(), view.camera
    pen = isinstance(event, QTabletEvent)
    return Pointer(
        camera.to_page(spot),
        spot,
        camera,
        event.button(),
        event.modifiers(),
        event.pressure() if pen else 1.0,
        pen and event.pointerType() == QPointingDevice.PointerType.Eraser,
    )
