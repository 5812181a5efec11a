"""Where an example of a style is drawn: a styled stroke, perhaps over the plain one it is of."""

import math

from PySide6.QtCore import QEvent, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QMouseEvent, QPainter, QPaintEvent, QTabletEvent, QTransform
from PySide6.QtWidgets import QFrame, QToolButton, QWidget

from iconstudio.gui.theme import theme
from iconstudio.gui.theme.layout import card, label, row, segments, tool_button
from iconstudio.gui.theme.painting import fill_rounded, smooth_painter
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.workspaces.line_style.scene import outline, pen
from iconstudio.model import CANVAS, Line, LineStyle, Point, StylePair
from iconstudio.workflows.line_style.page import OWN

_APART = 0.6
"""Canvas units that the pointer must move for another point."""
_PRESSED = 24.0
"""Width, in canvas units, of what a pen draws that is pressed as hard as may be."""
_INK, _THIN = 3.0, 1.5
"""Widths of what is shown, in device-independent pixels."""
_ROOM = UNIT
_SHOWN = 3
"""Most examples of a style that are shown at once."""


class ExamplePad(QWidget):
    """Shows the examples of the style in use; whoever draws here begins one of his own.

    It is as wide as the canvas, in canvas units.

    Signals
    -------
    drawing(StylePair), drawn(StylePair)
        An example as it is so far, and once it is finished.
    given_up()
        The example that was being drawn is none.
    waiting(bool)
        Whether a plain stroke waits for its styled one.
    """

    drawing = Signal(object)
    drawn = Signal(object)
    given_up = Signal()
    waiting = Signal(bool)

    def __init__(self) -> None:
        super().__init__()
        self.pairs = False
        """Whether the plain stroke is drawn first, and then the styled one."""
        self.plain: tuple[Point, ...] = ()
        """The plain stroke that waits for its styled one."""
        self._style: LineStyle | None = None
        self._points: list[Point] = []
        self._widths: list[float] = []
        self.setMinimumSize(20 * UNIT, 14 * UNIT)
        self.setCursor(Qt.CursorShape.CrossCursor)
        self.setAccessibleName("Draw an example")
        self.setAccessibleDescription("Draw a stroke in the style that lines should take, here")

    def show_style(self, style: LineStyle | None) -> None:
        """Show the examples of a style."""
        self._style = style
        self.update()

    def set_pairs(self, pairs: bool) -> None:
        """Let the plain stroke be drawn first, or only styled ones."""
        self.pairs = pairs
        self.forget()

    def forget(self, plain: tuple[Point, ...] = ()) -> None:
        """Give up what is not finished, but for a ``plain`` stroke."""
        self.plain, self._points, self._widths = plain, [], []
        self.waiting.emit(bool(plain))
        self.update()

    # -- pointer -------------------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Put the pen down."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._begin(event.position(), None)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Draw on."""
        self._go_on(event.position(), None)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Lift the pen."""
        self._end()

    def tabletEvent(self, event: QTabletEvent) -> None:
        """Draw with a pen; how hard it presses is the width of the stroke."""
        match event.type():
            case QEvent.Type.TabletPress:
                self._begin(event.position(), event.pressure())
            case QEvent.Type.TabletMove:
                self._go_on(event.position(), event.pressure())
            case QEvent.Type.TabletRelease:
                self._end()
        event.accept()

    def _begin(self, spot: QPointF, pressure: float | None) -> None:
        self._points, self._widths = [], []
        self._add(spot, pressure)

    def _go_on(self, spot: QPointF, pressure: float | None) -> None:
        if not self._points or math.dist(self._points[-1], self._at(spot)) < _APART:
            return
        self._add(spot, pressure)
        if not self._draws_plain:
            self.drawing.emit(self._pair())

    def _end(self) -> None:
        points, pair = tuple(self._points), self._pair()
        if not points:
            return
        stroke = len(set(points)) > 2
        if self._draws_plain:
            self.forget(points if stroke else ())
        elif stroke:
            self.forget()
            self.drawn.emit(pair)
        else:
            self.forget(self.plain)
            self.given_up.emit()

    @property
    def _draws_plain(self) -> bool:
        return self.pairs and not self.plain

    def _pair(self) -> StylePair:
        widths = tuple(self._widths)
        return StylePair(tuple(self._points), self.plain, widths=widths)

    def _add(self, spot: QPointF, pressure: float | None) -> None:
        self._points.append(self._at(spot))
        if pressure is not None:
            self._widths.append(round(_PRESSED * pressure, 2))
        self.update()

    def _at(self, spot: QPointF) -> Point:
        scale = CANVAS / self.width()
        return round(spot.x() * scale, 2), round(spot.y() * scale, 2)

    # -- picture -------------------------------------------------------------------------------

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the examples, and what is being drawn."""
        scheme = theme.current()
        with smooth_painter(self) as painter:
            fill_rounded(painter, QRectF(self.rect()), scheme.color("window"))
            scale = self.width() / CANVAS
            here = QTransform.fromScale(scale, scale)
            if self._points or self.plain:
                _paint(painter, here, self.plain, scheme.color("muted", 0.6), _THIN)
                plain = self._draws_plain
                color = scheme.color("muted" if plain else "accent")
                _paint(painter, here, tuple(self._points), color, _THIN if plain else _INK)
            elif self._style is not None:
                self._paint_style(painter, here, scheme)
            self._paint_words(painter, scheme)

    def _paint_style(self, painter: QPainter, here: QTransform, scheme: theme.Theme) -> None:
        own = self._style.name == OWN
        pairs = self._style.pairs if own else self._style.pairs[:_SHOWN]
        room = QRectF(0, 0, self.width() / len(pairs), self.height())
        ink = scheme.color("text" if own else "muted")
        for number, pair in enumerate(pairs):
            onto = here if own else _fitting(pair, room.translated(number * room.width(), 0))
            _paint(painter, onto, pair.plain, scheme.color("accent", 0.6), _THIN, pair.closed)
            _paint(painter, onto, pair.styled, ink, _INK if own else _THIN, pair.closed)

    def _paint_words(self, painter: QPainter, scheme: theme.Theme) -> None:
        words = self._words()
        if words:
            font = painter.font()
            font.setPixelSize(12)
            painter.setFont(font)
            painter.setPen(scheme.color("muted"))
            box = QRectF(self.rect()).adjusted(_ROOM, _ROOM / 2, -_ROOM, -_ROOM / 2)
            where = Qt.AlignmentFlag.AlignBottom | Qt.AlignmentFlag.AlignHCenter
            painter.drawText(box, where, words)

    def _words(self) -> str:
        if self._points:
            return ""
        if self.plain:
            return "Now the same stroke in your style"
        if self._style is None:
            return "Draw a plain stroke here" if self.pairs else "Draw a stroke here"
        return ""


