"""The icons that are to be mixed, as cards on which parts can be pinned."""

import math
from collections.abc import Sequence
from functools import partial

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QObject, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import (
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import QGridLayout, QWidget

from iconstudio.algorithms.iconification.guidance import mirror_image
from iconstudio.grammar import counted
from iconstudio.gui.canvas.tools.base import NUDGES
from iconstudio.gui.exchange.dropping import DropTarget
from iconstudio.gui.gallery.sheet_model import credited
from iconstudio.gui.pictures.picture import stencil, tinted
from iconstudio.gui.theme import theme
from iconstudio.gui.theme.layout import tool_button, with_role
from iconstudio.gui.theme.painting import smooth_painter
from iconstudio.gui.theme.theme import UNIT
from iconstudio.model import CANVAS, Axis, Point
from iconstudio.workflows.hybrids import page as edits
from iconstudio.workflows.hybrids.hybrids import pinned
from iconstudio.workflows.hybrids.page import HybridsDocument, Ingredient

SIDE = 9 * UNIT
"""Side of a card in device-independent pixels."""
COLUMNS = 5
NEAR = 7
"""A click within so many device-independent pixels of a pin means that pin."""


_PRESENCE = QEvent.Type.Enter, QEvent.Type.Leave, QEvent.Type.FocusIn, QEvent.Type.FocusOut


class IconCard(QWidget):
    """One icon with its pins.

    Signals
    -------
    pinned(str, tuple)
        The icon of that identifier is to have these pins.
    removed(str)
        The icon is to be mixed no more.
    """

    pinned = Signal(str, tuple)
    removed = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self._ingredient: Ingredient | None = None
        self._axis: Axis | None = None
        self._held: NDArray[np.bool_] | None = None
        self._mark: QPointF | None = None
        """Where the keys would set a pin, once they have been used."""
        self.setFixedSize(SIDE, SIDE)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setCursor(Qt.CursorShape.CrossCursor)
        self.button = with_role(tool_button("close", "", self._remove, 12, "muted"), "floating")
        self.button.setParent(self)
        self.button.setCursor(Qt.CursorShape.ArrowCursor)
        self.button.adjustSize()
        self.button.move(SIDE - self.button.width() - 3, 3)
        self.button.installEventFilter(self)
        self.button.hide()

    def show_icon(
        self, ingredient: Ingredient, axis: Axis | None, held: NDArray[np.bool_] | None = None
    ) -> None:
        """Show an icon, its pins, under a symmetry their mirror images, and what they hold.

        ``held`` is (CANVAS, CANVAS).
        """
        self._held = held if held is not None and held.any() else None
        self._ingredient, self._axis = ingredient, axis
        self.setToolTip(
            f"{credited(ingredient.exemplar)}\n"
            "Click a part that every hybrid should keep; click its pin to free it.\n"
            "Or move a mark there with the arrow keys, and press Space"
        )
        self.setAccessibleName(f"{ingredient.name}, {counted(len(ingredient.pins), 'pin')}")
        self.button.setToolTip(f"Do not mix {ingredient.name} (Delete)")
        self.button.setAccessibleName(f"Do not mix {ingredient.name}")
        self.update()

    def at(self, point: Point) -> QPointF:
        """Return where a point of the canvas is on the card."""
        box = self._box()
        return box.topLeft() + QPointF(*point) * box.width() / CANVAS

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Set a pin, or remove the one that was clicked."""
        if event.button() is not Qt.MouseButton.LeftButton or self._ingredient is None:
            super().mousePressEvent(event)
            return
        self._pin_at(event.position())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Remove the icon with Delete; arrows move a mark, and Space pins what lies there."""
        key = event.key()
        if key in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace):
            self._remove()
        elif key in NUDGES or (key == Qt.Key.Key_Space and self._mark is None):
            far = 12 if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 3
            spot = (self._mark or self._box().center()) + far * QPointF(*NUDGES.get(key, (0, 0)))
            box = self._box()
            self._mark = QPointF(
                min(max(spot.x(), box.left()), box.right()),
                min(max(spot.y(), box.top()), box.bottom()),
            )
            self.update()
        elif key == Qt.Key.Key_Space and self._ingredient is not None:
            self._pin_at(self._mark)
        else:
            super().keyPressEvent(event)

    def event(self, event: QEvent) -> bool:
        """Claim the key that removes the icon; show where the user is."""
        if event.type() == QEvent.Type.ShortcutOverride and event.key() == Qt.Key.Key_Backspace:
            event.accept()
        done = super().event(event)
        if event.type() == QEvent.Type.FocusOut:
            self._mark = None
        if event.type() in _PRESENCE:
            self._show_button()
        return done

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Hide the button once it has lost the focus."""
        if event.type() == QEvent.Type.FocusOut:
            self._show_button()
        return False

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the icon, its pins and their mirror images."""
        scheme = theme.current()
        if self._ingredient is None:
            return
        image = tinted(self._ingredient.exemplar, scheme.text)
        with smooth_painter(self) as painter:
            frame = QRectF(self.rect()).adjusted(1, 1, -1, -1)
            colour = "accent" if self.hasFocus() else "border"
            painter.setPen(QPen(scheme.color(colour), 1.5 if self.hasFocus() else 1))
            painter.setBrush(scheme.color("sunken" if self.underMouse() else "surface"))
            painter.drawRoundedRect(frame, 6, 6)
            box = self._box()
            painter.drawImage(box, image.at(box.width() * self.devicePixelRatioF()))
            if self._held is not None:
                ink = np.where(self._held, self._ingredient.exemplar.coverage, 0).astype(np.uint8)
                painter.drawImage(box, stencil(ink, scheme.color("accent")))
            for pin in self._ingredient.pins:
                if self._axis is not None:
                    _paint_pin(painter, self.at(mirror_image(pin, self._axis)), scheme, faint=True)
                _paint_pin(painter, self.at(pin), scheme)
            if self._mark is not None:
                painter.setBrush(Qt.BrushStyle.NoBrush)
                for colour, width in (("surface", 4), ("accent", 1.5)):
                    painter.setPen(QPen(scheme.color(colour), width))
                    painter.drawEllipse(self._mark, 6.5, 6.5)

    def _box(self) -> QRectF:
        return QRectF(self.rect()).adjusted(4, 4, -4, -4)

    def _is_near(self, pin: Point, spot: QPointF) -> bool:
        images = [pin] if self._axis is None else [pin, mirror_image(pin, self._axis)]
        gaps = [self.at(image) - spot for image in images]
        return any(math.hypot(gap.x(), gap.y()) <= NEAR for gap in gaps)

    def _pin_at(self, spot: QPointF) -> None:
        pins = self._ingredient.pins
        hit = next((pin for pin in pins if self._is_near(pin, spot)), None)
        if hit is not None:
            left = tuple(pin for pin in pins if pin != hit)
            self.pinned.emit(self._ingredient.id, left)
        else:
            box = self._box()
            place = (spot - box.topLeft()) * CANVAS / box.width()
            pin = edits.on_shape(self._ingredient.exemplar, (place.x(), place.y()))
            if pin not in pins:
                self.pinned.emit(self._ingredient.id, (*pins, pin))

    def _show_button(self) -> None:
        """Show the button only where the user is: it covers some of the icon."""
        self.button.setVisible(self.underMouse() or self.hasFocus() or self.button.hasFocus())
        self.update()

    def _remove(self) -> None:
        if self._ingredient is not None:
            self.removed.emit(self._ingredient.id)


