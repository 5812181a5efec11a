"""Tools for areas and lines on a page: draw some of a kind, select and correct them."""

import math

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QKeyEvent, QPainter, QPen, QPolygonF

from iconstudio.algorithms.geometry import near, simplified, simplified_line
from iconstudio.gui.canvas import painters
from iconstudio.gui.canvas.areas import TOKENS
from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.canvas.tools.base import Pointer, nudge
from iconstudio.gui.canvas.tools.polygon import GRIP, PolygonTool
from iconstudio.gui.document.document import new_gesture
from iconstudio.gui.theme.theme import Theme
from iconstudio.model import IconstudioError, Point, Polygon
from iconstudio.workflows.areas import Area, AreaOutline, Kind

FREEHAND = 5.0
"""Pixels that the pointer must be dragged to draw freehand: less is a click."""

STRAY = 2.5
"""Pixels that the corners kept of a freehand line may stray from it."""


_BEFORE = {
    Kind.REMOVE: "Remove: drag around what should go, or click its corners",
    Kind.ADD: "Add: drag the outline of what should come, or click its corners",
    Kind.HOLE: "Hole: drag around where paper should show, or click its corners",
    Kind.LINE: "Line: drag a line inside the outline, or click its points",
}
_AFTER = {
    Kind.REMOVE: "Now add what should come (A) · drag points to correct",
    Kind.ADD: "Mark more, or drag points to correct",
    Kind.HOLE: "Draw more holes, or drag points to correct",
    Kind.LINE: "Draw more lines, or drag points to correct",
}
_MISSED = (
    "That encloses nothing: drag all the way around, or click corners",
    "That is too short for a line: drag on, or click its points",
)
_MARKED = "Mark more · V selects areas to correct them"
"""What a tool says before an area is drawn, after that, and if there are others only."""


class AreaTool(PolygonTool):
    """Corrects the selected area, as any outline is corrected."""

    outline: AreaOutline

    @property
    def token(self) -> str:
        """The colour of the handles: that of the area."""
        area = self.outline.area
        return "accent" if area is None else TOKENS[area.kind]

    def cancel(self) -> bool:
        """Give up what is being traced, or deselect."""
        if super().cancel():
            return True
        selected = self.outline.index is not None
        self.outline.select(None)
        return selected

    def delete_selected(self) -> bool:
        """Remove the selected vertex, or else the selected area; while tracing, the last vertex."""
        if super().delete_selected():
            return True
        selected = self.outline.index is not None
        self.outline.remove()
        return selected

    def _closes(self, index: int) -> bool:
        """Whether a click on a vertex finishes the area: a line, on its last one."""
        area = self.outline.area
        if area is None or area.kind is not Kind.LINE:
            return super()._closes(index)
        count = len(area.vertices)
        return not area.closed and count >= area.least and index == count - 1

    def _press_nowhere(self, pointer: Pointer) -> None:
        if self.outline.closed:
            self.selected = None
            self.begin(pointer)
        else:
            super()._press_nowhere(pointer)

    def begin(self, pointer: Pointer) -> None:
        """Begin something where no outline is, and none is being traced."""
        raise NotImplementedError

    def _page_changed(self) -> None:
        self.outline.follow_page()
        super()._page_changed()


