"""Which part of the page the canvas shows."""

from dataclasses import dataclass, replace

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QTransform

from iconstudio.model import Point

LEAST, MOST = 0.02, 64.0
"""Range of the zoom, in device-independent pixels per page unit."""


@dataclass(frozen=True, slots=True)
class Camera:
    """A page point p is seen at ``zoom * p + (x, y)``."""

    zoom: float = 1.0
    x: float = 0.0
    y: float = 0.0

    @classmethod
    def fitting(cls, area: QRectF, room: QRectF) -> "Camera":
        """Return the camera that shows the whole ``area`` in the middle of ``room``, in pixels."""
        width, height = max(1.0, room.width()), max(1.0, room.height())
        zoom = min(width / max(area.width(), 1e-9), height / max(area.height(), 1e-9))
        shift = room.center() - zoom * area.center()
        return cls(zoom, shift.x(), shift.y())

    def to_page(self, point: QPointF) -> Point:
        """Return the page point seen at ``point``."""
        return (point.x() - self.x) / self.zoom, (point.y() - self.y) / self.zoom

    def to_view(self, point: Point) -> QPointF:
        """Return where a page point is seen."""
        return QPointF(self.zoom * point[0] + self.x, self.zoom * point[1] + self.y)

    def zoomed(self, factor: float, anchor: QPointF, base: float = 1.0) -> "Camera":
        """Return the camera zoomed by ``factor`` while ``anchor`` stays where it is.

        ``base`` is the zoom that fits the page; the range of the zoom is relative to it.
        """
        zoom = min(max(self.zoom * factor, LEAST * base), MOST * base)
        x, y = self.to_page(anchor)
        return Camera(zoom, anchor.x() - zoom * x, anchor.y() - zoom * y)

    def panned(self, by: QPointF) -> "Camera":
        """Return the camera with the page moved ``by`` pixels."""
        return replace(self, x=self.x + by.x(), y=self.y + by.y())

    @property
    def transform(self) -> QTransform:
        """The mapping from page to view."""
        return QTransform(self.zoom, 0, 0, self.zoom, self.x, self.y)
