"""The axes of the grid of results: lambda_S above the columns, styles before the rows."""

from collections.abc import Sequence

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPen, QResizeEvent
from PySide6.QtWidgets import QGridLayout, QWidget

from iconstudio.gui.theme import theme
from iconstudio.gui.theme.layout import column, label
from iconstudio.gui.theme.theme import UNIT

HINTS = {
    "lightest": "thin lines",
    "light": "lines",
    "medium": "lines and areas",
    "dark": "solid",
}
"""What the styles of section 3.5 look like."""

_HEAD = 13 * UNIT


class Scale(QWidget):
    """The axis above the columns: “smoother” on the right, and on the left ``nearer``."""

    def __init__(self, nearer: str) -> None:
        super().__init__()
        self._lambdas: Sequence[float] = ()
        self._nearer = nearer
        self.setFixedHeight(4 * UNIT + 4)
        self.setToolTip("λ: how much smooth seams weigh against the sketch (λ_S in the paper)")
        self.setAccessibleName("Columns: from closer to the sketch to smoother")

    def set_lambdas(self, lambdas: Sequence[float]) -> None:
        """Write the numbers of the columns."""
        self._lambdas = lambdas
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw names, arrow and numbers."""
        scheme = theme.current()
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            font = painter.font()
            font.setPixelSize(12)
            painter.setFont(font)
            left, right = self._nearer, "Smoother"
            metrics = painter.fontMetrics()
            line = QRectF(2, 0, self.width() - 4, 18)
            painter.setPen(scheme.color("text"))
            painter.drawText(line, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, left)
            painter.drawText(
                line, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, right
            )
            start = line.left() + metrics.horizontalAdvance(left) + UNIT
            end = line.right() - metrics.horizontalAdvance(right) - UNIT
            painter.setPen(QPen(scheme.color("muted", 0.6), 1.2))
            painter.drawLine(int(start), 10, int(end), 10)
            painter.drawLine(int(end) - 4, 6, int(end), 10)
            painter.drawLine(int(end) - 4, 14, int(end), 10)
            font.setPixelSize(11)
            painter.setFont(font)
            painter.setPen(scheme.color("muted"))
            width = self.width() / max(1, len(self._lambdas))
            for number, value in enumerate(self._lambdas):
                box = QRectF(number * width, 18, width, 16)
                painter.drawText(box, Qt.AlignmentFlag.AlignCenter, f"λ {value:.2f}")


class RowHead(QWidget):
    """Name of a style, what it looks like, and how many icons it had to choose from."""

    def __init__(self, style: str) -> None:
        super().__init__()
        self.setFixedWidth(_HEAD)
        name, hint = label(style.capitalize(), "heading"), label(HINTS.get(style, ""))
        self._count = label()
        column(None, name, hint, self._count, None, of=self, spacing=1, margins=(0, 0, UNIT, 0))

    def set_count(self, count: int | None) -> None:
        """Say how many icons the style had to choose from."""
        self._count.setText("" if count is None else f"from {count} icons")


class Grid(QWidget):
    """A row of cells for each style, below the scale; no cell is higher than wide."""

    def __init__(self, scale: Scale) -> None:
        super().__init__()
        self._scale = scale
        self._shape = 1, 1
        self.cells = QGridLayout(self)
        self.cells.setContentsMargins(0, 0, 0, 0)
        self.cells.setSpacing(0)

    def set_shape(self, rows: int, columns: int) -> None:
        """Say how many rows and columns there are."""
        self._shape = rows, columns
        for row in range(1, max(self.cells.rowCount(), rows + 1)):
            self.cells.setRowStretch(row, int(row <= rows))
        self._fit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Grow no higher than the cells are wide."""
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        rows, columns = self._shape
        height = self._scale.height() + rows * (self.width() - _HEAD) // columns
        self.setMaximumHeight(max(height, self.minimumSizeHint().height()))
