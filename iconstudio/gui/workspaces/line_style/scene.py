"""The canvas of line styles: the lines as they are, faint, and what is made of them."""

from functools import lru_cache

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QPainter, QPainterPath, QPen, QPolygonF

from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.canvas.scene import Scene
from iconstudio.gui.gallery.paling import Paling
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.theme.theme import Theme
from iconstudio.gui.workspaces.line_style.reading import IconLines
from iconstudio.model import Line
from iconstudio.workflows.line_style.page import RestyleDocument, RestylePage

_PLAIN, _ALONE = 0.12, 0.45
"""Opacity of the lines as they are, beside a result and without one."""


class RestyleScene(Scene):
    """Paints lines, the result over them, and which lines are selected."""

    welcome = (
        "Give the lines of an icon a style",
        "Look up an icon, drop one here, or draw with the pen. Then choose a style on the left, "
        "or draw an example of your own.",
    )

    def __init__(self, document: RestyleDocument) -> None:
        super().__init__(document)
        self._icon_lines: IconLines | None = None
        self.result: Picture | None = None
        """What is made of the lines."""
        self.paling = Paling(self)
        self.paling.changed.connect(self.changed)

    @property
    def page(self) -> RestylePage:
        """What is shown."""
        return self.document.page

    @property
    def empty(self) -> bool:
        """Whether there is no line yet."""
        return not self.page.has_lines

    @property
    def lines(self) -> tuple[Line, ...]:
        """The lines as they are, by number; none as long as those of the icon are being read."""
        work = self.page.work
        if work.icon is None:
            return work.strokes
        if self._icon_lines is None or self._icon_lines.icon != work.icon:
            return ()
        return (*self._icon_lines.lines, *work.strokes)

    @property
    def first_stroke(self) -> int:
        """The number of the first line that was drawn."""
        return len(self.lines) - len(self.page.work.strokes)

    def show_lines(self, lines: IconLines) -> None:
        """Show the lines of an icon."""
        self._icon_lines = lines
        self.changed.emit()

    def show_result(self, result: Picture | None) -> None:
        """Show another result, or none."""
        self.result = result
        self.paling.renew()
        self.changed.emit()

    def paint(self, painter: QPainter, camera: Camera, ratio: float, theme: Theme) -> None:
        """Draw the canvas's frame, the lines, and the result."""
        if self.empty:
            return
        painter.setPen(QPen(theme.color("border"), 1))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(camera.transform.mapRect(self.bounds()))
        painter.save()
        painter.setTransform(camera.transform, True)
        if self.result is None:
            self._paint_plain(painter, theme)
        else:
            painter.fillPath(self.result.outline, theme.color("text", self.paling.opacity))
        self._paint_thin(painter, theme)
        painter.restore()

    def _paint_plain(self, painter: QPainter, theme: Theme) -> None:
        """Draw the lines as their icon has them."""
        color = theme.color("muted", _ALONE)
        filled = QPainterPath()
        filled.setFillRule(Qt.FillRule.WindingFill)
        for line in self.lines:
            if line.width > 0:
                painter.strokePath(outline(line), pen(color, line.width))
            else:
                filled.addPath(outline(line))
        painter.fillPath(filled, color)

    def _paint_thin(self, painter: QPainter, theme: Theme) -> None:
        """Draw where the lines go, and the selected ones."""
        plain = _cosmetic(theme.color("accent", 0.55), 1.0)
        selected = _cosmetic(theme.color("accent"), 2.0)
        halo = _cosmetic(theme.color("surface", 0.8), 5.0)
        for number, line in enumerate(self.lines):
            if number in self.page.selected:
                painter.strokePath(outline(line), halo)
                painter.strokePath(outline(line), selected)
            elif self.result is not None:
                painter.strokePath(outline(line), plain)


@lru_cache(4096)
def outline(line: Line) -> QPainterPath:
    """Return a line in canvas units."""
    path = QPainterPath()
    path.addPolygon(QPolygonF([QPointF(*point) for point in line.points]))
    if line.closed:
        path.closeSubpath()
    return path


def pen(color, width: float) -> QPen:
    """Return a pen with round ends and joins."""
    cap, join = Qt.PenCapStyle.RoundCap, Qt.PenJoinStyle.RoundJoin
    return QPen(color, width, Qt.PenStyle.SolidLine, cap, join)


def _cosmetic(color, width: float) -> QPen:
    thin = pen(color, width)
    thin.setCosmetic(True)
    return thin
