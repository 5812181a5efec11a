"""The latest results of all workspaces, kept in sight."""

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
from PySide6.QtWidgets import QListView, QMenu, QStyle, QStyledItemDelegate, QWidget

from iconstudio.gui import theme
from iconstudio.gui.dragging import packed
from iconstudio.gui.panels.sending import Destination, offer
from iconstudio.gui.pictures import Picture

SIDE = 38
"""Side of an entry in device-independent pixels."""

MOST = 24
"""How many results are kept."""

EMPTY = "Results that you pick are kept here"

_Index = QModelIndex | QPersistentModelIndex


class RecentModel(QAbstractListModel):
    """The latest distinct results, newest first."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.pictures: list[Picture] = []

    def rowCount(self, parent: _Index = QModelIndex()) -> int:  # noqa: B008 - Qt's default
        """Return how many results are kept."""
        return 0 if parent.isValid() else len(self.pictures)

    def data(self, index: _Index, role: int = Qt.ItemDataRole.DisplayRole) -> str | None:
        """Describe a result to tool tips and screen readers."""
        if not index.isValid():
            return None
        name = self.pictures[index.row()].name
        if role == Qt.ItemDataRole.ToolTipRole:
            return f"{name}\nClick for what to do with it, or drag it where you need it"
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.AccessibleTextRole):
            return name
        return None

    def flags(self, index: _Index) -> Qt.ItemFlag:
        """Let results be dragged."""
        return super().flags(index) | Qt.ItemFlag.ItemIsDragEnabled

    def mimeData(self, indexes: Sequence[QModelIndex]) -> QMimeData:
        """Return a result as the icon that it is; for other programs as SVG."""
        pictogram = self.pictures[indexes[0].row()].pictogram()
        data = packed(pictogram)
        data.setData("image/svg+xml", pictogram.svg.encode())
        data.setText(pictogram.svg)
        return data

    def keep(self, picture: Picture) -> None:
        """Put a result in front; if it is there already, it moves there."""
        kept = [one for one in self.pictures if not _same(one, picture)]
        self._show([picture, *kept][:MOST])

    def remove(self, picture: Picture) -> None:
        """Forget a result."""
        self._show([one for one in self.pictures if one is not picture])

    def _show(self, pictures: list[Picture]) -> None:
        self.beginResetModel()
        self.pictures = pictures
        self.endResetModel()


class RecentDelegate(QStyledItemDelegate):
    """Draws a result."""

    def sizeHint(self, option, index: _Index) -> QSize:
        """Return the size of every entry."""
        return QSize(SIDE, SIDE)

    def paint(self, painter: QPainter, option, index: _Index) -> None:
        """Draw one result on a sheet of its own."""
        look = theme.current()
        picture = index.model().pictures[index.row()]
        box = QRectF(option.rect).adjusted(1.5, 1.5, -1.5, -1.5)
        hovered = bool(option.state & QStyle.StateFlag.State_MouseOver)
        focused = bool(option.state & QStyle.StateFlag.State_HasFocus)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(look.color("accent" if focused else "border"), 1.5 if focused else 1))
        painter.setBrush(look.color("accent_soft" if hovered else "surface"))
        painter.drawRoundedRect(box, 6, 6)
        picture.paint(painter, box.adjusted(2, 2, -2, -2), look.color("text"), coded=False)
        painter.restore()


class RecentStrip(QListView):
    """One row of results; a click, Enter or the context menu says what can be done with one.

    Signals
    -------
    sent(Picture, str)
        A result is to go to the workspace of that title.
    save_svg(Picture), save_png(Picture), copy_svg(Picture)
        A result is to be taken out of the window.
    """

    sent = Signal(object, str)
    save_svg = Signal(object)
    save_png = Signal(object)
    copy_svg = Signal(object)

    def __init__(self, destinations: Sequence[Destination], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._destinations = destinations
        self._model = RecentModel(self)
        self.menu: QMenu | None = None
        self.setModel(self._model)
        self.setItemDelegate(RecentDelegate(self))
        self.setFlow(QListView.Flow.LeftToRight)
        self.setUniformItemSizes(True)
        self.setFixedHeight(SIDE)
        self.setMouseTracking(True)
        self.setDragEnabled(True)
        self.setDragDropMode(QListView.DragDropMode.DragOnly)
        self.setSelectionMode(QListView.SelectionMode.SingleSelection)
        self.setHorizontalScrollMode(QListView.ScrollMode.ScrollPerPixel)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setAccessibleName("Recent results")
        self.setAccessibleDescription(EMPTY)
        self.clicked.connect(self._open_menu)

    @property
    def pictures(self) -> list[Picture]:
        """The results that are kept, newest first."""
        return self._model.pictures

    def keep(self, picture: Picture) -> None:
        """Put a result in front."""
        self._model.keep(picture)
        self.scrollToTop()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Say what can be done with Space or Enter; remove with Delete."""
        index = self.currentIndex()
        if event.key() in (Qt.Key.Key_Space, Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._open_menu(index)
        elif event.key() in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace) and index.isValid():
            self._model.remove(self.pictures[index.row()])
        else:
            super().keyPressEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Say what can be done with the result under the pointer, or the current one."""
        keyboard = event.reason() == QContextMenuEvent.Reason.Keyboard
        self._open_menu(self.currentIndex() if keyboard else self.indexAt(event.pos()))

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Scroll to the side, whichever way the wheel turns."""
        delta = event.angleDelta()
        bar = self.horizontalScrollBar()
        bar.setValue(bar.value() - (delta.x() or delta.y()) // 2)
        event.accept()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Say what is kept here as long as there is nothing."""
        super().paintEvent(event)
        if self.pictures:
            return
        with QPainter(self.viewport()) as painter:
            painter.setPen(theme.current().color("muted"))
            align = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft
            painter.drawText(QRectF(self.viewport().rect()), align, EMPTY)

    def changeEvent(self, event: QEvent) -> None:
        """Draw again in the new colours."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self.viewport().update()

    def _open_menu(self, index: _Index) -> None:
        if not index.isValid():
            return
        picture = self.pictures[index.row()]
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        offer(menu, self._destinations, lambda title: self.sent.emit(picture, title))
        if self._destinations:
            menu.addSeparator()
        menu.addAction("Save SVG…", lambda: self.save_svg.emit(picture))
        menu.addAction("Save PNG…", lambda: self.save_png.emit(picture))
        menu.addAction("Copy SVG", lambda: self.copy_svg.emit(picture))
        menu.addSeparator()
        menu.addAction("Remove", lambda: self._model.remove(picture))
        self.menu = menu
        below = self.visualRect(index).bottomLeft() + QPoint(0, 4)
        menu.popup(self.viewport().mapToGlobal(below))


def _same(one: Picture, other: Picture) -> bool:
    return one is other or one.result.drawing.path == other.result.drawing.path
