"""One cell of the results grid."""

import math
from enum import Enum, auto

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QEnterEvent, QPainter, QPainterPath, QPaintEvent, QPen
from PySide6.QtWidgets import QAbstractButton, QSizePolicy, QWidget

from iconstudio.gui import theme
from iconstudio.gui.pictures import Picture


class CellState(Enum):
    """What a cell is waiting for."""

    BLANK = auto()
    PENDING = auto()
    READY = auto()


class ResultCell(QAbstractButton):
    """Shows one result; can be picked once it is there."""

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.picture: Picture | None = None
        self.state = CellState.BLANK
        self._name = name
        self._coded = False
        self.recommended = False
        self.setCheckable(True)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.setMinimumSize(48, 48)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.expect(False)

    def sizeHint(self) -> QSize:
        """Return the size that a cell likes to have."""
        return QSize(84, 84)

    def expect(self, pending: bool) -> None:
        """Empty the cell; say whether something is to come."""
        self.picture = None
        self.recommended = False
        self.state = CellState.PENDING if pending else CellState.BLANK
        self.setEnabled(False)
        self.setChecked(False)
        self.setAccessibleName(f"{self._name}: {'on its way' if pending else 'empty'}")
        self.update()

    def show_picture(self, picture: Picture) -> None:
        """Put a result into the cell."""
        self.picture = picture
        self.state = CellState.READY
        self.setEnabled(True)
        self.setAccessibleName(self._name)
        self.setToolTip(self._name)
        self.update()

    def recommend(self, reason: str) -> None:
        """Mark the result as the one of its row to look at first."""
        self.recommended = True
        self.setToolTip(f"{self._name}\nLook here first: {reason}")
        self.setAccessibleName(f"{self._name}, recommended")
        self.update()

    def set_coded(self, coded: bool) -> None:
        """Switch between icon and colour code."""
        self._coded = coded
        self.update()

    def enterEvent(self, event: QEnterEvent) -> None:
        """Show that the cell can be picked."""
        super().enterEvent(event)
        self.update()

    def leaveEvent(self, event: QEvent) -> None:
        """Stop showing that the cell can be picked."""
        super().leaveEvent(event)
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the result, or where it is going to be."""
        look = theme.current()
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            box = QRectF(self.rect()).adjusted(2, 2, -2, -2)
            side = min(box.width(), box.height())
            if self.state is CellState.PENDING:
                painter.setPen(Qt.PenStyle.NoPen)
                painter.setBrush(look.color("sunken"))
                painter.drawRoundedRect(box, 6, 6)
            elif self.state is CellState.BLANK:
                painter.setPen(QPen(look.color("border"), 1, Qt.PenStyle.DotLine))
                painter.drawRoundedRect(box, 6, 6)
            else:
                self._paint_frame(painter, look, box)
                target = QRectF(0, 0, side, side)
                target.moveCenter(box.center())
                self.picture.paint(painter, target, look.color("text"), self._coded)
                if self.recommended:
                    self._paint_mark(painter, look, target)

    def _paint_frame(self, painter: QPainter, look: theme.Theme, box: QRectF) -> None:
        if self.isChecked():
            painter.setPen(QPen(look.color("accent"), 2))
            painter.setBrush(look.color("accent_soft"))
        elif self.underMouse() or self.hasFocus():
            painter.setPen(QPen(look.color("accent"), 1) if self.hasFocus() else Qt.PenStyle.NoPen)
            painter.setBrush(look.color("sunken"))
        else:
            return
        painter.drawRoundedRect(box, 6, 6)

    def _paint_mark(self, painter: QPainter, look: theme.Theme, icon: QRectF) -> None:
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(look.color("accent"))
        painter.drawPath(_star(icon.topRight() + QPointF(-8, 8), 6.0))


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
