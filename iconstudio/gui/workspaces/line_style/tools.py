"""What the pointer does on the canvas of line styles: select lines, and draw some."""

import math
from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QKeyEvent, QPainter, QPen

from iconstudio.grammar import counted
from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.canvas.tools.base import Pointer, Tool
from iconstudio.gui.theme.theme import Theme
from iconstudio.gui.workspaces.line_style.scene import RestyleScene, outline, pen
from iconstudio.inputs.wide_points import FAR
from iconstudio.model import Line, Point, Restyling
from iconstudio.workflows.line_style import page as edits
from iconstudio.workflows.line_style.page import WIDTH, RestyleDocument
from iconstudio.workflows.line_style.selecting import line_at, lines_in

_REACH = 7.0
"""A click within so many device-independent pixels of a line means that line."""
_APART = 0.8
"""Canvas units that the pen must move for another point."""
_LIGHT = 0.25
"""Width of what a pen draws that is hardly pressed, over what it draws at full pressure."""


class SelectTool(Tool):
    """A click selects a line, a drag all lines in a box; with Shift, more of them."""

    def __init__(self, document: RestyleDocument, scene: RestyleScene) -> None:
        self._document, self._scene = document, scene
        self._start: Pointer | None = None
        self._now: Pointer | None = None

    @property
    def hint(self) -> str:
        """What can be done now."""
        page = self._document.page
        if page.work.style is None:
            return "Choose a style on the left, or draw an example"
        if page.selected:
            what = counted(len(page.selected), "line")
            verb = "is" if len(page.selected) == 1 else "are"
            return f"{what} {verb} selected: the next style that you choose is for them only"
        return "Click lines, or drag a box around some, to give them a style of their own"

    def press(self, pointer: Pointer) -> None:
        """Begin a box."""
        if pointer.button == Qt.MouseButton.LeftButton:
            self._start = self._now = pointer

    def move(self, pointer: Pointer) -> None:
        """Draw the box on."""
        if self._start is not None:
            self._now = pointer

    def release(self, pointer: Pointer) -> None:
        """Select what was clicked, or what is in the box."""
        start = self._start
        if start is None:
            return
        self.cancel()
        lines, page = self._scene.lines, self._document.page
        gap = pointer.view - start.view
        if math.hypot(gap.x(), gap.y()) < 4:
            found = line_at(lines, pointer.page, _REACH / pointer.camera.zoom)
            hit = frozenset() if found is None else frozenset({found})
        else:
            hit = lines_in(lines, start.page, pointer.page)
        more = bool(start.modifiers & Qt.KeyboardModifier.ShiftModifier)
        edits.select(self._document, page.selected ^ hit if more else hit)

    def key(self, event: QKeyEvent) -> bool:
        """Select all with Ctrl+A; remove drawn lines with Delete."""
        control = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        if event.key() == Qt.Key.Key_A and control:
            edits.select(self._document, frozenset(range(len(self._scene.lines))))
            return True
        if event.key() == Qt.Key.Key_Delete:
            edits.remove_strokes(self._document, self._scene.first_stroke)
            return True
        return False

    def cancel(self) -> bool:
        """Give up the box; else select nothing."""
        drawing = self._start is not None
        self._start = self._now = None
        if not drawing and self._document.page.selected:
            edits.select(self._document, frozenset())
            return True
        return drawing

    def paint(self, painter: QPainter, camera: Camera, theme: Theme) -> None:
        """Draw the box."""
        if self._start is None or self._now is None:
            return
        box = QRectF(camera.to_view(self._start.page), self._now.view).normalized()
        painter.setPen(QPen(theme.color("accent"), 1))
        painter.setBrush(theme.color("accent", 0.12))
        painter.drawRect(box)


class PenTool(Tool):
    """Draws a line freehand, as wide as a pen presses; what is made of it follows.

    ``preview`` is called with the work as it is about to become.
    """

    def __init__(
        self, document: RestyleDocument, scene: RestyleScene, preview: Callable[[Restyling], object]
    ) -> None:
        self._document, self._scene, self._preview = document, scene, preview
        self._points: list[Point] = []
        self._widths: list[float] = []

    @property
    def cursor(self) -> Qt.CursorShape:
        """A cross."""
        return Qt.CursorShape.CrossCursor

    @property
    def hint(self) -> str:
        """What can be done now."""
        if self._document.page.work.style is None:
            return "Draw lines, and choose a style on the left"
        return "Draw lines freehand: they take the style"

    def press(self, pointer: Pointer) -> None:
        """Put the pen down."""
        if pointer.button == Qt.MouseButton.LeftButton:
            self._points, self._widths = [], []
            self._add(pointer)

    def move(self, pointer: Pointer) -> None:
        """Draw on."""
        if self._points and math.dist(self._points[-1], pointer.page) >= _APART:
            self._add(pointer)
            work = self._document.page.work
            self._preview(replace(work, strokes=(*work.strokes, self._line())))

    def release(self, pointer: Pointer) -> None:
        """Lift the pen: the line is on the page, if it is one."""
        line = self._line()
        self._points = []
        if len(set(line.points)) > 1:
            edits.add_stroke(self._document, line)

    def cancel(self) -> bool:
        """Give up the line."""
        drawing = bool(self._points)
        self._points = []
        if drawing:
            self._preview(self._document.page.work)
        return drawing

    def paint(self, painter: QPainter, camera: Camera, theme: Theme) -> None:
        """Draw the line."""
        if len(self._points) < 2:
            return
        painter.save()
        painter.setTransform(camera.transform, True)
        painter.strokePath(outline(self._line()), pen(theme.color("accent", 0.5), WIDTH))
        painter.restore()

    def _add(self, pointer: Pointer) -> None:
        self._points.append(_clamped(pointer.page))
        self._widths.append(round(WIDTH * (_LIGHT + (1 - _LIGHT) * pointer.pressure), 2))

    def _line(self) -> Line:
        varied = any(width != WIDTH for width in self._widths)
        widths = tuple(self._widths) if varied else ()
        return Line(tuple(self._points), width=WIDTH, widths=widths)


def _clamped(point: Point) -> Point:
    x, y = (min(max(value, -FAR), FAR) for value in point)
    return x, y
