"""What most widgets of our own begin with when they are painted."""

from collections.abc import Iterator
from contextlib import contextmanager

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QPaintDevice, QPainter, QPen

from iconstudio.gui.theme import theme

RADIUS = 6
"""Of round corners, in device-independent pixels."""


@contextmanager
def smooth_painter(device: QPaintDevice) -> Iterator[QPainter]:
    """Paint lines and images smoothly."""
    with QPainter(device) as painter:
        painter.setRenderHints(
            QPainter.RenderHint.Antialiasing | QPainter.RenderHint.SmoothPixmapTransform
        )
        yield painter


def fill_rounded(painter: QPainter, box: QRectF, color: QColor, radius: float = RADIUS) -> None:
    """Fill a box with round corners."""
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(color)
    painter.drawRoundedRect(box, radius, radius)


def paint_frame(
    painter: QPainter,
    box: QRectF,
    picked: bool = False,
    focused: bool = False,
    hovered: bool = False,
) -> None:
    """Draw the frame of an icon that is picked, has the focus or is pointed at."""
    if not (picked or focused or hovered):
        return
    scheme = theme.current()
    fill_rounded(painter, box, scheme.color("accent_soft" if picked else "sunken"))
    if picked or focused:
        painter.setPen(QPen(scheme.color("accent"), 2 if picked else 1.5))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRoundedRect(box, RADIUS, RADIUS)