class ExamplePanel(QFrame):
    """The pad, a switch between its two ways, and a button to begin anew.

    Signals
    -------
    cleared()
        The example is to be drawn anew.
    """

    cleared = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.pad = ExamplePad()
        self.clear = tool_button("clear", "Clear the example", self._clear)
        self._own = False
        self.alone, self.both = _segment("Style"), _segment("Plain, style")
        self.alone.setToolTip("Draw strokes in the style: lines follow their hand")
        self.both.setToolTip(
            "Draw a plain stroke, and then the same in the style: "
            "lines learn what became of the plain one"
        )
        self.switch = QFrame()
        segments(self.switch, self.alone, self.both)
        self.alone.setChecked(True)
        self.pad.waiting.connect(self._enable)
        self.alone.clicked.connect(lambda: self._set_pairs(False))
        self.both.clicked.connect(lambda: self._set_pairs(True))
        top = row((label("Draw an example", "heading"), 1), self.switch, self.clear)
        inside = card(top, (self.pad, 1))
        row(inside, of=self)

    def show_style(self, style: LineStyle | None) -> None:
        """Show the examples of the style in use."""
        self.pad.show_style(style)
        self._own = style is not None and style.name == OWN
        self._enable(bool(self.pad.plain))

    def _enable(self, waiting: bool) -> None:
        self.clear.setEnabled(self._own or waiting)

    def _clear(self) -> None:
        """Clear the plain stroke that waits; else the whole example."""
        waiting = bool(self.pad.plain)
        self.pad.forget()
        if not waiting:
            self.cleared.emit()

    def _set_pairs(self, pairs: bool) -> None:
        self.alone.setChecked(not pairs)
        self.both.setChecked(pairs)
        self.pad.set_pairs(pairs)


def _segment(text: str) -> QToolButton:
    button = QToolButton(text=text, checkable=True)
    button.setAccessibleName(text)
    return button


def _paint(
    painter: QPainter,
    onto: QTransform,
    points: tuple[Point, ...],
    color: object,
    width: float,
    closed: bool = False,
) -> None:
    if len(points) > 1:
        painter.strokePath(onto.map(outline(Line(points, closed))), pen(color, width))


def _fitting(pair: StylePair, room: QRectF) -> QTransform:
    """Return the mapping that shows an example as large as fits."""
    xs, ys = zip(*pair.styled, *pair.plain, strict=True)
    box = QRectF(QPointF(min(xs), min(ys)), QPointF(max(xs), max(ys)))
    room = room.adjusted(2 * _ROOM, 2 * _ROOM, -2 * _ROOM, -2 * _ROOM)
    scale = min(room.width() / max(box.width(), 1.0), room.height() / max(box.height(), 1.0))
    there, here = room.center(), box.center()
    onto = QTransform.fromTranslate(there.x(), there.y()).scale(scale, scale)
    return onto.translate(-here.x(), -here.y())
