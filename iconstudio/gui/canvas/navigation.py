"""A widget that looks at something through a camera: zoom, pan and fit."""

from typing import ClassVar

from PySide6.QtCore import QEvent, QPointF, QRectF, Qt
from PySide6.QtGui import QInputDevice, QNativeGestureEvent, QResizeEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.theme.theme import UNIT

ZOOM_STEP = 1.25


class CameraView(QWidget):
    """Zooms with the wheel, pans with a touch pad, pinches; keeps the content fitted if it was."""

    covered: ClassVar[tuple[float, float]] = (0.0, 0.0)
    """How high the upper and the lower end are that may be covered, in pixels: the content is
    fitted between them."""

    def __init__(self) -> None:
        super().__init__()
        self._camera = Camera()
        self._fitted = True

    def content(self) -> QRectF:
        """Return the area that ``fit`` shows."""
        raise NotImplementedError

    @property
    def camera(self) -> Camera:
        """Which part of the page is shown."""
        return self._camera

    def fit(self) -> None:
        """Show the whole content."""
        self._camera = self._fitting()
        self._fitted = True
        self.update()

    def zoom_by(self, factor: float, anchor: QPointF | None = None) -> None:
        """Zoom about ``anchor``, by default the middle."""
        middle = QPointF(self.width() / 2, self.height() / 2)
        self._camera = self._camera.zoomed(factor, anchor or middle, self._fitting().zoom)
        self._fitted = False
        self.update()

    def zoom_in(self) -> None:
        """Zoom in by a step."""
        self.zoom_by(ZOOM_STEP)

    def zoom_out(self) -> None:
        """Zoom out by a step."""
        self.zoom_by(1 / ZOOM_STEP)

    def pan(self, by: QPointF) -> None:
        """Move the content by view pixels."""
        self._camera = self._camera.panned(by)
        self._fitted = False
        self.update()

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

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Keep the content fitted, or its middle in the middle."""
        if self._fitted or not event.oldSize().isValid():
            self.fit()
        else:
            change = event.size() - event.oldSize()
            self._camera = self._camera.panned(QPointF(change.width(), change.height()) / 2)

    def _fitting(self) -> Camera:
        margin = 3 * UNIT
        above, below = (max(margin, covered) for covered in self.covered)
        room = QRectF(self.rect()).adjusted(margin, above, -margin, -below)
        return Camera.fitting(self.content(), room)
