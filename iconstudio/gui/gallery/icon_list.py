"""One row of results as small pictures, which can be picked, removed and dragged away."""

from collections.abc import Sequence

from PySide6.QtCore import (
    QAbstractListModel,
    QEvent,
    QMimeData,
    QModelIndex,
    QPersistentModelIndex,
    QPoint,
    QRectF,
    QSize,
    Qt,
    Signal,
)
from PySide6.QtGui import QContextMenuEvent, QKeyEvent, QPainter, QPaintEvent, QPen, QWheelEvent
from PySide6.QtWidgets import QListView, QStyle, QStyledItemDelegate, QWidget

from iconstudio.gui.exchange.dragging import packed
from iconstudio.gui.gallery.pictures import Picture
from iconstudio.gui.theme import theme

_Index = QModelIndex | QPersistentModelIndex


def same(one: Picture, other: Picture) -> bool:
    """Whether two results look the same."""
    return one.icon.looks_like(other.icon)


class IconListModel(QAbstractListModel):
    """Results in a row; ``advice`` tells in their tool tips what can be done with them."""

    def __init__(self, parent: QWidget, advice: str) -> None:
        super().__init__(parent)
        self.pictures: tuple[Picture, ...] = ()
        self._advice = advice

    def rowCount(self, parent: _Index = QModelIndex()) -> int:  # noqa: B008 - Qt's default
        """Return how many results there are."""
        return 0 if parent.isValid() else len(self.pictures)

    def data(self, index: _Index, role: int = Qt.ItemDataRole.DisplayRole) -> str | None:
        """Describe a result to tool tips and screen readers."""
        if not index.isValid():
            return None
        name = self.pictures[index.row()].name
        if role == Qt.ItemDataRole.ToolTipRole:
            return f"{name}\n{self._advice}"
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.AccessibleTextRole):
            return name
        return None

    def flags(self, index: _Index) -> Qt.ItemFlag:
        """Let results be dragged."""
        return super().flags(index) | Qt.ItemFlag.ItemIsDragEnabled

    def mimeData(self, indexes: Sequence[QModelIndex]) -> QMimeData:
        """Return a result as the icon that it is."""
        return packed(self.pictures[indexes[0].row()].pictogram())

    def show(self, pictures: Sequence[Picture]) -> None:
        """Show other results."""
        self.beginResetModel()
        self.pictures = tuple(pictures)
        self.endResetModel()


class IconListDelegate(QStyledItemDelegate):
    """Draws a result on a sheet of its own, ``side`` device-independent pixels wide."""

    def __init__(self, parent: QWidget, side: int) -> None:
        super().__init__(parent)
        self._side = side

    def sizeHint(self, option, index: _Index) -> QSize:
        """Return the size of every entry."""
        return QSize(self._side, self._side)

    def paint(self, painter: QPainter, option, index: _Index) -> None:
        """Draw one result."""
        scheme = theme.current()
        picture = index.model().pictures[index.row()]
        box = QRectF(option.rect).adjusted(1.5, 1.5, -1.5, -1.5)
        hovered = bool(option.state & QStyle.StateFlag.State_MouseOver)
        focused = bool(option.state & QStyle.StateFlag.State_HasFocus)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(scheme.color("accent" if focused else "border"), 1.5 if focused else 1))
        painter.setBrush(scheme.color("accent_soft" if hovered else "surface"))
        painter.drawRoundedRect(box, 6, 6)
        picture.paint(painter, box.adjusted(2, 2, -2, -2), scheme.color("text"))
        painter.restore()


