"""The checks that mean that there is nothing: what lies on them has a transparent ground."""

from PySide6.QtCore import QSize
from PySide6.QtGui import QBrush, QPainter, QPixmap

from iconstudio.gui.theme.theme import UNIT

_SIDE, _PALE, _DARK = UNIT, "#ffffff", "#e9e9e6"


def checks() -> QBrush:
    """Return a brush that fills with checks."""
    pixmap = QPixmap(QSize(2 * _SIDE, 2 * _SIDE))
    pixmap.fill(_PALE)
    with QPainter(pixmap) as painter:
        for place in (0, _SIDE):
            painter.fillRect(place, place, _SIDE, _SIDE, _DARK)
    return QBrush(pixmap)
