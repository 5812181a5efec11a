"""Trace a polygon: click to add, drag to move, click an edge to insert, close on the first."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QKeyEvent, QPainter, QPen

from iconstudio.gui.canvas import painters
from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.canvas.tools.base import Pointer, Tool, nudge
from iconstudio.gui.document.document import new_gesture
from iconstudio.gui.theme.theme import Theme
from iconstudio.model import Point
from iconstudio.workflows.outline import Hit, Outline

GRIP = 9.0
"""Pixels within which the pointer finds a vertex."""

EDGE_GRIP = 6.0
"""Pixels within which the pointer finds an edge."""


class PolygonTool(Tool):
    """Draws and corrects an outline."""

    def __init__(self, outline: Outline) -> None:
        self.outline = outline
        self._hover: Hit | None = None
        self._dragged: int | None = None
        self._gesture = 0
        self._pointer: Pointer | None = None
        self.selected: int | None = None
        outline.document.page_changed.connect(self._page_changed)

    # -- what the canvas shows -----------------------------------------------------------------

    @property
    def token(self) -> str:
        """The colour of the handles."""
        return "accent"

    @property
    def cursor(self) -> Qt.CursorShape:
        """A cross for adding, a hand for what can be taken hold of."""
        if self._hover is None:
            closed = self.outline.closed
            return Qt.CursorShape.ArrowCursor if closed else Qt.CursorShape.CrossCursor
        if self._hover.kind == "edge":
            return Qt.CursorShape.CrossCursor
        return Qt.CursorShape.PointingHandCursor

    @property
    def hint(self) -> str:
        """What can be done now."""
        outline = self.outline
        if outline.closed:
            return "Drag points · click an edge to add · right-click to remove"
        count = len(outline.vertices)
        if count == 0:
            return "Click around the object to trace its outline"
        if count < 3:
            return "Click the next point · Esc gives up"
        return "Click the first point or press Enter to close"

    def paint(self, painter: QPainter, camera: Camera, theme: Theme) -> None:
        """Draw the next edge, the handles, and what a click would do."""
        outline = self.outline
        accent = theme.color(self.token)
        points = _in_view(outline.vertices, camera)
        if len(points) and not outline.closed and self._pointer and self._hover is None:
            painter.setPen(QPen(accent, 1.5, Qt.PenStyle.DashLine))
            painter.drawLine(QPointF(*points[-1].tolist()), self._pointer.view)
        length = np.hypot(*np.diff(points, axis=0).T).sum()
        radius = 2.8 if length < 3 * GRIP * len(points) else 4.0
        for index in self._handles(points):
            self._paint_handle(painter, theme, index, QPointF(*points[index].tolist()), radius)
        if self._hover is not None and self._hover.kind == "edge":
            painter.setPen(QPen(accent, 1.5))
            painter.setBrush(theme.color("surface", 0.8))
            painter.drawEllipse(camera.to_view(self._hover.point), 4.5, 4.5)

    def _handles(self, points: NDArray[np.float64]) -> list[int]:
        """Return the vertices that have a handle; of very many, one where they lie together."""
        if len(points) <= painters.MANY:
            return list(range(len(points)))
        _, first = np.unique(np.floor(points / GRIP), axis=0, return_index=True)
        hovered = self._hover.index if self._hover and self._hover.kind == "vertex" else None
        held = {hovered, self.selected, self._dragged} - {None}
        return sorted({0, *first.tolist(), *held})

    def _paint_handle(
        self, painter: QPainter, theme: Theme, index: int, point: QPointF, radius: float
    ) -> None:
        hovered = self._hover == Hit("vertex", index, self.outline.vertices[index])
        selected = index in (self.selected, self._dragged)
        radius = 6.0 if hovered or selected else radius
        accent = theme.color(self.token)
        if hovered and self._closes(index):
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(theme.color(self.token, 0.25))
            painter.drawEllipse(point, 13, 13)
        painter.setPen(QPen(accent, min(2.0, radius / 2)))
        painter.setBrush(accent if selected else theme.color("surface"))
        if index == 0 and not self.outline.closed:
            painter.drawRect(QRectF(point.x() - radius, point.y() - radius, 2 * radius, 2 * radius))
        else:
            painter.drawEllipse(point, radius, radius)

    # -- pointer -------------------------------------------------------------------------------

    def press(self, pointer: Pointer) -> None:
        """Add, insert, take hold of, or remove a vertex, or close the outline."""
        self.move(pointer)
        hit = self._hover
        if pointer.button == Qt.MouseButton.RightButton:
            if hit is not None and hit.kind == "vertex":
                self._delete(hit.index)
            return
        if hit is None:
            self._press_nowhere(pointer)
        elif hit.kind == "edge":
            self.outline.insert(hit.index, hit.point)
            self._take(hit.index + 1)
        elif self._closes(hit.index):
            self.close_outline()
        else:
            self._take(hit.index)

    def move(self, pointer: Pointer) -> None:
        """Drag the vertex that is held, or look at what lies under the pointer."""
        self._pointer = pointer
        if self._dragged is None:
            self._hover = self.hit(pointer)
        elif pointer.page != self.outline.vertices[self._dragged]:
            self._move(self._dragged, pointer.page)

    def release(self, pointer: Pointer) -> None:
        """Let go of the vertex."""
        self._dragged = None
        self._hover = self.hit(pointer)

    def double_click(self, pointer: Pointer) -> None:
        """Close the outline; the first of the two clicks has put its last vertex here."""
        outline = self.outline
        if outline.closed or pointer.button != Qt.MouseButton.LeftButton:
            return
        self.close_outline()

    def leave(self) -> None:
        """Forget the pointer."""
        self._pointer = None
        self._hover = None

    def hit(self, pointer: Pointer) -> Hit | None:
        """Return the vertex or edge under the pointer; vertices come first."""
        zoom = pointer.camera.zoom
        return self.outline.hit(pointer.page, GRIP / zoom, EDGE_GRIP / zoom)

    # -- keys ----------------------------------------------------------------------------------

    def key(self, event: QKeyEvent) -> bool:
        """Enter closes, Backspace removes, arrows nudge, Page Up and Down select a vertex."""
        key = event.key()
        if key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            return self.close_outline()
        if key in (Qt.Key.Key_Backspace, Qt.Key.Key_Delete):
            return self.delete_selected()
        count = len(self.outline.vertices)
        if count == 0:
            return False
        if key in (Qt.Key.Key_PageUp, Qt.Key.Key_PageDown):
            step = 1 if key == Qt.Key.Key_PageDown else -1
            start = -step if self.selected is None and step == 1 else self.selected or 0
            self.selected = (start + step) % count
            self._gesture = new_gesture()
            return True
        if (step := nudge(event)) is None or self.selected is None:
            return False
        x, y = self.outline.vertices[self.selected]
        self._move(self.selected, (x + step[0], y + step[1]))
        return True

    def cancel(self) -> bool:
        """Give up an open outline; undo brings it back."""
        outline = self.outline
        if outline.closed or not outline.vertices:
            deselected, self.selected = self.selected is not None, None
            return deselected
        self.outline.clear()
        return True

    def close_outline(self) -> bool:
        """Join the last vertex to the first, if there are enough."""
        outline = self.outline
        if outline.closed or len(outline.vertices) < outline.least:
            return False
        self.outline.close()
        self._hover = self._dragged = self.selected = None
        return True

    def delete_selected(self) -> bool:
        """Remove the selected vertex; while tracing, the last one."""
        outline = self.outline
        index = self.selected
        if index is None and not outline.closed and outline.vertices:
            index = len(outline.vertices) - 1
        if index is None:
            return False
        self._delete(index)
        return True

    # -- edits ---------------------------------------------------------------------------------

    def _press_nowhere(self, pointer: Pointer) -> None:
        self.selected = None
        if not self.outline.closed:
            self.outline.add(pointer.page)
            self._take(len(self.outline.vertices) - 1)

    def _closes(self, index: int) -> bool:
        outline = self.outline
        return index == 0 and not outline.closed and len(outline.vertices) >= outline.least

    def _take(self, index: int) -> None:
        self._dragged = index
        self.selected = index if self.outline.closed else None
        self._gesture = new_gesture()
        self._hover = Hit("vertex", index, self.outline.vertices[index])

    def _move(self, index: int, point: Point) -> None:
        self.outline.move(index, point, self._gesture)
        self._hover = Hit("vertex", index, point)

    def _delete(self, index: int) -> None:
        self._dragged = self._hover = self.selected = None
        self.outline.delete(index)

    def _page_changed(self) -> None:
        count = len(self.outline.vertices)
        if self._hover is not None and self._hover.index >= count:
            self._hover = None
        if self.selected is not None and self.selected >= count:
            self.selected = None
        if self._dragged is not None and self._dragged >= count:
            self._dragged = None


def _in_view(vertices: Sequence[Point], camera: Camera) -> NDArray[np.float64]:
    """Return where vertices are seen, (n, 2)."""
    points = np.array(vertices, dtype=np.float64).reshape(-1, 2)
    return camera.zoom * points + (camera.x, camera.y)