class DrawTool(AreaTool):
    """Draws areas of a kind: press and drag around them, or click their corners."""

    def __init__(self, outline: AreaOutline, kind: Kind) -> None:
        super().__init__(outline)
        self.kind = kind
        self._stroke: list[Point] = []
        self._began: Pointer | None = None
        self._missed = False

    @property
    def cursor(self) -> Qt.CursorShape:
        """A cross, but for what can be taken hold of."""
        shape = super().cursor
        return Qt.CursorShape.CrossCursor if shape == Qt.CursorShape.ArrowCursor else shape

    @property
    def hint(self) -> str:
        """What can be done now."""
        if self._stroke:
            return f"Let go to finish the {_noun(self.kind)}"
        if not self.outline.closed:
            return self._hint_while_tracing
        if self._missed:
            return _MISSED[self.kind is Kind.LINE]
        if self.outline.area is not None:
            return _AFTER[self.kind]
        return _MARKED if self.outline.document.page.areas else _BEFORE[self.kind]

    @property
    def _hint_while_tracing(self) -> str:
        if self.kind is not Kind.LINE:
            return super().hint
        enough = len(self.outline.vertices) >= self.outline.least
        end = "double-click or press Enter to end" if enough else "Esc gives up"
        return f"Click the next point · {end}"

    def move(self, pointer: Pointer) -> None:
        """Draw on, or do what is done with any outline."""
        if self._began is None:
            super().move(pointer)
            return
        self._pointer = pointer
        gap = pointer.view - self._began.view
        if self._stroke:
            self._stroke.append(pointer.page)
        elif math.hypot(gap.x(), gap.y()) >= FREEHAND:
            self._stroke = [self._began.page, pointer.page]

    def release(self, pointer: Pointer) -> None:
        """Finish what was drawn freehand; after a click, go on corner by corner."""
        began, self._began = self._began, None
        stroke, self._stroke = self._stroke, []
        if began is None:
            super().release(pointer)
        elif stroke:
            self._draw(stroke, pointer.camera)
        else:
            self.outline.begin(self.kind, began.page)
            super().release(pointer)

    def cancel(self) -> bool:
        """Give up what is drawn now, or do what Escape does to any area."""
        drawing = self._began is not None
        self._began, self._stroke = None, []
        return drawing or super().cancel()

    def paint(self, painter: QPainter, camera: Camera, theme: Theme) -> None:
        """Draw the line that is under way, too."""
        super().paint(painter, camera, theme)
        if self._stroke:
            painter.setPen(QPen(theme.color(TOKENS[self.kind]), 2))
            ring = self.kind is not Kind.LINE
            if ring:
                painter.setBrush(theme.color(TOKENS[self.kind], 0.15))
            painter.drawPath(painters.outline_path(self._stroke, ring, camera))

    def begin(self, pointer: Pointer) -> None:
        """Begin another area."""
        self.outline.select(None)
        self._began = pointer
        self._missed = False

    def _draw(self, stroke: list[Point], camera: Camera) -> None:
        stray = STRAY / camera.zoom
        if self.kind is Kind.LINE:
            vertices = simplified_line(stroke, stray)
            self._missed = len(vertices) < 2
        else:
            polygon = simplified(Polygon.of(stroke), stray)
            vertices, self._missed = polygon.vertices, not _encloses(polygon)
        if not self._missed:
            self.outline.draw(self.kind, vertices)


class SelectTool(AreaTool):
    """Selects areas, moves them, and corrects their outlines."""

    def __init__(self, outline: AreaOutline, click: str, nothing: str) -> None:
        """``click`` is said where something can be selected, and ``nothing`` where not."""
        super().__init__(outline)
        self._click, self._nothing = click, nothing
        self._held: Point | None = None

    @property
    def cursor(self) -> Qt.CursorShape:
        """An arrow, but for what can be moved."""
        shape = super().cursor
        above = self._pointer is not None and self._area_at(self._pointer) is not None
        free = shape == Qt.CursorShape.ArrowCursor
        return Qt.CursorShape.SizeAllCursor if free and above else shape

    @property
    def hint(self) -> str:
        """What can be done now."""
        if not self.outline.closed:
            return super().hint
        if self.outline.area is not None:
            return f"Drag the {_noun(self.outline.area.kind)} or its points · Backspace removes it"
        if self.outline.document.page.areas:
            return self._click
        return self._nothing

    def move(self, pointer: Pointer) -> None:
        """Take the area along, or do what is done with any outline."""
        if self._held is None:
            super().move(pointer)
            return
        self._pointer = pointer
        if pointer.page != self._held:
            (x, y), (x0, y0) = pointer.page, self._held
            self.outline.shift(x - x0, y - y0, self._gesture)
            self._held = pointer.page

    def release(self, pointer: Pointer) -> None:
        """Let go."""
        self._held = None
        super().release(pointer)

    def key(self, event: QKeyEvent) -> bool:
        """Move the area with the arrow keys, unless one of its points is selected."""
        if super().key(event):
            return True
        if (step := nudge(event)) is None or self.outline.area is None:
            return False
        self.outline.shift(*step, ("nudge", self.outline.index))
        return True

    def begin(self, pointer: Pointer) -> None:
        """Select the area there, and take hold of it."""
        self.outline.select(self._area_at(pointer))
        if self.outline.area is not None:
            self._held = pointer.page
            self._gesture = new_gesture()

    def _area_at(self, pointer: Pointer) -> int | None:
        """Return the area that is seen there: what is removed lies below the others."""
        areas = self.outline.document.page.areas
        order = sorted(range(len(areas)), key=lambda i: (areas[i].kind is not Kind.REMOVE, i))
        return next((i for i in reversed(order) if _holds(areas[i], pointer)), None)


def _noun(kind: Kind) -> str:
    return "area" if kind in (Kind.REMOVE, Kind.ADD) else kind.noun


def _holds(area: Area, pointer: Pointer) -> bool:
    if area.kind is Kind.LINE:
        reach = GRIP / pointer.camera.zoom
        return bool(near(np.array([pointer.page]), area.vertices, reach)[0])
    shape = QPolygonF([QPointF(*vertex) for vertex in area.vertices])
    return shape.containsPoint(QPointF(*pointer.page), Qt.FillRule.WindingFill)


def _encloses(polygon: Polygon) -> bool:
    """Whether a polygon is more than a stroke to and fro."""
    try:
        polygon.fitted()
    except IconstudioError:
        return False
    return True