class Cards(QWidget):
    """The cards of all icons, in rows: edit the page; icons and files can be dropped here.

    Signals
    -------
    dropped(QMimeData)
        Something was dropped.
    """

    dropped = Signal(object)

    def __init__(self, document: HybridsDocument) -> None:
        super().__init__()
        self._document = document
        DropTarget(self, self.dropped.emit)
        self.cards: list[IconCard] = []
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setSpacing(UNIT // 2)
        self._grid.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)

    def show_icons(self, ingredients: Sequence[Ingredient], axis: Axis | None) -> None:
        """Show these icons."""
        while len(self.cards) < len(ingredients):
            card = IconCard()
            card.pinned.connect(partial(edits.set_pins, self._document))
            card.removed.connect(partial(edits.remove_icon, self._document))
            place = divmod(len(self.cards), COLUMNS)
            self._grid.addWidget(card, *place)
            self.cards.append(card)
        while len(self.cards) > len(ingredients):
            card = self.cards.pop()
            if card.hasFocus() or card.button.hasFocus():
                self.focusPreviousChild()
            card.hide()
            card.deleteLater()
        parts: Sequence[NDArray[np.bool_] | None] = [None] * len(ingredients)
        if any(one.pins for one in ingredients):
            pins = tuple(one.pins for one in ingredients)
            parts = pinned(pins, np.stack([one.exemplar.ink for one in ingredients]), axis)
        for card, ingredient, held in zip(self.cards, ingredients, parts, strict=True):
            card.show_icon(ingredient, axis, held)


def _paint_pin(
    painter: QPainter, centre: QPointF, scheme: theme.Theme, faint: bool = False
) -> None:
    painter.setPen(QPen(scheme.color("surface"), 1.5))
    painter.setBrush(scheme.color("accent", 0.4 if faint else 1))
    painter.drawEllipse(centre, 4.5, 4.5)
