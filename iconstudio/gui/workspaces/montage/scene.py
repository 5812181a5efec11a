"""The canvas of a montage: the icons, faint, under what is scribbled over them."""

from functools import lru_cache

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPainterPath, QPainterPathStroker, QPen, QPolygonF

from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.canvas.outlines import IconOutlines
from iconstudio.gui.canvas.scene import Scene
from iconstudio.gui.theme.theme import Theme
from iconstudio.gui.workspaces.montage.appearance import color_of
from iconstudio.gui.workspaces.montage.pictures import LayerPainter
from iconstudio.model import CANVAS, Stroke
from iconstudio.workflows.montage.page import MontageDocument, MontagePage, PlacedIcon

_FAINT, _CHOSEN = 0.20, 0.42
"""Opacity of the icons; the chosen one stands out."""

_FEW = 4
"""More icons than these are still fainter, so that together they hide nothing."""

_SCRIBBLE = 0.62


class MontageScene(Scene):
    """Paints the page, or what it is about to become while a gesture is under way."""

    welcome = (
        "Bring in two icons or more",
        "Find them on the left, and click or drag them here. Then scribble over the parts of "
        "each that you want to keep: they are joined at once.",
    )

    def __init__(self, document: MontageDocument, outlines: IconOutlines) -> None:
        super().__init__(document)
        self.icons = LayerPainter(outlines, self)
        self._draft: MontagePage | None = None
        outlines.changed.connect(self.changed)
        self.icons.sharpened.connect(self.changed)

    @property
    def page(self) -> MontagePage:
        """What is shown."""
        return self._draft or self.document.page

    @property
    def empty(self) -> bool:
        """Whether there is no icon yet."""
        return not self.document.page.layers

    def bounds(self) -> QRectF:
        """Return the area of the canvas."""
        return QRectF(0, 0, CANVAS, CANVAS)

    def preview(self, page: MontagePage | None) -> None:
        """Show what the page is about to become; None shows it as it is."""
        self._draft = page
        self.changed.emit()

    def paint(self, painter: QPainter, camera: Camera, ratio: float, theme: Theme) -> None:
        """Draw the canvas's frame, the icons, and the strokes."""
        if self.empty:
            return
        page = self.page
        painter.setPen(QPen(theme.color("border"), 1))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(camera.transform.mapRect(self.bounds()))
        faint = _FAINT * min(1.0, _FEW / len(page.layers))
        at = page.index(page.current.number)
        below, above = (
            [(one, color_of(one, faint)) for one in some if not one.hidden]
            for some in (page.layers[:at], page.layers[at + 1 :])
        )
        self.icons.paint_all("below", painter, below, camera, ratio)
        if not page.current.hidden:
            self.icons.paint(painter, page.current, color_of(page.current, _CHOSEN), camera)
        self.icons.paint_all("above", painter, above, camera, ratio)
        painter.save()
        painter.setTransform(camera.transform, True)
        for layer in page.layers:
            paint_strokes(painter, layer)
        painter.restore()


def paint_strokes(painter: QPainter, layer: PlacedIcon) -> None:
    """Draw the strokes of a layer in canvas units; where they overlap they are no darker."""
    if not layer.strokes:
        return
    shape = QPainterPath()
    shape.setFillRule(Qt.FillRule.WindingFill)
    for stroke in layer.strokes:
        shape.addPath(_outline(stroke))
    painter.fillPath(shape, color_of(layer, _SCRIBBLE))


@lru_cache(1024)
def _outline(stroke: Stroke) -> QPainterPath:
    points = [QPointF(*point) for point in stroke.points]
    line = QPainterPath(points[0])
    if len(points) == 1:
        line.lineTo(points[0] + QPointF(0.01, 0))
    else:
        line.addPolygon(QPolygonF(points))
    stroker = QPainterPathStroker()
    stroker.setWidth(stroke.width)
    stroker.setCapStyle(Qt.PenCapStyle.RoundCap)
    stroker.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
    return stroker.createStroke(line)
