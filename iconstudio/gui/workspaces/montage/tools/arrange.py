"""Choose, move and scale icons on the canvas."""

import math
from dataclasses import replace

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QKeyEvent, QPainter, QPen

from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.canvas.tools.base import Pointer, nudge
from iconstudio.gui.document.document import new_gesture
from iconstudio.gui.theme.theme import Theme
from iconstudio.gui.workspaces.montage.appearance import rect_of
from iconstudio.gui.workspaces.montage.scene import MontageScene
from iconstudio.gui.workspaces.montage.tools.base import LayerTool
from iconstudio.model import CANVAS, Point
from iconstudio.workflows.montage.page import MontageDocument, choose
from iconstudio.workflows.montage.snapping import (
    Guides,
    Snapped,
    corners,
    kept_in,
    moved,
    scaled,
)

GRIP = 9.0
"""Pixels within which the pointer finds a handle."""

SNAP = 6.0
"""Pixels at which a dragged icon snaps."""

_FREE = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier


class ArrangeTool(LayerTool):
    """Drags icons about, and their corners to scale them; every drag is one step to undo."""

    def __init__(self, document: MontageDocument, scene: MontageScene) -> None:
        super().__init__(document, scene)
        self._corner: int | None = None
        self._hover = False
        self._start: Point | None = None
        self._snapped: Snapped | None = None
        self._nudges = 0, -1

    @property
    def busy(self) -> bool:
        """Whether an icon is held."""
        return self._start is not None

    # -- what the canvas shows -----------------------------------------------------------------

    @property
    def cursor(self) -> Qt.CursorShape:
        """Arrows for handles, a cross of arrows for icons."""
        if self._corner is not None:
            diagonals = Qt.CursorShape.SizeFDiagCursor, Qt.CursorShape.SizeBDiagCursor
            return diagonals[self._corner % 2]
        return Qt.CursorShape.SizeAllCursor if self._hover else Qt.CursorShape.ArrowCursor

    @property
    def hint(self) -> str:
        """What can be done now."""
        if self._snapped is not None:
            centred = " · Alt scales about the centre" if self._corner is not None else ""
            return f"Hold Shift to place it freely{centred}"
        return "Drag to move · drag a corner to scale · M mirrors · B scribbles what to keep"

    def paint(self, painter: QPainter, camera: Camera, theme: Theme) -> None:
        """Draw the guides that are kept to, and the frame and handles of the chosen icon."""
        layer = self._scene.page.current
        if layer is None:
            return
        accent = theme.color("accent")
        if self._snapped is not None:
            painter.setPen(QPen(accent, 1, Qt.PenStyle.DashLine))
            for x in self._snapped.guides.xs:
                painter.drawLine(camera.to_view((x, 0)), camera.to_view((x, CANVAS)))
            for y in self._snapped.guides.ys:
                painter.drawLine(camera.to_view((0, y)), camera.to_view((CANVAS, y)))
        box = camera.transform.mapRect(rect_of(layer.box))
        painter.setPen(QPen(accent, 1.5))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(box)
        painter.setBrush(theme.color("surface"))
        for spot in map(camera.to_view, corners(layer.box)):
            painter.drawRect(QRectF(spot.x() - 4, spot.y() - 4, 8, 8))

    # -- pointer -------------------------------------------------------------------------------

    def press(self, pointer: Pointer) -> None:
        """Take hold of a handle or an icon; an icon becomes the chosen one."""
        if pointer.button != Qt.MouseButton.LeftButton:
            return
        self._look(pointer)
        if self._corner is None:
            found = self._document.page.found(pointer.page)
            if found is None:
                return
            if found is not self._document.page.current:
                choose(self._document, found.number)
        self._start = pointer.page

    def move(self, pointer: Pointer) -> None:
        """Drag what is held, or look at what lies under the pointer."""
        if self._start is None:
            self._look(pointer)
            return
        layer = self._document.page.current
        far = math.dist(pointer.page, self._start) * pointer.camera.zoom
        if layer is None or (self._snapped is None and far < 3):
            return
        free = bool(pointer.modifiers & _FREE)
        grip = 0.0 if free else SNAP / pointer.camera.zoom
        guides = Guides.of(
            one.box for one in self._document.page.layers if one is not layer and not one.hidden
        )
        by = pointer.page[0] - self._start[0], pointer.page[1] - self._start[1]
        if self._corner is None:
            self._snapped = moved(layer.icon, layer.placement, by, guides, grip)
        else:
            centred = bool(pointer.modifiers & Qt.KeyboardModifier.AltModifier)
            x, y = corners(layer.box)[self._corner]
            to = x + by[0], y + by[1]
            self._snapped = scaled(
                layer.icon, layer.placement, self._corner, to, centred, guides, grip
            )
        placement = self._snapped.placement
        self._scene.preview(self._document.page.placed(layer.number, placement))

    def release(self, pointer: Pointer) -> None:
        """Let go: the gesture becomes one step."""
        snapped, layer = self._snapped, self._document.page.current
        text = "move icon" if self._corner is None else "scale icon"
        self.cancel()
        if snapped is not None and layer is not None and snapped.placement != layer.placement:
            after = self._document.page.placed(layer.number, snapped.placement)
            self._document.change(text, after)
        self._look(pointer)

    def leave(self) -> None:
        """Forget the pointer."""
        if self._start is None:
            self._corner, self._hover = None, False

    # -- keys ----------------------------------------------------------------------------------

    def key(self, event: QKeyEvent) -> bool:
        """Arrows nudge; the rest as with all tools."""
        if super().key(event):
            return True
        step, layer = nudge(event), self._document.page.current
        if step is None or layer is None or self.busy:
            return False
        old = layer.placement
        new = kept_in(layer.icon, replace(old, dx=old.dx + step[0], dy=old.dy + step[1]))
        if new != old:
            # Nudges of one icon in a row are one step.
            if self._nudges[1] != layer.number or not event.isAutoRepeat():
                self._nudges = new_gesture(), layer.number
            after = self._document.page.placed(layer.number, new)
            self._document.change("nudge icon", after, self._nudges[0])
        return True

    def cancel(self) -> bool:
        """Put what is held back where it was."""
        held = self._start is not None
        self._start = self._snapped = self._corner = None
        self._scene.preview(None)
        return held

    # -- helpers -------------------------------------------------------------------------------

    def _look(self, pointer: Pointer) -> None:
        layer = self._document.page.current
        self._corner = None
        if layer is not None:
            spots = map(pointer.camera.to_view, corners(layer.box))
            gaps = [math.dist(spot.toTuple(), pointer.view.toTuple()) for spot in spots]
            if min(gaps) <= GRIP:
                self._corner = gaps.index(min(gaps))
        self._hover = self._document.page.found(pointer.page) is not None
