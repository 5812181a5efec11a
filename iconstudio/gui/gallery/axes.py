"""The axes of the grid of results: lambda_S above the columns, styles before the rows."""

from collections.abc import Sequence

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from iconstudio.grammar import counted
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

HEAD = 13 * UNIT
"""Width of the heads of rows."""


class Scale(QWidget):
    """The axis above the columns: “smoother” on the right, and on the left ``nearer``."""

    def __init__(self, nearer: str, lambdas: Sequence[float]) -> None:
        super().__init__()
        self._nearer, self._lambdas = nearer, lambdas
        self.setFixedHeight(4 * UNIT + 4)
        self.setToolTip("λ: how much smooth seams weigh against the sketch (λ_S in the paper)")
        self.setAccessibleName("Columns: from closer to the sketch to smoother")

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
        self.setFixedWidth(HEAD)
        name, hint = label(style.capitalize(), "heading"), label(HINTS.get(style, ""))
        self._count = label()
        column(None, name, hint, self._count, None, of=self, spacing=1, margins=(0, 0, UNIT, 0))

    def set_count(self, count: int | None) -> None:
        """Say how many icons the style had to choose from."""
        self._count.setText("" if count is None else f"from {counted(count, 'icon')}")
