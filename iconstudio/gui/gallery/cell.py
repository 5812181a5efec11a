"""One cell of the results grid."""

import math
from enum import Enum, auto

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPainterPath, QPaintEvent, QPen
from PySide6.QtWidgets import QAbstractButton, QSizePolicy

from iconstudio.gui.gallery.display import setting
from iconstudio.gui.gallery.paling import Paling
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.theme import theme
from iconstudio.gui.theme.painting import RADIUS, fill_rounded, paint_frame, smooth_painter


class CellState(Enum):
    """What a cell shows, and what it is waiting for."""

    BLANK = auto()
    PENDING = auto()
    """Empty; a result is on its way."""
    OLD = auto()
    """A result of an earlier run, until a newer one comes."""
    PREVIEW = auto()
    """A coarse result, until the finished one comes."""
    READY = auto()


_REMARKS = {
    CellState.BLANK: "empty",
    CellState.PENDING: "on its way",
    CellState.OLD: "from before the last change",
    CellState.PREVIEW: "preview",
}


class ResultCell(QAbstractButton):
    """Shows one result; can be picked once it is there."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.picture: Picture | None = None
        self.state = CellState.BLANK
        self._name = name
        self.recommended = ""
        self.paling = Paling(self)
        self.paling.changed.connect(self.update)
        self._stale = False
        self.setCheckable(True)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)  # it is painted anew when it is pointed at
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.setMinimumSize(48, 48)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        setting.changed.connect(self.update)
        self.expect(False)

    def sizeHint(self) -> QSize:
        """Return the size that a cell likes to have."""
        return QSize(84, 84)

    def expect(self, pending: bool) -> None:
        """Empty the cell; say whether something is to come."""
        self.picture = None
        self.recommended = ""
        self.setEnabled(False)
        self._turn(CellState.PENDING if pending else CellState.BLANK)

    def renew(self) -> None:
        """Something newer is to come: what is there stays until then, as an old result."""
        if self.picture is None:
            self.expect(True)
        elif self.state is not CellState.OLD:
            self._turn(CellState.OLD)

    def show_picture(self, picture: Picture) -> None:
        """Put a result into the cell."""
        self.picture = picture
        self.setEnabled(True)
        self._turn(CellState.PREVIEW if picture.preview else CellState.READY)

    def set_stale(self, stale: bool) -> None:
        """Say whether the result is of something else than what is there now."""
        if stale != self._stale:
            self._stale = stale
            self._turn(self.state)

    def recommend(self, reason: str) -> None:
        """Mark the result as the one of its row to look at first; without a reason, no more."""
        self.recommended = reason
        self._turn(self.state)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the result, or where it is going to be."""
        scheme = theme.current()
        with smooth_painter(self) as painter:
            box = QRectF(self.rect()).adjusted(2, 2, -2, -2)
            side = min(box.width(), box.height())
            if self.state is CellState.PENDING:
                fill_rounded(painter, box, scheme.color("sunken"))
            elif self.state is CellState.BLANK:
                painter.setPen(QPen(scheme.color("border"), 1, Qt.PenStyle.DotLine))
                painter.drawRoundedRect(box, RADIUS, RADIUS)
            else:
                paint_frame(painter, box, self.isChecked(), self.hasFocus(), self.underMouse())
                target = QRectF(0, 0, side, side)
                target.moveCenter(box.center())
                painter.setOpacity(self.paling.opacity)
                self.picture.paint(painter, target, scheme.color("text"), setting.value)
                if self.recommended:
                    self._paint_mark(painter, scheme, target)
                if self.state is CellState.PREVIEW:
                    self._paint_dots(painter, scheme, target)

    def _turn(self, state: CellState) -> None:
        """Enter a state; say in words what it is."""
        self.state = state
        self.paling.set_stale(self._stale or state is CellState.OLD)
        remark = _REMARKS.get(CellState.OLD if self._stale and self.picture else state)
        first = "recommended" if self.recommended else ""
        symmetric = "symmetric" if self._is_symmetric else ""
        names = self._name, symmetric, remark, first
        self.setAccessibleName(", ".join(part for part in names if part))
        advice = f"Look here first: {self.recommended}" if self.recommended else ""
        self.setToolTip("\n".join(part for part in (self._name, symmetric, advice) if part))
        self.update()

    @property
    def _is_symmetric(self) -> bool:
        return self.picture is not None and self.picture.icon.composite.symmetry is not None

    def _paint_mark(self, painter: QPainter, scheme: theme.Theme, icon: QRectF) -> None:
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(scheme.color("accent"))
        painter.drawPath(_star(icon.topRight() + QPointF(-8, 8), 6.0))

    def _paint_dots(self, painter: QPainter, scheme: theme.Theme, icon: QRectF) -> None:
        """Say “to be continued”."""
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(scheme.color("muted"))
        for number in range(3):
            painter.drawEllipse(icon.bottomRight() + QPointF(-6 * number - 6, -5), 1.5, 1.5)


def _star(centre: QPointF, radius: float) -> QPainterPath:
    """Return a star of five points; ``radius`` in device-independent pixels."""
    path = QPainterPath()
    for corner in range(10):
        angle = math.pi * (corner / 5 - 0.5)
        reach = radius * (0.45 if corner % 2 else 1.0)
        point = centre + reach * QPointF(math.cos(angle), math.sin(angle))
        path.lineTo(point) if corner else path.moveTo(point)
    path.closeSubpath()
    return path