class IconList(QListView):
    """One row of results; ``hint`` is shown as long as there is none.

    Signals
    -------
    chosen(Picture)
        The user clicked a result, or pressed Space or Enter on it.
    asked(Picture)
        The user wants the context menu of a result.
    changed()
        Other results are there.
    """

    chosen = Signal(object)
    asked = Signal(object)
    changed = Signal()

    def __init__(
        self,
        side: int,
        hint: str,
        advice: str,
        parent: QWidget | None = None,
        wrapping: bool = False,
    ) -> None:
        """``wrapping``: in as many rows as are needed."""
        super().__init__(parent)
        self._wrapping = wrapping
        self._hint = hint
        self._model = IconListModel(self, advice)
        self.setModel(self._model)
        self.setItemDelegate(IconListDelegate(self, side))
        self.setFlow(QListView.Flow.LeftToRight)
        self.setUniformItemSizes(True)
        self.setWrapping(wrapping)
        if wrapping:
            self.setResizeMode(QListView.ResizeMode.Adjust)
            self.setVerticalScrollMode(QListView.ScrollMode.ScrollPerPixel)
        else:
            self.setFixedHeight(side)
            self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setMouseTracking(True)
        self.setDragEnabled(True)
        self.setDragDropMode(QListView.DragDropMode.DragOnly)
        self.setSelectionMode(QListView.SelectionMode.SingleSelection)
        self.setHorizontalScrollMode(QListView.ScrollMode.ScrollPerPixel)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setAccessibleDescription(hint)
        self.clicked.connect(self._choose)

    @property
    def pictures(self) -> tuple[Picture, ...]:
        """The results, from left to right."""
        return self._model.pictures

    def show_pictures(self, pictures: Sequence[Picture]) -> None:
        """Show other results."""
        self._model.show(pictures)
        self.viewport().update()
        self.changed.emit()

    def remove(self, picture: Picture) -> None:
        """Take a result away; its neighbour becomes the current one."""
        row = self.currentIndex().row()
        self.show_pictures([one for one in self.pictures if one is not picture])
        if row >= 0 and self.pictures:
            self.setCurrentIndex(self._model.index(min(row, len(self.pictures) - 1)))

    def reveal(self, picture: Picture) -> None:
        """Scroll to a result."""
        self.scrollTo(self._model.index(self.pictures.index(picture)))

    def below(self, picture: Picture) -> QPoint:
        """Return the place on the screen where a menu for ``picture`` belongs."""
        box = self.visualRect(self._model.index(self.pictures.index(picture)))
        return self.viewport().mapToGlobal(box.bottomLeft() + QPoint(0, 4))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Choose with Space or Enter, remove with Delete or Backspace."""
        index = self.currentIndex()
        if event.key() in (Qt.Key.Key_Space, Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._choose(index)
        elif event.key() in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace) and index.isValid():
            self.remove(self.pictures[index.row()])
        else:
            super().keyPressEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Ask for the menu of the result under the pointer, or of the current one."""
        keyboard = event.reason() == QContextMenuEvent.Reason.Keyboard
        index = self.currentIndex() if keyboard else self.indexAt(event.pos())
        if index.isValid():
            self.asked.emit(self.pictures[index.row()])

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Scroll to the side, whichever way the wheel turns, if there is one row."""
        if self._wrapping:
            super().wheelEvent(event)
            return
        delta = event.angleDelta()
        bar = self.horizontalScrollBar()
        bar.setValue(bar.value() - (delta.x() or delta.y()) // 2)
        event.accept()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Give the hint as long as there is nothing."""
        super().paintEvent(event)
        if self.pictures:
            return
        with QPainter(self.viewport()) as painter:
            painter.setPen(theme.current().color("muted"))
            how = Qt.AlignmentFlag.AlignVCenter | Qt.TextFlag.TextWordWrap
            if self._wrapping:
                how |= Qt.AlignmentFlag.AlignHCenter
            painter.drawText(self.viewport().rect(), how, self._hint)

    def changeEvent(self, event: QEvent) -> None:
        """Draw again in the new colours."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self.viewport().update()

    def _choose(self, index: _Index) -> None:
        if index.isValid():
            self.chosen.emit(self.pictures[index.row()])
