"""Choose, move, resize and turn the motifs of an exemplar."""

import math
from enum import Enum, auto

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QKeyEvent, QPainter, QPen, QPolygonF

from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.canvas.tools.base import Pointer, Tool, nudge
from iconstudio.gui.document.document import Document, new_gesture
from iconstudio.gui.theme.theme import Theme
from iconstudio.gui.workspaces.pattern.scene import PatternScene
from iconstudio.model import CANVAS, Motif, Point
from iconstudio.workflows.pattern import page as edits
from iconstudio.workflows.pattern.page import PatternPage

GRIP = 9.0
"""Pixels within which the pointer finds a handle."""
_AROUND, _STALK = 5.0, 20.0
"""Pixels from a motif to its frame, and from that to the handle that turns it."""
_STILL = 3.0
"""Pixels that the pointer moves at least in a drag."""
_QUARTER = 15.0
"""Degrees to which Shift keeps."""
_HALO = QColor(255, 255, 255, 150)
"""Around frames: the ground of an exemplar is of any colour."""
_SMALLEST, _LARGEST = 6.0, 4.0 * CANVAS
"""Sides of motifs that are dragged."""


class Hold(Enum):
    """What the pointer has hold of."""

    MOTIFS = auto()
    CORNER = auto()
    STALK = auto()
    """The handle that turns."""
    BAND = auto()
    """Nothing: a band is drawn around what is to be chosen."""


