"""Scribble over the parts of an icon to keep, and rub scribbles out."""

import math

from PySide6.QtCore import QObject, QRectF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QPainter, QPen

from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.canvas.tools.base import Pointer
from iconstudio.gui.theme.theme import Theme
from iconstudio.gui.workspaces.montage.appearance import color_of
from iconstudio.gui.workspaces.montage.scene import MontageScene
from iconstudio.gui.workspaces.montage.tools.base import LayerTool
from iconstudio.model import CANVAS, Point
from iconstudio.workflows.montage.page import MontageDocument, MontagePage, choose
from iconstudio.workflows.montage.strokes import strokes_of, visible

THINNEST, WIDEST, USUAL = 2, 64, 14
"""Range of the brush in canvas pixels, and its width at first."""

_APART = 0.8
"""Canvas pixels that the pointer must move for another point."""

_FARTHEST = 2.0 * CANVAS
"""No point of a stroke is farther from the canvas's corner."""

_PIECE = 500
"""Points after which what is drawn so far is not looked at again, however long the line gets."""

_LIGHT = 0.35
"""Part of the brush's width that a pen draws with that hardly presses."""


class Brush(QObject):
    """The width of brush and eraser, in canvas pixels.

    Signals
    -------
    changed(int)
    """

    changed = Signal(int)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.width = USUAL

    def set_width(self, width: int) -> None:
        """Use another width, within the range."""
        width = min(max(width, THINNEST), WIDEST)
        if width != self.width:
            self.width = width
            self.changed.emit(width)

    def step(self, way: int) -> None:
        """Make it about a sixth wider (1) or narrower (-1)."""
        self.set_width(self.width + way * max(1, round(self.width / 6)))


class ScribbleTool(LayerTool):
    """Draws a line; when the pointer lets go, it becomes strokes, or rubs strokes out."""

    def __init__(
        self, document: MontageDocument, scene: MontageScene, brush: Brush, rubs: bool
    ) -> None:
        super().__init__(document, scene)
        self._brush = brush
        self._always_rubs = rubs
        self._rubs = rubs
        self._everywhere = False
        self._points: list[Point] = []
        self._widths: list[float] = []
        self._so_far: MontagePage | None = None
        self._pointer: Pointer | None = None
        brush.changed.connect(scene.changed)

    @property
    def busy(self) -> bool:
        """Whether a line is drawn."""
        return bool(self._points)

    @property
    def cursor(self) -> Qt.CursorShape:
        """None, for the brush itself is drawn; unless there is nothing to draw over."""
        empty = self._document.page.current is None
        return Qt.CursorShape.ArrowCursor if empty else Qt.CursorShape.BlankCursor

    @property
    def hint(self) -> str:
        """What can be done now."""
        layer = self._scene.page.current
        if layer is None:
            return ""
        name = layer.title if len(layer.title) <= 20 else f"{layer.title[:19]}…"
        if self._always_rubs:
            return f"Rub out scribbles of “{name}” · hold Alt for those of all icons"
        return f"Scribble over what to keep of “{name}” · Ctrl+click chooses another icon"

    def paint(self, painter: QPainter, camera: Camera, theme: Theme) -> None:
        """Draw the brush at the pointer."""
        layer = self._scene.page.current
        if self._pointer is None or layer is None:
            return
        width = self._widths[-1] if self._widths else self._brush.width
        radius = max(1.5, width * camera.zoom / 2)
        spot = self._pointer.view
        box = QRectF(spot.x() - radius, spot.y() - radius, 2 * radius, 2 * radius)
        rubs = self._rubs if self._points else self._always_rubs or self._pointer.eraser
        painter.setBrush(theme.color("surface", 0.5) if rubs else Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(theme.color("surface", 0.9), 3))
        painter.drawEllipse(box)
        style = Qt.PenStyle.DashLine if rubs else Qt.PenStyle.SolidLine
        painter.setPen(QPen(theme.color("text") if rubs else color_of(layer), 1.5, style))
        painter.drawEllipse(box)

    # -- pointer -------------------------------------------------------------------------------

    def press(self, pointer: Pointer) -> None:
        """Put the pen down; with Ctrl, choose the icon there."""
        self._pointer = pointer
        page = self._document.page
        if pointer.button != Qt.MouseButton.LeftButton or page.current is None:
            return
        if pointer.modifiers & Qt.KeyboardModifier.ControlModifier:
            found = page.found(pointer.page)
            if found is not None:
                choose(self._document, found.number)
            return
        self._rubs = self._always_rubs or pointer.eraser
        self._everywhere = bool(pointer.modifiers & Qt.KeyboardModifier.AltModifier)
        self._points, self._widths, self._so_far = [], [], None
        self._add(pointer)

    def move(self, pointer: Pointer) -> None:
        """Draw on."""
        self._pointer = pointer
        if self._points and math.dist(self._points[-1], pointer.page) >= _APART:
            self._add(pointer)

    def release(self, pointer: Pointer) -> None:
        """Lift the pen: the line becomes one step."""
        if not self._points:
            return
        after = self._outcome()
        self.cancel()
        if after != self._document.page:
            self._document.change("erase" if self._rubs else "scribble", after)

    def leave(self) -> None:
        """Forget the pointer."""
        self._pointer = None

    def key(self, event: QKeyEvent) -> bool:
        """Do as with all tools."""
        return not self.busy and super().key(event)

    def cancel(self) -> bool:
        """Give up the line."""
        drawing = self.busy
        self._points, self._widths, self._so_far = [], [], None
        self._scene.preview(None)
        return drawing

    def _add(self, pointer: Pointer) -> None:
        x, y = (min(max(value, -_FARTHEST), _FARTHEST) for value in pointer.page)
        self._points.append((x, y))
        pressed = _LIGHT + (1 - _LIGHT) * pointer.pressure
        self._widths.append(self._brush.width * (1.0 if self._rubs else pressed))
        outcome = self._outcome()
        self._scene.preview(outcome)
        if len(self._points) > _PIECE:
            self._so_far = outcome
            del self._points[:-1], self._widths[:-1]

    def _outcome(self) -> MontagePage:
        """Return what the line makes of the page."""
        page = self._so_far or self._document.page
        number = page.current.number
        strokes = strokes_of(self._points, self._widths)
        if self._rubs:
            return page.erased(strokes, None if self._everywhere else number)
        return page.drawn(number, tuple(filter(visible, strokes)))
