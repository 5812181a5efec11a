"""The endless sheet of hybrids, and the buttons that hover over one."""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QPersistentModelIndex, QPoint, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QContextMenuEvent, QKeyEvent, QPainter, QPen, QResizeEvent, QWheelEvent
from PySide6.QtWidgets import (
    QHBoxLayout,
    QListView,
    QStyle,
    QStyledItemDelegate,
    QToolButton,
    QWidget,
)

from iconstudio.gui.gallery.icon_list import same
from iconstudio.gui.gallery.pictures import Display, Picture
from iconstudio.gui.theme import icons, theme
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.workspaces.hybrids.sheet_model import Index, Rule, Section, SheetModel

CELL = 12 * UNIT
"""Side of a hybrid in device-independent pixels."""
_RULE, _HEADING = 3 * UNIT, 4 * UNIT


class SheetDelegate(QStyledItemDelegate):
    """Draws hybrids and rules."""

    def __init__(self, parent: "Sheet") -> None:
        super().__init__(parent)
        self.display = Display.BOTH
        self.favourites: Sequence[Picture] = ()
        self.set_width(8 * CELL)

    def set_width(self, width: int) -> None:
        """Let as many cells as fit fill a row of ``width``."""
        self._cell = QSize(width // max(1, width // CELL), CELL)
        self._rule, self._heading = QSize(width, _RULE), QSize(width, _HEADING)

    def sizeHint(self, option, index: Index) -> QSize:
        """Return the size of a cell, or of a rule across the sheet."""
        entry = index.model().entry(index)
        if isinstance(entry, Rule):
            return self._heading if entry.heading else self._rule
        return self._cell

    def paint(self, painter: QPainter, option, index: Index) -> None:
        """Draw one entry."""
        scheme = theme.current()
        entry = index.model().entry(index)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if isinstance(entry, Rule):
            last = index.row() == index.model().rowCount() - 1
            text = entry.text + (entry.more if last else "")
            _paint_rule(painter, QRectF(option.rect), text, entry.heading, scheme)
        else:
            self._paint_picture(painter, option, entry, scheme)
        painter.restore()

    def _paint_picture(
        self, painter: QPainter, option, picture: Picture, scheme: theme.Theme
    ) -> None:
        box = QRectF(option.rect).adjusted(2, 2, -2, -2)
        state = option.state
        picked = bool(state & QStyle.StateFlag.State_Selected)
        focused = bool(state & QStyle.StateFlag.State_HasFocus)
        if picked or focused or state & QStyle.StateFlag.State_MouseOver:
            width = 2 if picked else 1
            framed = QPen(scheme.color("accent"), width)
            painter.setPen(framed if picked or focused else Qt.PenStyle.NoPen)
            painter.setBrush(scheme.color("accent_soft" if picked else "sunken"))
            painter.drawRoundedRect(box, 6, 6)
        inner = QRectF(0, 0, CELL - 8, CELL - 8)
        inner.moveCenter(box.center())
        picture.paint(painter, inner, scheme.color("text"), self.display)
        if any(same(one, picture) for one in self.favourites):
            place = QRect(box.topRight().toPoint() - QPoint(19, -3), QSize(16, 16))
            icons.icon("star-full", "accent").paint(painter, place)


class HoverBar(QWidget):
    """The buttons over the hybrid at which the pointer is.

    Signals
    -------
    favourite(), like()
        What to do with it.
    """

    favourite = Signal()
    like = Signal()

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._star = self._button("Keep as a favourite (F)", self.favourite)
        self._more = self._button("More like this (L)", self.like)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(0)
        row.addWidget(self._more)
        row.addWidget(self._star)
        self._more.setIcon(icons.icon("like", "accent"))
        self._show_kept(False)
        self.adjustSize()
        self.hide()

    def show_over(self, box, kept: bool) -> None:
        """Show the buttons at the top of ``box``; ``kept`` says whether it is a favourite."""
        self._show_kept(kept)
        self.move(box.right() - self.width() - 2, box.top() + 2)
        self.show()

    def _show_kept(self, kept: bool) -> None:
        self._star.setIcon(icons.icon("star-full" if kept else "star", "accent"))
        self._star.setToolTip("No favourite any more (F)" if kept else "Keep as a favourite (F)")

    def _button(self, words: str, signal) -> QToolButton:
        button = QToolButton(toolTip=words)
        button.setAccessibleName(words)
        button.setIconSize(QSize(16, 16))
        button.setProperty("floating", True)
        button.setCursor(Qt.CursorShape.ArrowCursor)
        button.clicked.connect(signal)
        return button


class Sheet(QListView):
    """Hybrids to look through and to pick from; scrolling to the end asks for more.

    Signals
    -------
    picked(Picture)
        The user has gone to it, by mouse or keys.
    chosen(Picture)
        The user clicked it, or pressed Space or Enter on it.
    favourite(Picture), like(Picture)
        The user wants to keep it, or others that resemble it.
    asked(Picture, QPoint)
        The user wants its menu, at this place on the screen.
    neared_end()
        There is little left below what is in sight.
    """

    picked = Signal(object)
    chosen = Signal(object)
    favourite = Signal(object)
    like = Signal(object)
    asked = Signal(object, QPoint)
    neared_end = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.hybrids = SheetModel(self)
        self._delegate = SheetDelegate(self)
        self._hovered = QPersistentModelIndex()
        self._unsettled: Section | None = None
        self._last: Picture | None = None
        """The hybrid that was picked last."""
        self.setModel(self.hybrids)
        self.setItemDelegate(self._delegate)
        self.setViewMode(QListView.ViewMode.IconMode)
        self.setResizeMode(QListView.ResizeMode.Adjust)
        self.setMovement(QListView.Movement.Static)
        self.setDragDropMode(QListView.DragDropMode.NoDragDrop)
        self.setMouseTracking(True)
        self.setVerticalScrollMode(QListView.ScrollMode.ScrollPerPixel)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOn)
        self.setAccessibleName("Hybrids")
        self.bar = HoverBar(self.viewport())
        self.bar.favourite.connect(lambda: self._tell(self.favourite, self._hovered))
        self.bar.like.connect(lambda: self._tell(self.like, self._hovered))
        self.entered.connect(self._hover)
        self.viewportEntered.connect(lambda: self._hover(QPersistentModelIndex()))
        self.clicked.connect(lambda index: self._tell(self.chosen, index))
        self.selectionModel().currentChanged.connect(self._tell_picked)
        self.hybrids.modelReset.connect(self._pick_again)
        self.verticalScrollBar().valueChanged.connect(self._scrolled)

    # -- what there is -------------------------------------------------------------------------

    @property
    def picture(self) -> Picture | None:
        """The hybrid that is picked."""
        entry = self.hybrids.entry(self.currentIndex())
        return entry if isinstance(entry, Picture) else None

    @property
    def at_end(self) -> bool:
        """Whether there is little left below what is in sight."""
        self.executeDelayedItemsLayout()
        bar = self.verticalScrollBar()
        return bar.value() >= bar.maximum() - CELL

    def show_display(self, display: Display) -> None:
        """Show hybrids as icons, by their colour code, or both."""
        self._delegate.display = display
        self.viewport().update()

    def set_favourites(self, favourites: Sequence[Picture]) -> None:
        """Mark these hybrids."""
        self._delegate.favourites = favourites
        self.viewport().update()
        self._place_bar()

    def add(self, section: Section, picture: Picture) -> None:
        """Add a hybrid to the section's present batch, and leave what the user looks at alone."""
        anchor = self._anchor()
        self.hybrids.add(section, picture, self._held())
        self._unsettled = section
        if anchor is not None and anchor[0].row() != anchor[1]:  # else no layout is needed yet
            self._restore(anchor)

    def end(self, section: Section, rule: Rule) -> None:
        """End the present batch."""
        self.hybrids.end(section, rule)
        self._unsettled = section
        if not self._hovered.isValid():
            self.settle()

    def settle(self) -> None:
        """Put the batch that was drawn last in order, now that nobody points at it."""
        section, self._unsettled = self._unsettled, None
        if section in self.hybrids.sections and not self.hybrids.settled(section):
            anchor = self._anchor()
            self.hybrids.settle(section)
            self._restore(anchor)

    # -- Qt ------------------------------------------------------------------------------------

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Choose with Space or Enter."""
        if event.key() in (Qt.Key.Key_Space, Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._tell(self.chosen, self.currentIndex())
        else:
            super().keyPressEvent(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Scroll; at the end of the sheet, ask for more."""
        super().wheelEvent(event)
        if event.angleDelta().y() < 0 and self.at_end:
            self.neared_end.emit()

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Ask for the menu of the hybrid under the pointer, or of the current one."""
        keyboard = event.reason() == QContextMenuEvent.Reason.Keyboard
        index = self.currentIndex() if keyboard else self.indexAt(event.pos())
        entry = self.hybrids.entry(index)
        if isinstance(entry, Picture):
            spot = self.visualRect(index).center() if keyboard else event.pos()
            self.asked.emit(entry, self.viewport().mapToGlobal(spot))

    def viewportEvent(self, event: QEvent) -> bool:
        """Take the buttons away when the pointer leaves."""
        if event.type() == QEvent.Type.Leave:
            self._hover(QPersistentModelIndex())
            self.settle()
        return super().viewportEvent(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit the rules to the new width."""
        super().resizeEvent(event)
        self._delegate.set_width(self.viewport().width() - 2)
        self.scheduleDelayedItemsLayout()

    # -- inside --------------------------------------------------------------------------------

    def _held(self) -> int:
        """Return the last row that must stay where it is; -1 if none."""
        held = [self._first_visible() - 1]
        if self._hovered.isValid():
            held.append(self._hovered.row())
        if self.hasFocus() and self.currentIndex().isValid():
            held.append(self.currentIndex().row())
        return max(held)

    def _first_visible(self) -> int:
        """Return the first row of which something is in sight; 0 at the top of the sheet."""
        if self.verticalScrollBar().value() == 0:
            return 0
        return max(0, self.indexAt(QPoint(CELL // 2, CELL // 4)).row())

    def _anchor(self) -> tuple[QPersistentModelIndex, int, int] | None:
        """Return an entry in sight, its row and its place; None at the top of the sheet."""
        row = self._first_visible()
        if row == 0:
            return None
        index = self.hybrids.index(row)
        return QPersistentModelIndex(index), row, self.visualRect(index).top()

    def _restore(self, anchor: tuple[QPersistentModelIndex, int, int] | None) -> None:
        """Scroll so that the entry is at its place again."""
        self.executeDelayedItemsLayout()
        if anchor is not None and anchor[0].isValid():
            moved = self.visualRect(self.hybrids.index(anchor[0].row())).top() - anchor[2]
            if moved:
                bar = self.verticalScrollBar()
                bar.setValue(bar.value() + moved)
        self._place_bar()

    def _scrolled(self) -> None:
        self._hover(QPersistentModelIndex())
        if self.at_end:
            self.neared_end.emit()

    def _hover(self, index: Index) -> None:
        there = isinstance(self.hybrids.entry(index), Picture)
        self._hovered = QPersistentModelIndex(index) if there else QPersistentModelIndex()
        self._place_bar()

    def _place_bar(self) -> None:
        picture = self.hybrids.entry(self._hovered)
        if not isinstance(picture, Picture):
            self.bar.hide()
            return
        kept = any(same(one, picture) for one in self._delegate.favourites)
        self.bar.show_over(self.visualRect(self.hybrids.index(self._hovered.row())), kept)

    def _tell(self, signal, index: Index) -> None:
        entry = self.hybrids.entry(index)
        if isinstance(entry, Picture):
            signal.emit(entry)

    def _tell_picked(self) -> None:
        if self.picture is not None:
            self._last = self.picture
            self.picked.emit(self.picture)

    def _pick_again(self) -> None:
        """Mark the picked hybrid, if it is still in sight now that other sections are."""
        if self._last is not None:
            self.setCurrentIndex(self.hybrids.index_of(self._last))


def _paint_rule(
    painter: QPainter, box: QRectF, text: str, heading: bool, scheme: theme.Theme
) -> None:
    font = theme.strong(painter.font()) if heading else painter.font()
    font.setPixelSize(13 if heading else 11)
    painter.setFont(font)
    painter.setPen(scheme.color("text" if heading else "muted"))
    where = box.adjusted(UNIT / 2, 0, 0, 0)
    painter.drawText(where, Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft, text)
    words = painter.fontMetrics().horizontalAdvance(text)
    painter.setPen(QPen(scheme.color("border"), 1))
    y = box.center().y()
    painter.drawLine(int(where.left() + words + UNIT), int(y), int(box.right() - UNIT), int(y))
