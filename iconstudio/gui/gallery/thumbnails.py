"""Thumbnails of the retrieved icons, each of which can be left out."""

from collections.abc import Sequence

from PySide6.QtCore import (
    QAbstractListModel,
    QEvent,
    QModelIndex,
    QPersistentModelIndex,
    QRectF,
    QSize,
    Qt,
    Signal,
)
from PySide6.QtGui import QAction, QContextMenuEvent, QImage, QKeyEvent, QPainter, QPen
from PySide6.QtWidgets import QListView, QMenu, QStyle, QStyledItemDelegate, QWidget

from iconstudio.gui.gallery.pictures import stencil
from iconstudio.gui.theme import theme
from iconstudio.model import Exemplar

SIDE = 44
"""Side of a thumbnail in device-independent pixels."""

_Index = QModelIndex | QPersistentModelIndex


class ThumbnailModel(QAbstractListModel):
    """The retrieved exemplars; those that were left out stay in their places, struck out."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._exemplars: list[Exemplar] = []
        self.excluded: frozenset[str] = frozenset()

    def rowCount(self, parent: _Index = QModelIndex()) -> int:  # noqa: B008 - Qt's default
        """Return how many exemplars are shown."""
        return 0 if parent.isValid() else len(self._exemplars)

    def exemplar(self, index: _Index) -> Exemplar:
        """Return the exemplar at ``index``."""
        return self._exemplars[index.row()]

    def data(self, index: _Index, role: int = Qt.ItemDataRole.DisplayRole) -> str | None:
        """Describe an exemplar to tool tips and screen readers."""
        if not index.isValid():
            return None
        exemplar = self.exemplar(index)
        out = exemplar.id in self.excluded
        if role == Qt.ItemDataRole.ToolTipRole:
            credit = exemplar.pictogram.credit
            verb = "use it again" if out else "leave it out"
            return f"{exemplar.name}\n{credit.author} · {credit.license}\nClick to {verb}"
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.AccessibleTextRole):
            return f"{exemplar.name}, left out" if out else exemplar.name
        return None

    def show(self, exemplars: Sequence[Exemplar]) -> None:
        """Show ``exemplars``; keep those in sight that were left out."""
        kept = {exemplar.id for exemplar in exemplars}
        merged = list(exemplars)
        for place, exemplar in enumerate(self._exemplars):
            if exemplar.id in self.excluded and exemplar.id not in kept:
                merged.insert(min(place, len(merged)), exemplar)
        self.beginResetModel()
        self._exemplars = merged
        self.endResetModel()

    def clear(self) -> None:
        """Forget all exemplars."""
        self.beginResetModel()
        self._exemplars = []
        self.endResetModel()

    def set_excluded(self, excluded: frozenset[str]) -> None:
        """Say which exemplars are left out."""
        self.excluded = excluded
        if self._exemplars:
            self.dataChanged.emit(self.index(0), self.index(len(self._exemplars) - 1))


class ThumbnailDelegate(QStyledItemDelegate):
    """Draws an exemplar; pale and struck through when it is left out."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._cache: dict[tuple[str, str, int], QImage] = {}

    def sizeHint(self, option, index: _Index) -> QSize:
        """Return the size of every thumbnail."""
        return QSize(SIDE, SIDE)

    def paint(self, painter: QPainter, option, index: _Index) -> None:
        """Draw one thumbnail."""
        scheme = theme.current()
        model: ThumbnailModel = index.model()
        exemplar = model.exemplar(index)
        out = exemplar.id in model.excluded
        box = QRectF(option.rect).adjusted(2, 2, -2, -2)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        hovered = bool(option.state & QStyle.StateFlag.State_MouseOver)
        focused = bool(option.state & QStyle.StateFlag.State_HasFocus)
        if hovered or focused:
            painter.setPen(QPen(scheme.color("accent"), 1.5) if focused else Qt.PenStyle.NoPen)
            painter.setBrush(scheme.color("sunken"))
            painter.drawRoundedRect(box, 6, 6)
        painter.setOpacity(0.25 if out else 1.0)
        ratio = painter.device().devicePixelRatio()
        inner = box.adjusted(4, 4, -4, -4)
        painter.drawImage(inner, self._image(exemplar, scheme.text, round(inner.width() * ratio)))
        painter.setOpacity(1.0)
        if out:
            painter.setPen(QPen(scheme.color("danger"), 1.8))
            painter.drawLine(inner.bottomLeft(), inner.topRight())
        painter.restore()

    def _image(self, exemplar: Exemplar, ink: str, side: int) -> QImage:
        key = (exemplar.id, ink, side)
        if key not in self._cache:
            image = stencil(exemplar.coverage, theme.current().color("text"))
            self._cache[key] = image.scaled(
                side,
                side,
                Qt.AspectRatioMode.KeepAspectRatio,
                Qt.TransformationMode.SmoothTransformation,
            )
        return self._cache[key]


class Thumbnails(QListView):
    """A sheet of thumbnails; a click, Space or the context menu leaves one out or takes it back.

    Signals
    -------
    toggled(str)
        Identifier of the icon whose use is to be switched.
    """

    toggled = Signal(str)

    model_class = ThumbnailModel
    delegate_class = ThumbnailDelegate

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._model = self.model_class(self)
        self.setModel(self._model)
        self.setItemDelegate(self.delegate_class(self))
        self.setViewMode(QListView.ViewMode.IconMode)
        self.setResizeMode(QListView.ResizeMode.Adjust)
        self.setMovement(QListView.Movement.Static)
        # What is dropped is for the panel around it.
        self.setDragDropMode(QListView.DragDropMode.NoDragDrop)
        self.setUniformItemSizes(True)
        self.setMouseTracking(True)
        self.setSelectionMode(QListView.SelectionMode.NoSelection)
        self.setVerticalScrollMode(QListView.ScrollMode.ScrollPerPixel)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setAccessibleName("Icons found")
        self.clicked.connect(self._toggle)

    def sheet(self) -> ThumbnailModel:
        """Return the model, typed."""
        return self._model

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Toggle the current thumbnail with Space or Enter."""
        if event.key() in (Qt.Key.Key_Space, Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._toggle(self.currentIndex())
        else:
            super().keyPressEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Offer to leave the icon out or to take it back."""
        index = self.indexAt(event.pos())
        if not index.isValid():
            return
        out = self._model.exemplar(index).id in self._model.excluded
        menu = QMenu(self)
        menu.addAction(QAction("Use this icon again" if out else "Leave this icon out", menu))
        if menu.exec(event.globalPos()) is not None:
            self._toggle(index)
        menu.deleteLater()

    def changeEvent(self, event: QEvent) -> None:
        """Draw again in the new colours."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self.viewport().update()

    def _toggle(self, index: _Index) -> None:
        if index.isValid():
            self.toggled.emit(self._model.exemplar(index).id)
