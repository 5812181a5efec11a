"""A sheet of icons, in one row or in many: they are looked at, chosen, removed, dragged away."""

from collections.abc import Sequence

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtGui import (
    QContextMenuEvent,
    QKeyEvent,
    QPainter,
    QPaintEvent,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QListView

from iconstudio.gui.exchange.dragging import drag
from iconstudio.gui.gallery import display, tidiness
from iconstudio.gui.gallery.sheet_delegate import Look, SheetDelegate
from iconstudio.gui.gallery.sheet_model import (
    Describe,
    Entry,
    Index,
    Rule,
    SheetModel,
    pictogram_of,
)
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.theme import theme

_CHOOSE = Qt.Key.Key_Space, Qt.Key.Key_Return, Qt.Key.Key_Enter
_REMOVE = Qt.Key.Key_Delete, Qt.Key.Key_Backspace


class Sheet(QListView):
    """Icons, which may be results or those of the collection, with rules between them.

    Parameters
    ----------
    look
        How the icons are drawn.
    describe
        Says what they are called, and what can be done with them.
    name
        What the sheet is called for screen readers.
    hint
        What is shown as long as there is none.
    one_row
        Whether they stand in one row, instead of as many as are needed.
    draggable, removable
        Whether they can be dragged away; whether Delete takes them out.

    Signals
    -------
    chosen(object)
        The user clicked an icon, or pressed Space or Enter on it.
    picked(object)
        The user has gone to it, by mouse or keys; only if the look shows which is picked.
    asked(object, QPoint)
        The user wants its menu, at this place on the screen.
    neared_end()
        There is little left below what is in sight.
    changed()
        Other icons are there.
    """

    chosen = Signal(object)
    picked = Signal(object)
    asked = Signal(object, QPoint)
    neared_end = Signal()
    changed = Signal()

    def __init__(
        self,
        look: Look,
        describe: Describe,
        name: str,
        hint: str = "",
        one_row: bool = False,
        draggable: bool = False,
        removable: bool = False,
    ) -> None:
        super().__init__()
        self._look, self._hint = look, hint
        self._one_row, self._removable = one_row, removable
        self._last: Entry | None = None
        """The icon that was picked last."""
        self._model = SheetModel(self, describe, draggable)
        self._delegate = SheetDelegate(self, look)
        self.setModel(self._model)
        self.setItemDelegate(self._delegate)
        self._arrange()
        modes = QListView.DragDropMode
        # What is dropped is for the panel around it.
        self.setDragDropMode(modes.DragOnly if draggable else modes.NoDragDrop)
        some, none = QListView.SelectionMode.SingleSelection, QListView.SelectionMode.NoSelection
        self.setSelectionMode(some if look.picks or draggable else none)
        self.setUniformItemSizes(not look.fills)
        self.setMouseTracking(True)
        self.setAccessibleName(name)
        self.setAccessibleDescription(hint)
        self.clicked.connect(self._choose)
        self.verticalScrollBar().valueChanged.connect(self._scrolled)
        display.setting.changed.connect(self.viewport().update)
        if look.picks:
            self.selectionModel().currentChanged.connect(self._pick)
            self._model.modelReset.connect(self._pick_again)
        if look.tidies:
            self._model.shown = tidiness.shown
            tidiness.setting.changed.connect(self._model.renew)

    def _arrange(self) -> None:
        policies, never = Qt.ScrollBarPolicy, Qt.ScrollBarPolicy.ScrollBarAlwaysOff
        self.setHorizontalScrollBarPolicy(never)
        self.setHorizontalScrollMode(QListView.ScrollMode.ScrollPerPixel)
        self.setVerticalScrollMode(QListView.ScrollMode.ScrollPerPixel)
        if self._one_row:
            self.setFlow(QListView.Flow.LeftToRight)
            self.setFixedHeight(self._look.side)
            self.setVerticalScrollBarPolicy(never)
            return
        self.setViewMode(QListView.ViewMode.IconMode)
        self.setResizeMode(QListView.ResizeMode.Adjust)
        self.setMovement(QListView.Movement.Static)
        if self._look.fills:
            self.setVerticalScrollBarPolicy(policies.ScrollBarAlwaysOn)
            bar = self.verticalScrollBar()  # has its room always, but is seen only if it scrolls
            bar.setEnabled(False)
            bar.rangeChanged.connect(lambda least, most: bar.setEnabled(most > least))

    # -- what there is -------------------------------------------------------------------------

    @property
    def pictures(self) -> tuple[Picture, ...]:
        """The results, in their order."""
        return tuple(one for one in self._model.entries if isinstance(one, Picture))

    @property
    def picture(self) -> Picture | None:
        """The result that is picked."""
        entry = self._model.entry(self.currentIndex())
        return entry if isinstance(entry, Picture) else None

    def show_entries(self, entries: Sequence[Entry]) -> None:
        """Show other icons."""
        self._model.show(entries)
        self.viewport().update()
        self.changed.emit()

    def set_hint(self, hint: str) -> None:
        """Say something else as long as there is none."""
        self._hint = hint
        self.setAccessibleDescription(hint)
        self.viewport().update()

    def remove(self, entry: Entry) -> None:
        """Take an icon out; its neighbour becomes the current one."""
        row = self.currentIndex().row()
        self.show_entries([one for one in self._model.entries if one is not entry])
        if row >= 0 and self._model.entries:
            self.setCurrentIndex(self._model.index(min(row, self._model.rowCount() - 1)))

    def reveal(self, entry: Entry) -> None:
        """Scroll to an icon."""
        self.scrollTo(self._model.index_of(entry))

    def below(self, entry: Entry) -> QPoint:
        """Return the place on the screen where a menu for an icon belongs."""
        box = self.visualRect(self._model.index_of(entry))
        return self.viewport().mapToGlobal(box.bottomLeft() + QPoint(0, 4))

    @property
    def at_end(self) -> bool:
        """Whether there is little left below what is in sight."""
        self.executeDelayedItemsLayout()
        bar = self.verticalScrollBar()
        return bar.value() >= bar.maximum() - self._look.side

    # -- Qt ------------------------------------------------------------------------------------

    def startDrag(self, actions: Qt.DropAction) -> None:
        """Let the user drag the icon that was pressed."""
        index = self.currentIndex()
        if self.dragEnabled() and index.isValid():
            picture = self.viewport().grab(self.visualRect(index))
            drag(pictogram_of(self._model.entry(index)), picture, self)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Choose with Space or Enter, remove with Delete or Backspace."""
        index = self.currentIndex()
        if event.key() in _CHOOSE:
            self._choose(index)
        elif self._removable and event.key() in _REMOVE and index.isValid():
            self.remove(self._model.entry(index))
        else:
            super().keyPressEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Ask for the menu of the icon under the pointer, or of the current one."""
        keyboard = event.reason() == QContextMenuEvent.Reason.Keyboard
        index = self.currentIndex() if keyboard else self.indexAt(event.pos())
        if self._holds_icon(index):
            spot = self.visualRect(index).center() if keyboard else event.pos()
            self.asked.emit(self._model.entry(index), self.viewport().mapToGlobal(spot))

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Scroll: one row to the side, whichever way the wheel turns; at the end, ask for more."""
        delta = event.angleDelta()
        if self._one_row:
            bar = self.horizontalScrollBar()
            bar.setValue(bar.value() - (delta.x() or delta.y()) // 2)
            event.accept()
            return
        super().wheelEvent(event)
        if delta.y() < 0 and self.at_end:
            self.neared_end.emit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit rows and rules to the new width."""
        super().resizeEvent(event)
        if self._look.fills:
            self._delegate.set_width(self.viewport().width() - 2)
            self.scheduleDelayedItemsLayout()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Give the hint as long as there is nothing."""
        super().paintEvent(event)
        if self._model.entries or not self._hint:
            return
        with QPainter(self.viewport()) as painter:
            painter.setPen(theme.current().color("muted"))
            how = Qt.AlignmentFlag.AlignVCenter | Qt.TextFlag.TextWordWrap
            if not self._one_row:
                how |= Qt.AlignmentFlag.AlignHCenter
            painter.drawText(self.viewport().rect(), how, self._hint)

    # -- inside --------------------------------------------------------------------------------

    def _holds_icon(self, index: Index) -> bool:
        return not isinstance(self._model.entry(index), Rule | None)

    def _choose(self, index: Index) -> None:
        if self._holds_icon(index):
            self.chosen.emit(self._model.entry(index))

    def _pick(self) -> None:
        if self.picture is not None:
            self._last = self.picture
            self.picked.emit(self.picture)

    def _pick_again(self) -> None:
        """Mark the picked icon, if it is still in sight now that others are."""
        if self._last is not None:
            self.setCurrentIndex(self._model.index_of(self._last))

    def _scrolled(self) -> None:
        if self.at_end:
            self.neared_end.emit()
