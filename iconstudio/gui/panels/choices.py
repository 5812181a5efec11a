"""Thumbnails of icons to choose from."""

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QPoint, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QContextMenuEvent, QMouseEvent, QPainter, QPen
from PySide6.QtWidgets import QApplication

from iconstudio.gui.exchange.dragging import drag
from iconstudio.gui.gallery.thumbnails import ThumbnailDelegate, ThumbnailModel, Thumbnails
from iconstudio.gui.theme import theme
from iconstudio.gui.theme.theme import UNIT
from iconstudio.model import Exemplar

Index = QModelIndex | QPersistentModelIndex

_SIDE = 7 * UNIT


class ChoiceModel(ThumbnailModel):
    """Icons to choose from; some may be taken already."""

    multiple = False
    """Whether some can be taken, and given back."""
    _taken: frozenset[str] = frozenset()

    def is_taken(self, exemplar: Exemplar) -> bool:
        """Whether an icon is taken, so that choosing it gives it back."""
        return self.multiple and exemplar.id in self._taken

    def set_taken(self, identifiers: frozenset[str]) -> None:
        """Say which icons are taken."""
        self._taken = identifiers
        if self.rowCount():
            self.dataChanged.emit(self.index(0), self.index(self.rowCount() - 1))

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> str | None:
        """Describe an icon to tool tips and screen readers."""
        if not index.isValid():
            return None
        exemplar = self.exemplar(index)
        taken = self.is_taken(exemplar)
        if role == Qt.ItemDataRole.ToolTipRole:
            credit = exemplar.pictogram.credit
            what = "take it away" if taken else "add it" if self.multiple else "use it"
            text = (
                f"{exemplar.name}\n{credit.author} · {credit.license}\nClick to {what}, or drag it"
            )
            return text
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.AccessibleTextRole):
            return f"{exemplar.name}, taken" if taken else exemplar.name
        return None


class ChoiceDelegate(ThumbnailDelegate):
    """Draws an icon to choose; with a tick if it is taken."""

    def sizeHint(self, option, index: Index) -> QSize:
        """Return the size of every icon."""
        return QSize(_SIDE, _SIDE)

    def paint(self, painter: QPainter, option, index: Index) -> None:
        """Draw one icon."""
        model: ChoiceModel = index.model()
        taken = model.is_taken(model.exemplar(index))
        scheme = theme.current()
        box = QRectF(option.rect).adjusted(2, 2, -2, -2)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if taken:
            painter.setPen(QPen(scheme.color("accent"), 1.5))
            painter.setBrush(scheme.color("accent_soft"))
            painter.drawRoundedRect(box, 6, 6)
        super().paint(painter, option, index)
        if taken:
            _paint_tick(painter, box.topRight() + QPointF(-UNIT, UNIT), scheme)
        painter.restore()


class Choices(Thumbnails):
    """A sheet of icons: a click, Enter or Space chooses one, and each can be dragged away."""

    model_class = ChoiceModel
    delegate_class = ChoiceDelegate
    _pressed: QPoint | None = None
    """Where a drag may begin."""

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Offer nothing: a click says it all."""
        event.ignore()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Remember where a drag may begin."""
        super().mousePressEvent(event)
        left = event.button() is Qt.MouseButton.LeftButton
        self._pressed = event.position().toPoint() if left else None

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Begin to drag an icon once the pointer has moved far enough."""
        if self._pressed is None or not event.buttons() & Qt.MouseButton.LeftButton:
            super().mouseMoveEvent(event)
            return
        distance = (event.position().toPoint() - self._pressed).manhattanLength()
        if distance >= QApplication.startDragDistance():
            index, self._pressed = self.indexAt(self._pressed), None
            if index.isValid():
                picture = self.viewport().grab(self.visualRect(index))
                drag(self.sheet().exemplar(index).pictogram, picture, self)


def _paint_tick(painter: QPainter, centre: QPointF, scheme: theme.Theme) -> None:
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(scheme.color("accent"))
    painter.drawEllipse(centre, 7, 7)
    pen = QPen(scheme.color("on_accent"), 1.6)
    pen.setCapStyle(Qt.PenCapStyle.RoundCap)
    pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
    painter.setPen(pen)
    tick = (QPointF(-3, 0), QPointF(-1, 2.4), QPointF(3.2, -2.4))
    painter.drawPolyline([centre + point for point in tick])
