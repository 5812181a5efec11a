"""The list of a montage's icons, the topmost first."""

from PySide6.QtCore import QPoint, QRectF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPaintEvent
from PySide6.QtWidgets import QFrame, QSplitter, QWidget

from iconstudio.grammar import counted
from iconstudio.gui.pictures.picture import tinted
from iconstudio.gui.theme import icons, theme
from iconstudio.gui.theme.elided import ElidedLabel
from iconstudio.gui.theme.layout import (
    card,
    column,
    label,
    row,
    scrolled,
    splitter,
    tool_button,
    turn_role,
    with_role,
)
from iconstudio.gui.theme.painting import fill_rounded, smooth_painter
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.workspaces.montage.appearance import color_of
from iconstudio.workflows.montage import edits
from iconstudio.workflows.montage.page import MontageDocument, MontagePage, PlacedIcon, choose

EMPTY = "The icons of the montage are listed here."


class LayerPicture(QWidget):
    """An icon as it is, on a stripe of its colour."""

    def __init__(self) -> None:
        super().__init__()
        self._layer: PlacedIcon | None = None
        self.setFixedSize(5 * UNIT, 4 * UNIT)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)

    def show_layer(self, layer: PlacedIcon) -> None:
        """Show another one."""
        self._layer = layer
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw swatch and icon."""
        if self._layer is None:
            return
        color = color_of(self._layer)
        image = tinted(self._layer.icon.exemplar, theme.current().text)
        with smooth_painter(self) as painter:
            fill_rounded(painter, QRectF(0, 2, 5, self.height() - 4), color, 2.5)
            side = self.height()
            painter.setOpacity(0.35 if self._layer.hidden else 1.0)
            box = QRectF(self.width() - side, 0, side, side)
            painter.drawImage(box, image.at(side * self.devicePixelRatioF()))


class LayerRow(QFrame):
    """One icon: colour, picture, name, how many strokes, and what can be done with it."""

    def __init__(self, owner: "LayerList", layer: PlacedIcon) -> None:
        super().__init__(owner)
        number = self.number = layer.number
        self.icon = layer.icon
        self._owner = owner
        self._pressed: QPoint | None = None
        self.picture = LayerPicture()
        self.title = ElidedLabel(layer.title)
        self.count = label()
        tip = "Show or hide the icon on the canvas; its strokes count all the same"
        self.eye = tool_button("eye", tip, lambda: owner.hid.emit(number, not self._hidden))
        tip = "Take the icon out of the montage"
        self.bin = tool_button("clear", tip, lambda: owner.deleted.emit(number))
        for button in (self.eye, self.bin):
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self._hidden = False
        words, half = column(self.title, self.count, spacing=0), UNIT // 2
        parts = self.picture, half, (words, 1), self.eye, self.bin
        row(*parts, of=with_role(self, "layer"), spacing=half, margins=(half,) * 4)
        self._show_eye()

    def show_layer(self, layer: PlacedIcon, chosen: bool) -> None:
        """Show what the layer is now."""
        if self._hidden != layer.hidden:
            self._hidden = layer.hidden
            self._show_eye()
        self.picture.show_layer(layer)
        strokes = len(layer.strokes)
        self.count.setText(counted(strokes, "stroke") if strokes else "not marked yet")
        self.setToolTip(f"{layer.icon.pictogram.name}\nClick to scribble over it, drag to reorder")
        self.setAccessibleName(f"{layer.title}, {self.count.text()}")
        turn_role(self, "chosen", chosen)

    def _show_eye(self) -> None:
        self.eye.setIcon(icons.icon("eye-closed" if self._hidden else "eye"))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Choose the layer; a drag may begin."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._pressed = event.position().toPoint()
            self._owner.chosen.emit(self.number)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Show where the layer would come to lie."""
        if self._pressed is not None:
            self._owner.drag_to(self, self.mapToParent(event.position().toPoint()).y())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Put the layer where it was dragged to."""
        if self._pressed is not None:
            self._pressed = None
            self._owner.drop(self)


class LayerList(QWidget):
    """Rows for all layers; keys: up, down, Delete, and Alt with up and down to reorder.

    Signals
    -------
    chosen(int), deleted(int)
        What to do with the layer of that number.
    hid(int, bool)
        A layer is to be hidden, or shown.
    moved(int, int)
        A layer is to lie at another height, 0 being the back.
    """

    chosen = Signal(int)
    deleted = Signal(int)
    hid = Signal(int, bool)
    moved = Signal(int, int)

    def __init__(self, document: MontageDocument) -> None:
        super().__init__()
        self._page = document.page
        self._rows: dict[int, LayerRow] = {}
        self._target: int | None = None
        self._hint = label(EMPTY, wordWrap=True)
        self._list = column(spacing=2)
        column(self._hint, self._list, None, of=self)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setAccessibleName("Icons of the montage")
        self.chosen.connect(lambda number: choose(document, number))
        self.deleted.connect(lambda number: edits.delete(document, number))
        self.hid.connect(lambda number, hidden: edits.hide(document, number, hidden))
        self.moved.connect(lambda number, at: edits.reorder(document, number, at))
        document.page_changed.connect(self.show_page)

    @property
    def rows(self) -> list[LayerRow]:
        """The rows from top to bottom."""
        return [self._rows[one.number] for one in reversed(self._page.layers)]

    def show_page(self, page: MontagePage) -> None:
        """Show the layers of a page."""
        self._page = page
        self._hint.setVisible(not page.layers)
        wanted = {one.number: one.icon for one in page.layers}
        for number, one in [*self._rows.items()]:
            if wanted.get(number) is not one.icon:
                del self._rows[number]
                self._list.removeWidget(one)
                one.hide()
                one.deleteLater()
        for at, layer in enumerate(reversed(page.layers)):
            one = self._rows.get(layer.number)
            if one is None:
                one = self._rows[layer.number] = LayerRow(self, layer)
            if self._list.indexOf(one) != at:
                self._list.insertWidget(at, one)
            one.show_layer(layer, layer is page.current)

    def drag_to(self, dragged: LayerRow, y: int) -> None:
        """Mark the row's place where the pointer is."""
        rows = self.rows
        at = sum(1 for one in rows if one is not dragged and one.geometry().center().y() < y)
        self._target = None if at == rows.index(dragged) else at
        if self._list.indexOf(dragged) != at:
            self._list.insertWidget(at, dragged)

    def drop(self, dragged: LayerRow) -> None:
        """End a drag."""
        target, self._target = self._target, None
        if target is not None:
            self.moved.emit(dragged.number, len(self._page.layers) - 1 - target)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Choose, reorder and delete."""
        current = self._page.current
        step = {Qt.Key.Key_Up: 1, Qt.Key.Key_Down: -1}.get(event.key())
        if current is None:
            super().keyPressEvent(event)
        elif step is not None:
            at = self._page.index(current.number) + step
            if 0 <= at < len(self._page.layers):
                if event.modifiers() & Qt.KeyboardModifier.AltModifier:
                    self.moved.emit(current.number, at)
                else:
                    self.chosen.emit(self._page.layers[at].number)
        elif event.key() == Qt.Key.Key_Delete:
            self.deleted.emit(current.number)
        else:
            super().keyPressEvent(event)


def left_side(chooser: QWidget, layers: LayerList) -> QSplitter:
    """Return where icons are found, above the list of those that are there."""
    finding = card(label("Find icons", "heading"), (chooser, 1))
    area = scrolled(layers, focusPolicy=Qt.FocusPolicy.NoFocus)
    listed = card(label("Layers", "heading"), (area, 1))
    return splitter(Qt.Orientation.Vertical, (finding, 300, 0), (listed, 260, 0))
