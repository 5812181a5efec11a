"""A button that shows a colour, and lets the user choose another."""

from collections.abc import Sequence

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import (
    QAbstractButton,
    QColorDialog,
    QGridLayout,
    QMenu,
    QWidget,
    QWidgetAction,
)

from iconstudio.gui.theme import theme
from iconstudio.gui.theme.layout import column, push_button
from iconstudio.gui.theme.painting import smooth_painter
from iconstudio.gui.theme.theme import UNIT

_ACROSS = 5


class Swatch(QAbstractButton):
    """A small round of one colour, to click."""

    def __init__(self, colour: str, tip: str = "", side: int = 3 * UNIT) -> None:
        super().__init__()
        self.colour = colour
        self.setFixedSize(QSize(side, side))
        self.setToolTip(tip or colour)
        self.setAccessibleName(tip or colour)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)

    def show_colour(self, colour: str) -> None:
        """Show another colour."""
        self.colour = colour
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the round, with a ring if it is checked or pointed at."""
        scheme = theme.current()
        with smooth_painter(self) as painter:
            box = QRectF(self.rect()).adjusted(1.5, 1.5, -1.5, -1.5)
            if self.isChecked() or self.hasFocus() or (self.underMouse() and self.isEnabled()):
                painter.setBrush(Qt.BrushStyle.NoBrush)
                painter.setPen(QPen(scheme.color("accent"), 2 if self.isChecked() else 1.5))
                painter.drawEllipse(box)
            paint_colour(painter, box.adjusted(3, 3, -3, -3), self.colour, self.isEnabled())


def paint_colour(painter: QPainter, box: QRectF, colour: str, enabled: bool = True) -> None:
    """Draw a round of a colour; its rim keeps it visible on any ground."""
    scheme = theme.current()
    color = QColor(colour)
    color.setAlphaF(1.0 if enabled else 0.25)
    painter.setBrush(color)
    painter.setPen(QPen(scheme.color("muted", 0.6 if enabled else 0.25), 1))
    painter.drawEllipse(box)


class ColourButton(Swatch):
    """Shows a colour; a click opens swatches, and a dialog with all colours.

    Signals
    -------
    chosen(str)
        The user wants this colour, ``#rrggbb``.
    """

    chosen = Signal(str)

    def __init__(self, palette: Sequence[str], tip: str, side: int = 4 * UNIT) -> None:
        super().__init__(palette[0], tip, side)
        self._tip = tip
        self.menu = QMenu(self)
        grid = QGridLayout()
        grid.setSpacing(2)
        for number, colour in enumerate(palette):
            swatch = Swatch(colour)
            swatch.clicked.connect(lambda _=False, colour=colour: self._choose(colour))
            grid.addWidget(swatch, *divmod(number, _ACROSS))
        more = push_button("More colours…", do=self.ask)
        holder, action = QWidget(), QWidgetAction(self.menu)
        column(grid, more, of=holder, margins=(UNIT // 2,) * 4)
        action.setDefaultWidget(holder)
        self.menu.addAction(action)
        self.clicked.connect(self._open)

    def ask(self) -> None:
        """Let the user choose any colour."""
        self.menu.close()
        found = QColorDialog.getColor(QColor(self.colour), self.window(), self._tip)
        if found.isValid():
            self.chosen.emit(found.name())

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the colour, and a small arrow that says that there are others."""
        super().paintEvent(event)
        with smooth_painter(self) as painter:
            corner = QPointF(self.width() - 2.0, self.height() - 2.0)
            scheme = theme.current()
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(scheme.color("muted", 1.0 if self.isEnabled() else 0.3))
            painter.drawPolygon([corner, corner - QPointF(6, 0), corner - QPointF(0, 6)])

    def _open(self) -> None:
        self.menu.popup(self.mapToGlobal(self.rect().bottomLeft()))

    def _choose(self, colour: str) -> None:
        self.menu.close()
        self.chosen.emit(colour)