class ArrangeTool(Tool):
    """Drags motifs about; every drag is one step to undo.

    The topmost chosen motif has handles. What they do happens to all chosen ones, each about its
    own middle.
    """

    def __init__(self, document: Document[PatternPage], scene: PatternScene) -> None:
        self._document, self._scene = document, scene
        self._hold: Hold | None = None
        self._start: Pointer | None = None
        self._now: Pointer | None = None
        self._begun = PatternPage()
        self._moved = False
        self._gesture: object = None
        self._hover: Hold | None = None
        self._nudges: object = None

    # -- what the canvas shows -----------------------------------------------------------------

    @property
    def cursor(self) -> Qt.CursorShape:
        """What dragging would do here."""
        match self._hold or self._hover:
            case Hold.CORNER:
                return Qt.CursorShape.SizeFDiagCursor
            case Hold.STALK:
                return Qt.CursorShape.OpenHandCursor
            case Hold.MOTIFS:
                return Qt.CursorShape.SizeAllCursor
        return Qt.CursorShape.ArrowCursor

    @property
    def hint(self) -> str:
        """What can be done now."""
        if self._hold is Hold.STALK:
            return "Hold Shift to turn by steps"
        if self._moved:
            return ""
        if not self._document.page.chosen:
            return "Click an icon, or drag a band around several · Ctrl+A chooses all"
        return "Drag to move · handles resize and turn · M mirrors · Delete removes"

    def paint(self, painter: QPainter, camera: Camera, theme: Theme) -> None:
        """Draw frames, handles and the band."""
        page = self._document.page
        accent = theme.color("accent")
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for number in page.chosen:
            frame = self._frame(page.work.motifs[number], camera)
            for color, width in ((_HALO, 3.0), (accent, 1.5)):
                painter.setPen(QPen(color, width))
                painter.drawPolygon(frame)
        if (motif := self._handled) is not None and self._hold is not Hold.BAND:
            self._paint_handles(painter, self._frame(motif, camera), theme)
        if self._hold is Hold.BAND and self._moved:
            painter.setPen(QPen(accent, 1))
            painter.setBrush(theme.color("accent", 0.12))
            painter.drawRect(QRectF(self._start.view, self._now.view).normalized())

    def _paint_handles(self, painter: QPainter, frame: QPolygonF, theme: Theme) -> None:
        end, foot = stalk(frame)
        painter.setPen(QPen(theme.color("accent"), 1.5))
        painter.drawLine(foot, end)
        painter.setBrush(QColor("white"))
        painter.drawEllipse(end, 4.5, 4.5)
        for corner in frame:
            painter.drawRect(QRectF(corner.x() - 4, corner.y() - 4, 8, 8))

    # -- pointer -------------------------------------------------------------------------------

    def press(self, pointer: Pointer) -> None:
        """Take hold of a handle or a motif, which becomes a chosen one; or begin a band."""
        if pointer.button != Qt.MouseButton.LeftButton:
            return
        self._hold, page = self._found(pointer), self._document.page
        if self._hold is Hold.MOTIFS:
            number = self._number(pointer)
            if pointer.modifiers & Qt.KeyboardModifier.ShiftModifier:
                edits.choose(self._document, page.chosen ^ {number})
                self._hold = Hold.MOTIFS if number in self._document.page.chosen else None
            elif number not in page.chosen:
                edits.choose(self._document, frozenset({number}))
        self._start = self._now = pointer
        self._begun, self._moved, self._gesture = self._document.page, False, new_gesture()

    def move(self, pointer: Pointer) -> None:
        """Drag what is held, or look at what lies under the pointer."""
        if self._start is None:
            self._hover = self._found(pointer)
            return
        self._moved = self._moved or _far(pointer, self._start) >= _STILL
        if self._moved:
            match self._hold:
                case Hold.MOTIFS:
                    self._drag(pointer)
                case Hold.CORNER:
                    self._resize(pointer)
                case Hold.STALK:
                    self._turn(pointer)
        self._now = pointer

    def release(self, pointer: Pointer) -> None:
        """Let go; of several motifs one that is only clicked becomes the only one."""
        start, hold, moved = self._start, self._hold, self._moved
        self._let_go()
        if start is None:
            return
        more = bool(start.modifiers & Qt.KeyboardModifier.ShiftModifier)
        page = self._document.page
        if hold is Hold.BAND:
            box = QRectF(QPointF(*start.page), QPointF(*pointer.page)).normalized()
            hit = self._scene.shapes.within(page.work.motifs, box) if moved else frozenset()
            edits.choose(self._document, page.chosen | hit if more else hit)
        elif hold is Hold.MOTIFS and not moved and not more:
            number = self._number(pointer)
            edits.choose(self._document, frozenset() if number is None else frozenset({number}))
        self._hover = self._found(pointer)

    def leave(self) -> None:
        """Forget the pointer."""
        self._hover = None

    def cancel(self) -> bool:
        """Put what is held back where it was; else choose nothing."""
        begun, held, moved = self._begun, self._start is not None, self._moved
        self._let_go()
        if held:
            if moved and self._document.page.work != begun.work:
                self._document.undo_stack.undo()
        elif self._document.page.chosen:
            edits.choose(self._document, frozenset())
            return True
        return held

    def key(self, event: QKeyEvent) -> bool:
        """Arrows nudge; Ctrl+A chooses all, Delete removes."""
        page, step = self._document.page, nudge(event)
        if event.key() == Qt.Key.Key_A and event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            edits.choose(self._document, frozenset(range(len(page.work.motifs))))
        elif event.key() == Qt.Key.Key_Delete:
            edits.remove_chosen(self._document)
        elif step is not None and page.chosen and self._start is None:
            # Nudges as long as a key is held are one step.
            if not event.isAutoRepeat():
                self._nudges = new_gesture()
            dx, dy = _kept_in(page, *step)
            edits.move_chosen(self._document, dx, dy, self._nudges)
        else:
            return False
        return True

    # -- drags ---------------------------------------------------------------------------------

    def _drag(self, pointer: Pointer) -> None:
        wanted, done = (
            _kept_in(self._begun, *_between(self._start, one)) for one in (pointer, self._now)
        )
        by = wanted[0] - done[0], wanted[1] - done[1]
        edits.move_chosen(self._document, *by, self._gesture)

    def _resize(self, pointer: Pointer) -> None:
        sides = [self._begun.work.motifs[number].size for number in self._begun.chosen]
        least, most = _SMALLEST / min(sides), _LARGEST / max(sides)
        first = max(_distance(self._middle, self._start), 1e-3)
        wanted, done = (
            min(max(_distance(self._middle, one) / first, least), most)
            for one in (pointer, self._now)
        )
        edits.resize_chosen(self._document, wanted / done, self._gesture)

    def _turn(self, pointer: Pointer) -> None:
        motif = self._handled
        by = _angle(self._middle, pointer) - _angle(self._middle, self._now)
        if pointer.modifiers & Qt.KeyboardModifier.ShiftModifier:
            upright = _angle(self._middle, pointer) + 90
            by = round(upright / _QUARTER) * _QUARTER - motif.turn
        edits.turn_chosen(self._document, by, self._gesture)

    @property
    def _handled(self) -> Motif | None:
        """The motif with the handles."""
        page = self._document.page
        return page.work.motifs[max(page.chosen)] if page.chosen else None

    @property
    def _middle(self) -> Point:
        motif = self._handled
        return motif.x, motif.y

    def _let_go(self) -> None:
        self._hold = self._start = self._now = None
        self._moved = False

    # -- helpers -------------------------------------------------------------------------------

    def _frame(self, motif: Motif, camera: Camera) -> QPolygonF:
        frame = self._scene.shapes.frame(motif, _AROUND / camera.zoom)
        return QPolygonF([camera.to_view(corner.toTuple()) for corner in frame])

    def _number(self, pointer: Pointer) -> int | None:
        reach = _AROUND / pointer.camera.zoom
        motifs = self._document.page.work.motifs
        return self._scene.shapes.found(motifs, pointer.page, reach)

    def _found(self, pointer: Pointer) -> Hold:
        """Return what is under the pointer."""
        if (motif := self._handled) is not None:
            frame = self._frame(motif, pointer.camera)
            if _near(stalk(frame)[0], pointer.view):
                return Hold.STALK
            if any(_near(corner, pointer.view) for corner in frame):
                return Hold.CORNER
        return Hold.BAND if self._number(pointer) is None else Hold.MOTIFS


