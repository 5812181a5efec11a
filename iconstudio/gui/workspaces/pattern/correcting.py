"""Say with a brush which layer a part of an image is of."""

import math

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen, QPolygonF

from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.canvas.tools.base import Pointer, Tool
from iconstudio.gui.theme.theme import Theme
from iconstudio.gui.workspaces.montage.tools.scribble import Brush
from iconstudio.gui.workspaces.pattern.scene import PatternScene, tint
from iconstudio.model import CANVAS, Photo, Point, Stroke
from iconstudio.workflows.pattern import page as edits
from iconstudio.workflows.pattern.page import PatternDocument

_APART = 1.5
"""Device-independent pixels that the pointer moves for another point."""


class CorrectTool(Tool):
    """Draws a line over an image; what it covers is of the layer that is chosen."""

    def __init__(self, document: PatternDocument, scene: PatternScene, brush: Brush) -> None:
        self._document, self._scene, self._brush = document, scene, brush
        self.layer = 1
        """The number of the layer that the brush gives."""
        self._points: list[Point] = []
        self._pointer: Pointer | None = None
        brush.changed.connect(scene.changed)

    @property
    def cursor(self) -> Qt.CursorShape:
        """None, for the brush itself is drawn."""
        return Qt.CursorShape.ArrowCursor if self._photo is None else Qt.CursorShape.BlankCursor

    @property
    def hint(self) -> str:
        """What can be done now."""
        layer = "the ground" if self.layer == 0 else f"layer {self.layer}"
        return f"Paint over what belongs to {layer} · choose another layer below"

    def paint(self, painter: QPainter, camera: Camera, theme: Theme) -> None:
        """Draw the line, and the brush at the pointer."""
        if self._photo is None:
            return
        width = self._width * camera.zoom
        if self._points:
            line = QPolygonF([camera.to_view(point) for point in self._points])
            line.append(line.last() + QPointF(0.01, 0))
            cap, join = Qt.PenCapStyle.RoundCap, Qt.PenJoinStyle.RoundJoin
            color = tint(self.layer, 0.8)
            painter.setPen(QPen(color, width, Qt.PenStyle.SolidLine, cap, join))
            painter.drawPolyline(line)
        if self._pointer is not None:
            box = QRectF(0, 0, width, width)
            box.moveCenter(self._pointer.view)
            painter.setBrush(Qt.BrushStyle.NoBrush)
            for color, line_width in ((theme.color("surface", 0.9), 3), (tint(self.layer), 1.5)):
                painter.setPen(QPen(color, line_width))
                painter.drawEllipse(box)

    def press(self, pointer: Pointer) -> None:
        """Put the brush down."""
        self._pointer = pointer
        if pointer.button == Qt.MouseButton.LeftButton and self._photo is not None:
            self._points = [pointer.page]

    def move(self, pointer: Pointer) -> None:
        """Draw on."""
        self._pointer = pointer
        if self._points:
            gap = _APART / pointer.camera.zoom
            if math.dist(self._points[-1], pointer.page) >= gap:
                self._points.append(pointer.page)

    def release(self, pointer: Pointer) -> None:
        """Lift the brush: the line is one step."""
        points = tuple((round(x, 1), round(y, 1)) for x, y in self._points)
        self.cancel()
        if points and self._photo is not None:
            edits.correct(self._document, self.layer, Stroke(round(self._width, 1), points))

    def leave(self) -> None:
        """Forget the pointer."""
        self._pointer = None

    def cancel(self) -> bool:
        """Give up the line."""
        drawing = bool(self._points)
        self._points = []
        return drawing

    @property
    def _photo(self) -> Photo | None:
        image = self._document.page.work.image
        return None if image is None else image.photo

    @property
    def _width(self) -> float:
        """Of the brush, in pixels of the image."""
        return self._brush.width * max(self._photo.width, self._photo.height) / CANVAS
