"""The list of a montage's icons, the topmost first."""

from PySide6.QtCore import QEvent, QPoint, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QScrollArea,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from iconstudio.gui.canvas.mipmap import Mipmap
from iconstudio.gui.gallery.pictures import stencil
from iconstudio.gui.panels.elided import ElidedLabel
from iconstudio.gui.theme import icons, theme
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.workspaces.montage.appearance import color_of
from iconstudio.workflows.montage.page import MontagePage, PlacedIcon

EMPTY = "The icons of the montage are listed here."


class LayerPicture(QWidget):
    """An icon as it is, on a stripe of its colour."""

    _image: Mipmap | None = None

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._layer: PlacedIcon | None = None
        self.setFixedSize(5 * UNIT, 4 * UNIT)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)

    def show_layer(self, layer: PlacedIcon) -> None:
        """Show another one."""
        self._layer = layer
        self.update()

    def changeEvent(self, event: QEvent) -> None:
        """Draw the icon anew in other colours."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self._image = None

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw swatch and icon."""
        if self._layer is None:
            return
        color = color_of(self._layer)
        if self._image is None:
            ink = theme.current().color("text")
            self._image = Mipmap.of(stencil(self._layer.icon.exemplar.coverage, ink), 32)
        with QPainter(self) as painter:
            painter.setRenderHints(
                QPainter.RenderHint.Antialiasing | QPainter.RenderHint.SmoothPixmapTransform
            )
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(color)
            painter.drawRoundedRect(QRectF(0, 2, 5, self.height() - 4), 2.5, 2.5)
            side = self.height()
            painter.setOpacity(0.35 if self._layer.hidden else 1.0)
            box = QRectF(self.width() - side, 0, side, side)
            painter.drawImage(box, self._image.at(side * self.devicePixelRatioF()))


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
        self.count = QLabel()
        self.count.setProperty("muted", True)
        self.eye = _button("Show or hide the icon on the canvas; its strokes count all the same")
        self.bin = _button("Take the icon out of the montage")
        self.bin.setIcon(icons.icon("clear"))
        self.eye.clicked.connect(lambda: owner.hid.emit(number, not self._hidden))
        self.bin.clicked.connect(lambda: owner.deleted.emit(number))
        self._hidden = False
        words = QVBoxLayout()
        words.setSpacing(0)
        words.addWidget(self.title)
        words.addWidget(self.count)
        row = QHBoxLayout(self)
        row.setContentsMargins(UNIT // 2, UNIT // 2, UNIT // 2, UNIT // 2)
        row.setSpacing(UNIT // 2)
        row.addWidget(self.picture)
        row.addSpacing(UNIT // 2)
        row.addLayout(words, 1)
        row.addWidget(self.eye)
        row.addWidget(self.bin)
        self.setProperty("layer", True)
        self._show_eye()

    def show_layer(self, layer: PlacedIcon, chosen: bool) -> None:
        """Show what the layer is now."""
        if self._hidden != layer.hidden:
            self._hidden = layer.hidden
            self._show_eye()
        self.picture.show_layer(layer)
        self.count.setText(_counted(len(layer.strokes)))
        self.setToolTip(f"{layer.icon.pictogram.name}\nClick to scribble over it, drag to reorder")
        self.setAccessibleName(f"{layer.title}, {self.count.text()}")
        if self.property("chosen") != chosen:
            self.setProperty("chosen", chosen)
            self.style().unpolish(self)
            self.style().polish(self)

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

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._page = MontagePage()
        self._rows: dict[int, LayerRow] = {}
        self._target: int | None = None
        self._hint = QLabel(EMPTY, wordWrap=True)
        self._hint.setProperty("muted", True)
        self._list = QVBoxLayout()
        self._list.setContentsMargins(0, 0, 0, 0)
        self._list.setSpacing(2)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._hint)
        layout.addLayout(self._list)
        layout.addStretch()
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setAccessibleName("Icons of the montage")

    @property
    def rows(self) -> list[LayerRow]:
        """The rows from top to bottom."""
        return [self._rows[one.number] for one in reversed(self._page.layers)]

    def show_page(self, page: MontagePage) -> None:
        """Show the layers of a page."""
        self._page = page
        self._hint.setVisible(not page.layers)
        wanted = {one.number: one.icon for one in page.layers}
        for number, row in [*self._rows.items()]:
            if wanted.get(number) is not row.icon:
                del self._rows[number]
                self._list.removeWidget(row)
                row.hide()
                row.deleteLater()
        for at, layer in enumerate(reversed(page.layers)):
            row = self._rows.get(layer.number)
            if row is None:
                row = self._rows[layer.number] = LayerRow(self, layer)
            if self._list.indexOf(row) != at:
                self._list.insertWidget(at, row)
            row.show_layer(layer, layer is page.current)

    def drag_to(self, row: LayerRow, y: int) -> None:
        """Mark the row's place where the pointer is."""
        rows = self.rows
        at = sum(1 for one in rows if one is not row and one.geometry().center().y() < y)
        self._target = None if at == rows.index(row) else at
        if self._list.indexOf(row) != at:
            self._list.insertWidget(at, row)

    def drop(self, row: LayerRow) -> None:
        """End a drag."""
        target, self._target = self._target, None
        if target is not None:
            self.moved.emit(row.number, len(self._page.layers) - 1 - target)

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


def scrolling(widget: QWidget) -> QScrollArea:
    """Return a scroll area around the list."""
    area = QScrollArea(widgetResizable=True)
    area.setWidget(widget)
    area.viewport().setAutoFillBackground(False)
    widget.setAutoFillBackground(False)
    area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    return area


def _counted(strokes: int) -> str:
    return {0: "not marked yet", 1: "1 stroke"}.get(strokes, f"{strokes} strokes")


def _button(tip: str) -> QToolButton:
    button = QToolButton(toolTip=tip)
    button.setAccessibleName(tip)
    button.setIconSize(QSize(16, 16))
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    return button