def stalk(frame: QPolygonF) -> tuple[QPointF, QPointF]:
    """Return where the handle that turns is, above the frame, and where it is fixed."""
    left, right, under = frame[0], frame[1], frame[3]
    foot, up = (left + right) / 2, left - under
    length = math.hypot(up.x(), up.y())
    return foot + up * (_STALK / max(length, 1e-6)), foot


def _near(one: QPointF, other: QPointF) -> bool:
    gap = one - other
    return math.hypot(gap.x(), gap.y()) <= GRIP


def _far(one: Pointer, other: Pointer) -> float:
    gap = one.view - other.view
    return math.hypot(gap.x(), gap.y())


def _between(start: Pointer, end: Pointer) -> Point:
    return end.page[0] - start.page[0], end.page[1] - start.page[1]


def _kept_in(page: PatternPage, dx: float, dy: float) -> Point:
    """Return how far the chosen motifs can move together with all middles on the canvas."""
    chosen = [page.work.motifs[number] for number in page.chosen]
    if not chosen:
        return 0.0, 0.0
    xs, ys = [one.x for one in chosen], [one.y for one in chosen]
    return (
        min(max(dx, -min(xs)), CANVAS - max(xs)),
        min(max(dy, -min(ys)), CANVAS - max(ys)),
    )


def _distance(middle: Point, pointer: Pointer) -> float:
    return math.dist(middle, pointer.page)


def _angle(middle: Point, pointer: Pointer) -> float:
    """Return the direction from a middle to the pointer, in degrees clockwise from the right."""
    x, y = pointer.page
    return math.degrees(math.atan2(y - middle[1], x - middle[0]))
