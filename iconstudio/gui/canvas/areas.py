"""Areas on the canvas: their colours, and what is drawn inside an outline."""

from collections.abc import Sequence

from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter, QPen

from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.canvas.painters import outline_join, outline_path
from iconstudio.gui.theme.theme import Theme
from iconstudio.workflows.areas import Area, Kind

TOKENS = {
    Kind.REMOVE: "danger",
    Kind.ADD: "added",
    Kind.HOLE: "accent",
    Kind.LINE: "accent",
}
"""The colours of areas in the theme."""


def paint_inner(painter: QPainter, areas: Sequence[Area], camera: Camera, theme: Theme) -> None:
    """Draw holes as paper with a rim, and lines as strokes; a pale rim keeps them visible."""
    for area in areas:
        if area.kind in (Kind.REMOVE, Kind.ADD):
            continue
        path = outline_path(area.vertices, area.ring, camera)
        if area.ring:
            painter.fillPath(path, theme.color("surface", 0.75))
        join, cap = outline_join(path), Qt.PenCapStyle.RoundCap
        width = 3.5 if area.kind is Kind.LINE else 2.0
        color = theme.color(TOKENS[area.kind])
        for one, wide in ((theme.color("surface", 0.8), width + 3), (color, width)):
            painter.strokePath(path, QPen(one, wide, Qt.PenStyle.SolidLine, cap, join))
