"""Paths as Qt draws them, so that icons are crisp at any size and pixel density."""

from fontTools.pens.qtPen import QtPen
from PySide6.QtCore import Qt
from PySide6.QtGui import QPainterPath

from iconstudio.model import Path


def painter_path(path: Path) -> QPainterPath:
    """Return a path for Qt, to be filled with the nonzero rule."""
    drawn = QPainterPath()
    drawn.setFillRule(Qt.FillRule.WindingFill)
    path.draw(QtPen(None, drawn))
    return drawn
