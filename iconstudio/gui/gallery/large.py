"""A result, large: the part that is pointed at is outlined, and its source named."""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QPoint, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QMouseEvent, QPainter, QPaintEvent, QPen, QResizeEvent, QTransform
from PySide6.QtWidgets import QSizePolicy, QWidget

from iconstudio.gui.gallery.display import setting
from iconstudio.gui.gallery.paling import Paling
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.pictures.vector import painter_path
from iconstudio.gui.theme import theme
from iconstudio.gui.theme.painting import RADIUS, fill_rounded, smooth_painter
from iconstudio.gui.theme.theme import UNIT, Theme
from iconstudio.model import CANVAS, Layer, Remix
from iconstudio.workflows.parts import Part, Parts

_PIN = 5.0
"""Radius of the mark of a pinned part, in device-independent pixels."""


class LargePicture(QWidget):
    """A result on a sheet of its own.

    Signals
    -------
    part_clicked(Part, QPoint)
        The user clicked a part of it, at this place of the screen; only if parts ``answer``.
    """

    part_clicked = Signal(object, QPoint)

    def __init__(self, wide: bool = False) -> None:
        """``wide``: it fills what room there is, instead of growing with its height only."""
        super().__init__()
        self._picture: Picture | None = None
        self._parts: Parts | None = None
        self._part: Part | None = None
        self._pins: Sequence[Layer] = ()
        self.answers = False
        """Whether something comes of clicking a part."""
        self._wide = wide
        self.paling = Paling(self)
        self.paling.changed.connect(self.update)
        self.setMinimumSize(20 * UNIT, 20 * UNIT)
        across = QSizePolicy.Policy.Expanding if wide else QSizePolicy.Policy.Preferred
        self.setSizePolicy(across, QSizePolicy.Policy.Expanding)
        self.setAccessibleName("The picked icon")
        self.setMouseTracking(True)
        setting.changed.connect(self.update)

    @property
    def part(self) -> Part | None:
        """The part that is pointed at."""
        return self._part

    def show_picture(self, picture: Picture | None) -> None:
        """Show another result."""
        self._picture = picture
        icon = None if picture is None else picture.icon
        self._parts = Parts(icon) if isinstance(icon, Remix) else None
        self._point_at(None)
        self.paling.renew()
        self.update()

    def show_pins(self, pins: Sequence[Layer]) -> None:
        """Mark the parts that are pinned, wherever they are the result's."""
        self._pins = pins
        self.update()

    def sizeHint(self) -> QSize:
        """Return a square, if there is room for one."""
        side = 20 * UNIT if self._wide else min(self.height(), 40 * UNIT)
        return QSize(side, 20 * UNIT)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Stay square."""
        if event.size().height() != event.oldSize().height():
            self.updateGeometry()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Point at a part."""
        self._point_at(self._found(event.position()))

    def leaveEvent(self, event: QEvent) -> None:
        """Point at nothing."""
        self._point_at(None)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Tell which part is clicked."""
        part = self._found(event.position())
        if self.answers and part is not None and event.button() == Qt.MouseButton.LeftButton:
            self.part_clicked.emit(part, event.globalPosition().toPoint())

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the sheet and the icon."""
        scheme = theme.current()
        with smooth_painter(self) as painter:
            fill_rounded(painter, self._sheet, scheme.color("window"), 8)
            if self._picture is not None:
                ink = scheme.color("text")
                painter.setOpacity(self.paling.opacity)
                self._picture.paint(painter, self._target, ink, setting.value)
                painter.setOpacity(1)
                self._paint_part(painter, scheme)
                self._paint_pins(painter, scheme)

    @property
    def _sheet(self) -> QRectF:
        side = min(self.width(), self.height())
        sheet = QRectF(0, 0, side, side)
        sheet.moveCenter(QRectF(self.rect()).center())
        return sheet

    @property
    def _target(self) -> QRectF:
        return self._sheet.adjusted(UNIT, UNIT, -UNIT, -UNIT)

    @property
    def _placing(self) -> QTransform:
        """From units of the drawing to the widget."""
        box = self._picture.icon_box(self._target, setting.value)
        moved = QTransform.fromTranslate(box.x(), box.y())
        return moved.scale(box.width() / CANVAS, box.height() / CANVAS)

    def _found(self, spot: QPointF) -> Part | None:
        if self._parts is None:
            return None
        inverse, _ = self._placing.inverted()
        return self._parts.at(inverse.map(spot).toTuple())

    def _point_at(self, part: Part | None) -> None:
        if part is self._part:
            return
        self._part = part
        clickable = self.answers and part is not None
        shape = Qt.CursorShape.PointingHandCursor if clickable else Qt.CursorShape.ArrowCursor
        self.setCursor(shape)
        self.update()

    def _paint_part(self, painter: QPainter, scheme: Theme) -> None:
        """Outline the part that is pointed at, and name its source where it is not in the way."""
        part = self._part
        if part is None:
            return
        outline = self._placing.map(painter_path(part.outline))
        painter.setPen(QPen(scheme.color("accent"), 2))
        painter.setBrush(scheme.color("accent", 0.35))
        painter.drawPath(outline)
        icon = part.source.exemplar.pictogram
        metrics, sheet = painter.fontMetrics(), self._sheet
        room = sheet.width() - 4 * UNIT
        lines = [
            metrics.elidedText(line, Qt.TextElideMode.ElideRight, int(room))
            for line in (icon.name, icon.credit.author)
        ]
        width = max(map(metrics.horizontalAdvance, lines)) + 2 * UNIT
        box = QRectF(0, 0, width, 2 * metrics.height() + UNIT)
        box.moveLeft(sheet.center().x() - width / 2)
        low = outline.boundingRect().center().y() > sheet.center().y()
        box.moveTop(sheet.top() + UNIT / 2 if low else sheet.bottom() - box.height() - UNIT / 2)
        fill_rounded(painter, box, scheme.color("text", 0.9), RADIUS)
        painter.setPen(scheme.color("surface"))
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, "\n".join(lines))

    def _paint_pins(self, painter: QPainter, scheme: Theme) -> None:
        if self._parts is None or not self._pins:
            return
        icon = self._parts.icon
        placed = {(one.exemplar.id, one.placement) for one in icon.composite.sources}
        frame = icon.drawing.frame
        painter.setPen(QPen(scheme.color("window"), 2))
        painter.setBrush(scheme.color("accent"))
        for pin in self._pins:
            if (pin.icon.id, pin.placement) in placed:
                points = pin.strokes[0].points
                x, y = points[len(points) // 2]
                at = QPointF(x - frame.x, y - frame.y) * (CANVAS / frame.size)
                painter.drawEllipse(self._placing.map(at), _PIN, _PIN)
